"""Rows into a packed dataset, past HDF5's own zlib.

HDF5 packs by shuffling bytes (all first bytes of the numbers, then all second ones) and zlib, which takes
16 ns a byte. A stream for the same readers comes from igzip (Intel's ISA-L) in a tenth of the time. So
chunks are packed here and handed over as they are. The rows of a chunk that is not full yet are kept; what
`settle` has written of them is packed again with those that follow.
"""

from __future__ import annotations

import itertools
from typing import Any

import h5py
import numpy as np
from isal import isal_zlib
from numpy.typing import NDArray

LEVEL = 1

Numbers = NDArray[Any]


class Packed:
    """A dataset in chunks, with shuffle and gzip, that gets longer. rows: its length."""

    def __init__(self, dataset: h5py.Dataset) -> None:
        self._dataset = dataset
        self._chunks: tuple[int, ...] = dataset.chunks
        self._item: tuple[int, ...] = dataset.shape[1:]
        self._fill = dataset.fillvalue
        self.rows = int(dataset.shape[0])
        self._begun = [self._read_begun()]
        self._settled = self.rows

    def append(self, rows: Numbers) -> None:
        """Rows at the end. Chunks that are full are written, what is left over waits."""
        rows = np.asarray(rows, self._dataset.dtype)
        self._resize(self.rows + len(rows))
        height, waiting = self._chunks[0], self.rows % self._chunks[0]
        start = self.rows - waiting
        self.rows += len(rows)
        if waiting + len(rows) < height:
            self._begun.append(rows.copy())
            return
        self._put(start, np.concatenate([*self._begun, rows[: height - waiting]]))
        for first in range(height - waiting, len(rows) - height + 1, height):
            self._put(start + waiting + first, rows[first : first + height])
        left = self.rows % height
        self._begun = [rows[len(rows) - left :].copy()]

    def settle(self) -> None:
        """Writes what waits."""
        if self._settled < self.rows and self.rows % self._chunks[0]:
            begun = np.concatenate(self._begun)
            self._put(self.rows - len(begun), begun)
            self._begun = [begun]
        self._settled = self.rows

    def cut(self, rows: int) -> None:
        """Shortens it."""
        self._resize(rows)
        self.rows = self._settled = rows
        self._begun = [self._read_begun()]

    def _resize(self, rows: int) -> None:
        """`Dataset.resize` without its questions, which take longer than the resizing."""
        self._dataset.id.set_extent((rows, *self._item))

    def _read_begun(self) -> Numbers:
        """The rows in the last chunk, none when it is full."""
        count = self.rows % self._chunks[0]
        if not count:
            return np.empty((0, *self._dataset.shape[1:]), self._dataset.dtype)
        begun: Numbers = self._dataset[self.rows - count :]
        return begun

    def _put(self, start: int, rows: Numbers) -> None:
        """Rows that begin where chunks do, at most as many as these hold."""
        for corner in _corners(rows.shape, self._chunks):
            part = rows[(slice(None), *map(slice, corner, np.add(corner, self._chunks[1:])))]
            stream = packed(_filled(part, self._chunks, self._fill))
            self._dataset.id.write_direct_chunk((start, *corner), stream)


def _corners(shape: tuple[int, ...], chunks: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Where the chunks beside each other begin, along all axes but the first."""
    across = (range(0, size, step) for size, step in zip(shape[1:], chunks[1:], strict=True))
    return list(itertools.product(*across))


def _filled(part: Numbers, chunks: tuple[int, ...], fill: Any) -> Numbers:
    """The part as a whole chunk: what lies beyond the dataset's edge is what HDF5 leaves there."""
    if part.shape == chunks:
        return part
    chunk = np.full(chunks, fill, part.dtype)
    chunk[tuple(map(slice, part.shape))] = part
    return chunk


def packed(chunk: Numbers) -> bytes:
    """Shuffled and deflated, as HDF5's two filters do it."""
    from physsim._engine import shuffled  # noqa: PLC0415, who only reads needs no engine

    numbers = np.ascontiguousarray(chunk).reshape(-1).view(np.uint8)
    stream: bytes = isal_zlib.compress(shuffled(numbers, chunk.itemsize), LEVEL)
    return stream
