"""What sets the speed of a wave of dominoes? Its sensitivity to gap, friction, restitution and first push.

A sweep varies one value at a time, up and down, and takes the times at which two dominoes of the row begin to
fall: their distance over the time between is the speed of the wave. Elasticities, d ln(speed) / d ln(value),
tell what matters.

    python examples/domino_sensitivity.py [--quick]
"""

from __future__ import annotations

import argparse
import math
import tempfile
from pathlib import Path

import physsim

SCENE = Path(__file__).parents[1] / "scenes" / "dominoes.yaml"
FIRST, LAST = 5, 15
STARTED = 1.0
"""A domino that turns faster than this [rad/s] has begun to fall."""

# %% What is varied, about the values that the scene has.

VALUES = {
    "parameters.gap": (25e-3, "gap between dominoes"),
    "pairs[0].kinetic_friction": (0.25, "kinetic friction, domino on domino"),
    "pairs[0].restitution": (0.3, "restitution, domino on domino"),
    "bodies.marble.velocity[0]": (0.8, "speed of the marble"),
}


def varied(quick: bool) -> dict[str, tuple[float, str]]:
    """Those that are looked at."""
    return dict(list(VALUES.items())[:1]) if quick else VALUES


# %% The sweep: one row as it is, and for each value one below and one above.


def speeds(
    values: dict[str, tuple[float, str]], change: float, folder: Path
) -> dict[tuple[str, float], float]:
    """Speed of the wave [m/s] by the path that was varied and its factor."""
    names = list(values)
    rows = [(name, factor) for name in names for factor in (1 - change, 1 + change)]
    columns = {
        name: [values[name][0] * (factor if other == name else 1.0) for other, factor in rows]
        for name in names
    }
    result = physsim.sweep(
        {
            "physsim_sweep": 1,
            "scene": str(SCENE),
            "set": {
                "simulation.duration": "0.8 s",
                "expect": [],
                "record.every": "1 ms",
                "record.contacts": False,
            },
            "zip": columns,
            "metrics": {
                name: {
                    "type": "crossing",
                    "quantity": f"bodies.domino[{row},0,0].angular_speed",
                    "level": STARTED,
                    "direction": "up",
                }
                for name, row in (("first", FIRST), ("last", LAST))
            },
        },
        output=folder / "dominoes",
    )
    first, last = (result.table.column(name) for name in ("first", "last"))
    found = {}
    for (name, factor), start, end in zip(rows, first, last, strict=True):
        gap = values["parameters.gap"][0] * (factor if name == "parameters.gap" else 1.0)
        found[name, factor] = (LAST - FIRST) * gap / (float(end) - float(start))
    return found


# %% Elasticities by differences to both sides.


def main() -> None:
    """Prints speed below and above, and the elasticity, for every value."""
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("--quick", action="store_true", help="the gap only")
    values, change = varied(arguments.parse_args().quick), 0.1
    with tempfile.TemporaryDirectory() as folder:
        found = speeds(values, change, Path(folder))
    print(f"{'value':<36} {'speed at -10 %':>15} {'at +10 %':>10} {'elasticity':>11}")
    for name, (_, title) in values.items():
        below, above = found[name, 1 - change], found[name, 1 + change]
        elasticity = math.log(above / below) / math.log((1 + change) / (1 - change))
        print(f"{title:<36} {below:11.3f} m/s {above:6.3f} m/s {elasticity:11.2f}")


if __name__ == "__main__":
    main()
