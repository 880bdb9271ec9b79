"""Prescribed motion of fixed bodies: from what was written to the numbers that the engine takes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from physsim.model.arrays import floats, wholes
from physsim.model.forces import ZERO, Schedule, Vector, schedule_of
from physsim.model.placement import Placement
from physsim.model.profiles import Profiles

if TYPE_CHECKING:
    from physsim.scene.spec.bodies import BodySpec
    from physsim.scene.spec.motion import MotionSpec

POSITION, VELOCITY = 0, 1
"""Numbers of the border."""


@dataclass(frozen=True)
class Motion:
    """How one body is moved, world axes.

    kind POSITION: linear is a way [m], angular a rotation vector [rad]; kind VELOCITY: linear is a velocity
    of the body's origin [m/s], angular an angular velocity [rad/s]. center: the body's origin at the start
    [m].
    """

    body: int
    kind: int
    linear: Vector
    angular: Vector
    center: Vector
    schedule: Schedule


def motions(bodies: Mapping[str, BodySpec], placement: Placement, profiles: Profiles) -> tuple[Motion, ...]:
    """Of every body that has one, copies of repeated bodies included."""
    return tuple(
        _motion(name, body.motion, placement, profiles)
        for name, body in bodies.items()
        if body.motion is not None
    )


def engine_input(rows: tuple[Motion, ...]) -> dict[str, object]:
    """The motions as plain arrays."""
    return {
        "motion_body": wholes([row.body for row in rows]),
        "motion_kind": wholes([row.kind for row in rows]),
        "motion_linear": floats([row.linear for row in rows], 3),
        "motion_angular": floats([row.angular for row in rows], 3),
        "motion_center": floats([row.center for row in rows], 3),
        "motion_window": floats([row.schedule.window for row in rows], 2),
        "motion_profile": wholes([row.schedule.profile for row in rows]),
    }


def _motion(name: str, spec: MotionSpec, placement: Placement, profiles: Profiles) -> Motion:
    body = placement[name]
    linear, angular = spec.velocity, spec.angular_velocity
    if spec.is_position:
        turn = spec.rotation
        linear, angular = spec.translation, None if turn is None else _rotation_vector(turn.axis, turn.angle)
    return Motion(
        body=body.number,
        kind=POSITION if spec.is_position else VELOCITY,
        linear=linear or ZERO,
        angular=angular or ZERO,
        center=tuple(body.position.tolist()),
        schedule=schedule_of(spec.from_, spec.until, profiles.number(spec.profile)),
    )


def _rotation_vector(axis: tuple[float, ...], angle: float) -> tuple[float, float, float]:
    x, y, z = (float(part) for part in angle * np.array(axis))
    return x, y, z
