"""The datasets of an open file that get longer during a run."""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from physsim.recording import layout
from physsim.recording.column import Column
from physsim.recording.create import axis_dataset
from physsim.recording.packed import Packed
from physsim.recording.pending import Pending

Numbers = NDArray[Any]


class Growing:
    """Every growing dataset of a file, with its axis."""

    def __init__(self, file: h5py.File, columns: tuple[Column, ...]) -> None:
        self._columns = [column for column in columns if column.grows_along]
        self._datasets = {column.path: Packed(file[column.path]) for column in self._columns}
        self._times: list[Numbers] = []
        self._axes = {
            (group, dim): axis_dataset(file, group, dim) for group, dim in layout.bare_axes(columns)
        }

    def rows(self, path: str) -> int:
        """The length of a dataset, 0 when it is not recorded."""
        return self._datasets[path].rows if path in self._datasets else 0

    def append(self, pending: Pending) -> None:
        """Rows of frames, but for their times, which wait for `append_times`."""
        added = {column.path: pending.of(column.path) for column in self._columns if column.path != "time"}
        counts = added.get("contacts/offset")
        if counts is not None:
            added |= self._numbered(counts)
        for path, rows in added.items():
            self._append(path, rows)
        times = pending.of("time")
        if times is not None:
            self._times.append(times)

    def settle(self) -> None:
        """Writes what waits in chunks that are not full, and how long the axes are."""
        for dataset in self._datasets.values():
            dataset.settle()
        rows = {(column.group, column.dims[0]): self.rows(column.path) for column in self._columns}
        for key, axis in self._axes.items():
            axis.resize(rows.get(key, len(axis)), axis=0)

    def append_times(self) -> None:
        """Makes the frames count, of which all else is written."""
        if self._times:
            self._append("time", np.concatenate(self._times))
            self._times.clear()
            self._datasets["time"].settle()

    def cut(self, lengths: dict[str, int]) -> None:
        """Shortens to a length for each axis."""
        for path, dataset in self._datasets.items():
            dataset.cut(lengths[layout.BY_PATH[path].dims[0]])
        for (_, dim), axis in self._axes.items():
            if dim in lengths:
                axis.resize(lengths[dim], axis=0)

    def _numbered(self, counts: Numbers) -> dict[str, Numbers | None]:
        """`/contacts/frame` and `/contacts/offset` of frames with so many contact points each."""
        first = self.rows("step")
        ends = self.rows("contacts/frame") + np.cumsum(counts)
        frames = np.repeat(np.arange(first, first + len(counts)), counts)
        return {
            "contacts/frame": frames if len(frames) else None,
            "contacts/offset": ends if first else np.concatenate([[0], ends]),
        }

    def _append(self, path: str, added: Numbers | None) -> None:
        if added is not None:
            self._datasets[path].append(added)
