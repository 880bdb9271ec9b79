"""Rows into a packed dataset, whole chunks past HDF5's own zlib.

HDF5 packs by shuffling bytes (all first bytes of the numbers, then all second ones) and zlib, which takes
16 ns a byte. A stream for the same readers comes from igzip (Intel's ISA-L) in a tenth of the time. So
chunks that are begun are packed here and handed over as they are; what goes on inside of a chunk that is
there already goes through HDF5.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import h5py
import numpy as np
from isal import isal_zlib
from numpy.typing import NDArray

LEVEL = 1


def put(dataset: h5py.Dataset, start: int, rows: NDArray[Any]) -> None:
    """Writes rows at the end of a dataset that is long enough for them. dataset: in chunks, with shuffle and
    gzip.
    """
    chunks, count = dataset.chunks, len(rows)
    begun = min(-start % chunks[0], count)
    if begun:
        dataset[start : start + begun] = rows[:begun]
    if begun == count:
        return
    rows, fill, corners = np.asarray(rows, dataset.dtype), dataset.fillvalue, _corners(dataset.shape, chunks)
    for row in range(begun, count, chunks[0]):
        for corner in corners:
            part = rows[(slice(row, row + chunks[0]), *map(slice, corner, np.add(corner, chunks[1:])))]
            stream = packed(_filled(part, chunks, fill))
            dataset.id.write_direct_chunk((start + row, *corner), stream)


def _corners(shape: tuple[int, ...], chunks: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Where the chunks beside each other begin, along all axes but the first."""
    across = (range(0, size, step) for size, step in zip(shape[1:], chunks[1:], strict=True))
    return list(itertools.product(*across))


def _filled(part: NDArray[Any], chunks: tuple[int, ...], fill: Any) -> NDArray[Any]:
    """The part as a whole chunk: what lies beyond the dataset's edge is what HDF5 leaves there."""
    if part.shape == chunks:
        return part
    chunk = np.full(chunks, fill, part.dtype)
    chunk[tuple(map(slice, part.shape))] = part
    return chunk


def packed(chunk: NDArray[Any]) -> bytes:
    """Shuffled and deflated, as HDF5's two filters do it."""
    count = math.prod(chunk.shape)
    shuffled = np.ascontiguousarray(chunk).view(np.uint8).reshape(count, chunk.itemsize).T
    stream: bytes = isal_zlib.compress(np.ascontiguousarray(shuffled), LEVEL)
    return stream
