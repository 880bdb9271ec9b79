"""What `physsim export` asks of each format: its names, its options, its examples, and how it is written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any

import click

from physsim.cli.verb import Example


@dataclass(frozen=True)
class Order:
    """What is to be exported. file: the trajectory; format: a name of the format; target: where to, which may
    not exist yet unless `force`; quantities: as given, none when the format takes none.
    """

    file: Path
    format: str
    target: Path
    force: bool
    quantities: tuple[str, ...]


@dataclass(frozen=True)
class Format:
    """One way to write a trajectory, under one or more names of `--to`.

    write: is called with the order and a keyword for each of `options`; returns what to say on stdout.
    options: those that not every format has; formats that share one list the same object.
    quantities: whether names of quantities may follow the file.
    """

    names: tuple[str, ...]
    write: Callable[..., str]
    options: tuple[click.Option, ...] = ()
    examples: tuple[Example, ...] = ()
    quantities: bool = False


class Finite(click.FloatRange):
    """A number that is neither infinite nor NaN, which a range alone lets pass."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        number = super().convert(value, param, ctx)
        if not isfinite(number):
            self.fail(f"{number} is not a finite number", param, ctx)
        return number


START = click.Option(["--from", "start"], type=Finite(), metavar="T", help="Begin at this time [s].")
END = click.Option(["--until", "end"], type=Finite(), metavar="T", help="End at this time [s].")
FPS = click.Option(
    ["--fps"],
    type=Finite(min=0, min_open=True),
    metavar="N",
    help="Frames per second. Default: glb, those of the file; mp4, 30; gif, 20.",
)
SPEED = click.Option(
    ["--speed"],
    type=Finite(min=0, min_open=True),
    default=1.0,
    metavar="X",
    help="Simulated seconds in each second that is shown: 0.25 is slow motion. Default: 1.",
)
