"""Volume and inertia of the primitive shapes in closed form (formula sheet, section 6, completed).

Every function returns a volume [m^3] or the diagonal of the inertia tensor (3,) [kg m^2] about the centre
of mass. The axis of a cylinder, capsule, cone or rod is z. Solid bodies of uniform density; the hollow
sphere is a thin shell. Formulas as in Beer & Johnston, Vector Mechanics for Engineers: Dynamics, appendix
"Mass moments of inertia of common geometric shapes", except where said.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np

from physsim.model.rotation import FloatArray

ROD_SLENDERNESS = 1e-3
"""Radius of the rod that stands for a thin one, as a part of its length.

With I_zz = 0 the tensor has no inverse and the spin about the rod's own axis no equation of motion. A
radius of L/1000 leaves I_xx right to 3e-6 and the tensor well enough conditioned (1.7e5) for double
precision.
"""


def sphere_volume(radius: float) -> float:
    """4/3 pi R^3."""
    return 4 / 3 * pi * radius**3


def sphere_inertia(mass: float, radius: float) -> FloatArray:
    """2/5 m R^2 about every axis."""
    return np.full(3, 2 / 5 * mass * radius**2)


def hollow_sphere_inertia(mass: float, radius: float) -> FloatArray:
    """2/3 m R^2 about every axis (thin shell)."""
    return np.full(3, 2 / 3 * mass * radius**2)


def box_volume(size: Sequence[float]) -> float:
    """Product of the three edges."""
    return size[0] * size[1] * size[2]


def box_inertia(mass: float, size: Sequence[float]) -> FloatArray:
    """m (b^2 + c^2) / 3 and so on, with the half edges a, b, c."""
    a, b, c = (edge / 2 for edge in size)
    return mass / 3 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])


def cylinder_volume(radius: float, height: float) -> float:
    """pi R^2 H."""
    return pi * radius**2 * height


def cylinder_inertia(mass: float, radius: float, height: float) -> FloatArray:
    """m (3 R^2 + H^2) / 12 across, m R^2 / 2 along the axis."""
    across = mass * (3 * radius**2 + height**2) / 12
    return np.array([across, across, mass * radius**2 / 2])


def capsule_volume(radius: float, height: float) -> float:
    """Cylinder of the given height and two half spheres."""
    return cylinder_volume(radius, height) + sphere_volume(radius)


def capsule_inertia(mass: float, radius: float, height: float) -> FloatArray:
    """Cylinder and two half spheres, composed by the parallel-axis theorem.

    A half sphere of mass m_h has its centre 3R/8 above its flat face and there 83/320 m_h R^2 across; moved
    by H/2 + 3R/8 this is m_h (2/5 R^2 + H^2/4 + 3/8 H R).
    """
    density = mass / capsule_volume(radius, height)
    cylinder = density * cylinder_volume(radius, height)
    caps = density * sphere_volume(radius)
    across = cylinder * (3 * radius**2 + height**2) / 12 + caps * (
        2 / 5 * radius**2 + height**2 / 4 + 3 / 8 * height * radius
    )
    return np.array([across, across, cylinder * radius**2 / 2 + caps * 2 / 5 * radius**2])


def cone_volume(radius: float, height: float) -> float:
    """pi R^2 H / 3."""
    return pi * radius**2 * height / 3


def cone_inertia(mass: float, radius: float, height: float) -> FloatArray:
    """m (3/20 R^2 + 3/80 H^2) across, 3/10 m R^2 along the axis, about the centre of mass H/4 above the base.

    The sheet puts the base at the origin; about that point the moment across would be larger by m (H/4)^2.
    """
    across = mass * (3 / 20 * radius**2 + 3 / 80 * height**2)
    return np.array([across, across, 3 / 10 * mass * radius**2])


def rod_inertia(mass: float, length: float) -> FloatArray:
    """m L^2 / 12 across; along the axis the m R^2 / 2 of a rod of radius `ROD_SLENDERNESS` L instead of
    zero.
    """
    across = mass * length**2 / 12
    return np.array([across, across, mass * (ROD_SLENDERNESS * length) ** 2 / 2])


def ellipsoid_volume(radii: Sequence[float]) -> float:
    """4/3 pi a b c."""
    return 4 / 3 * pi * radii[0] * radii[1] * radii[2]


def ellipsoid_inertia(mass: float, radii: Sequence[float]) -> FloatArray:
    """m (b^2 + c^2) / 5 and so on, with the half axes a, b, c."""
    a, b, c = radii
    return mass / 5 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
