"""`physsim fit`: values of a scene that make its simulation match what was measured."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output, progress
from physsim.cli.table import number, table
from physsim.cli.verb import Example, Verb, debug_option, json_option

if TYPE_CHECKING:
    from physsim.batch.fit_result import Estimate, Found

EVALUATIONS_BETWEEN_WORDS = 10


@click.command(
    cls=Verb,
    exits=(0, 1, 2, 3, 130),
    arguments=[("FIT", "the fit file (YAML): a scene, what is sought in it, and what was measured")],
    examples=[
        Example("estimates with their standard deviations", "physsim fit my_fit.yaml"),
        Example("the fit through the data, as a picture", "physsim fit my_fit.yaml --plot fit.png"),
        Example("for a program", "physsim fit my_fit.yaml --json --quiet"),
    ],
)
@click.argument("file", metavar="FIT", type=click.Path())
@click.option(
    "--plot",
    "picture",
    type=click.Path(),
    metavar="FILE",
    help="Draw the fit against the data: .png, .svg or .pdf (needs the extra `plot`: matplotlib).",
)
@click.option("--quiet", is_flag=True, help="No progress.")
@json_option
@debug_option
@click.pass_context
def command(ctx: click.Context, *, file: str, picture: str | None, quiet: bool, as_json: bool) -> None:
    """Find the values of a scene that make the simulated motion match measured data.

    The scene is simulated with trial values, for every file of data; scipy's optimisers make the difference
    small. The uncertainties come from the derivatives at the end: they are those of one measured value (sigma
    where it is given, else what is left between fit and data) carried over to the estimates. Exit status 1
    when the search did not come to an end.
    """
    from physsim.batch.fit import search
    from physsim.batch.fit_load import load_fit

    target = None if picture is None else Path(picture)
    if target is not None:
        from physsim.analysis.plot.canvas import check_target

        check_target(target)
    fit = load_fit(file)
    found = search(fit, None if quiet or as_json else teller())
    if target is not None:
        draw(found, target)
    code = 0 if found.success else 1
    if as_json:
        output.document("fit", code, **as_data(found))
    else:
        output.result("\n".join(as_lines(fit.title, found)))
    ctx.exit(code)


def teller() -> Callable[[int, float], None] | None:
    """A line now and then on a terminal, nothing elsewhere."""
    if not progress.on_terminal():
        return None

    def tell(evaluations: int, best: float) -> None:
        if evaluations % EVALUATIONS_BETWEEN_WORDS == 0:
            output.message(f"{evaluations} simulations, best sum of squares {number(best)}")

    return tell


def draw(found: Found, target: Path) -> None:
    """The picture, with the estimates above it."""
    from physsim.analysis.plot.canvas import canvas
    from physsim.analysis.plot.fitted import draw_fit

    told = "\n".join(f"{each.path} = {_value(each)}" for each in found.estimates)
    with canvas(target) as figure:
        draw_fit(figure, found.compared, told)


def as_data(found: Found) -> dict[str, Any]:
    """The JSON document; the series are left out."""
    series = ("time", "measured", "fitted")
    whole = asdict(found)
    whole["compared"] = [
        {key: value for key, value in each.items() if key not in series} | {"values": len(each["time"])}
        for each in whole["compared"]
    ]
    return whole


def as_lines(title: str, found: Found) -> Iterator[str]:
    """The report for people."""
    yield click.style(title, bold=True)
    rows = [[each.path, _value(each), number(each.start), _remark(each)] for each in found.estimates]
    yield table(("value", "estimate", "from", ""), rows)
    yield ""
    rows = [
        [each.file, each.quantity, str(len(each.time)), number(each.rms, 3), each.unit]
        for each in found.compared
    ]
    yield table(("data", "quantity", "values", "rms difference", ""), rows, right=(2, 3))
    pairs = [
        f"{a.path} and {b.path} {found.correlation[k][j]:+.2f}"
        for k, a in enumerate(found.estimates)
        for j, b in enumerate(found.estimates[:k])
    ]
    if pairs:
        yield "correlation: " + ", ".join(pairs)
    if found.reduced is not None:
        yield f"chi-squared per degree of freedom: {number(found.reduced, 3)}"
    ending = f"{found.evaluations} simulations; {found.message.rstrip('.')}"
    yield click.style(ending, fg=None if found.success else "red")
    told = " ".join(f"--set {each.path}={_written(each)}" for each in found.estimates)
    yield f"to run it: physsim run SCENE {told}"


def _value(each: Estimate) -> str:
    """The estimate in as many digits as its deviation (two of them) lets stand."""
    if not math.isfinite(each.deviation) or each.deviation == 0:
        spread = "" if each.deviation == 0 else " (not determined)"
        return f"{each.value:.6g} {each.unit}".rstrip() + spread
    last = math.floor(math.log10(each.deviation)) - 1
    if abs(last) > 12:
        return f"{each.value:.6g} ± {each.deviation:.2g} {each.unit}".rstrip()
    digits = max(0, -last)
    return f"{each.value:.{digits}f} ± {each.deviation:.{digits}f} {each.unit}".rstrip()


def _remark(each: Estimate) -> str:
    if not math.isfinite(each.deviation):
        return "the data do not determine it"
    return "at a bound" if each.at_bound else ""


def _written(each: Estimate) -> str:
    return f"{each.value:.9g}" if not each.unit else f"'{each.value:.9g} {each.unit}'"
