"""A check that HDF5 leaves out: a damaged heap of texts makes it run in a circle for ever (seen with HDF5
2.0).

Layout: HDF5 File Format Specification 3.0, III.E, "Disk Format: Level 1E - Global Heap". A collection is
"GCOL", version 1, its size, then objects, each with a header of 16 bytes; object 0 is the free space and
counts its header.
"""

from __future__ import annotations

import mmap
from collections.abc import Iterator
from pathlib import Path

_MARK = b"GCOL\x01"
_HEADER = 16
_SMALLEST = 4096
# Texts are written when a file is made and when it is finished: only so much of its two ends is looked
# through.
BYTES_AT_EACH_END = 32 << 20


def broken_heap(path: Path) -> int | None:
    """Where a heap begins that HDF5 would not come back from, in bytes; None when all is well."""
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        return next((start for start in _heaps(data) if not _can_be_walked(data, start)), None)


def _heaps(data: mmap.mmap) -> Iterator[int]:
    """Where collections begin. What only looks like one says an impossible size: HDF5 refuses that itself."""
    end, tail = len(data), max(0, len(data) - BYTES_AT_EACH_END)
    for first, last in ((0, min(end, BYTES_AT_EACH_END)), (tail, end)):
        start = data.find(_MARK, first, last)
        while start >= 0:
            if _SMALLEST <= _number(data, start + 8) <= end - start:
                yield start
            start = data.find(_MARK, start + 1, last)


def _can_be_walked(data: mmap.mmap, start: int) -> bool:
    here, end = start + _HEADER, start + _number(data, start + 8)
    while here + _HEADER <= end:
        is_free_space = data[here : here + 2] == b"\0\0"
        size = _number(data, here + 8)
        step = size if is_free_space else _HEADER + (size + 7) // 8 * 8
        if not 0 < step <= end - here:
            return False
        here += step
    return True


def _number(data: mmap.mmap, at: int) -> int:
    return int.from_bytes(data[at : at + 8], "little")
