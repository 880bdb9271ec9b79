"""What the verbs that draw share: their options, and how far a long work has come."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

import click

from physsim.cli import output
from physsim.cli.progress import SECONDS_BETWEEN_LINES, on_terminal

if TYPE_CHECKING:
    from physsim.view.picture.show import Look

T = TypeVar("T")
SMALLEST, LARGEST = 16, 8192
SHOWN = ("contacts", "joints", "springs", "trails", "frames", "labels")
WRITTEN = ("time", "scale", "title")


class Size(click.ParamType[tuple[int, int]]):
    """`1280x720`."""

    name = "size"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """Two whole numbers, pixels across and down."""
        if isinstance(value, tuple):
            return value
        width, _, height = str(value).lower().partition("x")
        if not (width.isdecimal() and height.isdecimal()):
            self.fail(f"{value!r} is no size; write 1280x720", param, ctx)
        if not all(SMALLEST <= side <= LARGEST for side in (int(width), int(height))):
            self.fail(f"a side of a picture has {SMALLEST} to {LARGEST} pixels, not {value}", param, ctx)
        return int(width), int(height)


class Numbers(click.ParamType[tuple[float, ...]]):
    """So many numbers, between commas; the last may be left out down to `least`."""

    name = "numbers"

    def __init__(self, least: int, most: int, example: str) -> None:
        self.least, self.most, self.example = least, most, example

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[float, ...]:
        """Finite numbers."""
        import math

        if isinstance(value, tuple):
            return value
        try:
            found = tuple(float(part) for part in str(value).split(","))
        except ValueError:
            self.fail(f"{value!r} are no numbers between commas; write {self.example}", param, ctx)
        if not (self.least <= len(found) <= self.most and all(math.isfinite(part) for part in found)):
            self.fail(f"{value!r}: write {self.example}", param, ctx)
        return found


class Words(click.ParamType[tuple[str, ...]]):
    """Words of a list, between commas; `none` for none."""

    name = "words"

    def __init__(self, allowed: tuple[str, ...]) -> None:
        self.allowed = allowed

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[str, ...]:
        """In the order given."""
        if isinstance(value, tuple):
            return value
        words = tuple(word.strip() for word in str(value).split(",") if word.strip() != "none")
        for word in words:
            if word not in self.allowed:
                self.fail(f"{word!r} is none of {', '.join(self.allowed)}", param, ctx)
        return words


SIZE = click.Option(
    ["--size"], type=Size(), metavar="WxH", help="Pixels across and down. Default: 1280x720; gif: 480x300."
)
VIEW = click.Option(
    ["--view"],
    type=Numbers(2, 3, "-60,25 or -60,25,4"),
    metavar="AZIMUTH,ELEVATION[,DISTANCE]",
    help="Where the camera stands, seen from what it looks at [degrees, m]: azimuth 0 is the x axis, 90 the "
    "y axis. Default: so that it sees all that moves.",
)
LOOK_AT = click.Option(
    ["--look-at"], type=Numbers(3, 3, "0,0,1"), metavar="X,Y,Z", help="What the camera looks at [m]."
)
FOLLOW = click.Option(["--follow"], metavar="BODY", help="The camera keeps up with this body.")
SHOW = click.Option(
    ["--show"],
    type=Words(SHOWN),
    default="springs",
    metavar="WHAT,...",
    help=f"What is drawn beside the bodies: {', '.join(SHOWN)}, or none. Default: springs, and with them the "
    "strings of distance joints.",
)
CAPTION = click.Option(
    ["--caption"],
    type=Words(WRITTEN),
    default="time,scale",
    metavar="WHAT,...",
    help=f"What is written into it: {', '.join(WRITTEN)}, or none. Default: time and scale.",
)
COLOUR = click.Option(
    ["--color", "--colour", "colour"],
    type=click.Choice(("material", "speed")),
    default="material",
    help="What the colours of bodies tell: material (default), or speed, from dark to light.",
)
LOOKS = (SIZE, VIEW, LOOK_AT, FOLLOW, COLOUR, SHOW, CAPTION)


def look_of(
    usual_size: tuple[int, int],
    *,
    size: tuple[int, int] | None,
    view: tuple[float, ...] | None,
    look_at: tuple[float, ...] | None,
    follow: str | None,
    colour: str,
    show: tuple[str, ...],
    caption: tuple[str, ...],
) -> Look:
    """What the options say."""
    from physsim.view.picture.camera import View
    from physsim.view.picture.show import Look

    azimuth, elevation, distance = (*(view or ()), None, None, None)[:3]
    if elevation is not None and not -90 <= elevation <= 90:
        raise click.UsageError(f"--view: an elevation is from -90 to 90 degrees, got {elevation:g}")
    if distance is not None and distance <= 0:
        raise click.UsageError(f"--view: a distance is greater than 0, got {distance:g}")
    target = None if look_at is None else (look_at[0], look_at[1], look_at[2])
    return Look(
        size=size or usual_size,
        view=View(azimuth, elevation, distance, target),
        signs=show,
        words=caption,
        follow=follow,
        by_speed=colour == "speed",
    )


def counted(pieces: Iterable[T], total: int, title: str) -> Iterator[T]:
    """The pieces; on stderr how many are done: a bar on a terminal, elsewhere a line every ten seconds."""
    if on_terminal():
        yield from _bar(pieces, total, title)
        return
    told = time.monotonic()
    for done, piece in enumerate(pieces):
        if time.monotonic() - told >= SECONDS_BETWEEN_LINES:
            told = time.monotonic()
            output.message(f"{title}: {done} of {total}")
        yield piece


def _bar(pieces: Iterable[T], total: int, title: str) -> Iterator[T]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    console = Console(stderr=True, no_color=output.colour_wanted() is False)
    with Progress(*columns, console=console, transient=True) as drawn:
        task = drawn.add_task(title, total=total)
        for piece in pieces:
            yield piece
            drawn.advance(task)
