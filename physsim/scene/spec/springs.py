"""Springs and dampers between two bodies, or a body and the world."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.materials import Restitution
from physsim.scene.spec.names import BodyPair
from physsim.scene.spec.schema_rules import Schema, all_of, any_of, not_together
from physsim.scene.spec.values import (
    Angle,
    AngularSpeed,
    Force,
    Length,
    Number,
    Position,
    Speed,
    Stiffness,
    Torque,
    TurningStiffness,
    UnitVector,
)

MAX_SAMPLES = 100_000
DampingRatio = Annotated[float, Number(at_least=0, at_most=1000)]
Distance = Annotated[float, Number(kinds.LENGTH, at_least=0)]
Damping = Annotated[float, Number(kinds.DAMPING, at_least=0)]
TurningDamping = Annotated[float, Number(kinds.TURNING_DAMPING, at_least=0)]
_SAMPLES = Field(min_length=2, max_length=MAX_SAMPLES)
_BETWEEN = "Names of the two bodies; `world` is one, and is fixed."
_RATIO = (
    "Damping over critical damping 2 sqrt(k m), m of both ends along the spring, at least 0; in place of "
    "damping."
)
_LINES = "straight lines between, the last ones go on outside"


def _rules(curve: str, *acting: str) -> Schema:
    """Something acts, and damping is given in one way; a damping ratio needs one stiffness."""
    ways = (("damping", "damping_ratio"), ("damping", "damping_curve"), ("damping_ratio", "damping_curve"))
    return all_of(
        any_of("stiffness", curve, "damping", "damping_curve", "preload", *acting),
        *not_together(*ways, ("damping_ratio", curve)),
    )


class LinearSpring(Spec):
    """A spring and damper along the line between two points.

    Tension, which pulls the ends together: k (length - rest length) + c d(length)/dt + preload.
    """

    model_config = ConfigDict(json_schema_extra=_rules("force_curve", "limits"))
    type: Literal["linear"]
    between: BodyPair = Field(description=_BETWEEN)
    anchors: tuple[Position, Position] = Field(
        default=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        description="Where it is tied, each in its body's own frame [m].",
    )
    rest_length: Distance | None = Field(
        default=None, description="Length without force [m], at least 0; the length as placed when left out."
    )
    stiffness: Stiffness = Field(
        default=0.0,
        description="Stiffness k [N/m], at least 0; 0 for a damper alone.",
        examples=["100 N/m"],
    )
    damping: Damping | None = Field(
        default=None,
        description="Damping coefficient c [N s/m], at least 0; 0 when left out.",
        examples=["5 N*s/m"],
    )
    damping_ratio: DampingRatio | None = Field(default=None, description=_RATIO)
    preload: Force = Field(default=0.0, description="Tension that is added at every length [N].")
    acts: Literal["always", "tension", "compression"] = Field(
        default="always",
        description="When it acts: a rope only while longer than rest_length, never pushing (tension); a "
        "bumper only while shorter, never pulling (compression).",
    )
    force_curve: Annotated[tuple[tuple[Length, Force], ...], _SAMPLES] | None = Field(
        default=None,
        description=f"Pairs [stretch in m, tension in N], stretch rising, in place of stiffness; {_LINES}.",
        examples=[[[0, 0], ["1 cm", "2 N"], ["2 cm", "8 N"]]],
    )
    damping_curve: Annotated[tuple[tuple[Speed, Force], ...], _SAMPLES] | None = Field(
        default=None,
        description="Pairs [speed of lengthening in m/s, tension in N], speed rising, in place of damping; "
        f"{_LINES}.",
    )
    limits: tuple[Distance, Distance] | None = Field(
        default=None,
        description="Shortest and longest length [m], hard stops; none when left out.",
        examples=[["10 cm", "30 cm"]],
    )
    restitution: Restitution = Field(
        default=0.0, description="Coefficient of restitution of the hard stops, 0 to 1."
    )


class TorsionalSpring(Spec):
    """A spring and damper about an axis; its angle is that of the second body seen from the first.

    Torque that turns it back: k (angle - rest angle) + c d(angle)/dt + preload; the angle is 0 as placed.
    """

    model_config = ConfigDict(json_schema_extra=_rules("torque_curve"))
    type: Literal["torsional"]
    between: BodyPair = Field(description=_BETWEEN)
    axis: UnitVector = Field(
        description="Axis in world axes at the start, not zero; moves with the first body."
    )
    rest_angle: Angle = Field(
        default=0.0, description="Angle without torque [rad], counted from the angle as placed."
    )
    stiffness: TurningStiffness = Field(
        default=0.0,
        description="Stiffness k [N m/rad], at least 0; 0 for a damper alone.",
        examples=["3 N*m/rad"],
    )
    damping: TurningDamping | None = Field(
        default=None, description="Damping coefficient c [N m s/rad], at least 0; 0 when left out."
    )
    damping_ratio: DampingRatio | None = Field(
        default=None,
        description="Damping over critical damping 2 sqrt(k I), I of both ends about the axis, at least 0; "
        "in place of damping.",
    )
    preload: Torque = Field(default=0.0, description="Torque that is added at every angle [N m].")
    torque_curve: Annotated[tuple[tuple[Angle, Torque], ...], _SAMPLES] | None = Field(
        default=None,
        description="Pairs [angle from the rest angle in rad, torque in N m], angle rising, in place of "
        f"stiffness; {_LINES}.",
    )
    damping_curve: Annotated[tuple[tuple[AngularSpeed, Torque], ...], _SAMPLES] | None = Field(
        default=None,
        description="Pairs [angular speed in rad/s, torque in N m], speed rising, in place of damping; "
        f"{_LINES}.",
    )


SpringSpec = Annotated[LinearSpring | TorsionalSpring, Field(discriminator="type")]
