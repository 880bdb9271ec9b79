"""`sweep`: a sweep goes in, a folder with a table comes out."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

from physsim.batch import manifest as manifests
from physsim.batch.backlog import Backlog
from physsim.batch.design import Design, Run
from physsim.batch.gather import NAME as GATHERED
from physsim.batch.gather import gather
from physsim.batch.job import Job, job_of
from physsim.batch.journal import Journal
from physsim.batch.load import Sweep, load_sweep
from physsim.batch.place import Answer, Place
from physsim.batch.table import Table, table_of, write_tables
from physsim.batch.workshop import COMPLETE, Result
from physsim.errors import FileTrouble, Problem
from physsim.model import compile_scene
from physsim.recording.whole_file import written
from physsim.simulation import Interrupted
from physsim.simulation.stop import StopRequest

JOURNAL, RUNS = "journal.jsonl", "runs"
OURS = (JOURNAL, manifests.NAME, "table.csv", "table.parquet", GATHERED)
SECONDS_BETWEEN_LOOKS = 0.1
# More blocks than workers are out, so that none waits while its last results are written down.
AHEAD = 1


@dataclass(frozen=True)
class Progress:
    """One report: runs done of all, those of them that did not complete, those that an earlier call had done,
    and the seconds since this call began working.
    """

    done: int
    total: int
    failed: int
    found_done: int
    wall_time: float

    @property
    def seconds_left(self) -> float | None:
        """Estimated from the pace of this call; None while nothing is known."""
        new = self.done - self.found_done
        return (self.total - self.done) * self.wall_time / new if new else None


Report = Callable[[Progress], None]


@dataclass(frozen=True)
class SweepResult:
    """What came of a sweep. folder: where everything is; files: the tables; manifest: as in manifest.json."""

    folder: Path
    table: Table
    files: list[Path]
    manifest: dict[str, Any]

    @property
    def failed(self) -> int:
        """Number of runs that did not complete."""
        return sum(status != COMPLETE for status in self.table.column("status"))

    def to_pandas(self) -> Any:
        """The table as a data frame. Needs pandas (extra `analysis`)."""
        import pandas  # noqa: PLC0415, optional and slow to import

        return pandas.DataFrame(self.table.rows, columns=[column.name for column in self.table.columns])


def sweep(
    source: str | Path | Mapping[str, Any] | Sweep,
    *,
    output: str | Path | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    force: bool = False,
    progress: Report | None = None,
    warn: Callable[[Problem], None] | None = None,
) -> SweepResult:
    """Runs one scene many ways and writes one row per run.

    source: a sweep file, a dictionary with the same keys, or a Sweep that is loaded already. output: the
    folder; NAME_sweep in the current folder when not given. workers: processes on this machine; as many as it
    has cores when not given. cluster: address of a Dask scheduler, which is used instead. A folder that holds
    a part of this sweep is completed: only missing runs are done. force: begins anew. progress: called after
    every block. warn: called with every warning.

    A run that fails is a row with its error. Raises SceneError when the sweep or its scene is not valid,
    FileTrouble when the folder cannot be written or holds another sweep, and Interrupted on Ctrl-C or SIGTERM
    (what was done is kept).
    """
    loaded = source if isinstance(source, Sweep) else load_sweep(source)
    job = job_of(loaded)
    for problem in (*loaded.warnings, *loaded.scene.warnings, *compile_scene(loaded.scene).warnings):
        if warn is not None:
            warn(problem)
    folder = _folder(loaded, output)
    journal = _opened(folder, job, force)
    try:
        return _Conductor(loaded, job, folder, journal, progress).conduct(workers, cluster)
    finally:
        journal.close()


class _Conductor:
    """One call of `sweep` from its first block to its table."""

    def __init__(
        self, loaded: Sweep, job: Job, folder: Path, journal: Journal, report: Report | None
    ) -> None:
        self._sweep, self._job, self._folder, self._journal = loaded, job, folder, journal
        self._design: Design = loaded.design
        self._report = report
        self._missing = [run.number for run in self._design if not journal.is_done(run.key)]
        self._found_done = len(self._design) - len(self._missing)
        self._done = self._found_done
        self._failed = sum(result.status != COMPLETE for _, result in self._results())
        self._began = time.monotonic()

    def conduct(self, workers: int | None, cluster: str | None) -> SweepResult:
        """Does what is missing, then writes the tables; also when interrupted, before saying so."""
        count = workers or _cores()
        manifest = manifests.manifest_of(self._sweep, self._job, cluster or f"{count} local workers")
        manifests.write(self._folder, manifest)
        signal = None
        with StopRequest.heard() as stop:
            if self._missing:
                self._work(min(count, len(self._missing)), cluster, stop)
            signal = stop.signal
        result = self._concluded(manifest, "interrupted" if signal else "complete")
        if signal is not None:
            left = len(self._design) - self._done
            raise Interrupted(f"stopped by {signal.name}: {left} runs are left, run it again to go on")
        return result

    def _work(self, workers: int, cluster: str | None, stop: StopRequest) -> None:
        answers: SimpleQueue[Answer] = SimpleQueue()
        place = self._place(workers, cluster, answers)
        try:
            self._hand_out(place, answers, stop)
        finally:
            place.close()

    def _place(self, workers: int, cluster: str | None, answers: SimpleQueue[Answer]) -> Place:
        if cluster is not None:
            from physsim.batch.cluster import ClusterPlace  # noqa: PLC0415, only with a cluster

            return ClusterPlace(self._job, cluster, answers)
        from physsim.batch.local import LocalPlace  # noqa: PLC0415, only without one

        here = replace(self._job, meshes={})
        return LocalPlace(here, self._sweep.scene.folder, self._folder, workers, answers)

    def _hand_out(self, place: Place, answers: SimpleQueue[Answer], stop: StopRequest) -> None:
        runs = (self._design.run(number) for number in self._missing)
        backlog = Backlog(runs, len(self._missing), place.slots)
        out = 0
        self._tell()
        while not backlog.is_done and stop.signal is None:
            while out < place.slots + AHEAD and (block := backlog.take()) is not None:
                place.submit(block)
                out += 1
            try:
                answer = answers.get(timeout=SECONDS_BETWEEN_LOOKS)
            except Empty:
                continue
            out -= 1
            self._take(answer, backlog)
            self._tell()

    def _take(self, answer: Answer, backlog: Backlog) -> None:
        if answer.trouble is not None:
            raise answer.trouble
        if answer.results is None:
            results = backlog.lost(answer.block, answer.reason)
        else:
            backlog.done(answer.block, answer.results)
            results = answer.results
        for name, data in answer.files.items():
            written(self._folder / name, data)
        self._journal.append(results)
        self._done += len(results)
        self._failed += sum(result.status != COMPLETE for result in results)

    def _tell(self) -> None:
        if self._report is not None:
            wall_time = time.monotonic() - self._began
            total = len(self._design)
            self._report(Progress(self._done, total, self._failed, self._found_done, wall_time))

    def _results(self) -> Iterator[tuple[Run, Result]]:
        """Runs that have a result, with it, in order."""
        for run in self._design:
            result = self._journal.results.get(run.key)
            if result is not None:
                yield run, result

    def _concluded(self, manifest: dict[str, Any], status: str) -> SweepResult:
        done = list(self._results())
        table = table_of(self._design, done)
        files = write_tables(table, self._folder)
        if self._sweep.spec.gather and status == "complete":
            files.append(gather(table, self._folder))
        wall_time = time.monotonic() - self._began
        manifest = manifests.ended(manifest, status, [result for _, result in done], wall_time)
        manifests.write(self._folder, manifest)
        return SweepResult(self._folder, table, files, manifest)


def _folder(loaded: Sweep, output: str | Path | None) -> Path:
    if output is not None:
        return Path(output)
    if loaded.path is None:
        raise FileTrouble(f"{loaded.name}: was not read from a file, so `output` must name the folder")
    return Path(f"{loaded.path.stem}_sweep")


def _opened(folder: Path, job: Job, force: bool) -> Journal:
    """The journal of the folder, which is made when it is not there.

    Raises FileTrouble when it is a folder of something else, or of another sweep and `force` is not given.
    """
    if folder.exists() and not folder.is_dir():
        raise FileTrouble(f"{folder}: is a file; name a folder")
    before = manifests.read(folder)
    if before is None and folder.exists() and any(map(_is_foreign, folder.iterdir())):
        raise FileTrouble(f"{folder}: is not empty and holds no sweep; -o names another folder")
    if before is not None and before.get("digest") != job.digest and not force:
        what = ", ".join(manifests.differing(before, job))
        raise FileTrouble(
            f"{folder}: holds another sweep ({what} differ): --force begins anew, -o names another folder"
        )
    try:
        (folder / RUNS).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileTrouble(f"{folder}: cannot be made: {error.strerror}") from None
    if force or before is None:
        Journal(folder / JOURNAL).close()  # raises while another sweep is at work here
        _clear(folder)
    return Journal(folder / JOURNAL)


def _is_foreign(path: Path) -> bool:
    """Whether no sweep has made this; one that was killed in its first moments may have left no manifest."""
    return path.name.removesuffix(".part") not in (*OURS, RUNS)


def _clear(folder: Path) -> None:
    """Takes away what a sweep has written, and nothing else."""
    for name in OURS:
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder / RUNS)
    (folder / RUNS).mkdir()


def _cores() -> int:
    with suppress(AttributeError):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
