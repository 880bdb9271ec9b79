"""Forces: a body that exists, something that acts, an end after the start, tables that rise."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from physsim.errors import PathPart, Problem
from physsim.scene.draft import Draft
from physsim.scene.spec.forces import ForceSpec
from physsim.scene.spec.profiles import TableProfile

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `forces`."""
    for name, force in draft.forces.items():
        if force is not None:
            yield from _force(("forces", name), force, draft)


def _force(path: Path, force: ForceSpec, draft: Draft) -> Iterator[Problem]:
    trouble = draft.body_names.trouble(force.body)
    if trouble:
        yield Problem((*path, "body"), trouble[0], hint=trouble[1])
    if force.force is None and force.torque is None:
        yield Problem(path, "does nothing: give force or torque")
    if force.until is not None and force.until <= force.from_:
        yield Problem((*path, "until"), f"must be after the start ({force.from_:g} s)", f"{force.until:g} s")
    if isinstance(force.profile, TableProfile):
        yield from _table((*path, "profile", "samples"), force.profile)


def _table(path: Path, profile: TableProfile) -> Iterator[Problem]:
    for i, (before, after) in enumerate(pairwise(profile.samples)):
        if after[0] <= before[0]:
            yield Problem((*path, i + 1), "must be later than the sample before it", f"{after[0]:g} s")
