"""What acts along a coordinate of a joint: limits around 0, motors that are either driven or servos."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.between import check_limits
from physsim.scene.checks.profiles import check_profile
from physsim.scene.draft import Draft
from physsim.scene.spec.drives import AngleDrive, AngleMotor, DriveSpec, TravelMotor

Path = tuple[PathPart, ...]


def check_drive(path: Path, drive: DriveSpec, draft: Draft) -> Iterator[Problem]:
    """Problems of what acts along one coordinate, given at that path."""
    if not drive.model_fields_set:
        yield Problem(path, "does nothing: give limits, friction, damping, spring or motor")
    yield from check_limits(path, drive.limits, drive.restitution)
    if drive.limits is not None and drive.limits[0] < drive.limits[1]:
        yield from _around_zero((*path, "limits"), drive)
    if drive.motor is not None:
        yield from _motor((*path, "motor"), drive.motor)
        yield from check_profile((*path, "motor", "profile"), drive.motor.profile, draft)


def _around_zero(path: Path, drive: DriveSpec) -> Iterator[Problem]:
    assert drive.limits is not None
    if not drive.limits[0] <= 0 <= drive.limits[1]:
        word = "angle" if isinstance(drive, AngleDrive) else "travel"
        yield Problem(path, f"must have 0 between them: the {word} is 0 as placed")


def _motor(path: Path, motor: AngleMotor | TravelMotor) -> Iterator[Problem]:
    target, most = ("angle", "max_torque") if isinstance(motor, AngleMotor) else ("travel", "max_force")
    is_servo = getattr(motor, target) is not None
    if is_servo == (motor.speed is not None):
        what = "not both" if is_servo else "none is given"
        yield Problem(path, f"needs exactly one of speed and {target}, {what}")
    elif is_servo and motor.stiffness is None:
        yield Problem((*path, "stiffness"), f"is required beside {target}")
    elif not is_servo:
        yield from _with_speed(path, motor, target, most)


def _with_speed(path: Path, motor: AngleMotor | TravelMotor, target: str, most: str) -> Iterator[Problem]:
    if getattr(motor, most) is None:
        yield Problem((*path, most), "is required beside speed")
    for key in ("stiffness", "damping"):
        if getattr(motor, key) is not None:
            yield Problem((*path, key), f"is for a servo: give {target} in place of speed")
