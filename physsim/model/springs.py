"""Springs and dampers: from what was written to the numbers that the engine takes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from physsim.model import curves
from physsim.model.arrays import floats, wholes
from physsim.model.oscillation import Oscillation
from physsim.model.placement import Placed, Placement
from physsim.model.rotation import FloatArray
from physsim.model.tied import TiedTable

if TYPE_CHECKING:
    from physsim.scene.spec.springs import LinearSpring, SpringSpec, TorsionalSpring

NO_CURVE: FloatArray = np.zeros((0, 2))
COINCIDING = 1e-9
"""Metres between two points below which they have no direction."""


class SpringKind(IntEnum):
    """Numbers of the border."""

    LINEAR = 0
    TORSIONAL = 1


ACTS: Mapping[str, int] = {"always": 0, "tension": 1, "compression": 2}


@dataclass(frozen=True)
class Spring:
    """One spring.

    ends: the bodies A and B; anchors: two arms from the centres of mass, body axes [m], zero for torsional
    springs; axis: world axes at the start, a unit vector from anchor A to anchor B (linear) or the axis
    turned about (torsional); zero where the anchors coincide. placed: length [m] as placed, 0 for torsional
    ones. rest [m or rad], stiffness [N/m or N m/rad], damping [N s/m or N m s/rad], preload [N or N m], acts
    as in `ACTS`; the curves replace stiffness and damping, (n, 2) with n = 0 for none. mobility: 1/m_eff
    [1/kg] or 1/I_eff [1/(kg m^2)] of both ends along or about the axis.
    """

    kind: SpringKind
    ends: tuple[Placed, Placed]
    anchors: tuple[FloatArray, FloatArray]
    axis: FloatArray
    placed: float
    rest: float
    stiffness: float
    damping: float
    preload: float
    acts: int
    force_curve: FloatArray
    damping_curve: FloatArray
    mobility: float

    @property
    def oscillation(self) -> Oscillation:
        """With the mass at its ends, for small swings about rest: slopes stand for curves."""
        k = curves.slope_at_zero(self.force_curve) if len(self.force_curve) else self.stiffness
        c = curves.slope_at_zero(self.damping_curve) if len(self.damping_curve) else self.damping
        return Oscillation(k, c, self.mobility)

    @property
    def largest_stiffness(self) -> float:
        """k, or the steepest slope of the curve [N/m or N m/rad]."""
        return curves.steepest(self.force_curve) if len(self.force_curve) else self.stiffness

    @property
    def largest_damping(self) -> float:
        """c, or the steepest slope of the curve [N s/m or N m s/rad]."""
        return curves.steepest(self.damping_curve) if len(self.damping_curve) else self.damping


@dataclass(frozen=True)
class SpringTable(TiedTable):
    """The springs of a scene, in its order."""

    names: tuple[str, ...]
    types: tuple[str, ...]
    rows: tuple[Spring, ...]

    @property
    def axes(self) -> FloatArray:
        """(S, 3) unit vectors in A's own axes of torsional springs; NaN for linear ones."""
        return floats([_unit(_axes(row)[0]) for row in self.rows], 3)

    def engine_input(self) -> dict[str, object]:
        """The springs as plain arrays; anchors from the centres of mass."""
        rows = self.rows
        numbers = [(row.rest, row.stiffness, row.damping, row.preload, row.acts) for row in rows]
        return {
            "spring_kind": wholes([row.kind for row in rows]),
            "spring_bodies": self.bodies,
            "spring_anchors": floats([row.anchors for row in rows], 2, 3),
            "spring_axis": floats([_axes(row) for row in rows], 2, 3),
            "spring_parameters": floats(numbers, 5),
            "spring_force_curve": [row.force_curve for row in rows],
            "spring_damping_curve": [row.damping_curve for row in rows],
        }


def spring_table(specs: Mapping[str, SpringSpec], placement: Placement) -> SpringTable:
    """Every spring of the scene."""
    rows = tuple(_spring(spec, placement) for spec in specs.values())
    return SpringTable(tuple(specs), tuple(spec.type for spec in specs.values()), rows)


def _axes(row: Spring) -> list[FloatArray]:
    if row.kind is SpringKind.LINEAR:
        return [np.zeros(3), np.zeros(3)]
    return [end.axis_of_world(row.axis) for end in row.ends]


def _unit(axis: FloatArray) -> FloatArray:
    """Of length 1; NaN where there is no direction."""
    length = float(np.linalg.norm(axis))
    return axis / length if length > 0 else np.full(3, np.nan)


def _spring(spec: SpringSpec, placement: Placement) -> Spring:
    a, b = (placement[name] for name in spec.between)
    return _linear(spec, a, b) if spec.type == "linear" else _torsional(spec, a, b)


def _linear(spec: LinearSpring, a: Placed, b: Placed) -> Spring:
    """1/m_eff is the sum over both ends of 1/m + (r x n) . I^-1 (r x n), n along the spring as placed."""
    arms = (a.arm_of_own(spec.anchors[0]), b.arm_of_own(spec.anchors[1]))
    span = b.place(arms[1]) - a.place(arms[0])
    placed = float(np.linalg.norm(span))
    axis = span / placed if placed > COINCIDING else np.zeros(3)
    mobility = sum(_mobility(end, arm, axis) for end, arm in zip((a, b), arms, strict=True))
    return Spring(
        kind=SpringKind.LINEAR,
        ends=(a, b),
        anchors=arms,
        axis=axis,
        placed=placed,
        rest=placed if spec.rest_length is None else spec.rest_length,
        stiffness=spec.stiffness,
        damping=_damping(spec, mobility),
        preload=spec.preload,
        acts=ACTS[spec.acts],
        force_curve=_curve(spec.force_curve),
        damping_curve=_curve(spec.damping_curve),
        mobility=mobility,
    )


def _torsional(spec: TorsionalSpring, a: Placed, b: Placed) -> Spring:
    """1/I_eff is the sum over both ends of n . I^-1 n."""
    axis = np.array(spec.axis, dtype=np.float64)
    mobility = a.turning_mobility(axis) + b.turning_mobility(axis)
    return Spring(
        kind=SpringKind.TORSIONAL,
        ends=(a, b),
        anchors=(np.zeros(3), np.zeros(3)),
        axis=axis,
        placed=0.0,
        rest=spec.rest_angle,
        stiffness=spec.stiffness,
        damping=_damping(spec, mobility),
        preload=spec.preload,
        acts=ACTS["always"],
        force_curve=_curve(spec.torque_curve),
        damping_curve=_curve(spec.damping_curve),
        mobility=mobility,
    )


def _mobility(end: Placed, arm: FloatArray, axis: FloatArray) -> float:
    """Along the axis; the mean over all directions where there is none."""
    if axis.any():
        return end.mobility(arm, axis)
    return sum(end.mobility(arm, direction) for direction in np.eye(3)) / 3


def _damping(spec: SpringSpec, mobility: float) -> float:
    """c as given, or 2 zeta sqrt(k m_eff) (formula sheet, section 4); 0 where a curve stands for it."""
    if spec.damping_ratio is None:
        return spec.damping or 0.0
    return 2 * spec.damping_ratio * sqrt(spec.stiffness / mobility) if mobility > 0 else 0.0


def _curve(samples: Sequence[Sequence[float]] | None) -> FloatArray:
    return NO_CURVE if samples is None else floats(samples, 2)
