"""Samples that come in the order of time and are wanted by body: kept in a file, not in memory."""

from __future__ import annotations

from collections.abc import Iterator
from typing import IO

import numpy as np
import numpy.typing as npt

from physsim.view.gltf.keyframes import Keys
from physsim.view.stage import FloatArray

SPILL_ROWS = 1 << 18


class Spool:
    """Kept samples of `rows` motions with `width` numbers each, in 32 bits.

    file: where they wait, open for reading and writing. kept: how many samples there are.
    """

    def __init__(self, file: IO[bytes], rows: int, width: int) -> None:
        self._type = np.dtype([("sample", np.uint32), ("values", np.float32, (width,))])
        self._file = file
        self._rows = rows
        self._bounds: list[npt.NDArray[np.intp]] = []
        self._waiting: list[Keys] = []
        self._waiting_rows = 0
        self.kept = 0

    def add(self, keys: Keys) -> None:
        """Samples later than all before of the same row."""
        self._waiting.append(keys)
        self._waiting_rows += len(keys.rows)
        if self._waiting_rows >= SPILL_ROWS:
            self._spill()

    def motions(self) -> Iterator[tuple[npt.NDArray[np.intp], FloatArray]]:
        """Of each row: which samples (n), and their values (n, width)."""
        self._spill()
        self._file.flush()
        kept = (
            np.memmap(self._file, self._type, "r", shape=(self.kept,))
            if self.kept
            else np.empty(0, self._type)
        )
        for row in range(self._rows):
            parts = [kept[bounds[row] : bounds[row + 1]] for bounds in self._bounds]
            own = np.concatenate([*parts, np.empty(0, self._type)])
            yield own["sample"].astype(np.intp), own["values"].astype(np.float64)

    def _spill(self) -> None:
        """What waits goes to the file, row after row."""
        if not self._waiting:
            return
        rows = np.concatenate([keys.rows for keys in self._waiting])
        records = np.empty(len(rows), self._type)
        records["sample"] = np.concatenate([keys.samples for keys in self._waiting])
        records["values"] = np.concatenate([keys.values for keys in self._waiting])
        order = np.argsort(rows, kind="stable")
        self._file.write(records[order].tobytes())
        self._bounds.append(self.kept + np.searchsorted(rows[order], np.arange(self._rows + 1)))
        self.kept += len(rows)
        self._waiting, self._waiting_rows = [], 0
