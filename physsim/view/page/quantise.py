"""Real numbers as whole ones: each row has a range of its own, cut into equal steps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from physsim.view.page.coding import NUMBERS_AT_ONCE, Codes
from physsim.view.stage import FloatArray

ROUNDINGS = 4
"""Base + code * step is rounded three times in double precision, and once when it is packed."""


@dataclass(frozen=True)
class Quantised:
    """codes (R, T): value = base + code * step; the highest code of all, 256**planes - 1, stands for NaN.

    base, step and error are (R,), in the unit of the values; no value is further off than error.
    """

    codes: Codes
    base: FloatArray
    step: FloatArray
    error: FloatArray


def quantised(values: FloatArray, planes: int, whole: bool = False) -> Quantised:
    """Values (R, T) in `planes` bytes each. What is not finite becomes NaN.

    The step is the row's range / (256**planes - 2), so the error is half of that: range / 2**17 for 2 bytes,
    range / 2**33 for 4. `whole`: the values are whole numbers, and stay exact where their range allows.
    """
    highest = 256**planes - 2
    base, top = _ranges(values)
    step = top / highest - base / highest
    # Steps that are no normal numbers have too few digits to count with: less than one counts as none.
    step = np.where(step < np.finfo(np.float64).tiny, 0.0, step)
    if whole:
        step = np.where(step > 0, np.maximum(step, 1.0), 0.0)
    rounding = ROUNDINGS * np.finfo(np.float64).eps * np.maximum(np.abs(base), np.abs(top))
    exact = (step == 0) | (whole & (step == 1))
    error = np.where(exact, np.where(step == 0, top - base, 0.0), step / 2 + rounding)
    codes = np.empty(values.shape, np.uint32)
    rows = max(1, NUMBERS_AT_ONCE // max(1, values.shape[1]))
    for first in range(0, len(values), rows):
        some = slice(first, first + rows)
        codes[some] = _codes(values[some], base[some, None], step[some, None], highest)
    return Quantised(codes, base, step, error)


def _ranges(values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Least and greatest finite value of each row; 0 and 0 where there is none."""
    if values.shape[1] == 0:
        return np.zeros(len(values)), np.zeros(len(values))
    finite = np.isfinite(values)
    low = np.min(values, axis=1, initial=np.inf, where=finite)
    high = np.max(values, axis=1, initial=-np.inf, where=finite)
    none = low > high
    return np.where(none, 0.0, low), np.where(none, 0.0, high)


def _codes(values: FloatArray, base: FloatArray, step: FloatArray, highest: int) -> Codes:
    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        # Halved, as the whole range of double precision is twice its largest number.
        steps = (values / 2 - base / 2) / np.where(step > 0, step / 2, np.inf)
    found = np.isfinite(values)
    nearest = np.clip(np.rint(np.where(found, steps, 0)), 0, highest)
    return np.where(found, nearest, highest + 1).astype(np.uint32)
