"""What the scene language has and this version does not do yet: refused at its line, never ignored.

A feature that has come to work loses its row here; nothing else in the scene room changes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from physsim.errors import PathPart, Problem
from physsim.scene.draft import Draft


@dataclass(frozen=True)
class NotYet:
    """A path that is refused unless its value is one of `works`; a mapping is refused entry by entry."""

    path: tuple[str, ...]
    feature: str
    works: tuple[Any, ...] = ()


NOT_YET: tuple[NotYet, ...] = (
    NotYet(("springs",), "springs"),
    NotYet(("joints",), "joints"),
    NotYet(("forces",), "forces"),
    NotYet(("world", "gravitation"), "gravitation", works=(0.0,)),
    NotYet(("simulation", "integrator"), "this integrator", works=("semi_implicit_euler",)),
    NotYet(("simulation", "impacts"), "located impacts", works=("stepped",)),
    NotYet(("simulation", "threads"), "more than one thread", works=(1,)),
)


def refusals(draft: Draft) -> Iterator[Problem]:
    """A problem for everything in the scene that is not supported yet."""
    for row in NOT_YET:
        value: Any = draft
        for key in row.path:
            value = getattr(value, key, None)
        yield from _refused(row, value)


def _refused(row: NotYet, value: Any) -> Iterator[Problem]:
    if value is None or value in row.works:
        return
    entries: list[tuple[PathPart, ...]] = [(name,) for name in value] if isinstance(value, dict) else [()]
    for entry in entries:
        works = ", ".join(map(str, row.works)) or None
        yield Problem((*row.path, *entry), f"not supported yet: {row.feature}", allowed=works)
