"""Where two plain structures (dictionaries, lists, scalars) are not equal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any


def unequal(before: Any, after: Any, path: str = "") -> Iterator[tuple[str, Any, Any]]:
    """`("bodies.ball.position[2]", 1.0, 2.0)` for every value that differs; None for what is not there."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key in [*before, *(key for key in after if key not in before)]:
            inner = f"{path}.{key}" if path else str(key)
            yield from unequal(before.get(key), after.get(key), inner)
    elif isinstance(before, list | tuple) and isinstance(after, list | tuple) and len(before) == len(after):
        for index, (old, new) in enumerate(zip(before, after, strict=True)):
            yield from unequal(old, new, f"{path}[{index}]")
    elif before != after:
        yield path, before, after
