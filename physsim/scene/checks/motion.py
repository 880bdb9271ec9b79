"""Prescribed motion: of fixed bodies only, one way to give it, without jumps."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.profiles import check_profile, check_window, first_value
from physsim.scene.draft import Draft
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.motion import MotionSpec
from physsim.scene.spec.profiles import ProfileSpec, StepProfile

Path = tuple[PathPart, ...]
# Factor that counts as 0: what rounding makes of sin(pi n).
NOTHING = 1e-6


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `motion` and `surface_velocity` of bodies."""
    for name, body in draft.bodies.items():
        if body is not None:
            yield from _body(("bodies", name), body, draft)


def _body(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    if any(body.surface_velocity) and not body.collides:
        yield Problem((*path, "surface_velocity"), "does nothing: the body does not collide")
    if body.motion is None:
        return
    if not body.fixed:
        yield Problem((*path, "motion"), "is for fixed bodies only; add fixed: true")
    yield from _motion((*path, "motion"), body.motion, draft)


def _motion(path: Path, motion: MotionSpec, draft: Draft) -> Iterator[Problem]:
    yield from check_window(path, motion.from_, motion.until)
    yield from check_profile((*path, "profile"), motion.profile, draft, motion.from_)
    is_velocity = motion.velocity is not None or motion.angular_velocity is not None
    if is_velocity and motion.is_position:
        yield Problem(
            path, "needs translation and rotation, or velocity and angular_velocity, not of both kinds"
        )
    elif not is_velocity and not motion.is_position:
        yield Problem(path, "does nothing: give translation, rotation, velocity or angular_velocity")
    elif motion.is_position and motion.profile is None:
        yield Problem((*path, "profile"), "is required beside translation and rotation")
    elif motion.is_position and motion.profile is not None:
        yield from _jumps((*path, "profile"), motion.profile)


def _jumps(path: Path, profile: ProfileSpec) -> Iterator[Problem]:
    """Until its motion starts the body is where it stood: a profile of positions begins at 0."""
    if isinstance(profile, StepProfile):
        yield Problem((*path, "type"), "jumps, and a position must not", "step", "ramp")
    elif abs(first_value(profile)) > NOTHING:
        yield Problem(path, f"must begin at 0, or the body jumps; it begins at {first_value(profile):.6g}")
