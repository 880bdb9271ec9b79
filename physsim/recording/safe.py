"""Opening a file that somebody else may have made, or broken.

Nothing outside the file is followed (soft and external links, external storage, virtual datasets), no
filter is loaded but those that the writer uses, and what a dataset declares is compared with what the file
can hold before anything is read: a file of 1 kB can declare terabytes.
"""

from __future__ import annotations

import math
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from physsim.errors import FileTrouble
from physsim.recording import layout
from physsim.recording.column import Column
from physsim.recording.heaps import broken_heap
from physsim.recording.target import is_being_written, plain

SIGNATURE = b"\x89HDF\r\n\x1a\n"
# gzip cannot shrink anything by more than this (zlib's own limit is 1032).
MOST_COMPRESSION = 1040
MAX_CHUNK_BYTES = 16 << 20
MAX_ATTRIBUTE_BYTES = 1 << 20

_FILTERS = (h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_FLETCHER32)
_LAYOUTS = (h5py.h5d.COMPACT, h5py.h5d.CONTIGUOUS, h5py.h5d.CHUNKED)
_NUMPY_KINDS = {"f8": np.float64, "i8": np.int64, "i4": np.int32, "i1": np.int8, "u1": np.uint8}
# What h5py and numpy raise on files that are not what they say.
_SYMPTOMS = (
    ArithmeticError,
    AttributeError,
    LookupError,
    MemoryError,
    NotImplementedError,
    OSError,
    RuntimeError,
    TypeError,
    ValueError,
)


class Damaged(ValueError):
    """What is wrong with a file, in words; `guarded` adds the file's name."""


@contextmanager
def guarded(path: Path) -> Iterator[None]:
    """Turns whatever a broken file makes h5py raise into FileTrouble with one clear sentence."""
    try:
        yield
    except FileTrouble:
        raise
    except Damaged as error:
        raise FileTrouble(f"{path}: {error}") from error
    except _SYMPTOMS as error:
        raise FileTrouble(f"{path}: the file is damaged and cannot be read ({plain(error)})") from error


def open_for_reading(path: Path, *, trusted: bool = False) -> tuple[h5py.File, bool]:
    """The open file, and whether another process is writing to it.

    trusted: what would hang HDF5 is not looked for, which takes up to 50 ms.
    Raises FileTrouble when it is missing, not a regular file, not HDF5 or not a physsim trajectory.
    """
    _check_signature(path)
    writing = is_being_written(path)
    with guarded(path):
        if not trusted and broken_heap(path) is not None:
            raise Damaged("the texts in the file are damaged, it cannot be read")
        file = _opened(path)
    try:
        with guarded(path):
            _check_format(file)
    except FileTrouble:
        file.close()
        raise
    return file, writing


def _opened(path: Path) -> h5py.File:
    try:
        return h5py.File(path, "r", locking="best-effort")
    except BlockingIOError:
        return h5py.File(path, "r", locking=False)


def text_attribute(file: h5py.File, name: str) -> str:
    """A text attribute of the root, "" when there is none."""
    value = _small_attribute(file, name)
    if value is None:
        return ""
    if not isinstance(value, str):
        raise Damaged(f"the attribute {name} is not a text")
    return value


def number_attribute(file: h5py.File, name: str) -> int:
    """An integer attribute of the root, 0 when there is none."""
    value = _small_attribute(file, name)
    if value is None:
        return 0
    if not isinstance(value, np.integer):
        raise Damaged(f"the attribute {name} is not an integer")
    return int(value)


def dataset(file: h5py.File, column: Column) -> h5py.Dataset | None:
    """The dataset of a column, checked but for its lengths; None when the file has none.

    Raises Damaged when something else stands there.
    """
    here: Any = file
    for part in column.path.split("/"):
        if not isinstance(here, h5py.Group):
            raise Damaged(f"/{column.path}: is not where it should be")
        link = here.get(part, getlink=True)
        if link is None:
            return None
        if not isinstance(link, h5py.HardLink):
            raise Damaged(f"/{column.path}: is a link to elsewhere, which is not followed")
        here = here[part]
    if not isinstance(here, h5py.Dataset):
        raise Damaged(f"/{column.path}: is not a dataset")
    _check_type(column, here)
    _check_storage(column, here, Path(file.filename).stat().st_size)
    return here


def _check_signature(path: Path) -> None:
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            raise FileTrouble(f"{path}: is not a regular file")
        with path.open("rb") as file:
            head = file.read(len(SIGNATURE))
    except (OSError, ValueError) as error:
        raise FileTrouble(f"{path}: {plain(error)}") from error
    if head != SIGNATURE:
        what = "is empty" if not head else "is not an HDF5 file"
        raise FileTrouble(f"{path}: {what}, so it is no trajectory")


def _check_format(file: h5py.File) -> None:
    if text_attribute(file, "format") != layout.FORMAT:
        raise Damaged(
            "is an HDF5 file, but not a physsim trajectory (no attribute format: physsim-trajectory)"
        )
    version = number_attribute(file, "format_version")
    if version != layout.FORMAT_VERSION:
        raise Damaged(f"has format version {version}; this physsim reads version {layout.FORMAT_VERSION}")


def _small_attribute(file: h5py.File, name: str) -> Any:
    if name not in file.attrs:
        return None
    attribute = h5py.h5a.open(file.id, name.encode())
    if attribute.shape != () or attribute.get_storage_size() > MAX_ATTRIBUTE_BYTES:
        raise Damaged(f"the attribute {name} is not a single value")
    if not isinstance(attribute.get_type(), h5py.h5t.TypeStringID | h5py.h5t.TypeIntegerID):
        raise Damaged(f"the attribute {name} is neither a text nor an integer")
    return file.attrs[name]


def _check_type(column: Column, found: h5py.Dataset) -> None:
    if len(found.shape or ()) != len(column.dims) or found.shape is None:
        raise Damaged(f"/{column.path}: has {len(found.shape or ())} axes instead of {len(column.dims)}")
    if column.kind == "str":
        matches = h5py.check_string_dtype(found.dtype) is not None
    else:
        matches = found.dtype == _NUMPY_KINDS[column.kind]
    if not matches:
        raise Damaged(f"/{column.path}: is of type {found.dtype} instead of {column.kind}")


def _check_storage(column: Column, found: h5py.Dataset, file_bytes: int) -> None:
    plan = found.id.get_create_plist()
    filters = [plan.get_filter(index)[0] for index in range(plan.get_nfilters())]
    if plan.get_external_count() or plan.get_layout() not in _LAYOUTS:
        raise Damaged(f"/{column.path}: keeps its numbers in another file, which is not followed")
    if any(number not in _FILTERS for number in filters):
        raise Damaged(f"/{column.path}: is compressed in a way that physsim does not use")
    declared = math.prod(found.shape) * found.dtype.itemsize
    largest = file_bytes
    if found.chunks:
        chunk_bytes = math.prod(found.chunks) * found.dtype.itemsize
        if chunk_bytes > MAX_CHUNK_BYTES:
            raise Damaged(f"/{column.path}: has chunks of {chunk_bytes} bytes")
        largest = MOST_COMPRESSION * file_bytes + MAX_CHUNK_BYTES
    if declared > largest:
        raise Damaged(f"/{column.path}: declares {declared} bytes, more than the whole file can hold")
