"""The run loop: step, record, save, until the end or until somebody says stop."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import Any, Protocol

from physsim._engine import Diverged, EngineError, Frames
from physsim.recording import Block
from physsim.recording.layout import Status
from physsim.simulation.onlooker import Onlooker
from physsim.simulation.progress import Progress, Throttle
from physsim.simulation.stop import StopRequest
from physsim.simulation.world import Simulated

# One call of the engine takes about this long, so that Ctrl-C and the progress bar come through.
SECONDS_PER_CALL = 0.05
# `until: at_rest` ends a run when every moving body has been at rest, as the engine sees it, for this long.
REST_SECONDS = 0.25


@dataclass(frozen=True)
class Schedule:
    """When frames are due, in steps: every `steps_per_frame`, and at `steps`, the last. timestep in s."""

    timestep: float
    steps_per_frame: int
    steps: int
    until_rest: bool

    def steps_to_frame(self, step: int, number: int) -> int:
        """From `step` to the frame that comes as the `number`-th after it, or to the last."""
        return min((step // self.steps_per_frame + number) * self.steps_per_frame, self.steps) - step

    def has_frame(self, step: int) -> bool:
        return step % self.steps_per_frame == 0 or step == self.steps

    def frame_at(self, step: int) -> int:
        """The number of the frame that `step` has, from 0."""
        return -(-step // self.steps_per_frame)

    def whole_frames(self, step: int) -> int:
        """Frames at multiples of `steps_per_frame` up to and with `step`."""
        return step // self.steps_per_frame + 1


@dataclass(frozen=True)
class Ending:
    """How the loop ended: status and one sentence for the file."""

    status: Status
    detail: str


class Measuring(Protocol):
    """Turns what the engine kept into rows by dataset path: `Measure`, or a `Watch` of less.

    frames: where the engine keeps them.
    """

    frames: Frames

    def take(self, world: Any) -> Block: ...


class Keeping(Protocol):
    """Takes blocks of frames as they come: the `Recorder` of a file, or a `Memory`."""

    @property
    def frames(self) -> int: ...
    @property
    def room(self) -> int: ...
    def append(self, block: Block) -> None: ...
    def checkpoint_is_due(self, coming: int) -> bool: ...
    def write_part(self) -> None: ...
    def write_checkpoint(self, engine: bytes, step: int) -> None: ...
    def check(self) -> None: ...
    def settle(self) -> None: ...


class Loop:
    """One run from its present step to its end. `step` is where it is."""

    def __init__(
        self,
        simulated: Simulated,
        measure: Measuring,
        schedule: Schedule,
        *,
        recorder: Keeping,
        report: Throttle,
        onlooker: Onlooker | None = None,
        step: int = 0,
    ) -> None:
        self.step = step
        self._world, self._answer = simulated.world, simulated.answer
        self._measure = measure
        self._schedule = schedule
        self._recorder = recorder
        self._report = report
        self._onlooker = onlooker
        self._pace = _Pace()
        self._began = time.monotonic()

    @property
    def time(self) -> float:
        """Simulated time [s]: the step number times the timestep."""
        return self.step * self._schedule.timestep

    @property
    def wall_time(self) -> float:
        return time.monotonic() - self._began

    def run(self, stop: StopRequest) -> Ending:
        """Steps and records until the end, rest, or a signal. What the engine raises passes through."""
        try:
            if self._recorder.frames == 0:
                self._begin()
            return self._run(stop)
        finally:
            self._hand_over()

    def run_to_its_end(self, stop: StopRequest, body_names: tuple[str, ...]) -> Ending:
        """As `run`; a motion that blows up, or an engine that fails, is an ending too."""
        try:
            return self.run(stop)
        except Diverged as error:
            body, moment = error.args
            blown_up = f"its motion blew up at {moment:g} s (not finite, or far too fast)"
            return Ending("failed", f"bodies.{body_names[body]}: {blown_up}")
        except EngineError as error:
            return Ending("failed", str(error))

    def checkpoint(self) -> bytes:
        """The engine as it is, with all frames and impacts up to here handed to the recorder."""
        self._hand_over()
        engine: bytes = self._world.save()
        return engine

    def _begin(self) -> None:
        """Frame 0, the declared state, goes to the disk at once: from then on there is a file."""
        self._world.keep(self._measure.frames)
        self._recorder.write_checkpoint(self.checkpoint(), self.step)
        self._recorder.settle()

    def _run(self, stop: StopRequest) -> Ending:
        while self.step < self._schedule.steps:
            if stop.signal is not None:
                return self._ended("interrupted", f"stopped by {stop.signal.name} at {self.time:g} s")
            if self._at_rest():
                return self._ended("complete", f"at rest at {self.time:g} s")
            self._advance()
        return self._ended("complete", f"ran to its end at {self.time:g} s")

    def _at_rest(self) -> bool:
        return (
            self._schedule.until_rest
            and self._schedule.has_frame(self.step)
            and self._world.solver()["rest_time"] >= REST_SECONDS
        )

    def _advance(self) -> None:
        """One call of the engine, of about `SECONDS_PER_CALL`; steps are the same however they are cut."""
        schedule = self._schedule
        count = min(self._pace.steps, schedule.steps_to_frame(self.step, self._room()))
        began = time.perf_counter()
        rest_time = REST_SECONDS if schedule.until_rest else math.inf
        frames, due = self._measure.frames, (schedule.steps_per_frame, schedule.steps)
        made = self._world.record(frames, count, *due, rest_time, self._answer)
        self._pace.took(made, time.perf_counter() - began)
        self.step += made
        self._report(lambda: self._progress("running"))
        if self._onlooker is not None:
            self._hand_over()
        self._save_when_due()

    def _room(self) -> int:
        """Frames that may come before some are handed over."""
        return self._recorder.room - len(self._measure.frames)

    def _hand_over(self) -> None:
        """What the engine kept goes to the recorder, and to who looks on."""
        block = self._measure.take(self._world)
        self._recorder.append(block)
        if self._onlooker is not None:
            for rows, contacts in block:
                step = int(rows["step"])
                self._onlooker.frame(self._schedule.frame_at(step), step, float(rows["time"]), rows, contacts)

    def _save_when_due(self) -> None:
        self._recorder.check()
        if self._recorder.checkpoint_is_due(len(self._measure.frames)):
            self._recorder.write_checkpoint(self.checkpoint(), self.step)
        elif self._room() <= 0:
            self._hand_over()
            self._recorder.write_part()

    def _ended(self, status: Status, detail: str) -> Ending:
        self._report(lambda: self._progress(status), last=True)
        return Ending(status, detail)

    def _progress(self, status: Status) -> Progress:
        schedule, contacts = self._schedule, int(self._world.solver()["contact_count"])
        duration = schedule.steps * schedule.timestep
        return Progress(self.time, duration, self.step, schedule.steps, self.wall_time, contacts, status)


class _Pace:
    """How many steps fit in one call of the engine, from how long the last call took."""

    def __init__(self) -> None:
        self.steps = 1

    def took(self, count: int, seconds: float) -> None:
        """What the last call took."""
        self.steps = max(1, min(int(count * SECONDS_PER_CALL / max(seconds, 1e-9)), 2 * count + 1))
