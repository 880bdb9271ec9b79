"""How far a run has come: a bar on a terminal, a plain line every ten seconds elsewhere. Always on stderr."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from physsim.cli import output

if TYPE_CHECKING:
    from physsim.simulation import Progress

SECONDS_BETWEEN_LINES = 10.0

Report = Callable[["Progress"], None]


class Speed:
    """Simulated seconds per second of the clock since the first report; a resumed run does not start at 0."""

    def __init__(self) -> None:
        self._first: Progress | None = None

    def at(self, now: Progress) -> float:
        """The speed up to now; 0 while there is nothing to divide by."""
        first = self._first = self._first or now
        elapsed = now.wall_time - first.wall_time
        return (now.time - first.time) / elapsed if elapsed > 0 else 0.0


@contextmanager
def shown(title: str, *, quiet: bool) -> Iterator[Report | None]:
    """A function to call with every Progress; None when nothing is to be shown."""
    if quiet:
        yield None
    elif on_terminal():
        with bar(title) as report:
            yield report
    else:
        yield lines(title)


def on_terminal() -> bool:
    """Whether stderr is a terminal that can redraw a line."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


@contextmanager
def bar(title: str) -> Iterator[Report]:
    """A bar that disappears when the run has ended: simulated time, speed, contacts, time left."""
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.fields[facts]}"),
        TimeRemainingColumn(),
    )
    console = Console(stderr=True, no_color=output.colour_wanted() is False)
    with Bar(*columns, console=console, transient=True, refresh_per_second=10) as drawn:
        task = drawn.add_task(title, total=None, facts="")
        speed = Speed()

        def report(now: Progress) -> None:
            drawn.update(task, total=now.duration, completed=now.time, facts=facts(now, speed.at(now)))

        yield report


def lines(title: str) -> Report:
    """A reporter for files and pipes: one line every ten seconds, none for a run that is over before."""
    meter = Speed()
    told = 0.0

    def report(now: Progress) -> None:
        nonlocal told
        speed = meter.at(now)
        if now.wall_time - told >= SECONDS_BETWEEN_LINES:
            told = now.wall_time
            output.message(f"{title}: {facts(now, speed)}{time_left(now, speed)}")

    return report


def facts(now: Progress, speed: float) -> str:
    """`1.7 of 5 s, 12.3x real time, 24 contacts`."""
    return f"{now.time:.4g} of {now.duration:.4g} s, {speed:.3g}x real time, {now.contacts} contacts"


def time_left(now: Progress, speed: float) -> str:
    """`, 12 s left`; nothing while the speed is not known."""
    return f", {(now.duration - now.time) / speed:.0f} s left" if speed > 0 else ""
