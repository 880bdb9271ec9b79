"""What springs and joints share: two different bodies that exist, one of which can move; limits in order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from physsim.errors import PathPart, Problem
from physsim.scene.draft import Draft

Path = tuple[PathPart, ...]


def check_between(path: Path, between: tuple[str, str], draft: Draft) -> Iterator[Problem]:
    """Problems of the key `between` of the spring or joint at that path."""
    for i, name in enumerate(between):
        trouble = draft.body_names.trouble(name, world=True)
        if trouble:
            yield Problem((*path, "between", i), trouble[0], hint=trouble[1])
    if between[0] == between[1]:
        yield Problem((*path, "between"), "must be two different bodies", f"{between[0]} twice")
    elif all(draft.body_names.is_fixed(name) for name in between):
        yield Problem((*path, "between"), "are both fixed: there is nothing to move")


def check_limits(path: Path, limits: tuple[float, float] | None, restitution: float) -> Iterator[Problem]:
    """Problems of the keys `limits` and `restitution` of the mapping at that path."""
    if limits is None:
        if restitution > 0:
            yield Problem((*path, "restitution"), "needs limits beside it")
    elif limits[0] >= limits[1]:
        yield Problem((*path, "limits"), "must be the lower limit, then the upper one")


def check_rising(
    path: Path,
    rows: Sequence[tuple[float, float]] | None,
    told: str = "must be greater than the one before it",
) -> Iterator[Problem]:
    """Problems of a table whose first column must rise."""
    for i, (before, after) in enumerate(pairwise(rows or ()), start=1):
        if after[0] <= before[0]:
            yield Problem((*path, i, 0), told, f"{after[0]:g}")
