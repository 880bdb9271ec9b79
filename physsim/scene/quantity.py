"""Names of what a trajectory holds: `bodies.crate.position.z`, `energy.total`, `contacts.count`, `time`.

    time                                            simulated time [s]
    bodies.NAME.position | velocity | angular_velocity [.x | .y | .z]
    bodies.NAME.orientation [.w | .x | .y | .z]     unit quaternion
    bodies.NAME.speed | angular_speed               length of velocity, of angular_velocity
    bodies.NAME.kinetic_energy                      of translation and rotation
    bodies.NAME.momentum [.x | .y | .z]             mass times velocity
    bodies.NAME.angular_momentum [.x | .y | .z]     about the body's own centre of mass
    bodies.NAME.contact_force [.x | .y | .z]        sum of the contact forces on it in the last step
    springs.NAME.length | force                     of a linear spring; positive force pulls the ends together
    springs.NAME.angle | torque                     of a torsional spring; positive torque turns it back
    joints.NAME.force | torque [.x | .y | .z]       reaction on the first body, torque about the anchor
    joints.NAME.reaction                            length of the force
    joints.NAME.coordinate | coordinate_2 | coordinate_3    angles and travels of the second body
    joints.NAME.violation | angular_violation       how far the joint is from its constraints [m], [rad]
    energy.TERM                                     a term of the ledger, kinetic (sum), total (of the state)
    momentum.linear | angular [.x | .y | .z]        of the whole scene
    contacts.count                                  contact points
    solver.residual | iterations                    of the last step
    solver.fallbacks                                steps so far in which located impacts fell back to stepped

NAME may hold dots and brackets (`bodies.brick[0,0,3].position.z`): what follows it is known, so it is read
from the right. Only names and dimensions are known here; values are for those who read trajectories. Whether
a joint's coordinate is an angle or a length says the scene.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from physsim.scene.spec import kinds
from physsim.scene.spec.joints import COORDINATES, is_angle
from physsim.scene.spec.kinds import Kind
from physsim.scene.suggest import did_you_mean

Group = Literal["time", "bodies", "springs", "joints", "energy", "momentum", "contacts", "solver"]
Described = tuple[Kind, tuple[str, ...]]
_XYZ, _WXYZ = ("x", "y", "z"), ("w", "x", "y", "z")

ENERGY_TERMS = (
    "kinetic_translational",
    "kinetic_rotational",
    "gravitational",
    "gravitation",
    "spring",
    "work_forces",
    "work_motors",
    "lost_damping",
    "lost_friction",
    "lost_impact",
    "stabilization",
    "residual",
    "kinetic",
    "total",
)
COORDINATE_FIELDS = ("coordinate", "coordinate_2", "coordinate_3")
NAMED_FIELDS: dict[str, dict[str, Described]] = {
    "bodies": {
        "position": (kinds.LENGTH, _XYZ),
        "orientation": (kinds.NUMBER, _WXYZ),
        "velocity": (kinds.SPEED, _XYZ),
        "angular_velocity": (kinds.ANGULAR_SPEED, _XYZ),
        "speed": (kinds.SPEED, ()),
        "angular_speed": (kinds.ANGULAR_SPEED, ()),
        "kinetic_energy": (kinds.ENERGY, ()),
        "momentum": (kinds.LINEAR_MOMENTUM, _XYZ),
        "angular_momentum": (kinds.ANGULAR_MOMENTUM, _XYZ),
        "contact_force": (kinds.FORCE, _XYZ),
    },
    "springs": {
        "length": (kinds.LENGTH, ()),
        "force": (kinds.FORCE, ()),
        "angle": (kinds.ANGLE, ()),
        "torque": (kinds.TORQUE, ()),
    },
    "joints": {
        "force": (kinds.FORCE, _XYZ),
        "torque": (kinds.TORQUE, _XYZ),
        "reaction": (kinds.FORCE, ()),
        **dict.fromkeys(COORDINATE_FIELDS, (kinds.COORDINATE, ())),
        "violation": (kinds.LENGTH, ()),
        "angular_violation": (kinds.ANGLE, ()),
    },
}
SCENE_FIELDS: dict[str, dict[str, Described]] = {
    "energy": dict.fromkeys(ENERGY_TERMS, (kinds.ENERGY, ())),
    "momentum": {"linear": (kinds.LINEAR_MOMENTUM, _XYZ), "angular": (kinds.ANGULAR_MOMENTUM, _XYZ)},
    "contacts": {"count": (kinds.NUMBER, ())},
    "solver": {
        "residual": (kinds.SPEED, ()),
        "iterations": (kinds.NUMBER, ()),
        "fallbacks": (kinds.NUMBER, ()),
    },
}
_OWNER = {"bodies": "a body", "springs": "a spring", "joints": "a joint"}
_PATTERNS = {
    group: re.compile(rf"(?P<name>.+)\.(?P<field>{'|'.join(fields)})(?:\.(?P<component>[^.]*))?\Z", re.DOTALL)
    for group, fields in NAMED_FIELDS.items()
}


class QuantityError(ValueError):
    """The text names nothing that a trajectory holds; told with the likely slip and what may stand there."""

    def __init__(self, message: str, hint: str | None = None, allowed: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint
        self.allowed = allowed


@dataclass(frozen=True)
class Quantity:
    """One quantity of a trajectory.

    group: the part of the trajectory; field: the name in it (`time` for time).
    name: of the body, the spring or the joint; None elsewhere. component: x, y, z (or w), None for scalars
    and whole vectors.
    components: those the field has, empty for a scalar. kind: what it measures, with the SI unit.
    """

    text: str
    group: Group
    field: str
    kind: Kind
    components: tuple[str, ...] = ()
    name: str | None = None
    component: str | None = None

    @property
    def is_scalar(self) -> bool:
        """One number per frame, not a vector."""
        return not self.components or self.component is not None

    @property
    def index(self) -> int | None:
        """Position of the component in its vector."""
        return self.components.index(self.component) if self.component is not None else None


def parse_quantity(text: str, joint_types: Mapping[str, str] | None = None) -> Quantity:
    """Read the name of a quantity. Raises QuantityError.

    joint_types: type of each joint by name, from which follows whether its coordinates are angles or lengths;
    without it their kind is `kinds.COORDINATE`, which is either.
    """
    group, _, rest = text.partition(".")
    if text == "time":
        return Quantity(text, "time", "time", kinds.TIME)
    if group in NAMED_FIELDS:
        return _of_named(text, group, rest, joint_types or {})
    if group in SCENE_FIELDS:
        return _of_scene(text, group, rest)
    known = ["time", *NAMED_FIELDS, *SCENE_FIELDS]
    raise QuantityError(
        "names no quantity", did_you_mean(group, known), f"one that begins with {', '.join(known)}"
    )


def _of_named(text: str, group: str, rest: str, joint_types: Mapping[str, str]) -> Quantity:
    known = NAMED_FIELDS[group]
    match = _PATTERNS[group].match(rest)
    if not match:
        name, _, field = rest.rpartition(".")
        hint = did_you_mean(field, known) if name else None
        allowed = f"{group}.NAME.({' | '.join(known)})"
        raise QuantityError(f"names no quantity of {_OWNER[group]}", hint, allowed)
    kind, components = known[match["field"]]
    if kind is kinds.COORDINATE:
        kind = _coordinate_kind(joint_types.get(match["name"]), match["field"])
    component = _component(match["component"], match["field"], components)
    return Quantity(text, group, match["field"], kind, components, match["name"], component)  # type: ignore[arg-type]


def _coordinate_kind(joint_type: str | None, field: str) -> Kind:
    """An angle or a length; either when the joint is not known or has no such coordinate."""
    coordinates = COORDINATES.get(joint_type or "", ())
    i = COORDINATE_FIELDS.index(field)
    if i >= len(coordinates):
        return kinds.COORDINATE
    return kinds.ANGLE if is_angle(coordinates[i]) else kinds.LENGTH


def _of_scene(text: str, group: str, rest: str) -> Quantity:
    field, dot, component = rest.partition(".")
    known = SCENE_FIELDS[group]
    if field not in known:
        raise QuantityError(
            f"names no quantity of {group}", did_you_mean(field, known), f"{group}.({' | '.join(known)})"
        )
    kind, components = known[field]
    chosen = _component(component if dot else None, field, components)
    return Quantity(text, group, field, kind, components, None, chosen)  # type: ignore[arg-type]


def _component(component: str | None, field: str, components: tuple[str, ...]) -> str | None:
    if component is None or component in components:
        return component
    if not components:
        raise QuantityError(f"names a part of {field}, which is a single number")
    raise QuantityError(f"names no component of {field}", allowed=", ".join(components))
