"""`watch`: runs a scene without a file and keeps in memory only what is asked for.

A sweep of small scenes would spend most of its time on files: making one costs more than thousands of steps.
What is kept here has the same bits as what a file would hold, at the same frames.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.simulation.loop import Ending, Loop, Schedule
from physsim.simulation.measure import Measure, Rows
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
# What the engine is asked for -> groups of quantities that it answers.
_ASKED = {
    "energies": ("energy",),
    "solver": ("solver", "contacts"),
    "joints": ("joints",),
    "springs": ("springs",),
}
_GROUP_OF = {"energies": "energy"}
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
    def needs_contacts(self) -> bool:
        """Whether contacts are looked at, also for the forces that they put on a body."""
        return self.contacts or any(some.field == "contact_force" for some in self.quantities)

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
        record_contacts=wanted.needs_contacts,
    )
    with StopRequest() as stop:
        ending = loop.run_to_its_end(stop, model.body_names)
    if ending.status == "interrupted":
        raise Interrupted(ending.detail)
    impacts = Measure.events(simulated.world) if wanted.events else {}
    return _watched(model, memory, wanted, ending, impacts)


def _frames(schedule: Schedule, wanted: Wanted) -> Schedule:
    """Fewer frames where they decide nothing; a run that may end at rest is looked at in all of them."""
    if not wanted.ends_only or schedule.until_rest:
        return schedule
    return replace(schedule, steps_per_frame=schedule.steps)


class Watch:
    """Measures, of every frame, what is wanted and nothing else."""

    def __init__(self, model: Model, wanted: Wanted) -> None:
        self._measure = Measure(model)
        self._groups = wanted.groups
        self._fields = wanted.body_fields
        rows = [row for row, name in enumerate(model.body_names) if name in wanted.body_names]
        self._rows = np.array(rows, np.intp)
        self._asked = [group for group in _ASKED if self._groups & set(_ASKED[group])]
        self._forces = any(some.field == "contact_force" for some in wanted.quantities)

    def frame(self, world: Any) -> Rows:
        """Rows by dataset path, and what the engine hands out as a whole under the name that it has there. Of
        bodies only those that are watched, at their centres of mass.
        """
        rows: Rows = {group: getattr(world, group)() for group in self._asked}
        if self._fields:
            state = world.state()
            rows |= {name: state[name][self._rows] for name in self._fields}
        if "momentum" in self._groups:
            rows |= self._measure.momentum(world)
        return rows

    def contacts(self, world: Any) -> Rows:
        """The contact points of the last step: who touches whom, and the rest when forces are wanted."""
        if self._forces:
            return self._measure.contacts(world)
        found = world.contacts()
        return {"contacts/body_a": found["body_a"], "contacts/body_b": found["body_b"]}

    @staticmethod
    def events(world: Any) -> Rows:
        """None while the run goes on: the engine keeps them, and is asked for all of them at the end."""
        return {}


class Memory:
    """Keeps rows as they come; there is nothing to be saved."""

    block_is_full = False
    checkpoint_is_due = False

    def __init__(self) -> None:
        self.time: list[float] = []
        self.rows: list[Rows] = []
        self.contacts: list[Rows] = []

    @property
    def frames(self) -> int:
        return len(self.time)

    def append(self, step: int, frame_time: float, frame: Rows, contacts: Rows | None = None) -> None:
        self.time.append(frame_time)
        self.rows.append(frame)
        if contacts is not None:
            self.contacts.append(contacts)

    def append_events(self, events: Rows) -> None:
        """Nothing comes before the end, see `Watch.events`."""

    def write_block(self) -> None:
        """No file, no block."""

    def write_checkpoint(self, engine: bytes, step: int) -> None:
        """No file, no checkpoint."""


def _watched(model: Model, memory: Memory, wanted: Wanted, ending: Ending, impacts: Rows) -> Watched:
    return Watched(
        time=np.array(memory.time),
        status=ending.status,
        status_detail=ending.detail,
        names=tuple(name for name in model.body_names if name in wanted.body_names),
        model=model,
        columns=_columns(memory.rows),
        touching=memory.contacts,
        impacts=impacts,
    )


def _columns(rows: list[Rows]) -> Rows:
    """Rows frame by frame -> columns over time by dataset path."""
    columns: Rows = {}
    for path, first in rows[0].items():
        if isinstance(first, dict):
            group = _GROUP_OF.get(path, path)
            columns |= {f"{group}/{name}": np.array([row[path][name] for row in rows]) for name in first}
        else:
            columns[path] = np.array([row[path] for row in rows])
    return columns
