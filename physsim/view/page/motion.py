"""Everything in a trajectory that has a number at each frame, read into rows over time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from physsim.recording import Series, Trajectory
from physsim.recording.column import FIXED_AXES, Column
from physsim.recording.layout import EVERYTHING
from physsim.view.stage import FloatArray, IntArray

FRAMES_AT_ONCE = 256
BODY_TRACKS = ("position", "orientation", "velocity", "angular_velocity")
_NOT_DRAWN = ("time", "step")


@dataclass(frozen=True)
class Track:
    """One dataset over time: values (rows * components, T), rows being bodies, joints, springs, or the scene
    itself (1). whole: its numbers are whole ones.
    """

    name: str
    unit: str
    rows: int
    components: int
    whole: bool
    values: FloatArray


def kept_frames(frames: int, stride: int) -> IntArray:
    """Every stride-th frame from the first on, and the last."""
    kept = np.arange(0, frames, stride, dtype=np.int32)
    if frames and kept[-1] != frames - 1:
        kept = np.append(kept, np.int32(frames - 1))
    return kept


def columns_over_time(trajectory: Trajectory) -> list[Column]:
    """The datasets of the file that have a number at each frame, but for the time itself."""
    return [
        column
        for column in EVERYTHING
        if column.grows_along == "time" and column.path not in _NOT_DRAWN and trajectory.has(column.path)
    ]


def numbers_of_a_frame(trajectory: Trajectory) -> int:
    """How many numbers all tracks have at one frame."""
    return sum(
        math.prod(trajectory.series(column.path).shape[1:]) for column in columns_over_time(trajectory)
    )


def tracks_of(trajectory: Trajectory, kept: IntArray) -> list[Track]:
    """All tracks at the kept frames. Takes 8 bytes of memory for each number."""
    return [_track(trajectory, column, kept) for column in columns_over_time(trajectory)]


def _track(trajectory: Trajectory, column: Column, kept: IntArray) -> Track:
    series = trajectory.series(column.path)
    components = len(FIXED_AXES.get(column.dims[-1], ("",)))
    return Track(
        name=column.path,
        unit="" if column.units == "1" else column.units,
        rows=math.prod(series.shape[1:]) // components,
        components=components,
        whole=column.kind.startswith("i"),
        values=_read(series, kept),
    )


def _read(series: Series, kept: IntArray) -> FloatArray:
    """Block by block of frames, turned so that each row lies in one piece."""
    numbers = math.prod(series.shape[1:])
    found = np.empty((numbers, len(kept)))
    for start in range(0, len(series), FRAMES_AT_ONCE):
        first, last = np.searchsorted(kept, (start, start + FRAMES_AT_ONCE))
        if first == last:
            continue
        block = series[start : int(kept[last - 1]) + 1].reshape(-1, numbers)
        found[:, first:last] = block[kept[first:last] - start].T
    return found
