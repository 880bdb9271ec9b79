"""Frames in hand: what has been recorded but not written yet."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from physsim.recording.block import Block, Rows


class Pending:
    """Blocks in the order they came. frames: how many they hold together."""

    def __init__(self) -> None:
        self.frames = 0
        self._rows: dict[str, list[NDArray[Any]]] = {}

    def add(self, block: Block) -> None:
        """What follows on what is here."""
        self.frames += block.frames
        self._keep(block.events)
        self._keep(block.rows)
        if block.contacts is not None:
            self._keep({"contacts/offset": block.counts, **block.contacts})

    def of(self, path: str) -> NDArray[Any] | None:
        """All rows of a dataset together; None when there are none.

        `contacts/offset`: how many contact points each frame has.
        """
        rows = self._rows.get(path)
        if not rows:
            return None
        together = rows[0] if len(rows) == 1 else np.concatenate(rows)
        return together if len(together) else None

    def _keep(self, rows: Rows) -> None:
        for path, some in rows.items():
            self._rows.setdefault(path, []).append(np.asarray(some))
