"""Expectations: bodies that exist, times within the run."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import Problem
from physsim.scene.draft import Draft
from physsim.scene.spec.simulation import ROUNDING


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `expect`."""
    for i, entry in enumerate(draft.expect):
        if entry is None:
            continue
        body = entry.parsed.body
        trouble = draft.body_names.trouble(body) if body is not None else None
        if trouble:
            yield Problem(("expect", i, "quantity"), trouble[0], hint=trouble[1])
        yield from _moment(i, entry.at, draft)


def _moment(i: int, at: float | str, draft: Draft) -> Iterator[Problem]:
    if draft.simulation is None or isinstance(at, str):
        return
    if at > draft.simulation.duration * (1 + ROUNDING):
        yield Problem(
            ("expect", i, "at"), f"is after the end of the run ({draft.simulation.duration:g} s)", f"{at:g} s"
        )
