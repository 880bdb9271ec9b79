"""Rules that make a coefficient for two materials from one of each.

None of them is physics: restitution and friction belong to a pair. They are what simulators use where
nobody has measured the pair, and the scene says which.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import sqrt
from types import MappingProxyType


def _harmonic_mean(a: float, b: float) -> float:
    return 2 * a * b / (a + b) if a + b > 0 else 0.0


RULES: Mapping[str, Callable[[float, float], float]] = MappingProxyType(
    {
        "minimum": min,
        "maximum": max,
        "mean": lambda a, b: (a + b) / 2,
        "geometric_mean": lambda a, b: sqrt(a * b),
        "harmonic_mean": _harmonic_mean,
        "product": lambda a, b: a * b,
    }
)
"""Every rule but `error`, which refuses to mix. All are symmetric, and all but `product` leave equals as
they are.
"""
