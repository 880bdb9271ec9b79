"""`physsim export`: a trajectory as a table for other programs."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option

if TYPE_CHECKING:
    from collections.abc import Iterator

    from physsim.analysis.export.rows import Batch, Units
    from physsim.recording import Trajectory

TABLES = ("csv", "parquet")
LATER = ("glb", "mp4", "gif", "png", "html")
CONTENTS = ("wide", "long", "contacts", "impacts")


@click.command(
    cls=Verb,
    arguments=[
        ("FILE", "a trajectory (HDF5)"),
        (
            "QUANTITY...",
            "names as in `expect`, * for any body, joint or spring; default: the state of all bodies",
        ),
    ],
    examples=[
        Example(
            "one row per frame, the state of every body: my_scene.csv", "physsim export my_scene.h5 --to csv"
        ),
        Example(
            "chosen quantities, one row per number, as data frames like it",
            "physsim export my_scene.h5 'bodies.*.speed' energy.total --to parquet --rows long",
        ),
        Example("every contact point", "physsim export my_scene.h5 --to csv --rows contacts -o contacts.csv"),
    ],
)
@click.argument("file", type=click.Path())
@click.argument("quantities", metavar="[QUANTITY...]", nargs=-1)
@click.option(
    "--to",
    "format",
    required=True,
    type=click.Choice([*TABLES, *LATER]),
    metavar="|".join(TABLES),
    help="The format.",
)
@click.option(
    "--rows",
    type=click.Choice(CONTENTS),
    default="wide",
    help="What a row is: wide, a frame (default); long, a number; contacts, a contact point; impacts, an "
    "impact.",
)
@click.option(
    "-o", "--output", "target", type=click.Path(), metavar="FILE", help="Default: FILE's name, here."
)
@click.option("--force", is_flag=True, help="Replace an existing file.")
@debug_option
def command(
    *, file: str, quantities: tuple[str, ...], format: str, rows: str, target: str | None, force: bool
) -> None:
    """Write a trajectory as a table, block by block: a file of any size needs little memory.

    All values are SI; numbers in CSV are written in the fewest digits that give the same bits back. Columns
    of Parquet carry their units.
    """
    from physsim.analysis.export import check_writer, write
    from physsim.recording import open_trajectory

    if format in LATER:
        raise click.UsageError(
            f"--to {format}: not supported yet; this version writes {' and '.join(TABLES)}"
        )
    if quantities and rows in {"contacts", "impacts"}:
        raise click.UsageError(
            f"--rows {rows} writes all columns of {rows}; quantities are for wide and long"
        )
    path = Path(f"{Path(file).stem}.{format}") if target is None else Path(target)
    check_writer(format, path, force=force)
    with open_trajectory(file) as trajectory:
        count = write(format, path, *content(trajectory, rows, quantities))
    output.result(f"{path}: {output.counted(count, 'row', 'rows')}")


def content(trajectory: Trajectory, rows: str, quantities: Sequence[str]) -> tuple[Iterator[Batch], Units]:
    """The rows asked for, and the units of their columns."""
    from physsim.analysis import export
    from physsim.analysis.names import expanded

    if rows == "contacts":
        return export.contact_rows(trajectory)
    if rows == "impacts":
        return export.impact_rows(trajectory)
    names = [name for pattern in quantities for name in expanded(trajectory, pattern)] or None
    return (export.wide_rows if rows == "wide" else export.long_rows)(trajectory, names)
