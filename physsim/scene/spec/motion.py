"""Prescribed motion of fixed bodies: they go where they are told, and contacts feel how fast."""

from __future__ import annotations

from pydantic import ConfigDict, Field

from physsim.scene.spec.base import Spec
from physsim.scene.spec.profiles import ProfileSpec
from physsim.scene.spec.schema_rules import any_of, none_of
from physsim.scene.spec.values import Angle, AngularSpeed, Position, Speed, Time, UnitVector


class RotationSpec(Spec):
    """A rotation about an axis through the body's own origin."""

    axis: UnitVector = Field(description="Axis in world axes, not zero.")
    angle: Angle = Field(description="Angle about it [rad], right-handed.", examples=["10 deg"])


class MotionSpec(Spec):
    """Either how far the body is from where it stood, or how fast it moves; both times the profile.

    Position: translation, rotation, or both; the profile is required. Velocity: velocity, angular_velocity,
    or both; without a profile they are constant. Before the start and after the end the body stands still;
    after the end it stays where it is.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {
                    **any_of("translation", "rotation"),
                    **none_of("velocity", "angular_velocity"),
                    "required": ["profile"],
                },
                {**any_of("velocity", "angular_velocity"), **none_of("translation", "rotation")},
            ]
        }
    )
    translation: Position | None = Field(
        default=None,
        description="Way from the place at the start, in world axes [m].",
        examples=[["5 cm", 0, 0]],
    )
    rotation: RotationSpec | None = Field(
        default=None, description="Rotation from the orientation at the start, about the body's origin."
    )
    velocity: tuple[Speed, Speed, Speed] | None = Field(
        default=None, description="Velocity of the body's origin, in world axes [m/s]."
    )
    angular_velocity: tuple[AngularSpeed, AngularSpeed, AngularSpeed] | None = Field(
        default=None,
        description="Angular velocity about the body's origin, in world axes [rad/s].",
        examples=[[0, 0, "30 rpm"]],
    )
    profile: ProfileSpec | None = Field(default=None, description="Factor that multiplies them over time.")
    from_: Time = Field(default=0.0, alias="from", description="Start [s], at least 0.")
    until: Time | None = Field(default=None, description="End [s], after the start; never when left out.")

    @property
    def is_position(self) -> bool:
        """Whether it prescribes a position, not a velocity."""
        return self.translation is not None or self.rotation is not None
