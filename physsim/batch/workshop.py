"""Where runs are done: prepared once in every worker process, then one run after the other."""

from __future__ import annotations

import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import physsim
from physsim.batch.design import Run
from physsim.batch.job import Job
from physsim.batch.metrics import metrics_of, wanted_of
from physsim.errors import FileTrouble, PhyssimError, RunFailed, SceneError, dotted
from physsim.model import MeshMemory, compile_scene
from physsim.recording import open_trajectory
from physsim.scene import Original
from physsim.simulation import Interrupted, check_expectations, run, watch

if TYPE_CHECKING:
    from physsim.recording import Trajectory
    from physsim.scene import Scene

MOST_PROBLEMS_TOLD = 3
COMPLETE, FAILED, INVALID, CRASHED = "complete", "failed", "invalid", "crashed"


@dataclass(frozen=True)
class Result:
    """How one run went.

    key: of the run; status: complete, failed (blow-up, engine), invalid (the scene with its values is none),
    or crashed (it took its worker with it); error: in words, "" without one. metrics: by name, none unless
    complete. file: below the folder of the sweep, "" when no trajectory was kept. wall_time [s].
    """

    key: str
    status: str
    error: str = ""
    metrics: Mapping[str, float] = field(default_factory=dict)
    expectations_failed: int | None = None
    file: str = ""
    wall_time: float = 0.0

    def as_dict(self) -> dict[str, Any]:
        """Plain values for the journal."""
        return asdict(self)


class Workshop:
    """One worker's tools for one job: the scene parsed once, meshes read once.

    scenes: the folder from which the scene's files are found; results: the folder of the sweep.
    """

    def __init__(self, job: Job, scenes: Path, results: Path) -> None:
        if job.version != physsim.__version__:
            raise PhyssimError(f"the worker has physsim {physsim.__version__}, the sweep is of {job.version}")
        self._job = job
        self._results = results
        self._original = Original(job.text, job.name, None, scenes)
        self._memory = MeshMemory()

    def do(self, task: Run) -> Result:
        """One run. What goes wrong in it is in the result; only being told to stop, and a disk that takes no
        more (FileTrouble), pass through.
        """
        began = time.perf_counter()
        try:
            result = self._attempt(task)
        except (Interrupted, FileTrouble):
            raise
        except SceneError as error:
            result = Result(task.key, INVALID, _in_words(error))
        except (PhyssimError, MemoryError) as error:
            result = Result(task.key, FAILED, str(error) or "out of memory")
        except Exception as error:  # a mistake of ours in one run must not cost the others
            result = Result(task.key, FAILED, f"internal error: {type(error).__name__}: {error}")
        return replace(result, wall_time=time.perf_counter() - began)

    def _attempt(self, task: Run) -> Result:
        scene = self._original.scene({**self._job.shared, **dict(task.changes)})
        if self._job.keep == "all":
            return self._recorded(task, scene)
        result = self._watched(task, scene)
        unwell = result.status != COMPLETE or result.expectations_failed
        return self._recorded(task, scene) if unwell and self._job.keep == "failed" else result

    def _watched(self, task: Run, scene: Scene) -> Result:
        model = compile_scene(scene, self._memory)
        wanted = wanted_of(self._job.metrics, scene.spec.expect, _moving(scene))
        watched = watch(scene, model, wanted)
        if watched.status != COMPLETE:
            return Result(task.key, FAILED, watched.status_detail)
        return self._measured(task, scene, watched.as_trajectory())

    def _recorded(self, task: Run, scene: Scene) -> Result:
        target = self._results / task.file
        try:
            trajectory = run(scene, output=target, force=True)
        except RunFailed as error:
            return Result(task.key, FAILED, *_kept(target, task.file, error))
        with trajectory:
            found = self._measured(task, scene, trajectory)
        return replace(found, file=task.file)

    def _measured(self, task: Run, scene: Scene, trajectory: Trajectory) -> Result:
        metrics = metrics_of(trajectory, self._job.metrics, scene.spec.parameters, _moving(scene))
        checked = check_expectations(trajectory, scene.spec.expect)
        return Result(task.key, COMPLETE, "", metrics, sum(not entry.held for entry in checked))


def _moving(scene: Scene) -> list[str]:
    """Names of the bodies that can move."""
    return [name for name, body in scene.bodies.items() if not body.fixed]


def _kept(target: Path, file: str, error: RunFailed) -> tuple[str, dict[str, float], None, str]:
    """Error, metrics, expectations and file of a run that failed; the words are those in its file."""
    with suppress(FileTrouble), open_trajectory(target) as trajectory:
        return trajectory.status_detail, {}, None, file
    return str(error), {}, None, ""


def _in_words(error: SceneError) -> str:
    """The first problems, as `bodies.ball.mass: must be greater than 0, got -1`."""
    told = []
    for problem in error.problems[:MOST_PROBLEMS_TOLD]:
        place = f"{dotted(problem.path)}: " if problem.path else ""
        got = f", got {problem.given}" if problem.given is not None else ""
        told.append(f"{place}{problem.message}{got}")
    more = len(error.problems) - len(told)
    return "; ".join([*told, f"and {more} more"] if more > 0 else told)
