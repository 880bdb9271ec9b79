"""The runs of `physsim verify`: every case and every scene, judged."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from physsim.cli import progress
from physsim.cli.verify_ahead import run_ahead
from physsim.errors import PhyssimError

if TYPE_CHECKING:
    from physsim.analysis.verify import Case, Formula, Verdict
    from physsim.recording import Trajectory


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
