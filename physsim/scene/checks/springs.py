"""Springs: bodies that exist, something that acts, one way to give each thing, curves that rise."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.between import check_between, check_limits, check_rising
from physsim.scene.draft import Draft
from physsim.scene.spec.springs import LinearSpring, SpringSpec

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `springs`."""
    for name, spring in draft.springs.items():
        if spring is not None:
            yield from _spring(("springs", name), spring, draft)


def _spring(path: Path, spring: SpringSpec, draft: Draft) -> Iterator[Problem]:
    curve = "force_curve" if isinstance(spring, LinearSpring) else "torque_curve"
    yield from check_between(path, spring.between, draft)
    yield from _something_acts(path, spring, curve)
    yield from _stiffness(path, spring, curve)
    yield from _damping(path, spring, curve)
    yield from check_rising((*path, curve), getattr(spring, curve))
    yield from check_rising((*path, "damping_curve"), spring.damping_curve)
    if isinstance(spring, LinearSpring):
        yield from check_limits(path, spring.limits, spring.restitution)


def _something_acts(path: Path, spring: SpringSpec, curve: str) -> Iterator[Problem]:
    acting = ["stiffness", curve, "damping", "damping_ratio", "damping_curve", "preload", "limits"]
    if not any(getattr(spring, key, None) for key in acting):
        yield Problem(path, "does nothing: give stiffness, damping, or a curve")


def _stiffness(path: Path, spring: SpringSpec, curve: str) -> Iterator[Problem]:
    if spring.stiffness > 0 and getattr(spring, curve) is not None:
        yield Problem((*path, curve), "cannot be given together with stiffness")


def _damping(path: Path, spring: SpringSpec, curve: str) -> Iterator[Problem]:
    given = [key for key in ("damping", "damping_ratio", "damping_curve") if getattr(spring, key) is not None]
    for key in given[1:]:
        yield Problem((*path, key), f"cannot be given together with {given[0]}")
    if given != ["damping_ratio"]:
        return
    if getattr(spring, curve) is not None:
        yield Problem(
            (*path, "damping_ratio"), f"cannot be given together with {curve}: it needs one stiffness"
        )
    elif spring.damping_ratio and spring.stiffness == 0:
        yield Problem((*path, "damping_ratio"), "needs stiffness: it is a share of critical damping")
