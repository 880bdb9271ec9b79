"""A page that is served until Ctrl-C."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

from physsim.cli import output


def stay(serve: Callable[[], None], *, told: bool = True) -> None:
    """Serves until Ctrl-C or SIGTERM, or until `serve` ends by itself. told: say so."""
    with suppress(KeyboardInterrupt), _signals_interrupt():
        if told:
            output.message("The page stays until Ctrl-C.")
        serve()


@contextmanager
def _signals_interrupt() -> Iterator[None]:
    """SIGINT and SIGTERM raise KeyboardInterrupt, also where a shell has started us with SIGINT ignored (as
    it does in the background): otherwise nobody could end us but by a kill.
    """
    here = threading.current_thread() is threading.main_thread()
    numbers = (signal.SIGINT, signal.SIGTERM) if here else ()
    before = {number: signal.signal(number, signal.default_int_handler) for number in numbers}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
