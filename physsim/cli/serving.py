"""A page that is served until Ctrl-C."""

from __future__ import annotations

import signal
from collections.abc import Callable
from contextlib import suppress

from physsim.cli import output
from physsim.signals import handled


def stay(serve: Callable[[], None], *, told: bool = True) -> None:
    """Serves until Ctrl-C or SIGTERM, or until `serve` ends by itself. told: say so."""
    with suppress(KeyboardInterrupt), handled(signal.default_int_handler):
        if told:
            output.message("The page stays until Ctrl-C.")
        serve()
