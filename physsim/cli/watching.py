"""`--watch`: a page that shows a run while it computes. Whatever happens to the page, the run goes on."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import os
import socket
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

from physsim.cli import output, progress, serving

if TYPE_CHECKING:
    from physsim.view.live.feed import Feed


@contextmanager
def offered(wanted: bool, port: int | None) -> Iterator[Feed | None]:
    """What the run is to be told to, None when nobody wants to watch. Afterwards the page's server is gone.

    Raises click.UsageError for a port without a page, and for one that is taken.
    """
    if port is not None:
        _check(wanted, port)
    feed = _started(port or 0) if wanted else None
    try:
        yield feed
    finally:
        if feed is not None:
            feed.close()


def stay(feed: Feed) -> None:
    """On a terminal the page can be loaded until Ctrl-C, and the run has been told of by then."""
    if progress.on_terminal() and feed.has_page():
        serving.stay(feed.stay)


def _check(wanted: bool, port: int) -> None:
    if not wanted:
        raise click.UsageError("--port is of the page that --watch shows; add --watch.")
    with socket.socket() as trial:
        if os.name == "posix":
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            trial.bind(("127.0.0.1", port))
        except OSError as error:
            raise click.UsageError(f"--port {port}: cannot be used: {error.strerror}.") from error


def _started(port: int) -> Feed | None:
    from physsim.view.live.feed import Feed

    try:
        return Feed(_announce, _warn, port=port)
    except OSError as error:
        _warn(error.strerror or str(error))
        return None


def _warn(trouble: str) -> None:
    output.message(f"physsim: --watch: {trouble}; the run goes on without it")


def _announce(address: str) -> bool:
    """Tells where the page is, and opens it where there is a display, which may take a moment."""
    output.message(f"watch it at {address}")
    shown = _has_display()
    if shown:
        threading.Thread(target=_open, args=(address,), daemon=True).start()
    return shown


def _has_display() -> bool:
    others = sys.platform in {"win32", "darwin"}
    return others or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _open(address: str) -> None:
    import webbrowser

    webbrowser.open(address)
