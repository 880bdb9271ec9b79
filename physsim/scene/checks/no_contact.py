"""`no_contact`: every pattern names at least one body."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import Problem
from physsim.scene.draft import Draft
from physsim.scene.suggest import did_you_mean

# Patterns times bodies that are compared: some seconds at most.
MAX_COMPARISONS = 20_000_000


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `no_contact`."""
    rows = [(i, row) for i, row in enumerate(draft.no_contact) if row is not None]
    patterns = {pattern for _, row in rows for pattern in row}
    if len(patterns) * draft.body_names.total > MAX_COMPARISONS:
        yield Problem(("no_contact",), "has too many patterns for so many bodies")
        return
    good = {pattern for pattern in patterns if _names_a_body(pattern, draft)}
    for i, row in rows:
        for k, pattern in enumerate(row):
            if pattern not in good:
                hint = did_you_mean(pattern.strip("*"), draft.bodies)
                yield Problem(("no_contact", i, k), "fits the name of no body", pattern, hint=hint)


def _names_a_body(pattern: str, draft: Draft) -> bool:
    if "*" not in pattern:
        return draft.body_names.trouble(pattern) is None
    return any(draft.body_names.fitting(pattern))
