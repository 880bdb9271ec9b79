"""`physsim plot`: pictures of trajectories and of tables of runs."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option
from physsim.errors import FileTrouble

if TYPE_CHECKING:
    from physsim.recording import Trajectory

TRAJECTORIES = (".h5", ".hdf5", ".part")
TABLES = (".csv", ".parquet")


@click.command(
    cls=Verb,
    arguments=[
        ("FILE... QUANTITY...", "trajectories (HDF5) and what to draw of them, or one table (CSV, Parquet)"),
    ],
    examples=[
        Example(
            "height and speed over time",
            "physsim plot my_scene.h5 bodies.crate.position.z bodies.crate.speed -o a.png",
        ),
        Example("where the energy is, and where it went", "physsim plot my_scene.h5 energy -o energy.svg"),
        Example(
            "a phase portrait",
            "physsim plot my_scene.h5 bodies.crate.velocity.z vs bodies.crate.position.z -o phase.pdf",
        ),
        Example(
            "contact forces of all bodies, of two runs in one picture",
            "physsim run my_scene.yaml -o soft.h5 --quiet --set simulation.timestep='0.5 ms' && "
            "physsim plot my_scene.h5 soft.h5 'bodies.*.contact_force.z' -o forces.png",
        ),
    ],
)
@click.argument("words", metavar="FILE... QUANTITY...", nargs=-1, required=True)
@click.option(
    "-o",
    "--output",
    "target",
    type=click.Path(),
    metavar="FILE",
    help="The picture: .png, .svg or .pdf. Default: a window.",
)
@click.option("--from", "start", type=float, metavar="T", help="Draw from this time on [s].")
@click.option("--until", "end", type=float, metavar="T", help="Draw up to this time [s].")
@click.option("--title", help="A title above the picture.")
@debug_option
def command(
    *, words: tuple[str, ...], target: str | None, start: float | None, end: float | None, title: str | None
) -> None:
    """Draw quantities of one or more trajectories, or columns of a table of runs.

    A QUANTITY is a name as in `expect` (bodies.ball.position.z; a vector draws its components), with * for
    any body, joint or spring; `energy` is the stacked ledger; `A vs B` draws one over the other. Quantities
    of the same unit share a panel; of several files each has its own dashes. Of a table METRIC vs PARAMETER
    draws a curve, METRIC vs PARAMETER PARAMETER a map.
    """
    from physsim.analysis.plot.canvas import canvas, check_target

    files, names = told_apart(words)
    picture = None if target is None else Path(target)
    check_target(picture)
    if files[0].suffix in TABLES:
        from physsim.analysis.plot import draw_table, read_table, units_beside

        table = read_table(only_one(files))
        with canvas(picture, title) as figure:
            columns = [name for word in names for name in word.split(" vs ") if name != "vs"]
            draw_table(figure, table, columns, units_beside(files[0]))
    else:
        from physsim.analysis.plot import draw_trajectories, read_wishes

        wishes = read_wishes(names)
        with ExitStack() as stack:
            opened = [stack.enter_context(opened_trajectory(file)) for file in files]
            frames = [between(trajectory, start, end) for trajectory in opened]
            with canvas(picture, title) as figure:
                draw_trajectories(figure, opened, wishes, frames)
    if picture is not None:
        output.result(str(picture))


def told_apart(words: Sequence[str]) -> tuple[list[Path], list[str]]:
    """Files first, then names; click.UsageError when one of the two is missing."""
    files = [Path(word) for word in words if is_file_name(word)]
    names = [word for word in words if not is_file_name(word)]
    if not files:
        raise click.UsageError("name a trajectory (.h5) or a table (.csv, .parquet) first")
    if not names:
        raise click.UsageError(
            "name what to draw after the file, e.g. energy, bodies.ball.position.z or 'bodies.*.speed'"
        )
    return files, names


def is_file_name(word: str) -> bool:
    """A word that ends like a file, or is one; no quantity does."""
    return Path(word).suffix in (*TRAJECTORIES, *TABLES) or Path(word).is_file()


def only_one(files: Sequence[Path]) -> Path:
    """The file. click.UsageError for several tables, or tables among trajectories."""
    if len(files) > 1:
        raise click.UsageError("a table is drawn alone")
    return files[0]


def opened_trajectory(file: Path) -> Trajectory:
    """The trajectory; FileTrouble for a table among trajectories."""
    from physsim.recording import open_trajectory

    if file.suffix in TABLES:
        raise FileTrouble(f"{file}: is a table, which is drawn alone")
    return open_trajectory(file)


def between(trajectory: Trajectory, start: float | None, end: float | None) -> slice:
    """The frames of a span of time, both ends included."""
    from numpy import searchsorted

    first = 0 if start is None else int(searchsorted(trajectory.time, start, side="left"))
    stop = trajectory.frames if end is None else int(searchsorted(trajectory.time, end, side="right"))
    if stop <= first:
        raise FileTrouble(f"{trajectory.path}: has no frames in that span of time")
    return slice(first, stop)
