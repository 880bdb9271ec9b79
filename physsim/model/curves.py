"""Curves of straight pieces, (n, 2) rows of (argument, value), the last pieces going on outside."""

from __future__ import annotations

import numpy as np

from physsim.model.rotation import FloatArray


def slope_at_zero(curve: FloatArray) -> float:
    """Slope at argument 0; in a corner the mean of both sides."""
    slopes = _slopes(curve)
    inner = curve[1:-1, 0]
    left, right = np.searchsorted(inner, 0.0, side="left"), np.searchsorted(inner, 0.0, side="right")
    return float((slopes[left] + slopes[right]) / 2)


def steepest(curve: FloatArray) -> float:
    """The largest slope, at least 0."""
    return max(float(_slopes(curve).max()), 0.0)


def _slopes(curve: FloatArray) -> FloatArray:
    rise = np.diff(curve, axis=0)
    slopes: FloatArray = rise[:, 1] / rise[:, 0]
    return slopes
