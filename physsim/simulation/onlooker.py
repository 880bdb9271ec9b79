"""Somebody who looks on while a run computes."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from physsim.recording.block import Rows
from physsim.recording.layout import Status


class Onlooker(Protocol):
    """Is handed what the file is handed. It must return at once, raise nothing and change no array: the run
    waits for it, and its bits must not depend on it. What it is given is never written to again.
    """

    def begin(self, title: str, file: Path, duration: float, fixed: Rows) -> None:
        """Before the first step. file: the trajectory to be; duration: simulated [s]; fixed: datasets that do
        not grow, by path.
        """

    def frame(self, number: int, step: int, time: float, rows: Rows, contacts: Rows | None) -> None:
        """What is recorded as frame `number` of the file, at `time` [s], rows by dataset path; contacts: None
        when they are not recorded.
        """

    def end(self, status: Status, detail: str) -> None:
        """How the run ended; the file is closed."""
