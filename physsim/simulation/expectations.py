"""The scene's `expect`: what was wanted, what came, and whether it holds."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from physsim.errors import ExpectationFailed
from physsim.recording.quantities import over_time

if TYPE_CHECKING:
    from physsim.recording import Trajectory
    from physsim.scene.spec.expect import ExpectSpec


@dataclass(frozen=True)
class ExpectationResult:
    """One expectation after the run.

    quantity: its name; unit: SI; time: the time it was looked at [s]; wanted: in words; got: the value; held.
    """

    quantity: str
    unit: str
    time: float
    wanted: str
    got: float
    held: bool

    def __str__(self) -> str:
        unit = f" {self.unit}" if self.unit and self.unit != "1" else ""
        verdict = "holds" if self.held else "does not hold"
        return (
            f"{self.quantity} at {self.time:g} s: wanted {self.wanted}, got {self.got:.9g}{unit}: {verdict}"
        )


def check_expectations(trajectory: Trajectory, expect: Iterable[ExpectSpec]) -> list[ExpectationResult]:
    """Every entry of `expect`, in order.

    `at` between two frames is interpolated linearly; after the last frame (a run that came to rest early)
    the last frame counts. A run that was cut short is judged by the frames it has: that is told by its
    status. Raises NotInFile when an entry asks for what the run did not record.
    """
    return [_checked(trajectory, entry) for entry in expect]


def demand(results: Iterable[ExpectationResult]) -> None:
    """Raises ExpectationFailed naming every one that does not hold."""
    failed = [result for result in results if not result.held]
    if failed:
        raise ExpectationFailed("; ".join(str(result) for result in failed))


def _checked(trajectory: Trajectory, entry: ExpectSpec) -> ExpectationResult:
    quantity = entry.parsed
    last = float(trajectory.time[-1])
    moment = last if entry.at == "end" else min(float(entry.at), last)
    got = float(np.interp(moment, trajectory.time, over_time(trajectory, quantity)))
    return ExpectationResult(
        entry.quantity, quantity.kind.unit, moment, _wanted(entry), got, _held(entry, got)
    )


def _held(entry: ExpectSpec, got: float) -> bool:
    """False for NaN."""
    near = entry.value is None or entry.within is None or abs(got - entry.value) <= entry.within
    above = entry.min is None or got >= entry.min
    below = entry.max is None or got <= entry.max
    return bool(np.isfinite(got) and near and above and below)


def _wanted(entry: ExpectSpec) -> str:
    parts = []
    if entry.value is not None:
        parts.append(f"{entry.value:.9g} within {entry.within:.3g}")
    if entry.min is not None:
        parts.append(f"at least {entry.min:.9g}")
    if entry.max is not None:
        parts.append(f"at most {entry.max:.9g}")
    return " and ".join(parts)
