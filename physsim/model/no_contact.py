"""`no_contact` patterns -> pairs of body numbers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from physsim.scene.patterns import matches

Pairs = npt.NDArray[np.int32]


def no_contact_pairs(patterns: Sequence[Sequence[str]], names: Sequence[str]) -> Pairs:
    """Numbers (K, 2) of the different bodies that each row of patterns names, lower first, sorted, each
    once.
    """
    count = len(names)
    codes = [np.empty(0, dtype=np.int64)]
    for first, second in patterns:
        a, b = _matching(first, names), _matching(second, names)
        low = np.minimum(a[:, None], b[None, :]).ravel()
        high = np.maximum(a[:, None], b[None, :]).ravel()
        codes.append(np.unique((low * count + high)[low != high]))
    pairs = np.column_stack(np.divmod(np.unique(np.concatenate(codes)), count))
    return pairs.astype(np.int32)


def _matching(pattern: str, names: Sequence[str]) -> npt.NDArray[np.int64]:
    return np.array([number for number, name in enumerate(names) if matches(pattern, name)], dtype=np.int64)
