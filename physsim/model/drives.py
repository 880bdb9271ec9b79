"""What acts along the free coordinates of joints, as plain arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from math import inf
from typing import TYPE_CHECKING

from physsim.model.arrays import floats, wholes
from physsim.model.profiles import CONSTANT_ONE, Profiles

if TYPE_CHECKING:
    from physsim.scene.spec.drives import AngleMotor, DriveSpec, TravelMotor

FREE = (-inf, inf)


class MotorKind(IntEnum):
    """Numbers of the border."""

    NONE = 0
    SPEED = 1
    SERVO = 2


@dataclass(frozen=True)
class Motor:
    """numbers: [speed, largest force or torque, 0, 0] or [target, stiffness, damping, largest]; profile:
    number of the factor of speed or target.
    """

    kind: MotorKind = MotorKind.NONE
    numbers: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    profile: int = CONSTANT_ONE


@dataclass(frozen=True)
class Drive:
    """What acts along one coordinate of a joint: travel [m] and forces [N], or angle [rad] and torques [N m].

    joint: its row; coordinate: which of its coordinates; limits: lowest and highest, infinite where free;
    spring: stiffness and rest coordinate.
    """

    joint: int
    coordinate: int
    limits: tuple[float, float] = FREE
    restitution: float = 0.0
    friction: float = 0.0
    damping: float = 0.0
    spring: tuple[float, float] = (0.0, 0.0)
    motor: Motor = Motor()

    @property
    def does_something(self) -> bool:
        """Whether the engine needs to know of it."""
        forces = (self.friction, self.damping, self.spring[0], self.motor.kind)
        return self.limits != FREE or any(forces)

    @property
    def stiffness(self) -> float:
        """Of spring and servo together."""
        return self.spring[0] + (self.motor.numbers[1] if self.motor.kind is MotorKind.SERVO else 0.0)

    @property
    def viscosity(self) -> float:
        """Damping of the coordinate and of the servo together."""
        return self.damping + (self.motor.numbers[2] if self.motor.kind is MotorKind.SERVO else 0.0)


def drive(spec: DriveSpec, joint: int, coordinate: int, profiles: Profiles) -> Drive:
    """What a scene says of one coordinate."""
    return Drive(
        joint=joint,
        coordinate=coordinate,
        limits=FREE if spec.limits is None else spec.limits,
        restitution=spec.restitution,
        friction=spec.friction,
        damping=spec.damping,
        spring=(0.0, 0.0) if spec.spring is None else (spec.spring.stiffness, spec.spring.rest),
        motor=Motor() if spec.motor is None else _motor(spec.motor, profiles),
    )


def engine_input(rows: Sequence[Drive]) -> dict[str, object]:
    """The drives as plain arrays."""
    return {
        "drive_joint": wholes([row.joint for row in rows]),
        "drive_coordinate": wholes([row.coordinate for row in rows]),
        "drive_limits": floats([row.limits for row in rows], 2),
        "drive_restitution": floats([row.restitution for row in rows]),
        "drive_friction": floats([row.friction for row in rows]),
        "drive_damping": floats([row.damping for row in rows]),
        "drive_spring": floats([row.spring for row in rows], 2),
        "drive_motor_kind": wholes([row.motor.kind for row in rows]),
        "drive_motor": floats([row.motor.numbers for row in rows], 4),
        "drive_profile": wholes([row.motor.profile for row in rows]),
    }


def _motor(spec: AngleMotor | TravelMotor, profiles: Profiles) -> Motor:
    largest = _first(spec, "max_torque", "max_force", inf)
    profile = profiles.number(spec.profile)
    if spec.speed is not None:
        return Motor(MotorKind.SPEED, (spec.speed, largest, 0.0, 0.0), profile)
    target = _first(spec, "angle", "travel", 0.0)
    return Motor(MotorKind.SERVO, (target, spec.stiffness or 0.0, spec.damping or 0.0, largest), profile)


def _first(spec: object, turning: str, sliding: str, missing: float) -> float:
    """The value of the key, which is called one thing of angles and another of travels."""
    value = getattr(spec, turning, None)
    value = getattr(spec, sliding, None) if value is None else value
    return missing if value is None else float(value)
