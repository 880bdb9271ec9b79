"""The rows of a table, in batches: so many frames at a time, whatever the length of the trajectory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from physsim.recording import Trajectory
from physsim.recording.layout import BY_PATH
from physsim.recording.quantities import over_time
from physsim.recording.series import Array
from physsim.recording.views import columns_of, state_of_all

Batch = Mapping[str, Array]
"""Columns of one length by name."""
Units = Mapping[str, str]

# The chunks of so many frames of one dataset stay in HDF5's cache while body after body is read.
FRAMES_AT_ONCE = 256


def wide_rows(trajectory: Trajectory, quantities: Sequence[str] | None) -> tuple[Iterator[Batch], Units]:
    """One row per frame: `time`, then one column per number, named like the quantity. And the units, SI.

    quantities: names as in `expect`; the state of every body when not given. Raises NotInFile.
    """
    chosen = [trajectory.find_quantity(name) for name in _names(trajectory, quantities)]
    units = {"time": "s"}
    for quantity in chosen:
        units |= dict.fromkeys(columns_of(quantity, np.zeros((0, 4))), quantity.kind.unit)

    def batches() -> Iterator[Batch]:
        for frames in _blocks(trajectory.frames):
            columns: dict[str, Array] = {"time": trajectory.time[frames]}
            for quantity in chosen:
                columns |= columns_of(quantity, over_time(trajectory, quantity, frames))
            yield columns

    return batches(), units


def long_rows(trajectory: Trajectory, quantities: Sequence[str] | None) -> tuple[Iterator[Batch], Units]:
    """One row per number: time, name (of the body, joint or spring; empty for the scene's), quantity,
    component, value, unit. Rows come in blocks of frames, in each block quantity by quantity.
    """
    chosen = [trajectory.find_quantity(name) for name in _names(trajectory, quantities)]

    def batches() -> Iterator[Batch]:
        for frames in _blocks(trajectory.frames):
            time = trajectory.time[frames]
            for quantity in chosen:
                for text, values in columns_of(quantity, over_time(trajectory, quantity, frames)).items():
                    words = {
                        "name": quantity.name or "",
                        "quantity": quantity.field if quantity.name else _own_name(quantity.text, text),
                        "component": text.rpartition(".")[2] if quantity.components else "",
                    }
                    yield _filled(time, words, values, quantity.kind.unit)

    return batches(), {"time": "s"}


def contact_rows(trajectory: Trajectory) -> tuple[Iterator[Batch], Units]:
    """One row per contact point and frame, the columns of /contacts and the time. Raises NotInFile."""
    trajectory.contact_rows(0, 0)

    def batches() -> Iterator[Batch]:
        for frames in _blocks(trajectory.frames):
            table = trajectory.contact_rows(frames.start, frames.stop)
            yield {"time": trajectory.time[table.frame], **table.flat()}

    return batches(), {"time": "s", **_units("contacts", trajectory.contact_rows(0, 0).flat())}


def impact_rows(trajectory: Trajectory) -> tuple[Iterator[Batch], Units]:
    """One row per impact, the columns of /events."""
    columns = trajectory.events.flat()
    return iter([columns]), _units("events", columns)


def _names(trajectory: Trajectory, quantities: Sequence[str] | None) -> Sequence[str]:
    return state_of_all(trajectory) if quantities is None else quantities


def _own_name(quantity: str, column: str) -> str:
    """Of the scene's own quantities: `energy.total`, `momentum.linear` without its component."""
    return quantity if quantity != column and column.startswith(quantity) else column


def _filled(time: Array, words: Mapping[str, str], values: Array, unit: str) -> Batch:
    count = len(time)
    texts = {name: np.full(count, word, dtype=object) for name, word in words.items()}
    return {
        "time": time,
        **texts,
        "value": np.asarray(values, np.float64),
        "unit": np.full(count, unit, object),
    }


def _blocks(frames: int) -> Iterator[slice]:
    for start in range(0, frames, FRAMES_AT_ONCE):
        yield slice(start, min(start + FRAMES_AT_ONCE, frames))


def _units(group: str, columns: Batch) -> Units:
    units = {name: BY_PATH[f"{group}/{name.partition('.')[0]}"].units for name in columns}
    return {name: "" if unit == "1" else unit for name, unit in units.items()}
