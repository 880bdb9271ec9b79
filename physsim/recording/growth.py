"""The datasets of an open file that get longer during a run."""

from __future__ import annotations

import h5py
import numpy as np
from numpy.typing import NDArray

from physsim.recording import layout
from physsim.recording.column import Column
from physsim.recording.create import axis_dataset
from physsim.recording.packed import put
from physsim.recording.pending import Pending


class Growing:
    """Every growing dataset of a file, with its axis."""

    def __init__(self, file: h5py.File, columns: tuple[Column, ...]) -> None:
        self._columns = [column for column in columns if column.grows_along]
        self._datasets = {column.path: file[column.path] for column in self._columns}
        self._axes = {
            (group, dim): axis_dataset(file, group, dim) for group, dim in layout.bare_axes(columns)
        }

    def rows(self, path: str) -> int:
        """The length of a dataset, 0 when it is not recorded."""
        return int(self._datasets[path].shape[0]) if path in self._datasets else 0

    def append_all_but_time(self, pending: Pending) -> None:
        for column in self._columns:
            if column.path != "time":
                self._append(column, pending)

    def append_time(self, pending: Pending) -> None:
        self._append(layout.BY_PATH["time"], pending)

    def cut(self, lengths: dict[str, int]) -> None:
        """Shortens to a length for each axis."""
        for path, dataset in self._datasets.items():
            dataset.resize(lengths[layout.BY_PATH[path].dims[0]], axis=0)
        for (_, dim), axis in self._axes.items():
            if dim in lengths:
                axis.resize(lengths[dim], axis=0)

    def _append(self, column: Column, pending: Pending) -> None:
        added: NDArray[np.generic] | None = pending.of(column.path)
        if added is None:
            return
        dataset = self._datasets[column.path]
        start = dataset.shape[0]
        dataset.resize(start + len(added), axis=0)
        put(dataset, start, added)
        axis = self._axes.get((column.group, column.dims[0]))
        if axis is not None:
            axis.resize(start + len(added), axis=0)
