"""Times that must fit each other: duration, timestep, frames, expectations."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import Problem
from physsim.scene.draft import Draft
from physsim.scene.spec.record import RecordSpec
from physsim.scene.spec.simulation import ROUNDING, SimulationSpec

MAX_STEPS = 1e12


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of duration, timestep and record.every."""
    if draft.simulation is None:
        return
    yield from _step(draft.simulation)
    if draft.record is not None and "every" in draft.record.model_fields_set:
        yield from _frames(draft.record, draft.simulation)


def _step(simulation: SimulationSpec) -> Iterator[Problem]:
    path = ("simulation", "timestep")
    if simulation.timestep > simulation.duration:
        yield Problem(
            path, f"must not exceed the duration ({simulation.duration:g} s)", f"{simulation.timestep:g} s"
        )
    elif simulation.duration / simulation.timestep > MAX_STEPS:
        yield Problem(path, f"asks for more than {MAX_STEPS:g} steps", f"{simulation.timestep:g} s")


def _frames(record: RecordSpec, simulation: SimulationSpec) -> Iterator[Problem]:
    """Frames stand at whole steps: anything else would be rounded to other times than those asked for."""
    ratio = record.every / simulation.timestep
    steps = round(ratio)
    if steps >= 1 and abs(ratio - steps) <= ROUNDING * ratio:
        return
    nearest = sorted({max(1, int(ratio)), int(ratio) + 1})
    hint = "or ".join(f"{n * simulation.timestep:g} s " for n in nearest).strip()
    yield Problem(
        ("record", "every"),
        f"must be a whole number of timesteps ({simulation.timestep:g} s)",
        f"{record.every:g} s",
        hint=f"nearest: {hint}",
    )
