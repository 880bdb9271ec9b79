"""Checks across a scene that need no geometry: functions of the draft that yield problems by path."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import Problem
from physsim.scene.checks import (
    bodies,
    expect,
    forces,
    joints,
    materials,
    motion,
    no_contact,
    springs,
    timing,
)
from physsim.scene.draft import Draft

ALL = (
    timing.check,
    materials.check,
    bodies.check,
    motion.check,
    springs.check,
    joints.check,
    forces.check,
    no_contact.check,
    expect.check,
)


def all_problems(draft: Draft) -> Iterator[Problem]:
    """Everything that is wrong between the parts of the scene."""
    for check in ALL:
        yield from check(draft)
