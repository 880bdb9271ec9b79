"""Frames that follow each other, as they are handed to a recorder."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Rows = Mapping[str, Any]


@dataclass(frozen=True)
class Block:
    """Rows by dataset path.

    rows: of every dataset over time, (frames, ...), `time` among them; contacts: of all frames one after the
    other, None when they are not recorded; counts: contact points of each frame; events: impacts up to the
    last frame, or since.
    """

    rows: Rows
    contacts: Rows | None = None
    counts: NDArray[np.integer[Any]] = field(default_factory=lambda: np.zeros(0, np.int64))
    events: Rows = field(default_factory=dict)

    @property
    def frames(self) -> int:
        return len(self.rows["time"]) if self.rows else 0

    def __iter__(self) -> Iterator[tuple[Rows, Rows | None]]:
        """Frame by frame: its rows, and those of its contacts."""
        ends = np.cumsum(self.counts)
        for index in range(self.frames):
            rows = {path: found[index] for path, found in self.rows.items()}
            if self.contacts is None:
                yield rows, None
            else:
                own = slice(ends[index] - self.counts[index], ends[index])
                yield rows, {path: found[own] for path, found in self.contacts.items()}


def joined(parts: Sequence[Rows]) -> dict[str, Any]:
    """Rows that follow each other, together, by name."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
