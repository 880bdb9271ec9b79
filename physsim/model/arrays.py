"""Rows of numbers as the arrays that cross the border to the engine."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray


def floats(rows: Sequence[Any], *shape: int) -> FloatArray:
    """(len(rows), *shape) of float64, also when there are no rows."""
    return np.array(rows, dtype=np.float64).reshape(len(rows), *shape)


def wholes(rows: Sequence[Any], *shape: int) -> IntArray:
    """(len(rows), *shape) of int32, also when there are no rows."""
    return np.array(rows, dtype=np.int32).reshape(len(rows), *shape)
