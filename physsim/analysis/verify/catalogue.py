"""All formulas in the order of the sheet, and how cases are picked by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fnmatch import fnmatchcase

from physsim.analysis.verify.case import Formula
from physsim.analysis.verify.sections import (
    beyond_forces,
    beyond_joints,
    constraints,
    friction,
    impact,
    inertia,
    integration,
    kinematics,
    rigid_body,
    springs,
)

SECTIONS = {
    1: "Kinematics and Newton's laws",
    2: "Impulse and collision response",
    3: "Friction and contact forces",
    4: "Spring-damper systems",
    5: "Rigid body dynamics",
    6: "Inertia tensors",
    7: "Numerical integration",
    8: "Constraint forces and joints",
    9: "Beyond the sheet",
}
FORMULAS: tuple[Formula, ...] = (
    *kinematics.SECTION,
    *impact.SECTION,
    *friction.SECTION,
    *springs.SECTION,
    *rigid_body.SECTION,
    *inertia.SECTION,
    *integration.SECTION,
    *constraints.SECTION,
    *beyond_forces.SECTION,
    *beyond_joints.SECTION,
)


def pick(patterns: Sequence[str]) -> list[Formula]:
    """The formulas with those of their cases that a pattern names; all without patterns.

    A pattern is the name of a formula, of a case, or either with `*` in it. Raises KeyError with the first
    pattern that names nothing.
    """
    for pattern in patterns:
        if not any(_named(pattern, formula, case.name) for formula in FORMULAS for case in formula.cases):
            raise KeyError(pattern)
    if not patterns:
        return list(FORMULAS)
    picked = [
        replace(
            formula,
            cases=tuple(
                case for case in formula.cases if any(_named(p, formula, case.name) for p in patterns)
            ),
        )
        for formula in FORMULAS
    ]
    return [formula for formula in picked if formula.cases]


def _named(pattern: str, formula: Formula, case: str) -> bool:
    return fnmatchcase(formula.name, pattern) or fnmatchcase(case, pattern)
