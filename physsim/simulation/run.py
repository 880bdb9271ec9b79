"""`run`: a scene goes in, a trajectory file comes out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from physsim.errors import FileTrouble, PhyssimError, RunFailed
from physsim.recording import Recorder, Trajectory, open_own, open_trajectory, recorded
from physsim.simulation.about import fixed_values, now, root_attributes
from physsim.simulation.expectations import check_expectations, demand
from physsim.simulation.loop import Ending, Loop, Schedule
from physsim.simulation.measure import Measure
from physsim.simulation.onlooker import Onlooker
from physsim.simulation.overlaps import overlap_problems, overlaps_of
from physsim.simulation.prepare import Prepared, Warn, prepare
from physsim.simulation.progress import Report, Throttle
from physsim.simulation.resume import Resumable, find_resumable
from physsim.simulation.stop import Interrupted, StopRequest
from physsim.simulation.world import Simulated, build

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.recording.column import Column
    from physsim.recording.layout import Status
    from physsim.scene import Scene

# Position, orientation and velocities; force, torque, three coordinates, violations; length, force.
NUMBERS_PER_BODY = 3 + 4 + 3 + 3
NUMBERS_PER_JOINT = 3 + 3 + 3 + 2
NUMBERS_PER_SPRING = 2


def run(
    scene: str | Path | Scene,
    *,
    set: Mapping[str, Any] | list[str] | None = None,
    output: str | Path | None = None,
    duration: float | str | None = None,
    resume: bool = False,
    force: bool = False,
    progress: Report | None = None,
    warn: Warn | None = None,
    check: bool = False,
    onlooker: Onlooker | None = None,
) -> Trajectory:
    """Runs a scene and returns its trajectory, open for reading.

    scene: a file, or a Scene that is loaded already (then without `set` and `duration`). set: values to
    change before the scene is validated, `{"bodies.ball.mass": "2 kg"}`. output: the trajectory file;
    SCENE.h5 in the current folder when not given. duration: instead of the scene's, `"5 s"` or seconds.
    resume: goes on from what is in `output`, bit for bit as if it had never stopped; starts anew when there
    is nothing. force: replaces an old file. progress: called at most ten times a second. warn: called with
    every warning about the scene. check: raises ExpectationFailed when an entry of `expect` does not hold;
    the file is kept. onlooker: is handed everything that is recorded while it is; the file has the same bits.

    Raises SceneError when the scene is not valid, FileTrouble when the file cannot be written or another
    file is in the way, RunFailed when the motion blows up (the file is kept, status failed), and
    Interrupted on Ctrl-C or SIGTERM (the file is kept, status interrupted). While it runs in the main
    thread those two signals are its own.
    """
    prepared = prepare(scene, set, duration, output, warn)
    found = find_resumable(prepared.target, prepared.scene, prepared.model) if resume else None
    if found is None:
        _refuse_bad_target(prepared, force)
    if found is not None and _is_done(found, prepared.schedule):
        trajectory = open_trajectory(found.path)
    else:
        trajectory = open_own(_simulate(prepared, found, Throttle(progress), onlooker))
    if check:
        with _closed_on_error(trajectory):
            demand(check_expectations(trajectory, prepared.scene.spec.expect))
    return trajectory


def _refuse_bad_target(prepared: Prepared, force: bool) -> None:
    prepared.target.check(force=force)
    model = prepared.model
    numbers = NUMBERS_PER_BODY * len(model.body_names)
    if model.spec.record.joints:
        numbers += NUMBERS_PER_JOINT * len(model.mechanics.joints.names)
        numbers += NUMBERS_PER_SPRING * len(model.mechanics.springs.names)
    frames = prepared.schedule.whole_frames(prepared.schedule.steps)
    prepared.target.check_space(frames * numbers * 8)


def _is_done(found: Resumable, schedule: Schedule) -> bool:
    """Whether nothing is left to do. Raises FileTrouble when the file holds more than is asked for."""
    if found.checkpoint.step > schedule.steps:
        held, asked = (steps * schedule.timestep for steps in (found.checkpoint.step, schedule.steps))
        raise FileTrouble(f"{found.path}: holds {held:g} s already, more than the {asked:g} s asked for")
    return found.checkpoint.step == schedule.steps and found.status == "complete"


def _simulate(
    prepared: Prepared, found: Resumable | None, report: Throttle, onlooker: Onlooker | None
) -> Path:
    """Builds the world, runs the loop, and brings the file to its end, whatever that is. Returns the file."""
    simulated = build(prepared.model)
    recorder = _started(prepared, simulated) if found is None else _resumed(prepared, simulated, found)
    loop = Loop(
        simulated,
        Measure(prepared.model),
        prepared.schedule,
        recorder=recorder,
        report=report,
        onlooker=onlooker,
        step=found.checkpoint.step if found else 0,
    )
    if onlooker is not None:
        _tell_who_takes_part(onlooker, prepared)
    with StopRequest.heard() as stop:
        ending = _ending(loop, stop, recorder, prepared.model)
        engine = None if ending.status == "failed" else loop.checkpoint()
        took = loop.wall_time + (found.wall_time if found else 0.0)
        provenance = {"provenance/finished": now(), "provenance/wall_time": took}
        path = recorder.finish(ending.status, ending.detail, engine, loop.step, provenance)
    if onlooker is not None:
        onlooker.end(ending.status, ending.detail)
    return _kept(path, ending)


def _tell_who_takes_part(onlooker: Onlooker, prepared: Prepared) -> None:
    scene, model, schedule = prepared.scene, prepared.model, prepared.schedule
    duration = schedule.steps * schedule.timestep
    onlooker.begin(scene.title, prepared.target.path, duration, fixed_values(scene, model))


def _started(prepared: Prepared, simulated: Simulated) -> Recorder:
    for problem in overlap_problems(prepared.scene, overlaps_of(simulated, prepared.model)):
        prepared.warn(problem)
    scene, model = prepared.scene, prepared.model
    return Recorder.create(
        prepared.target, _columns(scene), root_attributes(scene), fixed_values(scene, model)
    )


def _resumed(prepared: Prepared, simulated: Simulated, found: Resumable) -> Recorder:
    """The frame at the end of a shorter run is dropped when a run straight through would not have it."""
    at = found.checkpoint
    try:
        simulated.world.restore(at.engine)
    except ValueError as error:
        raise FileTrouble(f"{found.path}: its checkpoint cannot be used: {error}") from error
    schedule = prepared.schedule
    frames = at.frames if at.step == schedule.steps else min(at.frames, schedule.whole_frames(at.step))
    return Recorder.resume(found.path, prepared.target, _columns(prepared.scene), frames, at.events)


def _columns(scene: Scene) -> tuple[Column, ...]:
    spec = scene.spec
    return recorded(
        name
        for name, wanted in {
            "geometry": True,
            "energy": spec.record.energy,
            "contacts": spec.record.contacts,
            "joints": spec.record.joints and spec.joints,
            "springs": spec.record.joints and spec.springs,
        }.items()
        if wanted
    )


def _ending(loop: Loop, stop: StopRequest, recorder: Recorder, model: Model) -> Ending:
    """How the loop ended; what nobody foresaw is written into the file before it is raised."""
    try:
        return loop.run_to_its_end(stop, model.body_names)
    except FileTrouble:
        raise
    except BaseException as error:
        status: Status = "interrupted" if isinstance(error, KeyboardInterrupt) else "failed"
        with suppress(FileTrouble):
            recorder.finish(status, f"{type(error).__name__} at {loop.time:g} s", None, loop.step, {})
        raise


def _kept(path: Path, ending: Ending) -> Path:
    """The file, or the error that an ending other than complete is for the caller."""
    if ending.status == "failed":
        raise RunFailed(f"{ending.detail}; what was computed is in {path}")
    if ending.status == "interrupted":
        raise Interrupted(f"{ending.detail}; what was computed is in {path}, --resume goes on from there")
    return path


@contextmanager
def _closed_on_error(trajectory: Trajectory) -> Iterator[None]:
    try:
        yield
    except PhyssimError:
        trajectory.close()
        raise
