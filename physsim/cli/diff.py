"""`physsim diff`: two trajectories held against each other."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output
from physsim.cli.table import number, table
from physsim.cli.verb import Example, Verb, debug_option, json_option

if TYPE_CHECKING:
    from physsim.analysis.diff import Comparison, Setting
    from physsim.recording import Trajectory

SHOWN = 12
MOST_LETTERS = 40


@click.command(
    cls=Verb,
    exits=(0, 1, 2, 3),
    arguments=[("A", "a trajectory (HDF5)"), ("B", "another one")],
    examples=[
        Example(
            "the same scene twice gives the same bits",
            "physsim run my_scene.yaml -o again.h5 --quiet && physsim diff my_scene.h5 again.h5",
        ),
        Example(
            "does another answer to contacts matter? (SI; relative for what is larger than 1)",
            "physsim run my_scene.yaml -o fcl.h5 --quiet --set simulation.collision=fcl && "
            "physsim diff my_scene.h5 fcl.h5 --tolerance 1e-6",
        ),
        Example("for a program", "physsim diff my_scene.h5 again.h5 --json"),
    ],
)
@click.argument("a", type=click.Path())
@click.argument("b", type=click.Path())
@click.option(
    "--tolerance",
    metavar="X",
    type=click.FloatRange(min=0),
    default=0.0,
    help="Values differ when they are further apart than X * max(1, their size), in SI. "
    "Default: 0, bit for bit.",
)
@json_option
@debug_option
@click.pass_context
def command(ctx: click.Context, *, a: str, b: str, tolerance: float, as_json: bool) -> None:
    """Compare two trajectories: where they part, in which body and quantity, and how the difference grows.

    Frames are matched by time, bodies, joints and springs by name. Settings, meshes and versions that differ
    are told too, but only values (and bodies that one file lacks) make the exit status 1.
    """
    from physsim.analysis.diff import compare, differing_settings
    from physsim.recording import open_trajectory

    with open_trajectory(a) as first, open_trajectory(b) as second:
        settings = differing_settings(first, second)
        found = compare(first, second, tolerance)
        ends = [_end(first), _end(second)]
    code = 0 if found.alike else 1
    if as_json:
        output.document("diff", code, a=ends[0], b=ends[1], **as_data(found, settings))
    else:
        output.result("\n".join(as_lines(found, settings, ends)))
    ctx.exit(code)


def _end(trajectory: Trajectory) -> dict[str, Any]:
    """How far a file goes."""
    last = float(trajectory.time[-1]) if trajectory.frames else 0.0
    return {
        "file": str(trajectory.path),
        "frames": trajectory.frames,
        "end": last,
        "status": trajectory.status,
        "impacts": trajectory.events.rows,
    }


def as_data(found: Comparison, settings: Sequence[Setting]) -> dict[str, Any]:
    """The JSON document."""
    whole = asdict(found)
    return {
        "alike": found.alike,
        "first": whole["divergences"][0] if found.divergences else None,
        **whole,
        "settings": [asdict(setting) for setting in settings],
    }


def as_lines(found: Comparison, settings: Sequence[Setting], ends: Sequence[dict[str, Any]]) -> Iterator[str]:
    """The report for people."""
    for letter, end in zip("AB", ends, strict=True):
        told = (
            f"{end['frames']} frames to {number(end['end'], 6)} s, {end['impacts']} impacts, {end['status']}"
        )
        yield f"{letter}: {click.style(end['file'], bold=True)}: {told}"
    yield f"{found.frames} frames in common, to {number(found.end, 6)} s"
    if settings:
        rows = [[each.kind, each.name, _shown(each.a), _shown(each.b)] for each in settings[:SHOWN]]
        yield "\n" + table(("differs", "", "A", "B"), rows) + _more(len(settings))
    for letter, names in (("A", found.only_a), ("B", found.only_b)):
        if names:
            yield f"only in {letter}: {', '.join(names[:SHOWN])}{_more(len(names))}"
    yield from _parting(found)


def _parting(found: Comparison) -> Iterator[str]:
    """Where values part, what differs, and how the distance of positions grows."""
    beyond = f" beyond {found.tolerance:g}" if found.tolerance else ""
    if not found.divergences:
        yield click.style(f"no value differs{beyond}", fg="green" if found.alike else None)
        return
    first = found.divergences[0]
    where = f"first difference{beyond} in frame {first.frame} of A ({number(first.time, 6)} s)"
    yield "\n" + click.style(
        f"{where}: {first.quantity}, by {number(first.difference, 3)} {first.unit}".rstrip(), fg="red"
    )
    rows = [
        [
            each.quantity,
            number(each.time, 6),
            number(each.difference, 3),
            number(each.greatest, 3),
            number(each.greatest_time, 6),
            each.unit,
        ]
        for each in found.divergences[:SHOWN]
    ]
    head = ("quantity", "from [s]", "by", "at most", "at [s]", "")
    yield table(head, rows, right=(1, 2, 3, 4)) + _more(len(found.divergences))
    if found.growth:
        grown = [[number(each.time, 6), number(each.difference, 3), each.quantity] for each in found.growth]
        yield "\n" + table(("time [s]", "most [m]", "growth of the difference"), grown, right=(0, 1))
    if found.doubling_time is not None:
        yield f"while it grows it doubles every {number(found.doubling_time, 3)} s"


def _shown(value: Any) -> str:
    text = "-" if value is None else str(value)
    return text if len(text) <= MOST_LETTERS else text[: MOST_LETTERS - 1] + "…"


def _more(count: int) -> str:
    return f"\n... and {count - SHOWN} more (--json shows all)" if count > SHOWN else ""
