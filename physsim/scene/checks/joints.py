"""Joints: bodies that exist, axes that fit each other, limits in order, gears between joints that turn."""

from __future__ import annotations

import math
from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.between import check_between, check_limits
from physsim.scene.checks.drives import check_drive
from physsim.scene.draft import Draft
from physsim.scene.spec.joints import (
    DistanceJoint,
    GearJoint,
    JointSpec,
    PlanarJoint,
    UniversalJoint,
    drives_of,
)
from physsim.scene.suggest import did_you_mean

Path = tuple[PathPart, ...]
Vector = tuple[float, float, float]
GEARED = ("hinge", "screw", "cylindrical")
# Cosine of the angle between axes up to which they count as perpendicular: directions with six digits.
PERPENDICULAR = 1e-5


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `joints`."""
    for name, joint in draft.joints.items():
        if isinstance(joint, GearJoint):
            yield from _gear(("joints", name), joint, draft)
        elif joint is not None:
            yield from check_between(("joints", name), joint.between, draft)
            yield from _geometry(("joints", name), joint)
            for _, below, drive in drives_of(joint):
                yield from check_drive(("joints", name, *below), drive, draft)


def _geometry(path: Path, joint: JointSpec) -> Iterator[Problem]:
    if isinstance(joint, DistanceJoint):
        yield from _distance(path, joint)
    elif isinstance(joint, UniversalJoint):
        yield from _perpendicular((*path, "axes"), *joint.axes, "must be perpendicular to each other")
    elif isinstance(joint, PlanarJoint):
        yield from _plane(path, joint)


def _distance(path: Path, joint: DistanceJoint) -> Iterator[Problem]:
    if joint.length is not None and joint.limits is not None:
        yield Problem((*path, "limits"), "cannot be given together with length")
    yield from check_limits(path, joint.limits, joint.restitution)


def _plane(path: Path, joint: PlanarJoint) -> Iterator[Problem]:
    if joint.axis is not None:
        yield from _perpendicular((*path, "axis"), joint.axis, joint.normal, "must be in the plane")
        return
    for key in ("x", "y"):
        if getattr(joint, key) is not None:
            yield Problem((*path, key), "needs axis beside it: the direction of x")


def _perpendicular(path: Path, a: Vector, b: Vector, told: str) -> Iterator[Problem]:
    """Of two unit vectors."""
    cosine = math.fsum(x * y for x, y in zip(a, b, strict=True))
    if abs(cosine) > PERPENDICULAR:
        angle = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
        yield Problem(path, f"{told}: the angle is {angle:.4g} deg, not 90")


def _gear(path: Path, gear: GearJoint, draft: Draft) -> Iterator[Problem]:
    for i, name in enumerate(gear.joints):
        if name not in draft.joints:
            hint = did_you_mean(name, draft.joints)
            yield Problem((*path, "joints", i), f"there is no joint '{name}'", hint=hint)
            continue
        joint = draft.joints[name]
        if joint is not None and joint.type not in GEARED:
            yield Problem((*path, "joints", i), "does not turn about one axis", joint.type, ", ".join(GEARED))
    if gear.joints[0] == gear.joints[1]:
        yield Problem((*path, "joints"), "must be two different joints", f"{gear.joints[0]} twice")
