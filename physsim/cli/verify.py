"""`physsim verify`: the formula sheet on this installation, every formula as a scene held against its
theory.
"""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output, progress
from physsim.cli.ahead import run_ahead
from physsim.cli.table import number, table
from physsim.cli.verb import Example, Verb, debug_option, json_option
from physsim.errors import FileTrouble, PhyssimError

if TYPE_CHECKING:
    from physsim.analysis.verify import Case, Formula, Verdict
    from physsim.recording import Trajectory

HEAD = ("case", "compared", "theory", "measured", "unit", "error", "order", "passed")
RIGHT = (2, 3, 5, 6)


@dataclass
class Tried:
    """What came of one formula: verdicts of its checks, and in words whatever went wrong besides."""

    formula: Formula
    verdicts: list[Verdict] = field(default_factory=list)
    troubles: list[str] = field(default_factory=list)
    expectations: int = 0

    @property
    def passed(self) -> bool:
        """Whether nothing was off."""
        return not self.troubles and all(verdict.passed for verdict in self.verdicts)


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


def run_all(formulas: Sequence[Formula], *, quiet: bool) -> Iterator[Tried]:
    """Runs and judges every formula, with a bar on a terminal."""
    with TemporaryDirectory(prefix="physsim-verify-") as name:
        folder = Path(name)
        jobs = [(scene, changes, folder) for scene, changes in runs_of(formulas)]
        with bar(len(jobs), quiet=quiet) as advance:
            run_ahead(jobs, advance)
        for formula in formulas:
            yield try_out(formula, folder)


def runs_of(formulas: Sequence[Formula]) -> list[tuple[str, dict[str, Any]]]:
    """Scene and changes of everything that is run, each once."""
    runs = [
        (case.scene, changes) for formula in formulas for case in formula.cases for changes in case.runs()
    ]
    runs += [(scene, {}) for formula in formulas for scene in formula.scenes]
    return list({file_name(*each): each for each in runs}.values())


def try_out(formula: Formula, folder: Path) -> Tried:
    """Runs every case of a formula, and its scenes as they stand; what fails is told, not raised.

    folder: where the trajectories are kept; those that are there already are not run again.
    """
    tried = Tried(formula)
    for case in formula.cases:
        try:
            tried.verdicts += verdicts(case, folder)
        except (PhyssimError, ValueError) as error:
            tried.troubles.append(f"{case.name}: {error}")
    for scene in formula.scenes:
        try:
            check_scene(scene, folder, tried)
        except PhyssimError as error:
            tried.troubles.append(f"{scene}.yaml: {error}")
    return tried


def verdicts(case: Case, folder: Path) -> list[Verdict]:
    """The case with all its timesteps, judged."""
    from physsim.analysis.verify import judge

    with ExitStack() as open_files:
        return judge(case, [open_files.enter_context(run(case.scene, each, folder)) for each in case.runs()])


def check_scene(scene: str, folder: Path, tried: Tried) -> None:
    """Runs a scene as it stands and checks what it expects of itself."""
    from physsim.analysis.verify import scene_file
    from physsim.scene import load_scene
    from physsim.simulation import check_expectations

    expected = load_scene(scene_file(scene)).spec.expect
    with run(scene, {}, folder) as trajectory:
        results = check_expectations(trajectory, expected)
    tried.expectations += len(results)
    tried.troubles += [f"{scene}.yaml: {result}" for result in results if not result.held]


def run(scene: str, changes: dict[str, Any], folder: Path) -> Trajectory:
    """The trajectory of a scene under changes; a run that is in the folder already is not done again."""
    from physsim.analysis.verify import scene_file
    from physsim.recording import open_trajectory
    from physsim.simulation import run as simulate

    file = folder / file_name(scene, changes)
    if file.exists():
        return open_trajectory(file)
    try:
        return simulate(scene_file(scene), set=changes, output=file)
    except PhyssimError:
        file.unlink(missing_ok=True)
        raise


