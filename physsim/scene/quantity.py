"""Names of what a trajectory holds: `bodies.crate.position.z`, `energy.total`, `contacts.count`, `time`.

    time                                            simulated time [s]
    bodies.NAME.position | velocity | angular_velocity [.x | .y | .z]
    bodies.NAME.orientation [.w | .x | .y | .z]     unit quaternion
    bodies.NAME.speed | angular_speed               length of velocity, of angular_velocity
    energy.TERM                                     a term of the ledger, kinetic (sum), total (of the state)
    momentum.linear | angular [.x | .y | .z]        of the whole scene
    contacts.count                                  contact points
    solver.residual | iterations                    of the last step

NAME may hold dots and brackets (`bodies.brick[0,0,3].position.z`): what follows it is known, so it is read
from the right. Only names and dimensions are known here; values are for those who read trajectories.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from physsim.scene.spec import kinds
from physsim.scene.spec.kinds import Kind
from physsim.scene.suggest import did_you_mean

Group = Literal["time", "bodies", "energy", "momentum", "contacts", "solver"]
_XYZ, _WXYZ = ("x", "y", "z"), ("w", "x", "y", "z")

ENERGY_TERMS = (
    "kinetic_translational",
    "kinetic_rotational",
    "gravitational",
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
_BODY_FIELDS: dict[str, tuple[Kind, tuple[str, ...]]] = {
    "position": (kinds.LENGTH, _XYZ),
    "orientation": (kinds.NUMBER, _WXYZ),
    "velocity": (kinds.SPEED, _XYZ),
    "angular_velocity": (kinds.ANGULAR_SPEED, _XYZ),
    "speed": (kinds.SPEED, ()),
    "angular_speed": (kinds.ANGULAR_SPEED, ()),
}
_FIELDS: dict[str, dict[str, tuple[Kind, tuple[str, ...]]]] = {
    "energy": dict.fromkeys(ENERGY_TERMS, (kinds.ENERGY, ())),
    "momentum": {"linear": (kinds.LINEAR_MOMENTUM, _XYZ), "angular": (kinds.ANGULAR_MOMENTUM, _XYZ)},
    "contacts": {"count": (kinds.NUMBER, ())},
    "solver": {"residual": (kinds.SPEED, ()), "iterations": (kinds.NUMBER, ())},
}
_BODY = re.compile(
    r"(?P<body>.+)\.(?P<field>" + "|".join(_BODY_FIELDS) + r")(?:\.(?P<component>[^.]*))?\Z", re.DOTALL
)


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
    body: the body's name, None outside of bodies. component: x, y, z (or w), None for scalars and whole
    vectors.
    components: those the field has, empty for a scalar. kind: what it measures, with the SI unit.
    """

    text: str
    group: Group
    field: str
    kind: Kind
    components: tuple[str, ...] = ()
    body: str | None = None
    component: str | None = None

    @property
    def is_scalar(self) -> bool:
        """One number per frame, not a vector."""
        return not self.components or self.component is not None

    @property
    def index(self) -> int | None:
        """Position of the component in its vector."""
        return self.components.index(self.component) if self.component is not None else None


def parse_quantity(text: str) -> Quantity:
    """Read the name of a quantity. Raises QuantityError."""
    group, _, rest = text.partition(".")
    if text == "time":
        return Quantity(text, "time", "time", kinds.TIME)
    if group == "bodies":
        return _of_body(text, rest)
    if group in _FIELDS:
        return _of_scene(text, group, rest)
    known = ["time", "bodies", *_FIELDS]
    raise QuantityError(
        "names no quantity", did_you_mean(group, known), f"one that begins with {', '.join(known)}"
    )


def _of_body(text: str, rest: str) -> Quantity:
    match = _BODY.match(rest)
    if not match:
        body, _, field = rest.rpartition(".")
        hint = did_you_mean(field, _BODY_FIELDS) if body else None
        raise QuantityError("names no quantity of a body", hint, f"bodies.NAME.({' | '.join(_BODY_FIELDS)})")
    kind, components = _BODY_FIELDS[match["field"]]
    component = _component(match["component"], match["field"], components)
    return Quantity(text, "bodies", match["field"], kind, components, match["body"], component)


def _of_scene(text: str, group: str, rest: str) -> Quantity:
    field, dot, component = rest.partition(".")
    known = _FIELDS[group]
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
