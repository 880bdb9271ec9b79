"""Forces, drag and uniform fields: from what was written to the numbers that the engine takes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from physsim.model.arrays import floats, wholes
from physsim.model.placement import Placement
from physsim.model.profiles import Profiles
from physsim.scene.patterns import matches

if TYPE_CHECKING:
    from physsim.scene.spec.forces import DragSpec, ForceSpec

Vector = tuple[float, ...]
ZERO: Vector = (0.0, 0.0, 0.0)
EVERYWHERE = ((-inf, -inf, -inf), (inf, inf, inf))


@dataclass(frozen=True)
class Schedule:
    """When something acts: from and until [s], and the number of the profile that multiplies it."""

    window: tuple[float, float]
    profile: int


@dataclass(frozen=True)
class Applied:
    """A force [N] and a torque [N m] on one body, in world or body axes.

    at: arm from the centre of mass, body axes [m].
    """

    body: int
    force: Vector
    torque: Vector
    at: Vector
    in_body_axes: bool
    schedule: Schedule


@dataclass(frozen=True)
class Drag:
    """Drag on one body: linear [N s/m], angular [N m s/rad], quadratic = rho C A / 2 [kg/m]."""

    body: int
    linear: float
    angular: float
    quadratic: float


@dataclass(frozen=True)
class Field:
    """A uniform acceleration [m/s^2] of one body, while its centre of mass is between two corners [m]."""

    body: int
    acceleration: Vector
    region: tuple[Vector, Vector]
    schedule: Schedule


@dataclass(frozen=True)
class ForceTable:
    """What acts on bodies, one row for each body."""

    applied: tuple[Applied, ...]
    drags: tuple[Drag, ...]
    fields: tuple[Field, ...]

    def engine_input(self) -> dict[str, object]:
        """All of it as plain arrays."""
        return {**self._applied(), **self._drags(), **self._fields()}

    def _applied(self) -> dict[str, object]:
        rows = self.applied
        return {
            "force_body": wholes([row.body for row in rows]),
            "force_force": floats([row.force for row in rows], 3),
            "force_torque": floats([row.torque for row in rows], 3),
            "force_at": floats([row.at for row in rows], 3),
            "force_frame": wholes([row.in_body_axes for row in rows]),
            "force_window": floats([row.schedule.window for row in rows], 2),
            "force_profile": wholes([row.schedule.profile for row in rows]),
        }

    def _drags(self) -> dict[str, object]:
        rows = self.drags
        return {
            "drag_body": wholes([row.body for row in rows]),
            "drag_linear": floats([row.linear for row in rows]),
            "drag_angular": floats([row.angular for row in rows]),
            "drag_quadratic": floats([row.quadratic for row in rows]),
        }

    def _fields(self) -> dict[str, object]:
        rows = self.fields
        return {
            "field_body": wholes([row.body for row in rows]),
            "field_acceleration": floats([row.acceleration for row in rows], 3),
            "field_region": floats([row.region for row in rows], 2, 3),
            "field_window": floats([row.schedule.window for row in rows], 2),
            "field_profile": wholes([row.schedule.profile for row in rows]),
        }


def force_table(specs: Mapping[str, ForceSpec], placement: Placement, profiles: Profiles) -> ForceTable:
    """Every force of the scene; patterns take the moving bodies that they fit."""
    applied: list[Applied] = []
    drags: list[Drag] = []
    fields: list[Field] = []
    for spec in specs.values():
        bodies = list(_moving(spec.body, placement))
        if spec.drag is not None:
            drags += [_drag(spec.drag, body) for body in bodies]
            continue
        schedule = schedule_of(spec.from_, spec.until, profiles.number(spec.profile))
        if spec.acceleration is not None:
            region = spec.region or EVERYWHERE
            fields += [Field(body, spec.acceleration, region, schedule) for body in bodies]
        else:
            applied.append(_applied(spec, placement, schedule))
    return ForceTable(tuple(applied), tuple(drags), tuple(fields))


def schedule_of(start: float, until: float | None, profile: int) -> Schedule:
    """A window in time [s], which never ends where `until` is None, and a profile."""
    return Schedule((start, inf if until is None else until), profile)


def _moving(pattern: str, placement: Placement) -> Iterator[int]:
    for number, name in enumerate(placement.names):
        if matches(pattern, name) and placement.moves(name):
            yield number


def _applied(spec: ForceSpec, placement: Placement, schedule: Schedule) -> Applied:
    body = placement[spec.body]
    return Applied(
        body=body.number,
        force=spec.force or ZERO,
        torque=spec.torque or ZERO,
        at=ZERO if spec.at is None else tuple(body.arm_of_own(spec.at).tolist()),
        in_body_axes=spec.frame == "body",
        schedule=schedule,
    )


def _drag(spec: DragSpec, body: int) -> Drag:
    """F = -c v - (1/2) rho C A |v| v (Rayleigh's drag equation; Batchelor, An Introduction to Fluid Dynamics,
    eq. 5.11.1, says what C stands for).
    """
    dynamic = 0.0
    if spec.density is not None and spec.area is not None and spec.coefficient is not None:
        dynamic = 0.5 * spec.density * spec.coefficient * spec.area
    return Drag(body, spec.linear, spec.angular, dynamic)
