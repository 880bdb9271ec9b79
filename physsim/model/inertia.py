"""Mass, centre of mass and inertia tensor of one rigid thing, and how such things are moved and joined.

Tensors are matrices: I_xy is the entry of the matrix, -integral of x y dm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from physsim.model.rotation import FloatArray

TRIANGLE_TOLERANCE = 1e-9
"""Rounding that the triangle inequality is allowed, relative to the largest principal moment."""


@dataclass(frozen=True)
class MassProperties:
    """mass [kg]; center (3,) [m] in the frame's coordinates; inertia (3, 3) [kg m^2] about the centre,
    frame axes.
    """

    mass: float
    center: FloatArray
    inertia: FloatArray

    def scaled(self, mass: float) -> MassProperties:
        """The same distribution with another total mass [kg]."""
        return MassProperties(mass, self.center, self.inertia * (mass / self.mass))

    def moved(self, rotation: FloatArray, translation: Sequence[float] | FloatArray) -> MassProperties:
        """The same thing seen from the frame in which its own frame is turned by `rotation` and then
        shifted.
        """
        center = rotation @ self.center + np.asarray(translation, dtype=np.float64)
        return MassProperties(self.mass, center, rotated(self.inertia, rotation))


def rotated(inertia: FloatArray, rotation: FloatArray) -> FloatArray:
    """I' = R I R^T (formula sheet, section 5), made exactly symmetric again."""
    turned = rotation @ inertia @ rotation.T
    symmetric: FloatArray = (turned + turned.T) / 2
    return symmetric


def parallel_axis(inertia: FloatArray, mass: float, offset: Sequence[float] | FloatArray) -> FloatArray:
    """Inertia about a point `offset` [m] away from the centre of mass: I + m (d.d 1 - d d^T).

    The diagonal is the formula sheet's I'_xx = I_xx + m (dy^2 + dz^2); the products are I'_xy = I_xy - m dx
    dy (Steiner's theorem; Goldstein, Classical Mechanics, 3rd ed., eq. 5.21 with both points exchanged).
    """
    d = np.asarray(offset, dtype=np.float64)
    moved: FloatArray = inertia + mass * (np.dot(d, d) * np.eye(3) - np.outer(d, d))
    return moved


def composed(parts: Sequence[MassProperties]) -> MassProperties:
    """Several things in one frame, joined into one. Raises ValueError when their mass sums to zero."""
    mass = sum(part.mass for part in parts)
    if not mass > 0:
        raise ValueError("the parts have no mass")
    center = sum((part.mass * part.center for part in parts), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for part in parts:
        inertia += parallel_axis(part.inertia, part.mass, part.center - center)
    return MassProperties(mass, center, inertia)


def principal(inertia: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Principal moments (3,), ascending, and a right-handed set of axes (3, 3), one per column."""
    moments, axes = np.linalg.eigh(inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 2] = -axes[:, 2]
    return moments, axes


def impossible(inertia: FloatArray) -> str | None:
    """Why no rigid body can have this tensor, in words, or None.

    Every moment must be positive and no principal moment larger than the sum of the others, because
    I_1 + I_2 - I_3 = 2 integral of x_3^2 dm (Wittenburg, Dynamics of Multibody Systems, 2nd ed., sec. 3.1).
    """
    moments, _ = principal(inertia)
    listed = ", ".join(f"{moment:.6g}" for moment in moments.tolist())
    if not moments[0] > 0:
        return f"is not positive definite: its principal moments are {listed} kg m^2"
    if moments[2] > (moments[0] + moments[1]) * (1 + TRIANGLE_TOLERANCE):
        return f"breaks the triangle inequality: of {listed} kg m^2 the last exceeds the sum"
    return None
