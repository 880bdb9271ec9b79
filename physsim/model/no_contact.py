"""`no_contact` patterns -> pairs of body numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from physsim.model.findings import Findings

Pairs = npt.NDArray[np.int32]


def no_contact_pairs(
    patterns: Sequence[Sequence[str]], names: Sequence[str], declared: Sequence[str], findings: Findings
) -> Pairs:
    """Pairs (K, 2) of different bodies, lower number first, sorted, each once.

    A pattern names a body, all copies of a repeated body (by its declared name), or with `*` whatever fits;
    brackets stand for themselves, because repeated bodies carry them. `names` and `declared` are parallel.
    """
    count = len(names)
    codes = [np.empty(0, dtype=np.int64)]
    for index, (first, second) in enumerate(patterns):
        a = _matching(first, names, declared, ("no_contact", index, 0), findings)
        b = _matching(second, names, declared, ("no_contact", index, 1), findings)
        low = np.minimum(a[:, None], b[None, :]).ravel()
        high = np.maximum(a[:, None], b[None, :]).ravel()
        codes.append((low * count + high)[low != high])
    unique = np.unique(np.concatenate(codes))
    return np.column_stack([unique // max(count, 1), unique % max(count, 1)]).astype(np.int32)


def _matching(
    pattern: str,
    names: Sequence[str],
    declared: Sequence[str],
    path: tuple[str | int, ...],
    findings: Findings,
) -> npt.NDArray[np.int64]:
    fits = re.compile(".*".join(re.escape(part) for part in pattern.split("*"))).fullmatch
    found = [
        i for i, (name, base) in enumerate(zip(names, declared, strict=True)) if fits(name) or base == pattern
    ]
    if not found:
        findings.error(path, "fits no body", given=pattern)
    return np.array(found, dtype=np.int64)
