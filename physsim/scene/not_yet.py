"""What the scene language has and this version does not do yet: refused at its line, never ignored.

A feature that has come to work loses its row here; nothing else in the scene room changes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from physsim.errors import Problem
from physsim.scene.draft import Draft


@dataclass(frozen=True)
class NotYet:
    """A path that is refused unless its value is one of `works`."""

    path: tuple[str, ...]
    feature: str
    works: tuple[Any, ...]


NOT_YET: tuple[NotYet, ...] = (NotYet(("simulation", "threads"), "more than one thread", works=(1,)),)


def refusals(draft: Draft) -> Iterator[Problem]:
    """A problem for everything in the scene that is not supported yet."""
    for row in NOT_YET:
        value: Any = draft
        for key in row.path:
            value = getattr(value, key, None)
        if value is not None and value not in row.works:
            works = ", ".join(map(str, row.works))
            yield Problem(row.path, f"not supported yet: {row.feature}", allowed=works)
