"""`no_contact` patterns -> pairs of body numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from physsim.model.findings import Findings
from physsim.model.placement import WORLD_NAME
from physsim.scene.patterns import matches

if TYPE_CHECKING:
    from physsim.scene.spec.joints import JointSpec

Pairs = npt.NDArray[np.int32]


MAX_PAIRS = 5_000_000
"""Listed pairs; the engine keeps every one (40 million took minutes to list)."""


def joined(joints: Mapping[str, JointSpec]) -> Iterator[tuple[str, str]]:
    """The bodies that joints take out of each other's way: all but those that say `collide: true`."""
    for joint in joints.values():
        if joint.type != "gear" and not joint.collide and WORLD_NAME not in joint.between:
            yield joint.between


def no_contact_pairs(
    patterns: Sequence[Sequence[str]],
    joined: Iterable[tuple[str, str]],
    names: Sequence[str],
    findings: Findings,
) -> Pairs:
    """Numbers (K, 2) of bodies that do not collide, lower first, sorted, each pair once.

    These are the different bodies that each row of `patterns` names, and those that are `joined`. More than
    `MAX_PAIRS` from patterns are an error in `findings`.
    """
    count, listed = len(names), 0
    numbers = {name: number for number, name in enumerate(names)}
    linked = [(numbers[a], numbers[b]) for a, b in joined]
    codes = [np.array([min(pair) * count + max(pair) for pair in linked], dtype=np.int64)]
    for row, (first, second) in enumerate(patterns):
        a, b = _matching(first, names), _matching(second, names)
        listed += len(a) * len(b)
        if listed > MAX_PAIRS:
            hint = "collides: false takes a body out of all contacts"
            findings.error(("no_contact", row), f"names more than {MAX_PAIRS} pairs of bodies", hint=hint)
            break
        low = np.minimum(a[:, None], b[None, :]).ravel()
        high = np.maximum(a[:, None], b[None, :]).ravel()
        codes.append((low * count + high)[low != high])
    ordered = np.sort(np.concatenate(codes))  # np.unique hashes, which takes ten times as long here
    once = ordered[np.diff(ordered, prepend=-1) > 0]
    pairs = np.column_stack(np.divmod(once, count))
    return pairs.astype(np.int32)


def _matching(pattern: str, names: Sequence[str]) -> npt.NDArray[np.int64]:
    return np.array([number for number, name in enumerate(names) if matches(pattern, name)], dtype=np.int64)
