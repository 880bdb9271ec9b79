"""The angle of repose: on which slope does a crate begin to slide, and is it arctan of the static friction?

A ramp is tilted in a search by halves; at each slope the scene runs and the crate has moved, or has not. What
sets the angle is mu_s alone, tan(angle) = mu_s, whatever the mass, the size or gravity.

    python examples/friction_angle_of_repose.py [--quick]
"""

from __future__ import annotations

import argparse
import math
import tempfile
from pathlib import Path
from typing import Any

import physsim

SCENE = Path(__file__).parents[1] / "scenes" / "crate_on_incline.yaml"
MOVED = 1e-4
"""A crate that has gone further than this [m] slides."""

# %% One question: does the crate slide on this slope?


def slides(crate: str, slope: float, duration: float, changes: dict[str, Any], folder: Path) -> bool:
    """slope in radians; crate: the body that is looked at."""
    told = {"parameters.slope": slope, "expect": [], "record.contacts": False, **changes}
    with physsim.run(SCENE, set=told, duration=duration, output=folder / "run.h5", force=True) as trajectory:
        way = trajectory.body(crate).position[-1] - trajectory.body(crate).position[0]
    return math.hypot(*way) > MOVED


# %% The search.


def angle_of_repose(
    crate: str, within: float, duration: float, changes: dict[str, Any], folder: Path
) -> float:
    """The slope in radians, to `within`."""
    holds, too_steep = math.radians(5), math.radians(50)
    while too_steep - holds > within:
        middle = (holds + too_steep) / 2
        if slides(crate, middle, duration, changes, folder):
            too_steep = middle
        else:
            holds = middle
    return (holds + too_steep) / 2


# %% The table.


def main() -> None:
    """Prints the angle for two materials, and for a heavy crate."""
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("--quick", action="store_true", help="to 1 degree, instead of 0.02")
    quick = arguments.parse_args().quick
    within, duration = (math.radians(1), 0.2) if quick else (math.radians(0.02), 0.6)
    print(f"{'crate':<28} {'mu_s':>5} {'arctan mu_s':>12} {'found':>9}")
    cases: list[tuple[str, str, float, dict[str, Any]]] = [
        ("wood on wood", "crate_on_wood", 0.4, {}),
        ("rubber on wood", "crate_on_rubber", 0.8, {}),
        ("wood on wood, 20 t", "crate_on_wood", 0.4, {"bodies.crate_on_wood.mass": "20 t"}),
    ]
    with tempfile.TemporaryDirectory() as folder:
        for title, crate, friction, changes in cases:
            found = angle_of_repose(crate, within, duration, changes, Path(folder))
            wanted = math.degrees(math.atan(friction))
            print(f"{title:<28} {friction:5.2f} {wanted:10.2f} ° {math.degrees(found):7.2f} °")


if __name__ == "__main__":
    main()
