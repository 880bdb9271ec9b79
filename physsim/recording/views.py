"""A trajectory as pandas and xarray see it."""

# ruff: noqa: PLC0415  pandas and xarray are optional and slow to import

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from physsim.recording.column import Column
from physsim.recording.quantities import over_time
from physsim.recording.resample import at_times
from physsim.recording.series import Array, check_memory

if TYPE_CHECKING:
    import pandas
    import xarray

    from physsim.recording.reader import Trajectory
    from physsim.scene.quantity import Quantity

STATE = ("position", "orientation", "velocity", "angular_velocity")


def to_pandas(
    trajectory: Trajectory, quantities: Sequence[str] | None, times: ArrayLike | None
) -> pandas.DataFrame:
    """One row per frame (or per time), one column per number, named like the quantity; index: time [s]."""
    import pandas

    names = state_of_all(trajectory) if quantities is None else quantities
    chosen = [trajectory.find_quantity(name) for name in names]
    check_memory(trajectory.path, 8 * trajectory.frames * sum(max(1, len(q.components)) for q in chosen))
    columns: dict[str, Array] = {}
    for quantity in chosen:
        found = over_time(trajectory, quantity) if times is None else at_times(trajectory, quantity, times)
        columns |= columns_of(quantity, found)
    index = trajectory.time if times is None else np.asarray(times, np.float64)
    return pandas.DataFrame(columns, index=pandas.Index(index, name="time"))


def columns_of(quantity: Quantity, values: Array) -> dict[str, Array]:
    """One column per number: a whole vector (T, 3) or (T, 4) falls into its components."""
    if quantity.is_scalar:
        return {quantity.text: values}
    return {f"{quantity.text}.{part}": values[:, k] for k, part in enumerate(quantity.components)}


def state_of_all(trajectory: Trajectory, bodies: Sequence[str] | None = None) -> list[str]:
    """Names of position, orientation and velocities of the bodies, all when not given."""
    names = trajectory.body_names if bodies is None else bodies
    return [f"bodies.{name}.{field}" for name in names for field in STATE]


def to_xarray(trajectory: Trajectory, bodies: str | None, frames: slice) -> xarray.Dataset:
    """The root of the file, whole frames only, of some bodies and frames."""
    import xarray

    rows = None if bodies is None else [trajectory.index_of(name) for name in trajectory.bodies(bodies)]
    variables = {}
    for column in trajectory.columns_in(""):
        data = _values(trajectory, column, rows, frames)
        attributes = {"units": column.units, "long_name": column.description}
        variables[column.name] = (column.dims, data, attributes)
    return xarray.Dataset(variables, attrs=trajectory.attributes)


def _values(trajectory: Trajectory, column: Column, rows: list[int] | None, frames: slice) -> Array:
    """A dataset of the root, cut to the chosen bodies and frames before it is in memory."""
    of_bodies = "body" in column.dims and rows is not None
    if "time" not in column.dims:
        data = trajectory.values(column.path)
        return data[rows] if of_bodies else data
    series = trajectory.series(column.path)
    if not of_bodies:
        return np.asarray(series[frames])
    count = len(range(trajectory.frames)[frames])
    check_memory(trajectory.path, 8 * count * len(rows or ()) * math.prod(series.shape[2:]))
    parts = [trajectory.series(column.path, row)[frames] for row in rows or ()]
    return np.stack(parts, axis=1) if parts else np.zeros((count, 0, *series.shape[2:]))
