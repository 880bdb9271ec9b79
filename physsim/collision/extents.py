"""How far each shape reaches in a direction, and the round skin that can be taken off it.

The reach (support function) of a convex set S is h(n) = max over s in S of n . s. Formulas: G. van den
Bergen, Collision Detection in Interactive 3D Environments (2003), section 4.3. They are written with
operators only, so that one formula serves a single direction in plain floats, the common and quick case,
and arrays of many.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from math import hypot, inf
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

Vector = tuple[float, float, float]

Numbers = Any
"""A float, or an array of them."""

Reach = Callable[[Numbers, Numbers, Numbers], Numbers]


class Kind(IntEnum):
    """Kinds of geoms, numbered as in the engine's input."""

    SPHERE = 0
    CAPSULE = 1
    BOX = 2
    CYLINDER = 3
    CONE = 4
    ELLIPSOID = 5
    ROD = 6
    HULL = 7
    HALFSPACE = 8
    MESH = 9


@dataclass(frozen=True, slots=True)
class Extent:
    """What the search for a direction needs to know of a shape.

    reach: h(x, y, z) for unit vectors in the geom's axes [m].
    radius: of a sphere about the geom's origin that holds the shape [m].
    size: of a sphere about the shape's middle that holds it [m]; differs for polytopes off their origin.
    skin: radius of the ball that, swept over the shape's core, makes the shape [m]: a sphere is a point
        with a skin, a capsule a segment with a skin; 0 for shapes without one, which are their own core.
    """

    reach: Reach
    radius: float
    size: float
    skin: float = 0.0


def extent(kind: Kind, parameters: tuple[float, ...], vertices: NDArray[np.float64] | None = None) -> Extent:
    """Extent of a shape from its border parameters; `vertices` f64[V, 3] of a hull or a triangle [m]."""
    if vertices is not None:
        return _polytope(vertices)
    return _PRIMITIVES[kind](*parameters)


def _sphere(radius: float, *_: float) -> Extent:
    return Extent(lambda x, y, z: radius, radius, radius, radius)


def _capsule(radius: float, half: float, *_: float) -> Extent:
    return Extent(lambda x, y, z: radius + half * abs(z), radius + half, radius + half, radius)


def _rod(half: float, *_: float) -> Extent:
    return Extent(lambda x, y, z: half * abs(z), half, half)


def _box(a: float, b: float, c: float, *_: float) -> Extent:
    radius = hypot(a, b, c)
    return Extent(lambda x, y, z: a * abs(x) + b * abs(y) + c * abs(z), radius, radius)


def _cylinder(radius: float, half: float, *_: float) -> Extent:
    corner = hypot(radius, half)
    return Extent(lambda x, y, z: radius * (x * x + y * y) ** 0.5 + half * abs(z), corner, corner)


def _cone(radius: float, height: float, *_: float) -> Extent:
    """Origin at the centre of mass, a quarter of the height above the base."""
    base, apex = -0.25 * height, 0.75 * height
    farthest = max(apex, hypot(radius, base))

    def reach(x: Numbers, y: Numbers, z: Numbers) -> Numbers:
        tip, rim = apex * z, radius * (x * x + y * y) ** 0.5 + base * z
        return 0.5 * (tip + rim + abs(tip - rim))

    return Extent(reach, farthest, farthest)


def _ellipsoid(a: float, b: float, c: float, *_: float) -> Extent:
    farthest = max(a, b, c)
    return Extent(lambda x, y, z: ((a * x) ** 2 + (b * y) ** 2 + (c * z) ** 2) ** 0.5, farthest, farthest)


def _halfspace(*_: float) -> Extent:
    """Solid below its plane; asked only along the plane's normal, and without a size of its own."""
    return Extent(lambda x, y, z: 0.0, 0.0, inf)


def _polytope(vertices: NDArray[np.float64]) -> Extent:
    radius, size = _farthest(vertices), _farthest(vertices - vertices.mean(axis=0))
    return Extent(lambda x, y, z: (vertices @ np.array((x, y, z))).max(axis=0), radius, size)


def _farthest(points: NDArray[np.float64]) -> float:
    return float(np.sqrt((points**2).sum(axis=1).max()))


_PRIMITIVES: dict[Kind, Callable[..., Extent]] = {
    Kind.SPHERE: _sphere,
    Kind.CAPSULE: _capsule,
    Kind.BOX: _box,
    Kind.CYLINDER: _cylinder,
    Kind.CONE: _cone,
    Kind.ELLIPSOID: _ellipsoid,
    Kind.ROD: _rod,
    Kind.HALFSPACE: _halfspace,
}
