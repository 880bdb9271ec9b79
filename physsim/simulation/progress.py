"""How far a run has come, told to whoever asked."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from physsim.recording.layout import Status

SECONDS_BETWEEN_REPORTS = 0.1


@dataclass(frozen=True)
class Progress:
    """One report.

    time, duration: simulated, reached and to be reached [s]; step, steps: the same in steps; wall_time:
    seconds by the clock since this call of `run` began stepping; contacts: points in the last step; status:
    as in the file.
    """

    time: float
    duration: float
    step: int
    steps: int
    wall_time: float
    contacts: int
    status: Status


Report = Callable[[Progress], None]


class Throttle:
    """Passes reports on, at most ten a second, but always one that is the last."""

    def __init__(self, report: Report | None) -> None:
        self._report = report
        self._last = -float("inf")

    def __call__(self, make: Callable[[], Progress], *, last: bool = False) -> None:
        """`make` is only called when the report is wanted now."""
        now = time.monotonic()
        if self._report and (last or now - self._last >= SECONDS_BETWEEN_REPORTS):
            self._last = now
            self._report(make())
