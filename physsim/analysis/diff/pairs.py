"""What of two trajectories can be compared: frames of equal times, quantities of equal names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from physsim.recording import Trajectory
from physsim.recording.layout import BY_PATH

Rows = NDArray[np.intp]
# Times are step numbers times the timestep: other timesteps give other last bits.
SAME_TIME = 1e-9

_WORDS = {"body": "bodies", "joint": "joints", "spring": "springs"}
# In this order a difference that begins in one frame is told.
_TRACKED = {
    "body": ("position", "orientation", "velocity", "angular_velocity"),
    "joint": (
        *(f"joints/coordinate{suffix}" for suffix in ("", "_2", "_3")),
        *(f"joints/{name}" for name in ("force", "torque", "violation", "angular_violation", "broken")),
    ),
    "spring": ("springs/length", "springs/force"),
}
_OF_SCENE = ("energy", "momentum")


@dataclass(frozen=True)
class Pair:
    """One dataset over time that both files have.

    path: in the file; rows_a, rows_b: of bodies, joints or springs of the same names; None for the scene's.
    names: what each row is called, as a quantity: `bodies.ball.position`.
    """

    path: str
    names: Sequence[str]
    rows_a: Rows | None = None
    rows_b: Rows | None = None

    @property
    def unit(self) -> str:
        """As the file has it; "" for a plain number."""
        units = BY_PATH[self.path].units
        return "" if units == "1" else units


def common_frames(a: Trajectory, b: Trajectory) -> tuple[Rows, Rows]:
    """Rows of the frames that both have, by time."""
    times_a, times_b = a.time, b.time
    if len(times_a) == 0 or len(times_b) == 0:
        return np.zeros(0, np.intp), np.zeros(0, np.intp)
    after = np.clip(np.searchsorted(times_b, times_a), 0, len(times_b) - 1)
    before = np.maximum(after - 1, 0)
    closer = np.abs(times_b[before] - times_a) < np.abs(times_b[after] - times_a)
    nearest = np.where(closer, before, after)
    same = np.abs(times_b[nearest] - times_a) <= SAME_TIME * np.maximum(1.0, times_a)
    return np.flatnonzero(same), nearest[same]


def common_pairs(a: Trajectory, b: Trajectory) -> list[Pair]:
    """Every dataset over time that both have, with the rows of the same names."""
    found = []
    for word, paths in _TRACKED.items():
        names = [name for name in names_of(a, word) if name in set(names_of(b, word))]
        rows_a, rows_b = (np.array([t.row_of(word, name) for name in names], np.intp) for t in (a, b))
        for path in paths if names else ():
            field = path.rpartition("/")[2]
            told = [f"{_WORDS[word]}.{name}.{field}" for name in names]
            found.append(Pair(path, told, rows_a, rows_b))
    for group in _OF_SCENE:
        both = [
            path for path, column in BY_PATH.items() if column.group == group and a.has(path) and b.has(path)
        ]
        found += [Pair(path, [path.replace("/", ".")]) for path in both]
    return [*found, Pair("solver/contact_count", ["contacts.count"])]


def names_of(trajectory: Trajectory, word: str) -> tuple[str, ...]:
    """Of its bodies, joints or springs."""
    by_word = {
        "body": trajectory.body_names,
        "joint": trajectory.joint_names,
        "spring": trajectory.spring_names,
    }
    return by_word[word]


def only_in(one: Trajectory, other: Trajectory) -> list[str]:
    """`bodies.ball`, ...: what one file has and the other has not."""
    return [
        f"{plural}.{name}"
        for word, plural in _WORDS.items()
        for name in names_of(one, word)
        if name not in set(names_of(other, word))
    ]
