"""Stopping a run at a step of one's choice."""

from __future__ import annotations

import signal
from collections.abc import Callable

import pytest

from physsim.simulation import Progress, loop


@pytest.fixture(autouse=True)
def many_short_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    """The engine is called for one or a few steps at a time, so that a stop can fall anywhere."""
    monkeypatch.setattr(loop, "SECONDS_PER_CALL", 1e-5)
    monkeypatch.setattr("physsim.simulation.progress.SECONDS_BETWEEN_REPORTS", 0.0)


def stopping_at(step: int) -> Callable[[Progress], None]:
    """A progress function that asks the run to stop, as Ctrl-C does."""

    def report(progress: Progress) -> None:
        if progress.step >= step and progress.status == "running":
            signal.raise_signal(signal.SIGINT)

    return report
