"""Ctrl-C and SIGTERM: a run notes them and ends in good order, between two steps."""

from __future__ import annotations

import signal
import threading
from types import FrameType
from typing import Any, Self

from physsim.errors import PhyssimError

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class Interrupted(PhyssimError):
    """The run was stopped by Ctrl-C or SIGTERM; what was computed is kept and `--resume` goes on from
    there.
    """

    exit_code = 130


class StopRequest:
    """While open, SIGINT and SIGTERM set `signal` instead of ending the process.

    Nothing is raised where a signal arrives: that could be half-way through a step (in the FCL callback) or a
    write. Handlers are only set in the main thread, where Python allows it, and restored at the end.
    """

    def __init__(self) -> None:
        self.signal: signal.Signals | None = None
        self._before: dict[signal.Signals, Any] = {}

    def __enter__(self) -> Self:
        if threading.current_thread() is threading.main_thread():
            self._before = {number: signal.signal(number, self._note) for number in SIGNALS}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _note(self, number: int, frame: FrameType | None) -> None:
        self.signal = signal.Signals(number)
