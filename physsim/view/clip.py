"""Poses of a trajectory over a span of time, at its frames or at an even rate, in blocks of bounded size."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.recording import Trajectory
from physsim.recording.orientation import between
from physsim.view.stage import FloatArray

MOST_TIMES = 1 << 24
"""As many as 32-bit floats can count."""
BLOCK_BYTES = 1 << 24
_POSE_BYTES = 7 * 8
NOT_UNIT = 1e-3
"""A quaternion whose length is farther from 1 than this is no orientation."""


@dataclass(frozen=True)
class Clip:
    """times (n) [s], increasing, none outside the frames of the trajectory."""

    trajectory: Trajectory
    times: FloatArray

    def blocks(self) -> Iterator[tuple[slice, FloatArray, FloatArray]]:
        """Which times, positions (m, N, 3) [m] and orientations (m, N, 4), of unit length, of all bodies.

        Between frames positions go along straight lines, orientations along arcs. A block takes some 16 MB,
        however long the trajectory. Raises FileTrouble where a pose is no number.
        """
        before, after, fraction = _neighbours(self.trajectory.time, self.times)
        at_once = max(2, BLOCK_BYTES // (_POSE_BYTES * max(len(self.trajectory.body_names), 1)))
        work = after + np.arange(len(after))
        first = 0
        while first < len(self.times):
            stop = max(first + 1, int(np.searchsorted(work, before[first] + first + at_once)))
            part = slice(first, stop)
            yield part, *self._poses(before[part], after[part], fraction[part])
            first = stop

    def first(self) -> tuple[FloatArray, FloatArray]:
        """Positions (N, 3) [m] and orientations (N, 4) at the first of the times."""
        _, positions, orientations = next(Clip(self.trajectory, self.times[:1]).blocks())
        return positions[0], orientations[0]

    def _poses(
        self,
        before: npt.NDArray[np.intp],
        after: npt.NDArray[np.intp],
        fraction: FloatArray,
    ) -> tuple[FloatArray, FloatArray]:
        frames = slice(int(before[0]), int(after[-1]) + 1)
        low, high, share = before - frames.start, after - frames.start, fraction[:, None, None]
        positions = self.trajectory.position[frames]
        orientations = self.trajectory.orientation[frames]
        lengths = np.linalg.norm(orientations, axis=-1)
        if not (np.isfinite(positions).all() and (np.abs(lengths - 1) < NOT_UNIT).all()):
            span = self.trajectory.time[frames][[0, -1]]
            raise FileTrouble(
                f"{self.trajectory.path}: has poses that are no poses between {span[0]:g} s and "
                f"{span[1]:g} s; --until ends before them"
            )
        bodies = positions.shape[1]
        rows = len(before) * bodies
        turned = between(
            orientations[low].reshape(rows, 4),
            orientations[high].reshape(rows, 4),
            np.repeat(fraction, bodies),
        )
        return (1 - share) * positions[low] + share * positions[high], turned.reshape(-1, bodies, 4)


def clip_of(
    trajectory: Trajectory, start: float | None = None, end: float | None = None, fps: float | None = None
) -> Clip:
    """The frames from `start` to `end` [s], both included, or `fps` poses a second between them.

    Raises FileTrouble when there are none.
    """
    whole = trajectory.time
    inside = (whole >= (-np.inf if start is None else start)) & (whole <= (np.inf if end is None else end))
    times = whole[inside]
    if len(times) == 0:
        raise FileTrouble(f"{trajectory.path}: has no frames in that span of time")
    if fps is not None:
        steps = (times[-1] - times[0]) * fps * (1 + 1e-12)
        if steps > MOST_TIMES:
            raise FileTrouble(f"{trajectory.path}: {fps:g} frames a second would be {steps:.2g} of them")
        times = np.minimum(times[0] + np.arange(int(steps) + 1) / fps, times[-1])
    return Clip(trajectory, np.asarray(times, np.float64))


def _neighbours(
    known: FloatArray, wanted: FloatArray
) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp], FloatArray]:
    """The frames before and after each time, and which part of the way it is from one to the other."""
    before = np.clip(np.searchsorted(known, wanted, side="right") - 1, 0, max(len(known) - 2, 0))
    after = np.minimum(before + 1, len(known) - 1)
    gap = known[after] - known[before]
    return before, after, (wanted - known[before]) / np.where(gap > 0, gap, 1)
