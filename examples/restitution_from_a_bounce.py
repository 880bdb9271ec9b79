"""Restitution measured from a bounce, in the three ways of a laboratory, against what the scene declares.

Balls of seven materials fall onto a floor. Each bounce gives e in three ways: by the speeds before and after,
by the heights (e = sqrt(h'/h)), and by the times of flight (e = t'/t). The last two are what a ruler and a
stop-watch would give; they need no knowledge of the impact itself.

    python examples/restitution_from_a_bounce.py [--quick]
"""

from __future__ import annotations

import argparse
import itertools
import tempfile
from pathlib import Path

import numpy as np

import physsim

SCENE = Path(__file__).parents[1] / "scenes" / "bouncing_balls.yaml"
LOWEST_TOP = 0.02
"""Bounces lower than this [m] are not measured: there are too few frames in them."""

# %% Run the scene. Impacts are located to the instant of touching, so that times of flight are exact.


def run(duration: str, output: Path) -> physsim.Trajectory:
    """The trajectory, a frame every 2 ms."""
    changes = {
        "simulation.impacts": "located",
        "simulation.integrator": "velocity_verlet",
        "record.every": "2 ms",
    }
    return physsim.run(SCENE, set=changes | {"expect": []}, duration=duration, output=output)


# %% Three estimates of e for every pair of bounces that follow each other.


def by_speeds(ball: physsim.recording.BodyTrack) -> np.ndarray:
    """Speed after over speed before, of every impact."""
    return ball.impacts().restitution_measured


def by_heights(trajectory: physsim.Trajectory, name: str) -> np.ndarray:
    """sqrt(h'/h) of the tops before and after each impact, over the height at which the ball touches."""
    z, times = trajectory.quantity(f"bodies.{name}.position.z"), trajectory.body(name).impacts().time
    touching = z[np.searchsorted(trajectory.time, times) - 1].min() if len(times) else np.nan
    spans = np.searchsorted(trajectory.time, [0.0, *times])
    tops = [z[a:b].max() - touching for a, b in itertools.pairwise(spans) if b > a]
    seen = np.array([top for top in tops if top > LOWEST_TOP])
    return np.sqrt(seen[1:] / seen[:-1])


def by_times(ball: physsim.recording.BodyTrack) -> np.ndarray:
    """t'/t of flights that follow each other."""
    flights = np.diff(ball.impacts().time)
    return flights[1:] / flights[:-1]


def mean(values: np.ndarray) -> str:
    """Mean and scatter, as a laboratory book has it."""
    return "-" if len(values) == 0 else f"{values.mean():.4f} ± {values.std():.4f}"


# %% The table.


def main() -> None:
    """Prints one line per ball."""
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("--quick", action="store_true", help="2 s instead of 6 s")
    quick = arguments.parse_args().quick
    with (
        tempfile.TemporaryDirectory() as folder,
        run("2 s" if quick else "6 s", Path(folder) / "run.h5") as trajectory,
    ):
        print(f"{'ball':<18} {'declared':>8}  {'speeds':<16} {'heights':<16} {'times':<16}")
        for name in trajectory.body_names[1:]:
            ball = trajectory.body(name)
            if ball.impacts().rows == 0:
                continue
            declared = ball.impacts().restitution_declared[0]
            told = [mean(by_speeds(ball)), mean(by_heights(trajectory, name)), mean(by_times(ball))]
            print(f"{name:<18} {declared:8.3f}  {told[0]:<16} {told[1]:<16} {told[2]:<16}")


if __name__ == "__main__":
    main()
