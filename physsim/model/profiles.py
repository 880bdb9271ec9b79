"""Profiles over time as kinds and numbers; equal ones are kept once."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np

from physsim.model.arrays import wholes

if TYPE_CHECKING:
    from physsim.scene.spec.profiles import ProfileSpec

CONSTANT_ONE = -1
"""Number of the profile that is not there: its factor is 1."""

Row = tuple["ProfileKind", tuple[float, ...]]


class ProfileKind(IntEnum):
    """Numbers of the border; `engine/src/profile.rs` has the formulas."""

    SINE = 1
    RAMP = 2
    STEP = 3
    TABLE = 4
    EXPRESSION = 5


class Profiles:
    """The profiles of a scene, numbered in the order in which they are first used."""

    def __init__(self) -> None:
        self._numbers: dict[Row, int] = {}

    def number(self, spec: ProfileSpec | None) -> int:
        """The number of a profile; `CONSTANT_ONE` where there is none."""
        if spec is None:
            return CONSTANT_ONE
        return self._numbers.setdefault(_row(spec), len(self._numbers))

    def engine_input(self) -> dict[str, object]:
        """profile_kind (P,), and for each the numbers that its formula takes."""
        return {
            "profile_kind": wholes([kind for kind, _ in self._numbers]),
            "profile_data": [np.array(data, dtype=np.float64) for _, data in self._numbers],
        }


def _row(spec: ProfileSpec) -> Row:
    if spec.type == "sine":
        return ProfileKind.SINE, (spec.frequency, spec.phase)
    if spec.type == "ramp":
        return ProfileKind.RAMP, (spec.over,)
    if spec.type == "step":
        return ProfileKind.STEP, (spec.at,)
    if spec.type == "table":
        return ProfileKind.TABLE, tuple(number for sample in spec.samples for number in sample)
    return ProfileKind.EXPRESSION, spec.program
