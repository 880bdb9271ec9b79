"""What acts along a free coordinate of a joint: limits, dry friction, damping, a spring, a motor.

A coordinate is the angle or the travel of the second body seen from the first, 0 as placed; angles are
counted through whole turns.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import ConfigDict, Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.materials import Restitution
from physsim.scene.spec.profiles import ProfileSpec
from physsim.scene.spec.schema_rules import SOMETHING, none_of
from physsim.scene.spec.values import (
    Angle,
    AngularSpeed,
    Length,
    Number,
    Speed,
    Stiffness,
    TurningStiffness,
)

LargestTorque = Annotated[float, Number(kinds.TORQUE, at_least=0)]
LargestForce = Annotated[float, Number(kinds.FORCE, at_least=0)]
JointDamping = Annotated[float, Number(kinds.DAMPING, at_least=0)]
TurningJointDamping = Annotated[float, Number(kinds.TURNING_DAMPING, at_least=0)]
_BOUNCE = "Coefficient of restitution of the limits, 0 to 1."
_PROFILE = "Factor of the speed, or of the target, over time from the start of the run; 1 when left out."


class AngleMotor(Spec):
    """A motor that drives to a speed with a bounded torque, or a servo that drives to an angle.

    Torque of the servo: stiffness (target - angle) + damping (d(target)/dt - d(angle)/dt), bounded.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {"required": ["speed", "max_torque"], **none_of("angle", "stiffness", "damping")},
                {"required": ["angle", "stiffness"], **none_of("speed")},
            ]
        }
    )
    speed: AngularSpeed | None = Field(
        default=None,
        description="Speed of the second body about the axis, seen from the first [rad/s]; with max_torque.",
        examples=["60 rpm"],
    )
    angle: Angle | None = Field(default=None, description="Target of a servo [rad]; with stiffness.")
    stiffness: TurningStiffness | None = Field(
        default=None, description="Stiffness of the servo [N m/rad], at least 0."
    )
    damping: TurningJointDamping | None = Field(
        default=None, description="Damping of the servo [N m s/rad], at least 0; 0 when left out."
    )
    max_torque: LargestTorque | None = Field(
        default=None,
        description="Largest torque of the motor [N m], at least 0; a servo without one has no bound.",
    )
    profile: ProfileSpec | None = Field(default=None, description=_PROFILE)


class TravelMotor(Spec):
    """A motor that drives to a speed with a bounded force, or a servo that drives to a travel.

    Force of the servo: stiffness (target - travel) + damping (d(target)/dt - d(travel)/dt), bounded.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {"required": ["speed", "max_force"], **none_of("travel", "stiffness", "damping")},
                {"required": ["travel", "stiffness"], **none_of("speed")},
            ]
        }
    )
    speed: Speed | None = Field(
        default=None,
        description="Speed of the second body along the axis, seen from the first [m/s]; with max_force.",
    )
    travel: Length | None = Field(default=None, description="Target of a servo [m]; with stiffness.")
    stiffness: Stiffness | None = Field(default=None, description="Stiffness of the servo [N/m], at least 0.")
    damping: JointDamping | None = Field(
        default=None, description="Damping of the servo [N s/m], at least 0; 0 when left out."
    )
    max_force: LargestForce | None = Field(
        default=None,
        description="Largest force of the motor [N], at least 0; a servo without one has no bound.",
    )
    profile: ProfileSpec | None = Field(default=None, description=_PROFILE)


class AngleReturn(Spec):
    """A spring that turns back to an angle."""

    stiffness: TurningStiffness = Field(description="Stiffness [N m/rad], at least 0.")
    rest: Angle = Field(default=0.0, description="Angle without torque [rad].")


class TravelReturn(Spec):
    """A spring that pushes back to a travel."""

    stiffness: Stiffness = Field(description="Stiffness [N/m], at least 0.")
    rest: Length = Field(default=0.0, description="Travel without force [m].")


class AngleDrive(Spec):
    """What acts about a free axis."""

    model_config = ConfigDict(json_schema_extra=SOMETHING)
    limits: tuple[Angle, Angle] | None = Field(
        default=None,
        description="Lowest and highest angle [rad], around 0; free when left out.",
        examples=[["-90 deg", "45 deg"]],
    )
    restitution: Restitution = Field(default=0.0, description=_BOUNCE)
    friction: LargestTorque = Field(
        default=0.0, description="Dry friction: torque against the turning [N m], at least 0."
    )
    damping: TurningJointDamping = Field(
        default=0.0, description="Torque per angular speed against the turning [N m s/rad], at least 0."
    )
    spring: AngleReturn | None = Field(default=None, description="A spring back to an angle.")
    motor: AngleMotor | None = Field(default=None, description="A motor about the axis.")


class TravelDrive(Spec):
    """What acts along a free axis."""

    model_config = ConfigDict(json_schema_extra=SOMETHING)
    limits: tuple[Length, Length] | None = Field(
        default=None,
        description="Lowest and highest travel [m], around 0; free when left out.",
        examples=[["-10 cm", "10 cm"]],
    )
    restitution: Restitution = Field(default=0.0, description=_BOUNCE)
    friction: LargestForce = Field(
        default=0.0, description="Dry friction: force against the sliding [N], at least 0."
    )
    damping: JointDamping = Field(
        default=0.0, description="Force per speed against the sliding [N s/m], at least 0."
    )
    spring: TravelReturn | None = Field(default=None, description="A spring back to a travel.")
    motor: TravelMotor | None = Field(default=None, description="A motor along the axis.")


DriveSpec = AngleDrive | TravelDrive
