"""`physsim sweep`: one scene run many ways, and a table with a row per run."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output, progress
from physsim.cli.run import Warnings
from physsim.cli.table import number, table
from physsim.cli.verb import Example, Verb, debug_option, json_option, settings
from physsim.errors import RunFailed

if TYPE_CHECKING:
    from physsim.batch import Progress, Sweep, SweepResult

MOST_FAILURES_TOLD = 5
MOST_FAILURES_IN_JSON = 1000
NO_PARQUET = "table.parquet was not written: pip install 'physsim[parquet]'"

Report = Callable[["Progress"], None]


@click.command(
    cls=Verb,
    exits=(0, 1, 2, 3, 130),
    arguments=[("SWEEP", "the sweep file (YAML): scene, what varies, metrics")],
    examples=[
        Example(
            "four heights; the table is my_sweep_sweep/table.csv",
            "printf '%s\\n' 'physsim_sweep: 1' 'scene: my_scene.yaml' 'grid: {parameters.drop: "
            "[0.2 m, 0.4 m, 0.6 m, 0.8 m]}' 'metrics: {lost: {type: energy_lost}}' > my_sweep.yaml && "
            "physsim sweep my_sweep.yaml",
        ),
        Example(
            "interrupted or killed? Only what is missing is done", "physsim sweep my_sweep.yaml --workers 1"
        ),
        Example("what would be done", "physsim sweep my_sweep.yaml --dry-run"),
        Example("another folder, and one JSON document", "physsim sweep my_sweep.yaml -o again --json"),
    ],
)
@click.argument("sweep", type=click.Path())
@click.option(
    "-o",
    "--output",
    "folder",
    type=click.Path(),
    metavar="FOLDER",
    help="Where everything goes. Default: the name of the sweep with _sweep, in the current folder.",
)
@click.option(
    "--workers",
    type=click.IntRange(1, 4096),
    metavar="N",
    help="Processes on this machine. Default: as many as it has cores.",
)
@click.option("--cluster", metavar="ADDRESS", help="A Dask scheduler to send the runs to: tcp://host:8786.")
@click.option("--force", is_flag=True, help="Begin anew in a folder that holds a sweep.")
@click.option("--dry-run", is_flag=True, help="Check the sweep and tell what it asks for; run nothing.")
@click.option("--quiet", is_flag=True, help="Errors only.")
@json_option
@debug_option
@click.pass_context
def command(
    ctx: click.Context,
    *,
    sweep: str,
    folder: str | None,
    workers: int | None,
    cluster: str | None,
    force: bool,
    dry_run: bool,
    quiet: bool,
    as_json: bool,
) -> None:
    """Run one scene many ways and write one row per run.

    SWEEP names a scene, what varies in it (grids, lists, ranges, random distributions, Latin hypercubes,
    Sobol points, replicates) and the metrics to keep of every run. Results are the same whatever the number
    of workers. The folder gets table.csv and table.parquet, a manifest, and the trajectories that the sweep
    keeps.

    A run that fails is a row with its error. A sweep that was interrupted or killed goes on where it stopped
    when it is called again. Fails only when every run failed.
    """
    if workers is not None and cluster is not None:
        raise click.UsageError(
            "--workers are processes on this machine, --cluster has its own: give one.", ctx
        )
    from physsim.batch import load_sweep
    from physsim.batch import sweep as run_sweep

    warnings = Warnings(sweep, told=not quiet and not as_json)
    settings(ctx).known = {"sweep": sweep, "warnings": warnings.data}
    loaded = load_sweep(sweep)
    if dry_run:
        _tell_plan(ctx, loaded, as_json)
        return
    with _shown(loaded.title, quiet=quiet) as report:
        result = run_sweep(
            loaded,
            output=folder,
            workers=workers,
            cluster=cluster,
            force=force,
            progress=report,
            warn=warnings,
        )
    facts = _facts(result)
    code = RunFailed.exit_code if result.failed == len(result.table.rows) else 0
    if as_json:
        output.document("sweep", code, **settings(ctx).known | facts, error=None, problems=[])
    elif not quiet:
        output.result(_as_text(result, facts))
        if all(file.suffix != ".parquet" for file in result.files):
            output.message(NO_PARQUET)
    ctx.exit(code)


def _facts(result: SweepResult) -> dict[str, Any]:
    """What came of the sweep, for the JSON document and for the summary."""
    column = result.table.column
    failures = [
        {"run": run, "status": status, "error": error}
        for run, status, error in zip(column("run"), column("status"), column("error"), strict=True)
        if status != "complete"
    ]
    return {
        "folder": str(result.folder),
        "files": [str(file) for file in result.files],
        "runs": len(result.table.rows),
        "by_status": result.manifest["by_status"],
        "expectations_failed": sum(bool(count) for count in column("expectations_failed")),
        "wall_time": result.manifest["wall_time"],
        "metrics": list(_statistics(result)),
        "failures": failures[:MOST_FAILURES_IN_JSON],
    }


def _statistics(result: SweepResult) -> Iterator[dict[str, Any]]:
    """Of every metric: in how many runs it has a value, and the spread of these."""
    for column in result.table.columns:
        if column.role == "metric":
            cells = [cell for cell in result.table.column(column.name) if cell is not None]
            known = [cell for cell in cells if math.isfinite(cell)]
            yield {
                "name": column.name,
                "unit": column.unit,
                "count": len(known),
                "mean": statistics.fmean(known) if known else None,
                "deviation": statistics.stdev(known) if len(known) > 1 else None,
                "min": min(known, default=None),
                "max": max(known, default=None),
            }


def _as_text(result: SweepResult, facts: dict[str, Any]) -> str:
    counts = ", ".join(f"{count} {status}" for status, count in facts["by_status"].items())
    runs = output.counted(facts["runs"], "run", "runs")
    lines = [f"{click.style(facts['folder'], bold=True)}: {runs} ({counts}) in {facts['wall_time']:.3g} s"]
    lines += facts["files"]
    if facts["expectations_failed"]:
        lines.append(f"expectations did not hold in {facts['expectations_failed']} of them")
    if facts["metrics"]:
        head = ("metric", "unit", "runs", "mean", "deviation", "min", "max")
        rows = [[_cell(metric[key]) for key in _KEYS] for metric in facts["metrics"]]
        lines.append(table(head, rows, right=range(2, 7)))
    for failure in facts["failures"][:MOST_FAILURES_TOLD]:
        lines.append(click.style(f"run {failure['run']} {failure['status']}: {failure['error']}", fg="red"))
    more = result.failed - MOST_FAILURES_TOLD
    return "\n".join([*lines, f"and {more} more, see the column error"] if more > 0 else lines)


_KEYS = ("name", "unit", "count", "mean", "deviation", "min", "max")


def _cell(value: Any) -> str:
    return value if isinstance(value, str) else number(value)


def _tell_plan(ctx: click.Context, loaded: Sweep, as_json: bool) -> None:
    from physsim.batch.table import columns_of

    design = loaded.design
    columns = columns_of(design)
    if as_json:
        listed = [{"name": c.name, "role": c.role, "kind": c.kind, "unit": c.unit} for c in columns]
        output.document("sweep", 0, **settings(ctx).known, runs=len(design), columns=listed)
        return
    varied = [[axis.path, axis.unit, _span(axis.cells)] for axis in design.columns]
    runs = output.counted(len(design), "run", "runs")
    output.result(f"{click.style(loaded.title, bold=True)}: {runs} of {loaded.base.name}")
    output.result(table(("varied", "unit", "values"), varied))
    output.result("metrics: " + (", ".join(loaded.spec.metrics) or "none"))


def _span(cells: tuple[Any, ...]) -> str:
    """`5: 0.2 to 1`."""
    if isinstance(cells[0], str):
        return f"{len(cells)}: {', '.join(cells[:3])}{', ...' if len(cells) > 3 else ''}"
    return f"{len(cells)}: {number(min(cells))} to {number(max(cells))}"


@contextmanager
def _shown(title: str, *, quiet: bool) -> Iterator[Report | None]:
    """A function to call with every Progress: a bar on a terminal, a plain line now and then elsewhere."""
    if quiet:
        yield None
    elif progress.on_terminal():
        with _bar(title) as report:
            yield report
    else:
        yield _lines(title)


@contextmanager
def _bar(title: str) -> Iterator[Report]:
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[facts]}"))
    console = Console(stderr=True, no_color=output.colour_wanted() is False)
    with Bar(*columns, console=console, transient=True, refresh_per_second=10) as drawn:
        task = drawn.add_task(title, total=None, facts="")

        def report(now: Progress) -> None:
            drawn.update(task, total=now.total, completed=now.done, facts=_how_far(now))

        yield report


def _lines(title: str) -> Report:
    told = 0.0

    def report(now: Progress) -> None:
        nonlocal told
        if now.wall_time - told >= progress.SECONDS_BETWEEN_LINES:
            told = now.wall_time
            output.message(f"{title}: {_how_far(now)}")

    return report


def _how_far(now: Progress) -> str:
    """`12 of 200 runs, 1 failed, 30 s left`."""
    parts = [f"{now.done} of {now.total} runs"]
    if now.failed:
        parts.append(f"{now.failed} failed")
    if now.seconds_left is not None:
        parts.append(f"{now.seconds_left:.0f} s left")
    return ", ".join(parts)
