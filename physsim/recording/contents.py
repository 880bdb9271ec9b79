"""Which datasets a file has, checked against the table in `layout`."""

from __future__ import annotations

import h5py
import numpy as np

from physsim.recording import layout
from physsim.recording.column import FIXED_AXES, Column
from physsim.recording.safe import Damaged, dataset

_LABELLED_AXES = {"body": "body", "pair": "pairs/pair", "joint": "joints/joint", "spring": "springs/spring"}

Datasets = dict[str, h5py.Dataset]


def find_datasets(file: h5py.File) -> Datasets:
    """Every dataset of the table that the file has, by path.

    Raises Damaged when one is missing, of another type or axes than the table says, or declares more than the
    file can hold; and when a group that may be absent is there in parts.
    """
    found: Datasets = {}
    for column in layout.EVERYTHING:
        there = dataset(file, column)
        if there is not None:
            found[column.path] = there
        elif column.group not in layout.OPTIONAL_GROUPS and not column.later:
            raise Damaged(f"has no dataset /{column.path}: the file is damaged")
    _check_groups_whole(found)
    sizes = {dim: len(labels) for dim, labels in FIXED_AXES.items()}
    sizes |= {dim: found[path].shape[0] for dim, path in _LABELLED_AXES.items() if path in found}
    for path, there in found.items():
        _check_lengths(layout.BY_PATH[path], there, sizes)
    return found


def whole_frames(datasets: Datasets) -> int:
    """The length of the shortest dataset over time, less frames whose time was not written."""
    lengths = [
        found.shape[0] - (layout.BY_PATH[path].grows_along == "boundary")
        for path, found in datasets.items()
        if layout.BY_PATH[path].grows_along in {"time", "boundary"}
    ]
    times = datasets["time"][: max(min(lengths), 0)]
    missing = np.flatnonzero(~np.isfinite(times))
    return int(missing[0]) if len(missing) else len(times)


def columns_of(group: str) -> list[Column]:
    """The table's columns of a group, in its order."""
    return [column for column in layout.EVERYTHING if column.group == group]


def _check_groups_whole(datasets: Datasets) -> None:
    for group in layout.OPTIONAL_GROUPS:
        there = [column.path in datasets for column in columns_of(group) if not column.later]
        if any(there) and not all(there):
            raise Damaged(f"/{group} is not whole: the file is damaged")


def _check_lengths(column: Column, found: h5py.Dataset, sizes: dict[str, int]) -> None:
    for dim, length in zip(column.dims, found.shape, strict=True):
        if dim in sizes and length != sizes[dim]:
            raise Damaged(f"/{column.path}: has length {length} along {dim} instead of {sizes[dim]}")
