"""SIGINT and SIGTERM, handled by somebody for a while."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM)


@contextmanager
def handled(by: Callable[[int, FrameType | None], object]) -> Iterator[None]:
    """While open, SIGINT and SIGTERM call `by`; the handlers that were there come back at the end.

    This also holds where a shell has started us with SIGINT ignored, as it does in the background: otherwise
    nobody could end us but by a kill. Outside the main thread nothing changes: Python allows it only there.
    """
    here = threading.current_thread() is threading.main_thread()
    before = {number: signal.signal(number, by) for number in SIGNALS} if here else {}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
