"""`physsim export`: a trajectory in the formats of other programs. Each format is in a file of its own."""

from __future__ import annotations

from copy import copy
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from physsim.cli import output
from physsim.cli.export_film import FILM
from physsim.cli.export_format import Format, Order
from physsim.cli.export_glb import GLB
from physsim.cli.export_html import PAGE
from physsim.cli.export_still import STILL
from physsim.cli.export_table import TABLE
from physsim.cli.verb import Verb, debug_option

FORMATS = (TABLE, GLB, PAGE, STILL, FILM)
NAMES = tuple(name for format in FORMATS for name in format.names)


class Export(Verb):
    """The verb with the options of all formats; the help of each begins with the formats that have it."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        for option in dict.fromkeys(option for format in FORMATS for option in format.options):
            shown = copy(option)
            shown.help = f"{', '.join(names_with(str(option.name)))}: {option.help}"
            self.params.insert(-1, shown)


def names_with(option: str) -> list[str]:
    """The formats that have an option."""
    return [
        name
        for format in FORMATS
        if option in {each.name for each in format.options}
        for name in format.names
    ]


@click.command(
    cls=Export,
    arguments=[
        ("FILE", "a trajectory (HDF5)"),
        (
            "QUANTITY...",
            "tables only: names as in `expect`, * for any body, joint or spring; default: the state of all "
            "bodies",
        ),
    ],
    examples=[example for format in FORMATS for example in format.examples],
)
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("quantities", metavar="[QUANTITY...]", nargs=-1)
@click.option(
    "--to",
    "name",
    required=True,
    type=click.Choice(NAMES),
    metavar="|".join(NAMES),
    help="The format.",
)
@click.option(
    "-o",
    "--output",
    "target",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Default: FILE's name, here.",
)
@click.option("--force", is_flag=True, help="Replace an existing file.")
@debug_option
@click.pass_context
def command(
    ctx: click.Context,
    /,
    *,
    file: Path,
    quantities: tuple[str, ...],
    name: str,
    target: Path | None,
    force: bool,
    **own: Any,
) -> None:
    """Write a trajectory for other programs.

    csv, parquet: a table, written block by block, so that a file of any size needs little memory. All values
    are SI; numbers in CSV are written in the fewest digits that give the same bits back. Columns of Parquet
    carry their units.

    glb: binary glTF 2.0 for Blender, model viewers and game engines: bodies, materials and their motion, in
    metres and seconds. Key frames that straight lines and arcs between the others reproduce are left out.

    html: the page that `physsim view` makes, which any browser plays.

    png, mp4, gif: pictures and films, drawn without display or graphics card (extra `view`). Between frames
    positions go along straight lines and orientations along arcs.
    """
    format = format_named(name)
    refuse_foreign(ctx, format, name)
    if quantities and not format.quantities:
        raise click.UsageError(f"--to {name} shows the whole scene; quantities are for {spoken(TABLE.names)}")
    order = Order(file, name, target or Path(f"{file.stem}.{name}"), force, quantities)
    if order.target.resolve() == file.resolve():
        raise click.UsageError(f"-o {order.target}: is the trajectory itself")
    output.result(format.write(order, **{option.name: own[option.name] for option in format.options}))


def format_named(name: str) -> Format:
    """The format of a name of `--to`."""
    return next(format for format in FORMATS if name in format.names)


def refuse_foreign(ctx: click.Context, format: Format, name: str) -> None:
    """click.UsageError for an option that was given and belongs to other formats."""
    has = {option.name for option in format.options}
    for option in dict.fromkeys(option for other in FORMATS for option in other.options):
        given = ctx.get_parameter_source(str(option.name)) is ParameterSource.COMMANDLINE
        if given and option.name not in has:
            raise click.UsageError(
                f"{option.opts[0]} is for --to {spoken(names_with(str(option.name)))}, not for --to {name}"
            )


def spoken(words: tuple[str, ...] | list[str]) -> str:
    """`a, b and c`."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
