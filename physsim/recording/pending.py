"""Frames in hand: what has been recorded but not written yet."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Rows = Mapping[str, Any]


class Pending:
    """Rows by dataset path, in the order they came. frames: how many; bytes: how much memory they take."""

    def __init__(self) -> None:
        self.frames = 0
        self.bytes = 0
        self._rows: dict[str, list[NDArray[Any]]] = {}

    def add_frame(self, frame: Rows) -> None:
        """One row of each dataset over time."""
        for path, row in frame.items():
            self._keep(path, np.array(row)[None])
        self.frames += 1

    def add_contacts(self, contacts: Rows, frame: int, written: int) -> None:
        """The contact points of the frame with that number; `written`: rows of /contacts that are in the
        file.
        """
        count = len(contacts["contacts/body_a"])
        self._keep("contacts/frame", np.full(count, frame, np.int64))
        self.add_rows(contacts)
        before = self._rows.get("contacts/offset")
        start = int(before[-1][-1]) if before else written
        offsets = [start, start + count] if frame == 0 else [start + count]
        self._keep("contacts/offset", np.array(offsets, np.int64))

    def add_rows(self, rows: Rows) -> None:
        """Any number of rows for each of some datasets."""
        for path, some in rows.items():
            self._keep(path, np.array(some))

    def of(self, path: str) -> NDArray[Any] | None:
        """All rows of a dataset together; None when there are none."""
        rows = self._rows.get(path)
        if not rows:
            return None
        together = np.concatenate(rows)
        return together if len(together) else None

    def _keep(self, path: str, rows: NDArray[Any]) -> None:
        self._rows.setdefault(path, []).append(rows)
        self.bytes += rows.nbytes
