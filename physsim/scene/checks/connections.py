"""Springs and joints: two different bodies that exist, one way to give damping, limits in order."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from physsim.errors import PathPart, Problem
from physsim.scene.draft import Draft

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `springs` and `joints`."""
    for name, spring in draft.springs.items():
        if spring is not None:
            yield from _between(("springs", name), spring.between, draft)
            yield from _damping(("springs", name), spring)
    for name, joint in draft.joints.items():
        if joint is not None:
            yield from _between(("joints", name), joint.between, draft)
            yield from _limits(("joints", name, "limits"), getattr(joint, "limits", None))


def _between(path: Path, between: tuple[str, str], draft: Draft) -> Iterator[Problem]:
    for i, name in enumerate(between):
        trouble = draft.body_names.trouble(name, world=True)
        if trouble:
            yield Problem((*path, "between", i), trouble[0], hint=trouble[1])
    if between[0] == between[1]:
        yield Problem((*path, "between"), "must be two different bodies", f"{between[0]} twice")
    elif all(draft.body_names.is_fixed(name) for name in between):
        yield Problem((*path, "between"), "are both fixed: there is nothing to move")


def _damping(path: Path, spring: Any) -> Iterator[Problem]:
    if spring.damping is not None and spring.damping_ratio is not None:
        yield Problem((*path, "damping_ratio"), "cannot be given together with damping")


def _limits(path: Path, limits: tuple[float, float] | None) -> Iterator[Problem]:
    if limits is not None and limits[0] > limits[1]:
        yield Problem(path, "must be the lower limit, then the upper one")
