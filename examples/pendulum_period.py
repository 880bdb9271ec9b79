"""The period of a pendulum against its amplitude, and the elliptic integral that it should follow.

Galileo thought that a pendulum keeps its time whatever its swing. It does not: T = 4 sqrt(l/g) K(sin(a/2)),
which is 2 pi sqrt(l/g) (1 + a^2/16 + ...) for small amplitudes and grows without bound towards the upright
position. A ball of radius r swings like a point at (l^2 + 2/5 r^2) / l.

    python examples/pendulum_period.py [--quick] [-o period.png]
"""

from __future__ import annotations

import argparse
import math
import tempfile
from pathlib import Path

import numpy as np
from scipy.special import ellipk

import physsim

RADIUS, GRAVITY = 0.05, 9.81
LENGTH = 1.0 + 0.4 * RADIUS**2
SCENE = """
physsim: 1
title: A pendulum
parameters: {amplitude: 10 deg}
simulation: {duration: 20 s, timestep: 1 ms, integrator: rk4}
bodies:
  bob:
    shape: {type: sphere, radius: 5 cm}
    mass: 1 kg
    collides: false
    position: ["${1 m * sin(amplitude)}", 0, "${-1 m * cos(amplitude)}"]
joints:
  pivot: {type: hinge, between: [world, bob], anchor: [0, 0, 0], axis: [0, 1, 0]}
record: {every: 10 ms, contacts: false}
"""

# %% One run: the times at which the bob passes its lowest point, each from the frames around it.


def period(scene: Path, amplitude: float) -> float:
    """T [s] from the first to the last upward passage, each on a cubic through four frames."""
    changes = {"parameters.amplitude": amplitude}
    with physsim.run(scene, set=changes, output=scene.with_suffix(".h5"), force=True) as trajectory:
        x, t = trajectory.quantity("bodies.bob.position.x"), trajectory.time
    rising = [k for k in range(1, len(x) - 2) if x[k] < 0 <= x[k + 1]]
    first, last = (_passage(t[k - 1 : k + 3], x[k - 1 : k + 3]) for k in (rising[0], rising[-1]))
    return (last - first) / (len(rising) - 1)


def _passage(t: np.ndarray, x: np.ndarray) -> float:
    """Where the cubic t(x) through four points passes x = 0."""
    return float(np.linalg.solve(np.vander(x, increasing=True), t)[0])


def exact(amplitude: float) -> float:
    """T = 4 sqrt(l/g) K(m), m = sin^2(a/2). Landau and Lifshitz, Mechanics, section 11, problem 1."""
    return 4 * math.sqrt(LENGTH / GRAVITY) * float(ellipk(math.sin(amplitude / 2) ** 2))


# %% All amplitudes, as a table and as a picture.


def main() -> None:
    """Prints measured and exact periods; draws them with -o."""
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("--quick", action="store_true", help="three amplitudes")
    arguments.add_argument("-o", "--output", help="a picture (needs matplotlib)")
    chosen = arguments.parse_args()
    degrees = np.array(
        [10, 90, 150] if chosen.quick else [1, 5, 10, 20, 30, 45, 60, 75, 90, 105, 120, 135, 150, 165, 175]
    )
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "pendulum.yaml"
        scene.write_text(SCENE)
        measured = np.array([period(scene, math.radians(each)) for each in degrees])
    wanted = np.array([exact(math.radians(each)) for each in degrees])
    print(f"{'amplitude':>9} {'measured [s]':>14} {'exact [s]':>12} {'relative error':>15}")
    for each, found, true in zip(degrees, measured, wanted, strict=True):
        print(f"{each:7.0f} ° {found:14.9f} {true:12.9f} {found / true - 1:15.1e}")
    if chosen.output:
        draw(degrees, measured, Path(chosen.output))


def draw(degrees: np.ndarray, measured: np.ndarray, target: Path) -> None:
    """Points over the curve of the elliptic integral."""
    from matplotlib.figure import Figure  # noqa: PLC0415, optional

    figure = Figure(figsize=(6, 4), layout="constrained")
    axes = figure.subplots()
    curve = np.linspace(0.5, degrees.max(), 300)
    axes.plot(curve, [exact(math.radians(each)) for each in curve], label="4 sqrt(l/g) K(sin a/2)")
    axes.plot(degrees, measured, "o", ms=4, label="simulated")
    axes.set(xlabel="amplitude [°]", ylabel="period [s]")
    axes.legend(frameon=False)
    figure.savefig(target, dpi=150)
    print(target)


if __name__ == "__main__":
    main()
