"""`physsim export --to csv|parquet`: a trajectory as a table for other programs."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from physsim.cli import output
from physsim.cli.export_format import Format, Order
from physsim.cli.verb import Example

if TYPE_CHECKING:
    from collections.abc import Iterator

    from physsim.analysis.export.rows import Batch, Units
    from physsim.recording import Trajectory

ROWS = click.Option(
    ["--rows"],
    type=click.Choice(("wide", "long", "contacts", "impacts")),
    default="wide",
    help="What a row is: wide, a frame (default); long, a number; contacts, a contact point; impacts, an "
    "impact.",
)


def write_table(order: Order, *, rows: str) -> str:
    """Block by block: a file of any size needs little memory."""
    from physsim.analysis.export import check_writer, write
    from physsim.recording import open_trajectory

    if order.quantities and rows in {"contacts", "impacts"}:
        raise click.UsageError(
            f"--rows {rows} writes all columns of {rows}; quantities are for wide and long"
        )
    check_writer(order.format, order.target, force=order.force)
    with open_trajectory(order.file) as trajectory:
        count = write(order.format, order.target, *content(trajectory, rows, order.quantities))
    return f"{order.target}: {output.counted(count, 'row', 'rows')}"


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


TABLE = Format(
    names=("csv", "parquet"),
    write=write_table,
    options=(ROWS,),
    quantities=True,
    examples=(
        Example(
            "one row per frame, the state of every body: my_scene.csv", "physsim export my_scene.h5 --to csv"
        ),
        Example(
            "chosen quantities, one row per number, as data frames like it",
            "physsim export my_scene.h5 'bodies.*.speed' energy.total --to parquet --rows long",
        ),
        Example("every contact point", "physsim export my_scene.h5 --to csv --rows contacts -o contacts.csv"),
    ),
)
