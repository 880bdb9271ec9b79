"""Profiles in time: tables that rise, expressions that stay finite, ends after starts."""

from __future__ import annotations

import math
from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.between import check_rising
from physsim.scene.draft import Draft
from physsim.scene.program import run
from physsim.scene.spec.profiles import (
    ExpressionProfile,
    ProfileSpec,
    RampProfile,
    SineProfile,
    StepProfile,
    TableProfile,
)

Path = tuple[PathPart, ...]
# Times of the run at which an expression is tried.
TRIED = 20


def check_profile(
    path: Path, profile: ProfileSpec | None, draft: Draft, start: float = 0.0
) -> Iterator[Problem]:
    """Problems of the profile at that path, whose time counts from `start` [s]."""
    if isinstance(profile, TableProfile):
        yield from check_rising(
            (*path, "samples"), profile.samples, "must be later than the sample before it"
        )
    elif isinstance(profile, ExpressionProfile) and draft.simulation is not None:
        span = max(0.0, draft.simulation.duration - start)
        yield from _finite((*path, "value"), profile, span)


def _finite(path: Path, profile: ExpressionProfile, span: float) -> Iterator[Problem]:
    for i in range(TRIED + 1):
        t = span * i / TRIED
        if not math.isfinite(run(profile.program, t)):
            yield Problem(path, f"gives a number that is not finite at t = {t:g} s", profile.value[:80])
            return


def check_window(path: Path, start: float, until: float | None) -> Iterator[Problem]:
    """Problems of the keys `from` and `until` of the mapping at that path."""
    if until is not None and until <= start:
        yield Problem((*path, "until"), f"must be after the start ({start:g} s)", f"{until:g} s")


def first_value(profile: ProfileSpec) -> float:
    """The factor at its start; NaN where an expression has no value there."""
    match profile:
        case SineProfile():
            return math.sin(profile.phase)
        case TableProfile():
            return profile.samples[0][1]
        case ExpressionProfile():
            return run(profile.program, 0.0)
        case RampProfile() | StepProfile():
            return 0.0
