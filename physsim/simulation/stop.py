"""Ctrl-C and SIGTERM: a run notes them and ends in good order, between two steps."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Self

from physsim.errors import PhyssimError
from physsim.signals import handled


class Interrupted(PhyssimError):
    """The run was stopped by Ctrl-C or SIGTERM; what was computed is kept and `--resume` goes on from
    there.
    """

    exit_code = 130


class StopRequest:
    """Has somebody asked to stop? `signal` is the signal that did, None as long as there was none.

    Nothing is raised where a signal arrives: that could be half-way through a step (in the FCL callback) or a
    write.
    """

    def __init__(self) -> None:
        self.signal: signal.Signals | None = None

    @classmethod
    @contextmanager
    def heard(cls) -> Iterator[Self]:
        """While open, SIGINT and SIGTERM are noted here instead of ending the process."""
        stop = cls()
        with handled(stop._note):
            yield stop

    def _note(self, number: int, _: FrameType | None) -> None:
        self.signal = signal.Signals(number)
