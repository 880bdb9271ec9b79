"""Joints between two bodies, or a body and the world; anchors and axes in the world frame at the start.

A is the first body of `between`, B the second. Coordinates are those of B seen from A, 0 as placed, along or
about an axis that moves with A.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.drives import AngleDrive, DriveSpec, TravelDrive, TurningJointDamping
from physsim.scene.spec.materials import Restitution
from physsim.scene.spec.names import BodyPair, ItemName
from physsim.scene.spec.schema_rules import ALL_DIFFERENT, all_of, not_together, only_with
from physsim.scene.spec.values import (
    NonZero,
    Number,
    PlainNumber,
    Position,
    Size,
    Switch,
    UnitVector,
)

_ANCHOR = "Where the bodies are joined, in the world frame at the start [m]."
_AXIS = "Axis in world axes at the start, not zero; moves with the first body."
_DAMPING = "Torque per relative angular speed against all turning [N m s/rad], at least 0."
BreakForce = Annotated[float, Number(kinds.FORCE, above=0)]
BreakTorque = Annotated[float, Number(kinds.TORQUE, above=0)]


class JointBase(Spec):
    """What joints between two bodies have."""

    between: BodyPair = Field(description="Names of the two bodies; `world` is one, and is fixed.")
    collide: Switch = Field(default=False, description="Whether the two bodies collide with each other.")
    break_force: BreakForce | None = Field(
        default=None,
        description="Reaction force at which the joint breaks for good [N], greater than 0; never when left "
        "out.",
    )


class TurningJoint(JointBase):
    """What joints have that hold an orientation too."""

    break_torque: BreakTorque | None = Field(
        default=None,
        description="Reaction torque at which the joint breaks for good [N m], greater than 0; never when "
        "left out.",
    )
    anchor: Position = Field(description=_ANCHOR)


class DistanceJoint(JointBase):
    """Keeps two points at one distance (a rod), or between two distances (a rope, a strut)."""

    model_config = ConfigDict(json_schema_extra=all_of(*not_together(("length", "limits"))))
    type: Literal["distance"]
    anchors: tuple[Position, Position] = Field(
        default=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        description="The two points, each in its body's own frame [m].",
    )
    length: Size | None = Field(
        default=None,
        description="The distance [m], greater than 0; the distance as placed when neither it nor limits is "
        "given.",
    )
    limits: tuple[Annotated[float, Number(kinds.LENGTH, at_least=0)], Size] | None = Field(
        default=None,
        description="Shortest and longest distance [m], in place of length; [0, L] is a rope.",
        examples=[[0, "2 m"]],
    )
    restitution: Restitution = Field(
        default=0.0, description="Coefficient of restitution of the limits, 0 to 1."
    )


class BallJoint(JointBase):
    """Keeps two points together; turning is free."""

    type: Literal["ball"]
    anchor: Position = Field(description=_ANCHOR)
    damping: TurningJointDamping = Field(default=0.0, description=_DAMPING)


class ConeJoint(TurningJoint):
    """A ball joint whose axis stays within a cone about where it stood."""

    type: Literal["cone"]
    axis: UnitVector = Field(description="Axis of the cone in world axes at the start, not zero.")
    max_angle: Annotated[float, Number(kinds.ANGLE, above=0, at_most=math.pi)] = Field(
        description="Half opening angle of the cone [rad], greater than 0, at most pi.", examples=["30 deg"]
    )
    restitution: Restitution = Field(
        default=0.0, description="Coefficient of restitution where the cone ends, 0 to 1."
    )
    damping: TurningJointDamping = Field(default=0.0, description=_DAMPING)


class FixedJoint(TurningJoint):
    """Holds two bodies as they were placed."""

    type: Literal["fixed"]


class AxisJoint(TurningJoint):
    """What joints have that leave motion about or along one axis."""

    axis: UnitVector = Field(description=_AXIS)


class HingeJoint(AngleDrive, AxisJoint):
    """Leaves one rotation, about an axis through the anchor; the angle is 0 as placed."""

    type: Literal["hinge"]


class SliderJoint(TravelDrive, AxisJoint):
    """Leaves one translation, along an axis; the travel is 0 as placed."""

    type: Literal["slider"]


class ScrewJoint(AngleDrive, AxisJoint):
    """Leaves turning about an axis, which advances along it; the angle is 0 as placed."""

    type: Literal["screw"]
    pitch: Annotated[float, Number(kinds.LENGTH), NonZero()] = Field(
        description="Advance of the second body per whole turn [m], not 0; negative for a left-hand thread.",
        examples=["2 mm"],
    )


class CylindricalJoint(AxisJoint):
    """Leaves turning about an axis and sliding along it, each by itself; travel and angle are 0 as placed."""

    type: Literal["cylindrical"]
    travel: TravelDrive | None = Field(default=None, description="What acts along the axis.")
    angle: AngleDrive | None = Field(default=None, description="What acts about the axis.")


class UniversalJoint(TurningJoint):
    """Two axes that stay perpendicular and meet in the anchor (Cardan); both angles are 0 as placed."""

    type: Literal["universal"]
    axes: tuple[UnitVector, UnitVector] = Field(
        description="The axis fixed to the first body and the one fixed to the second, in world axes at the "
        "start; perpendicular.",
        examples=[[[1, 0, 0], [0, 1, 0]]],
    )
    angle_1: AngleDrive | None = Field(default=None, description="What acts about the first axis.")
    angle_2: AngleDrive | None = Field(default=None, description="What acts about the second axis.")


class PlanarJoint(TurningJoint):
    """Leaves sliding in a plane and turning about its normal; x, y and angle are 0 as placed."""

    model_config = ConfigDict(json_schema_extra=only_with(x="axis", y="axis"))
    type: Literal["planar"]
    normal: UnitVector = Field(
        description="Normal of the plane in world axes at the start, not zero; moves with the first body."
    )
    axis: UnitVector | None = Field(
        default=None, description="Direction of x, in the plane; any when left out. y = normal x axis."
    )
    x: TravelDrive | None = Field(default=None, description="What acts along x.")
    y: TravelDrive | None = Field(default=None, description="What acts along y.")
    angle: AngleDrive | None = Field(default=None, description="What acts about the normal.")


class GearJoint(Spec):
    """Couples the angles of two joints: angle_2 = ratio * angle_1, both 0 as placed."""

    type: Literal["gear"]
    joints: tuple[ItemName, ItemName] = Field(
        description="Names of two joints, each a hinge, a screw or cylindrical.",
        examples=[["axle_1", "axle_2"]],
        json_schema_extra=ALL_DIFFERENT,
    )
    ratio: Annotated[PlainNumber, NonZero()] = Field(
        description="Angle of the second joint over angle of the first, not 0; negative turns the other way."
    )
    break_torque: BreakTorque | None = Field(
        default=None,
        description="Torque about the first axis at which the gear breaks for good [N m], greater than 0; "
        "never when left out.",
    )


JointSpec = Annotated[
    DistanceJoint
    | BallJoint
    | HingeJoint
    | SliderJoint
    | FixedJoint
    | ConeJoint
    | UniversalJoint
    | CylindricalJoint
    | PlanarJoint
    | ScrewJoint
    | GearJoint,
    Field(discriminator="type"),
]

COORDINATES: dict[str, tuple[str, ...]] = {
    "distance": ("length",),
    "hinge": ("angle",),
    "slider": ("travel",),
    "screw": ("angle",),
    "cylindrical": ("travel", "angle"),
    "universal": ("angle_1", "angle_2"),
    "planar": ("x", "y", "angle"),
}
"""The coordinates of each type of joint, in the order of coordinate, coordinate_2, coordinate_3."""


def is_angle(coordinate: str) -> bool:
    """Whether a coordinate of that name is an angle [rad], not a length [m]."""
    return coordinate.startswith("angle")


def drives_of(joint: JointSpec) -> Iterator[tuple[int, tuple[str, ...], DriveSpec]]:
    """(number of the coordinate, path below the joint, what acts along it), for all that are given."""
    if isinstance(joint, DriveSpec):
        yield 0, (), joint
    elif isinstance(joint, CylindricalJoint | UniversalJoint | PlanarJoint):
        for i, name in enumerate(COORDINATES[joint.type]):
            drive = getattr(joint, name)
            if drive is not None:
                yield i, (name,), drive
