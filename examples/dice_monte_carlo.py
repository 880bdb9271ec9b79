"""Is a simulated die fair? Many throws by a sweep, and what they say about each face, with confidence bounds.

Every throw is one run of a scene with another orientation and spin, drawn from distributions: four normal
numbers, brought to length 1, are a quaternion of which every orientation is equally likely. The face on top
is that of the body axis that points up at the end.

    python examples/dice_monte_carlo.py [--quick]
"""

from __future__ import annotations

import argparse
import math
import tempfile
from pathlib import Path

import numpy as np
from scipy.stats import chi2, norm

import physsim

SCENE = """
physsim: 1
title: One die
parameters: {a: 1, b: 0, c: 0, d: 0, spin_x: 0, spin_y: 0, size: "${sqrt(a^2 + b^2 + c^2 + d^2)}"}
simulation: {duration: 4 s, timestep: 1 ms, until: at_rest}
materials: {celluloid: {density: 1400 kg/m^3, restitution: 0.5, static_friction: 0.35, kinetic_friction: 0.3}}
pairs: [{between: [celluloid, wood], restitution: 0.5, static_friction: 0.35, kinetic_friction: 0.3}]
bodies:
  table: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: wood}
  die:
    shape: {type: box, size: [16 mm, 16 mm, 16 mm]}
    material: celluloid
    position: [0, 0, 20 cm]
    orientation: {quaternion: ["${a / size}", "${b / size}", "${c / size}", "${d / size}"]}
    velocity: [1 m/s, 0, 0]
    angular_velocity: ["${spin_x}", "${spin_y}", 0]
record: {every: 50 ms, contacts: false, energy: false}
"""
QUATERNION = "wxyz"

# %% The throws. Every run keeps the quaternion that the die ends with.


def throws(count: int, folder: Path) -> np.ndarray:
    """Orientations (count, 4) at the end of every run that came to rest."""
    (folder / "die.yaml").write_text(SCENE)
    turn = {"type": "normal", "mean": 0, "deviation": 1}
    spin = {"type": "normal", "mean": 0, "deviation": "20 rad/s"}
    result = physsim.sweep(
        {
            "physsim_sweep": 1,
            "scene": str(folder / "die.yaml"),
            "seed": 7,
            "sample": {
                "count": count,
                "values": {
                    **{f"parameters.{name}": turn for name in "abcd"},
                    **{f"parameters.{name}": spin for name in ("spin_x", "spin_y")},
                },
            },
            "metrics": {
                part: {"type": "final", "quantity": f"bodies.die.orientation.{part}"} for part in QUATERNION
            },
        },
        output=folder / "throws",
    )
    columns = [np.array(result.table.column(part), float) for part in QUATERNION]
    return np.stack(columns, axis=1)


# %% Which face is up: the body axis, of six, that is nearest to the world's z.


def faces_up(orientation: np.ndarray) -> np.ndarray:
    """1 to 6 by axis: +x 1, -x 6, +y 2, -y 5, +z 3, -z 4. The last row of R has the z of every body axis."""
    w, x, y, z = orientation.T
    up = np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], axis=1)
    axis = np.abs(up).argmax(axis=1)
    positive = up[np.arange(len(up)), axis] > 0
    return np.where(positive, axis + 1, 6 - axis)


# %% Bounds by Wilson (1927), which hold for small numbers too; fairness by chi-squared.


def wilson(hits: int, throws: int, confidence: float = 0.95) -> tuple[float, float]:
    """Lower and upper bound of a probability from so many hits."""
    z = norm.ppf(0.5 + confidence / 2)
    p, n = hits / throws, throws
    middle, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return (middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)


def main() -> None:
    """Prints the count of each face with its bounds, and the verdict."""
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("--quick", action="store_true", help="60 throws instead of 3000")
    count = 60 if arguments.parse_args().quick else 3000
    with tempfile.TemporaryDirectory() as folder:
        faces = faces_up(throws(count, Path(folder)))
    counts = np.bincount(faces, minlength=7)[1:]
    print(f"{'face':>4} {'throws':>7} {'probability, 95 %':>20}")
    for face, hits in enumerate(counts, start=1):
        low, high = wilson(int(hits), len(faces))
        print(f"{face:>4} {hits:>7} {low:>9.3f} to {high:.3f}")
    statistic = float(((counts - len(faces) / 6) ** 2 / (len(faces) / 6)).sum())
    chance = float(chi2.sf(statistic, 5))
    print(
        f"chi-squared {statistic:.2f}, 5 degrees of freedom; a fair die exceeds it in {chance:.0%} of trials"
    )


if __name__ == "__main__":
    main()
