"""Mass properties of a triangulated surface: of the solid that it encloses, or of a thin shell along it.

The surface is summed exactly, tetrahedron by tetrahedron or triangle by triangle. All sums are taken about
the mean of the vertices, so that a part modelled far from its origin loses no digits.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from physsim.model.inertia import MassProperties
from physsim.model.rotation import FloatArray

IntArray = npt.NDArray[np.int32]


def solid(vertices: FloatArray, triangles: IntArray) -> MassProperties:
    """The enclosed solid at density 1 kg/m^3; triangles counter-clockwise seen from outside, closed surface.

    Every triangle spans with the middle a tetrahedron of signed volume V_i, and over a tetrahedron with
    corners 0, a, b, c:  integral x x^T dV = V_i / 20 (a a^T + b b^T + c c^T + s s^T), s = a + b + c (Blow &
    Binstock, "How to find the inertia tensor of a 3D solid body", 2004). The mass is negative for a surface
    turned inside out and zero for one that encloses nothing.
    """
    middle, corners = _about_middle(vertices, triangles)
    volumes = np.linalg.det(corners) / 6
    return _summed(middle, corners, volumes, first=4, second=20)


def shell(vertices: FloatArray, triangles: IntArray) -> MassProperties:
    """A thin shell along the surface at 1 kg/m^2; the surface may be open.

    Over a triangle of area A_i:  integral x x^T dA = A_i / 12 (a a^T + b b^T + c c^T + s s^T).
    """
    middle, corners = _about_middle(vertices, triangles)
    return _summed(middle, corners, triangle_areas(corners), first=3, second=12)


def triangle_areas(corners: FloatArray) -> FloatArray:
    """Areas (T,) of triangles given by their corners (T, 3, 3)."""
    edges = corners[:, 1:] - corners[:, :1]
    areas: FloatArray = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) / 2
    return areas


def _about_middle(vertices: FloatArray, triangles: IntArray) -> tuple[FloatArray, FloatArray]:
    middle = vertices.mean(axis=0)
    return middle, (vertices - middle)[triangles]


def _summed(
    middle: FloatArray, corners: FloatArray, weights: FloatArray, first: int, second: int
) -> MassProperties:
    """`first` and `second` divide the first and second moments of one simplex."""
    mass = float(weights.sum())
    if mass == 0:
        return MassProperties(0.0, middle, np.zeros((3, 3)))
    sums = corners.sum(axis=1)
    center = weights @ sums / (first * mass)
    spread = np.einsum("t,tpi,tpj->ij", weights, corners, corners) + np.einsum(
        "t,ti,tj->ij", weights, sums, sums
    )
    about_center = spread / second - mass * np.outer(center, center)
    return MassProperties(mass, middle + center, np.trace(about_center) * np.eye(3) - about_center)
