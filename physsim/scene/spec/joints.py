"""Joints between two bodies, or a body and the world; anchors and axes in the world frame at the start."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import BodyPair
from physsim.scene.spec.values import (
    Angle,
    AngularSpeed,
    Length,
    Number,
    Position,
    Size,
    Speed,
    Switch,
    UnitVector,
)

_ANCHOR = "Where the bodies are joined, in the world frame at the start [m]."


class JointBase(Spec):
    """What every joint has."""

    between: BodyPair = Field(description="Names of the two bodies; `world` is one, and is fixed.")
    collide: Switch = Field(default=False, description="Whether the two bodies collide with each other.")


class DistanceJoint(JointBase):
    """Keeps two points at one distance."""

    type: Literal["distance"]
    anchors: tuple[Position, Position] = Field(
        default=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        description="The two points, each in its body's own frame [m].",
    )
    length: Size | None = Field(
        default=None, description="The distance [m], greater than 0; the distance as placed when left out."
    )


class BallJoint(JointBase):
    """Keeps two points together; turning is free."""

    type: Literal["ball"]
    anchor: Position = Field(description=_ANCHOR)


class HingeMotor(Spec):
    """Drives a hinge to a speed with a bounded torque."""

    speed: AngularSpeed = Field(
        description="Speed of the second body about the axis, seen from the first [rad/s]."
    )
    max_torque: Annotated[float, Number(kinds.TORQUE, at_least=0)] = Field(
        description="Largest torque of the motor [N m], at least 0."
    )


class HingeJoint(JointBase):
    """Leaves one rotation, about an axis through the anchor; the angle is 0 as placed."""

    type: Literal["hinge"]
    anchor: Position = Field(description=_ANCHOR)
    axis: UnitVector = Field(description="Axis in world axes at the start, not zero.")
    limits: tuple[Angle, Angle] | None = Field(
        default=None,
        description="Lowest and highest angle [rad]; free when left out.",
        examples=[["-90 deg", "45 deg"]],
    )
    motor: HingeMotor | None = Field(default=None, description="A motor on the axis.")


class SliderMotor(Spec):
    """Drives a slider to a speed with a bounded force."""

    speed: Speed = Field(description="Speed of the second body along the axis, seen from the first [m/s].")
    max_force: Annotated[float, Number(kinds.FORCE, at_least=0)] = Field(
        description="Largest force of the motor [N], at least 0."
    )


class SliderJoint(JointBase):
    """Leaves one translation, along an axis; the travel is 0 as placed."""

    type: Literal["slider"]
    anchor: Position = Field(description=_ANCHOR)
    axis: UnitVector = Field(description="Axis in world axes at the start, not zero.")
    limits: tuple[Length, Length] | None = Field(
        default=None, description="Lowest and highest travel [m]; free when left out."
    )
    motor: SliderMotor | None = Field(default=None, description="A motor along the axis.")


class FixedJoint(JointBase):
    """Holds two bodies as they were placed."""

    type: Literal["fixed"]
    anchor: Position = Field(description=_ANCHOR)


class ConeJoint(JointBase):
    """A ball joint whose axis stays within a cone about where it stood."""

    type: Literal["cone"]
    anchor: Position = Field(description=_ANCHOR)
    axis: UnitVector = Field(description="Axis of the cone in world axes at the start, not zero.")
    max_angle: Annotated[float, Number(kinds.ANGLE, above=0, at_most=math.pi)] = Field(
        description="Half opening angle of the cone [rad], greater than 0, at most pi.", examples=["30 deg"]
    )


JointSpec = Annotated[
    DistanceJoint | BallJoint | HingeJoint | SliderJoint | FixedJoint | ConeJoint, Field(discriminator="type")
]
