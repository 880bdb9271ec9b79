"""`physsim verify`: the formula sheet on this installation, every formula as a scene held against its
theory.
"""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option, json_option
from physsim.cli.verify_report import as_data, show, show_list
from physsim.cli.verify_run import Tried, run_all
from physsim.errors import FileTrouble

if TYPE_CHECKING:
    from physsim.analysis.verify import Formula


@click.command(
    cls=Verb,
    exits=(0, 1, 2, 3, 130),
    examples=[
        Example("two formulas", "physsim verify --case free_fall --case 'impact*'"),
        Example("every formula, its equation and its scene", "physsim verify --list"),
        Example("for a program", "physsim verify --case free_fall --json"),
    ],
)
@click.option(
    "--case",
    "patterns",
    metavar="NAME",
    multiple=True,
    help="A formula or one of its cases, with * for any text; may be repeated. Default: all.",
)
@click.option("--list", "listed", is_flag=True, help="List the formulas with their scenes, and run nothing.")
@click.option(
    "--plot",
    type=click.Path(file_okay=False),
    metavar="DIR",
    help="Draw curves and convergence, one DIR/FORMULA.svg each (needs the extra `plot`: matplotlib).",
)
@json_option
@debug_option
@click.pass_context
def command(
    ctx: click.Context, *, patterns: tuple[str, ...], listed: bool, plot: str | None, as_json: bool
) -> None:
    """Hold this installation against the closed forms of mechanics.

    Every formula has a scene of its own. It is run, where an order of convergence is claimed with three
    timesteps, and what comes is compared with the theory. The error is the greatest one, as a part of the
    greatest theoretical value (of 1 where that is 0); theory and measured are the two values where they
    differ most. What each scene expects of itself is checked too. Exit status 1 when anything is off.
    """
    formulas = picked(patterns)
    if listed:
        show_list(formulas, as_json)
        return
    if plot is not None:
        require_matplotlib()
    tried = list(run_all(formulas, quiet=as_json))
    if plot is not None:
        draw(tried, Path(plot))
    code = 0 if all(each.passed for each in tried) else 1
    if as_json:
        output.document("verify", code, **as_data(tried))
    else:
        show(tried)
    ctx.exit(code)


def picked(patterns: Sequence[str]) -> list[Formula]:
    """The formulas that the patterns name; click.BadParameter, with the nearest name, when one names
    nothing.
    """
    from difflib import get_close_matches

    from physsim.analysis.verify import FORMULAS, pick

    try:
        return pick(patterns)
    except KeyError as error:
        near = get_close_matches(str(error.args[0]), [formula.name for formula in FORMULAS], n=1)
        hint = f"; did you mean {near[0]!r}?" if near else "; --list shows all"
        raise click.BadParameter(f"no formula or case {error.args[0]!r}{hint}", param_hint="--case") from None


def require_matplotlib() -> None:
    """Raises FileTrouble, before anything is run, when there is nothing to draw with."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise FileTrouble("--plot needs matplotlib: pip install 'physsim[plot]'") from None


def draw(tried: Sequence[Tried], folder: Path) -> None:
    """One picture per formula."""
    from physsim.analysis.verify.plot import draw_formula

    folder.mkdir(parents=True, exist_ok=True)
    for each in tried:
        if each.verdicts:
            draw_formula(each.formula, each.verdicts, folder / f"{each.formula.name}.svg")
    output.message(f"drawn: {folder}/*.svg")
