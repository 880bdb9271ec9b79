"""`watch`: runs a scene without a file and keeps in memory only what is asked for.

A sweep of small scenes would spend most of its time on files: making one costs more than thousands of steps.
What is kept here has the same bits as what a file would hold, at the same frames.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim._engine import Frames
from physsim.recording.block import Block, joined
from physsim.simulation.loop import Ending, Loop, Schedule
from physsim.simulation.prepare import schedule_of
from physsim.simulation.progress import Throttle
from physsim.simulation.stop import Interrupted, StopRequest
from physsim.simulation.watched import Watched
from physsim.simulation.world import build

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene
    from physsim.scene.quantity import Quantity

BODY_FIELDS = ("position", "orientation", "velocity", "angular_velocity")
_MOTION = ("velocity", "angular_velocity")
# So many are kept in the engine before those columns of them that are wanted are taken out.
FRAMES_AT_ONCE = 256
# What the engine hands out -> groups of quantities that it answers.
_ANSWERS = {
    "energy": {"energy"},
    "momentum": {"momentum"},
    "solver": {"solver", "contacts"},
    "joints": {"joints"},
    "springs": {"springs"},
}
_NEEDS = {
    "position": ("position", "orientation"),
    "speed": ("velocity",),
    "angular_speed": ("angular_velocity",),
    "momentum": ("velocity",),
    "angular_momentum": ("orientation", "angular_velocity"),
    "kinetic_energy": ("orientation", "velocity", "angular_velocity"),
}


@dataclass(frozen=True)
class Wanted:
    """What of a run is wanted.

    quantities: by name; bodies: names of those whose motion is looked at besides; events: the impacts;
    contacts: who touches whom in every frame. ends_only: the first and the last frame are enough.
    """

    quantities: tuple[Quantity, ...] = ()
    bodies: frozenset[str] = frozenset()
    events: bool = False
    contacts: bool = False
    ends_only: bool = False

    @property
    def groups(self) -> frozenset[str]:
        """Parts of the trajectory that the quantities are in."""
        return frozenset(quantity.group for quantity in self.quantities)

    @property
    def body_names(self) -> frozenset[str]:
        """All bodies that are looked at."""
        return self.bodies | {str(some.name) for some in self.quantities if some.group == "bodies"}

    @property
    def contact_columns(self) -> tuple[str, ...]:
        """What is kept of contacts."""
        if any(some.field == "contact_force" for some in self.quantities):
            return ("body_a", "body_b", "force")
        return ("body_a", "body_b") if self.contacts else ()

    @property
    def body_fields(self) -> list[str]:
        """Datasets of bodies that the quantities need."""
        fields = {field for some in self.quantities for field in _NEEDS.get(some.field, (some.field,))}
        return [name for name in BODY_FIELDS if name in fields or (self.bodies and name in _MOTION)]


def watch(scene: Scene, model: Model, wanted: Wanted) -> Watched:
    """Steps a scene to its end and returns what was wanted of it, frame by frame.

    A motion that blows up is an ending (`status` "failed"), as in a file. Raises RunFailed when the engine
    refuses the model, Interrupted on Ctrl-C or SIGTERM.
    """
    simulated = build(model)
    memory = Memory()
    loop = Loop(
        simulated,
        Watch(model, wanted),
        _frames(schedule_of(scene), wanted),
        recorder=memory,
        report=Throttle(None),
    )
    with StopRequest.heard() as stop:
        ending = loop.run_to_its_end(stop, model.body_names)
    if ending.status == "interrupted":
        raise Interrupted(ending.detail)
    return _watched(model, memory, wanted, ending)


def _frames(schedule: Schedule, wanted: Wanted) -> Schedule:
    """Fewer frames where they decide nothing; a run that may end at rest is looked at in all of them."""
    if not wanted.ends_only or schedule.until_rest:
        return schedule
    return replace(schedule, steps_per_frame=schedule.steps)


class Watch:
    """Keeps, of every frame, what is wanted and nothing else: of bodies only those that are watched, at their
    centres of mass; of contacts who touches whom, and the forces when these are wanted.
    """

    def __init__(self, model: Model, wanted: Wanted) -> None:
        self._wanted = wanted
        self._fields = wanted.body_fields
        self._timestep = model.spec.simulation.timestep
        rows = [row for row, name in enumerate(model.body_names) if name in wanted.body_names]
        groups = wanted.groups
        self._groups = {group for group, answers in _ANSWERS.items() if groups & answers}
        self.frames = Frames(
            bodies=rows if self._fields else [],
            momentum="momentum" in groups,
            energy="energy" in groups,
            contacts=bool(wanted.contact_columns),
            joints=len(model.mechanics.joints.names) if "joints" in groups else 0,
            springs="springs" in groups,
        )

    def take(self, world: Any) -> Block:
        """What has been kept since the last call, and impacts up to now."""
        found, more = self.frames.take(), world.events()
        rows = {f"{group}/{name}": some for group in self._groups for name, some in found[group].items()}
        rows |= {name: found["bodies"][name] for name in self._fields}
        return Block(
            {"time": found["step"] * self._timestep, **rows},
            {name: found["contacts"][name] for name in self._wanted.contact_columns},
            found["solver"]["contact_count"],
            joined([found["events"], more]) if self._wanted.events else {},
        )


class Memory:
    """Keeps blocks as they come; there is nothing to be saved."""

    room = FRAMES_AT_ONCE

    def __init__(self) -> None:
        self.blocks: list[Block] = []

    @property
    def frames(self) -> int:
        return sum(block.frames for block in self.blocks)

    def append(self, block: Block) -> None:
        self.blocks.append(block)

    def checkpoint_is_due(self, coming: int) -> bool:
        """No file, no checkpoint."""
        return False

    def write_part(self) -> None:
        """No file, no part."""

    def write_checkpoint(self, engine: bytes, step: int) -> None:
        """No file, no checkpoint."""

    def check(self) -> None:
        """Nothing can go wrong."""

    def settle(self) -> None:
        """Nothing is under way."""


def _watched(model: Model, memory: Memory, wanted: Wanted, ending: Ending) -> Watched:
    filled = [block for block in memory.blocks if block.frames]
    columns = joined([block.rows for block in filled])
    return Watched(
        time=columns.pop("time"),
        status=ending.status,
        status_detail=ending.detail,
        names=tuple(name for name in model.body_names if name in wanted.body_names),
        model=model,
        columns=columns,
        touching=joined([block.contacts or {} for block in filled]),
        counts=np.concatenate([block.counts for block in filled]),
        impacts=joined([block.events for block in memory.blocks]),
    )
