"""Whole numbers over time in few bytes: differences along the row, byte planes, deflate.

Motion is smooth, so the number that continues the last ones (the same again, a line, a parabola) is nearly
right, and what is left is small. Its upper bytes are then almost always 0; put beside each other they cost
next to nothing. The page undoes it in viewer/src/coding.ts.
"""

from __future__ import annotations

import zlib

import numpy as np
import numpy.typing as npt

Codes = npt.NDArray[np.uint32]
Bytes = npt.NDArray[np.uint8]

ORDERS = 4
"""Differences are taken 0 to 3 times, whichever leaves least in a row."""
LEVEL = 6
"""Of zlib: level 9 takes three times as long for 1 % less."""
NUMBERS_AT_ONCE = 1 << 20


def encoded(codes: Codes, planes: int) -> bytes:
    """A table of whole numbers (R, T), each below 256**planes, as a zlib stream.

    In it: R bytes, how often differences were taken in each row; then `planes` times R * T bytes, the lowest
    of all residuals first. A residual r is stored as 2 r or -2 r - 1: small ones of both signs are small.
    """
    rows, length = codes.shape
    orders = np.zeros(rows, np.uint8)
    table = np.empty((planes, rows, length), np.uint8)
    step = max(1, NUMBERS_AT_ONCE // max(1, length))
    for first in range(0, rows, step):
        some = slice(first, first + step)
        orders[some], residuals = _best(codes[some], planes)
        for plane in range(planes):
            table[plane, some] = residuals >> np.uint32(8 * plane)
    return zlib.compress(orders.tobytes() + table.tobytes(), LEVEL)


def _best(codes: Codes, planes: int) -> tuple[Bytes, Codes]:
    """For each row the order of differences that leaves least, and its residuals.

    Computed in the upper bits of 32, so that what runs over falls off as it will when it is undone.
    """
    unused = np.uint32(32 - 8 * planes)
    current = codes << unused
    best = _folded(current, unused)
    least = _cost(best)
    orders = np.zeros(len(codes), np.uint8)
    for order in range(1, ORDERS):
        current = current.copy()
        current[:, 1:] -= current[:, :-1].copy()
        candidate = _folded(current, unused)
        cost = _cost(candidate)
        better = cost < least
        best[better], least[better], orders[better] = candidate[better], cost[better], order
    return orders, best


def _folded(upper: Codes, unused: np.uint32) -> Codes:
    """Signed residuals, held in the upper bits, as small positive numbers: 0, -1, 1, -2 become 0, 1, 2, 3."""
    signed = upper.view(np.int32) >> unused.view(np.int32)
    return ((signed << 1) ^ (signed >> 31)).view(np.uint32)


def _cost(residuals: Codes) -> npt.NDArray[np.float32]:
    """About how many bits each row takes."""
    return np.asarray(np.log2(residuals.astype(np.float32) + 1).sum(axis=1), np.float32)
