"""A new trajectory file: datasets, axes and labels from the table in `layout`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import h5py
import numpy as np

from physsim.recording import layout
from physsim.recording.column import FIXED_AXES, Column
from physsim.recording.disk import Disk

# HDF5 1.8 and later read this; "latest" would be read by HDF5 2.0 only.
LIBVER = ("earliest", "v110")
# One chunk of a per-body (joint, spring) dataset: in a scene of up to so many bodies at most so many of them,
# and as many frames as fit. Frames of a chunk are in memory together, so a large scene has fewer.
CHUNK_ITEMS = ((2048, 64), (8192, 128))
MOST_CHUNK_ITEMS = 256
ITEM_AXES = ("body", "joint", "spring")
CHUNK_BYTES = 192 * 1024
CHUNK_FRAMES = (16, 1024)
# Frames are packed when they hold about so many bodies: enough to make a call worth its while, so few that
# their memory stays with the process and little is left to do at the end.
PART_ITEMS = 16 * 1024
# Rows of /contacts and /events: about those of some frames, within bounds.
CHUNK_ROWS = (1024, 16384)
ROWS_PER_BODY = 16
# What does not grow is packed when it is larger than this: meshes.
PACKED_BYTES = 64 * 1024
PACKED_ROWS = 4096
SMALL_CHUNK_FRAMES = 256

# netCDF's own words for an axis that has a length but no labels.
_BARE_AXIS = "This is a netCDF dimension but not a netCDF variable."
_PACKED = {"compression": "gzip", "compression_opts": 1, "shuffle": True}
_NUMPY_KINDS = {"f8": np.float64, "i8": np.int64, "i4": np.int32, "i1": np.int8, "u1": np.uint8}


def fill_new_file(
    disk: Disk, columns: tuple[Column, ...], attributes: Mapping[str, Any], values: Mapping[str, Any]
) -> h5py.File:
    """Every dataset of `columns`, fixed ones filled from `values` (by path), growing ones empty.

    `attributes` go to the root. Freed room in the file is never used again ("none"): a chunk that is written
    anew does not overwrite what the file on disk still points to, so a kill between two writes loses nothing.
    """
    file = h5py.File(disk, "w", libver=LIBVER, fs_strategy="none")
    _set_attributes(file, attributes)
    sizes = _sizes(columns, values)
    made = {column.path: _create_dataset(file, column, sizes, values) for column in columns}
    made |= _create_bare_axes(file, columns, sizes)
    for column in columns:
        _attach_axes(made, column)
    return file


def block_frames(bodies: int) -> int:
    """Frames per chunk, and per block between two flushes: a power of two."""
    row_bytes = 4 * 8 * min(max(bodies, 1), chunk_items(bodies))
    fitting = 1 << ((CHUNK_BYTES // row_bytes).bit_length() - 1)
    return min(max(fitting, CHUNK_FRAMES[0]), CHUNK_FRAMES[1])


def part_frames(bodies: int) -> int:
    """Frames that are packed together, while the next ones are made: a power of two, no more than a block."""
    fitting = 1 << max(PART_ITEMS // max(bodies, 1), 1).bit_length() - 1
    return min(fitting, block_frames(bodies))


def chunk_items(bodies: int) -> int:
    """Bodies, joints or springs per chunk."""
    return next((items for most, items in CHUNK_ITEMS if bodies <= most), MOST_CHUNK_ITEMS)


def chunk_rows(bodies: int) -> int:
    """Contacts or impacts per chunk: a power of two."""
    return min(max(1 << (ROWS_PER_BODY * bodies).bit_length(), CHUNK_ROWS[0]), CHUNK_ROWS[1])


def axis_dataset(datasets: Mapping[str, h5py.Dataset], group: str, dim: str) -> h5py.Dataset:
    """The dimension scale of an axis: in the group itself, or else in the root. datasets: by path."""
    own = f"{group}/{dim}" if group else dim
    return datasets[own] if own in datasets else datasets[dim]


def _set_attributes(file: h5py.File, attributes: Mapping[str, Any]) -> None:
    file.attrs["format"] = layout.FORMAT
    file.attrs["format_version"] = np.int64(layout.FORMAT_VERSION)
    file.attrs["Conventions"] = layout.CONVENTIONS
    for name, value in attributes.items():
        file.attrs[name] = value


def _sizes(columns: tuple[Column, ...], values: Mapping[str, Any]) -> dict[str, int]:
    """The length of every axis that does not grow."""
    sizes = {dim: len(labels) for dim, labels in FIXED_AXES.items()}
    for column in columns:
        if column.path in values and not column.grows_along:
            sizes |= zip(column.dims, np.shape(values[column.path]), strict=True)
    return sizes


def _create_dataset(
    file: h5py.File, column: Column, sizes: Mapping[str, int], values: Mapping[str, Any]
) -> h5py.Dataset:
    shape = tuple(sizes.get(dim, 0) for dim in column.dims)
    dataset = file.create_dataset(
        column.path,
        shape=shape,
        dtype=_dtype(column),
        fillvalue=_missing(column),
        **_storage(column, shape, sizes),
    )
    dataset.attrs["units"] = column.units
    dataset.attrs["long_name"] = column.description
    if column.name in FIXED_AXES and column.is_scale:
        dataset[:] = list(FIXED_AXES[column.name])
    elif column.path in values and np.size(values[column.path]):
        dataset[...] = values[column.path]
    return dataset


def _storage(column: Column, shape: tuple[int, ...], sizes: Mapping[str, int]) -> dict[str, Any]:
    """How a dataset is cut into chunks and packed."""
    if column.grows_along:
        return {"maxshape": (None, *shape[1:]), "chunks": _chunks(column, shape, sizes), **_PACKED}
    if column.dims == ("byte",):
        return {"maxshape": (None,), "chunks": (1 << 16,)}
    if column.kind != "str" and 8 * math.prod(shape) > PACKED_BYTES:
        return {"chunks": (min(shape[0], PACKED_ROWS), *shape[1:]), **_PACKED}
    return {}


def _dtype(column: Column) -> Any:
    return h5py.string_dtype() if column.kind == "str" else _NUMPY_KINDS[column.kind]


def _missing(column: Column) -> Any:
    """What a reader finds where nothing was written: not a number, or -1, never a plausible 0."""
    return {"f8": np.nan, "i8": -1, "i4": -1, "i1": -1}.get(column.kind)


def _chunks(column: Column, shape: tuple[int, ...], sizes: Mapping[str, int]) -> tuple[int, ...]:
    if column.grows_along != "time":
        return (chunk_rows(sizes["body"]), *shape[1:])
    frames = block_frames(sizes["body"])
    if len(shape) < 2 or column.dims[1] not in ITEM_AXES:
        return (max(frames, SMALL_CHUNK_FRAMES), *shape[1:])
    return (frames, max(min(shape[1], chunk_items(sizes["body"])), 1), *shape[2:])


def _create_bare_axes(
    file: h5py.File, columns: tuple[Column, ...], sizes: Mapping[str, int]
) -> dict[str, h5py.Dataset]:
    made = {}
    for group, dim in layout.bare_axes(columns):
        path, shape = f"{group}/{dim}", (sizes.get(dim, 0),)
        axis = file.create_dataset(path, shape=shape, maxshape=(None,), chunks=(1 << 16,), dtype=np.int8)
        axis.attrs["units"] = "1"
        axis.make_scale(_BARE_AXIS)
        made[path] = axis
    return made


def _attach_axes(made: Mapping[str, h5py.Dataset], column: Column) -> None:
    dataset = made[column.path]
    if column.is_scale:
        dataset.make_scale(column.name)
        return
    for index, dim in enumerate(column.dims):
        dataset.dims[index].attach_scale(axis_dataset(made, column.group, dim))