def file_name(scene: str, changes: dict[str, Any]) -> str:
    """Of the trajectory of a run: scene and changes."""
    return ",".join([scene, *(f"{path}={value}" for path, value in changes.items())]) + ".h5"


def show_list(formulas: Sequence[Formula], as_json: bool) -> None:
    """Names, equations and scene files."""
    from physsim.analysis.verify import scene_file
    from physsim.analysis.verify.catalogue import SECTIONS

    if as_json:
        output.document("verify", 0, formulas=[formula_data(formula) for formula in formulas])
        return
    for section, title in SECTIONS.items():
        of_section = [formula for formula in formulas if formula.section == section]
        if of_section:
            output.result(click.style(f"{section} {title}", bold=True))
        for formula in of_section:
            output.result(f"  {formula.name}: {formula.equation}")
            for scene in formula.scenes:
                output.result(f"    {scene_file(scene)}")


def show(tried: Sequence[Tried]) -> None:
    """The table, each formula above its comparisons; then whatever else was off, then the count."""
    rows = [row(verdict) for each in tried for verdict in each.verdicts]
    head, *lines = table(HEAD, rows, right=RIGHT).splitlines()
    output.result(head)
    for each in tried:
        output.result(click.style(f"{each.formula.title}: {each.formula.equation}", bold=True))
        for _ in each.verdicts:
            output.result(lines.pop(0))
        for trouble in each.troubles:
            output.result(click.style(f"NO: {trouble}", fg="red"))
    failed = sum(not verdict.passed for each in tried for verdict in each.verdicts)
    troubles = sum(len(each.troubles) for each in tried)
    expected = sum(each.expectations for each in tried)
    output.result(
        f"\n{len(rows) - failed} of {len(rows)} comparisons passed, {expected} expectations of the scenes "
        f"checked, {output.counted(troubles, 'trouble', 'troubles')}"
    )


def row(verdict: Verdict) -> list[str]:
    """One line of the table."""
    check, passed = verdict.check, verdict.passed
    return [
        verdict.case.name,
        check.name,
        number(verdict.theory, 8),
        number(verdict.measured, 8),
        check.unit,
        number(verdict.error, 2),
        "" if check.order is None else number(verdict.order, 3),
        click.style("yes" if passed else "NO", fg="green" if passed else "red"),
    ]


def as_data(tried: Sequence[Tried]) -> dict[str, Any]:
    """The JSON document: formulas with their comparisons."""
    return {
        "passed": all(each.passed for each in tried),
        "formulas": [
            formula_data(each.formula)
            | {
                "passed": each.passed,
                "expectations": each.expectations,
                "troubles": each.troubles,
                "comparisons": [verdict_data(verdict) for verdict in each.verdicts],
            }
            for each in tried
        ],
    }


def formula_data(formula: Formula) -> dict[str, Any]:
    """What a formula is, in words."""
    from physsim.analysis.verify import scene_file

    return {
        "name": formula.name,
        "section": formula.section,
        "title": formula.title,
        "equation": formula.equation,
        "source": formula.source,
        "scenes": [str(scene_file(scene)) for scene in formula.scenes],
        "cases": [case.name for case in formula.cases],
    }


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """One comparison, in numbers."""
    return {
        "case": verdict.case.name,
        "compared": verdict.check.name,
        "unit": verdict.check.unit,
        "theory": verdict.theory,
        "measured": verdict.measured,
        "error": verdict.error,
        "within": verdict.check.within,
        "relative": verdict.check.relative,
        "timesteps": list(verdict.timesteps),
        "errors": list(verdict.errors),
        "order": verdict.order,
        "order_expected": verdict.check.order,
        "passed": verdict.passed,
    }


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


@contextmanager
def bar(length: int, *, quiet: bool) -> Iterator[Any]:
    """A function to call after each run; it draws on a terminal only."""
    if quiet or not progress.on_terminal():
        yield lambda: None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as drawn:
        task = drawn.add_task("verify", total=length)
        yield lambda: drawn.advance(task)
