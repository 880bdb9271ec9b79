"""What springs and joints share: two bodies, and the point of each that they are tied to."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from physsim.model.arrays import floats, wholes
from physsim.model.placement import Placed
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray


class Tied(Protocol):
    """ends: the bodies A and B; anchors: two arms from the centres of mass, body axes [m]."""

    @property
    def ends(self) -> tuple[Placed, Placed]: ...
    @property
    def anchors(self) -> tuple[FloatArray, FloatArray]: ...


class TiedTable:
    """Rows that tie two bodies each."""

    rows: Sequence[Tied]

    @property
    def bodies(self) -> IntArray:
        """Numbers (rows, 2) of A and B, -1 for the world."""
        return wholes([[end.number for end in row.ends] for row in self.rows], 2)

    @property
    def anchors(self) -> FloatArray:
        """(rows, 2, 3) m, each in its body's own frame."""
        return floats(
            [[arm + end.offset for arm, end in zip(row.anchors, row.ends, strict=True)] for row in self.rows],
            2,
            3,
        )
