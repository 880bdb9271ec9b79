"""A quantity at other times than those of the frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from physsim.recording.orientation import Floats, between

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory
    from physsim.scene.quantity import Quantity


def at_times(trajectory: Trajectory, quantity: Quantity, times: ArrayLike) -> Floats:
    """The quantity at `times` [s], in any order: (n), (n, 3) or (n, 4).

    Straight lines between frames, arcs for orientations. Only the frames around the times are read. Raises
    ValueError for a time before the first frame or after the last.
    """
    from physsim.recording.quantities import over_time  # noqa: PLC0415, it needs the reader, which needs this

    wanted = np.asarray(times, np.float64)
    whole = trajectory.time
    _check_range(wanted, whole)
    if wanted.size == 0:
        return np.asarray(over_time(trajectory, quantity, slice(0, 0)), np.float64)
    after = np.clip(np.searchsorted(whole, wanted, side="right"), 1, max(len(whole) - 1, 1))
    start, stop = int(after.min()) - 1, int(after.max()) + 1
    known, values = whole[start:stop], over_time(trajectory, quantity, slice(start, stop))
    if len(known) == 1:
        return np.repeat(values, len(wanted), axis=0)
    if quantity.field == "orientation":
        return _turned(trajectory, quantity, wanted, slice(start, stop))
    columns = values.reshape(len(known), -1).T
    found = np.stack([np.interp(wanted, known, column) for column in columns], axis=1)
    return found.reshape(len(wanted), *values.shape[1:])


def _turned(trajectory: Trajectory, quantity: Quantity, wanted: Floats, frames: slice) -> Floats:
    """Orientations on arcs between frames; one component when the quantity names one."""
    known = trajectory.time[frames]
    q = trajectory.body(str(quantity.name)).orientation[frames]
    after = np.clip(np.searchsorted(known, wanted, side="right"), 1, len(known) - 1)
    fraction = (wanted - known[after - 1]) / (known[after] - known[after - 1])
    found = between(q[after - 1], q[after], fraction)
    return found if quantity.index is None else found[:, quantity.index]


def _check_range(wanted: Floats, known: Floats) -> None:
    if wanted.ndim != 1:
        raise ValueError("times must be a list of numbers")
    if len(known) == 0:
        raise ValueError("the trajectory has no frames")
    if wanted.size and not (known[0] <= wanted.min() and wanted.max() <= known[-1]):
        raise ValueError(
            f"times must be within {known[0]:g} s to {known[-1]:g} s, the frames of the trajectory"
        )
