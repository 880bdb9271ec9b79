"""The one file that imports fcl: shapes as FCL knows them, and the two questions that are put to it.

Of FCL's entry points only two are used, both measured over some hundred thousand random and aligned poses
(docs/contacts.md): `distance` without sign, and `collide` for a rough first direction. Never `distance`
with sign: its expanding polytope aborts the whole process on touching polytopes (a C++ exception that the
binding does not catch) and has no bound on its effort for round shapes deep inside one another.

FCL's tolerances are absolute, 1e-6 in whatever unit the shapes are given, and cannot be set from Python. So a
solid is built in a unit that suits the pair: its numbers are lengths divided by the unit. Units are powers of
8, which scale floats without rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, log2
from typing import TYPE_CHECKING, Any

import fcl
import numpy as np

from physsim.collision.extents import Kind, Vector

if TYPE_CHECKING:
    from numpy.typing import NDArray

FCL_TOLERANCE = 1e-6
"""Distance tolerance of FCL's iterations, in the unit of its numbers."""

_DISTANCE = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=False)
_COLLISION = fcl.CollisionRequest(num_max_contacts=1, enable_contact=True)

_ROD_THICKNESS = 1e-3
"""Radius of the rod given to `collide` as a part of its half length: a segment has no inside. Only a rough
direction is taken from there, so that the thickness enters no depth."""


@dataclass(frozen=True, slots=True)
class Blueprint:
    """A shape before it is built in some unit. `vertices` f64[V, 3] [m] and `faces` of hulls and
    triangles."""

    kind: Kind
    parameters: tuple[float, ...]
    vertices: NDArray[np.float64] | None = None
    faces: Sequence[Sequence[int]] = ()


class Solid:
    """A shape in one unit, ready to be placed: whole, or its core without the round skin."""

    __slots__ = ("_centre", "_object", "_per_metre", "_unit")

    def __init__(self, blueprint: Blueprint, unit_exponent: int, core: bool) -> None:
        self._unit, self._per_metre = 8.0**unit_exponent, 8.0**-unit_exponent
        self._object = fcl.CollisionObject(_geometry(blueprint, self._per_metre, core))
        # FCL has a cone's origin at half its height, ours is at a quarter.
        self._centre = 0.25 * blueprint.parameters[1] if blueprint.kind is Kind.CONE else 0.0

    def place(self, position: Vector, quaternion: Sequence[float], axis: Vector) -> None:
        """Put the solid's origin at `position` [m]; `axis` is its z axis in the world."""
        x, y, z = position
        c, k = self._centre, self._per_metre
        self._object.setQuatRotation(quaternion)
        self._object.setTranslation(
            np.array((k * (x + c * axis[0]), k * (y + c * axis[1]), k * (z + c * axis[2])))
        )

    def nearest_points(self, other: Solid) -> tuple[Vector, Vector] | None:
        """The nearest points of the other solid and of this one [m], or None where they overlap."""
        result = fcl.DistanceResult()
        distance = fcl.distance(self._object, other._object, _DISTANCE, result)
        own, others = result.nearest_points
        if not distance > 0.0 or own is None:
            return None
        return self._metres(others), self._metres(own)

    def contact(self, other: Solid) -> tuple[Vector, Vector] | None:
        """A normal from this solid to the other (rough, perhaps zero) and a point of an overlap [m], or
        None."""
        result = fcl.CollisionResult()
        fcl.collide(self._object, other._object, _COLLISION, result)
        if not result.contacts:
            return None
        contact = result.contacts[0]
        x, y, z = contact.normal.tolist()
        return (x, y, z), self._metres(contact.pos)

    def _metres(self, point: NDArray[np.float64]) -> Vector:
        x, y, z = point.tolist()
        u = self._unit
        return (x * u, y * u, z * u)


def unit_exponent(tolerance: float) -> int:
    """Exponent e of the unit 8^e [m] in which FCL's tolerance is at most `tolerance` [m], and over an
    eighth of it."""
    return -ceil(log2(FCL_TOLERANCE / tolerance) / 3.0)


def _geometry(blueprint: Blueprint, per_metre: float, core: bool) -> Any:
    if blueprint.vertices is not None:
        # FCL wants polygons as one list of counts and indices.
        indices = [entry for face in blueprint.faces for entry in (len(face), *face)]
        return fcl.Convex(per_metre * blueprint.vertices, len(blueprint.faces), np.array(indices))
    return _PRIMITIVES[blueprint.kind](core, *(per_metre * x for x in blueprint.parameters))


_PRIMITIVES: dict[Kind, Callable[..., Any]] = {
    Kind.SPHERE: lambda core, radius, *_: fcl.Sphere(0.0 if core else radius),
    Kind.CAPSULE: lambda core, radius, half, *_: fcl.Capsule(0.0 if core else radius, 2.0 * half),
    Kind.BOX: lambda core, a, b, c, *_: fcl.Box(2.0 * a, 2.0 * b, 2.0 * c),
    Kind.CYLINDER: lambda core, radius, half, *_: fcl.Cylinder(radius, 2.0 * half),
    Kind.CONE: lambda core, radius, height, *_: fcl.Cone(radius, height),
    Kind.ELLIPSOID: lambda core, a, b, c, *_: fcl.Ellipsoid(a, b, c),
    Kind.ROD: lambda core, half, *_: fcl.Capsule(0.0 if core else _ROD_THICKNESS * half, 2.0 * half),
    Kind.HALFSPACE: lambda core, *_: fcl.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0),
}
