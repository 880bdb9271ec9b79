"""A form is a shape made ready: its mass distribution per kilogram and the geoms that stand for it in
contacts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.model import primitives, rotation
from physsim.model.geom import Geom, GeomKind, Look
from physsim.model.inertia import MassProperties
from physsim.model.rotation import FloatArray

if TYPE_CHECKING:
    from physsim.scene.spec.shapes import (
        BoxShape,
        CapsuleShape,
        ConeShape,
        CylinderShape,
        EllipsoidShape,
        HalfspaceShape,
        HollowSphereShape,
        RodShape,
        SphereShape,
    )


@dataclass(frozen=True)
class Form:
    """unit: mass properties of one kilogram of it; volume [m^3], None for what has none (rod, shell), inf
    for a half-space; method: how these were found; thickness, extent: smallest and largest dimension [m];
    drawn: the surface as the user drew it, where the geoms only stand for it.
    """

    unit: MassProperties
    volume: float | None
    method: str
    thickness: float
    extent: float
    geoms: tuple[Geom, ...]
    drawn: Geom | None = None

    def looks(self, collides: bool) -> list[Look]:
        """What is seen of it and what collides; nothing that does neither."""
        if self.drawn is None:
            return [Look(geom, shown=True, collides=collides) for geom in self.geoms]
        hidden = [Look(geom, shown=False, collides=True) for geom in self.geoms] if collides else []
        return [Look(self.drawn, shown=True, collides=False), *hidden]


def primitive(shape: Any) -> Form:
    """The form of a shape with a closed formula. `shape` is the scene's spec of it; its `type` is in
    `PRIMITIVES`.
    """
    return PRIMITIVES[shape.type](shape)


def _form(
    name: str, inertia: FloatArray, volume: float | None, dimensions: tuple[float, float], geom: Geom
) -> Form:
    unit = MassProperties(1.0, np.zeros(3), np.diag(inertia))
    return Form(unit, volume, f"closed form ({name})", *dimensions, (geom,))


def _sphere(shape: SphereShape) -> Form:
    r = shape.radius
    geom = Geom(GeomKind.SPHERE, (r,))
    return _form("sphere", primitives.sphere_inertia(1, r), primitives.sphere_volume(r), (2 * r, 2 * r), geom)


def _hollow_sphere(shape: HollowSphereShape) -> Form:
    r = shape.radius
    geom = Geom(GeomKind.SPHERE, (r,))
    return _form("hollow_sphere", primitives.hollow_sphere_inertia(1, r), None, (2 * r, 2 * r), geom)


def _box(shape: BoxShape) -> Form:
    size = shape.size
    geom = Geom(GeomKind.BOX, tuple(edge / 2 for edge in size))
    span = (min(size), float(np.linalg.norm(size)))
    return _form("box", primitives.box_inertia(1, size), primitives.box_volume(size), span, geom)


def _cylinder(shape: CylinderShape) -> Form:
    r, h = shape.radius, shape.height
    geom = Geom(GeomKind.CYLINDER, (r, h / 2))
    span = (min(2 * r, h), float(np.hypot(2 * r, h)))
    return _form(
        "cylinder", primitives.cylinder_inertia(1, r, h), primitives.cylinder_volume(r, h), span, geom
    )


def _capsule(shape: CapsuleShape) -> Form:
    r, h = shape.radius, shape.height
    geom = Geom(GeomKind.CAPSULE, (r, h / 2))
    inertia = primitives.capsule_inertia(1, r, h)
    return _form("capsule", inertia, primitives.capsule_volume(r, h), (2 * r, h + 2 * r), geom)


def _cone(shape: ConeShape) -> Form:
    r, h = shape.radius, shape.height
    geom = Geom(GeomKind.CONE, (r, h))
    span = (min(2 * r, h), max(2 * r, float(np.hypot(r, h))))
    return _form("cone", primitives.cone_inertia(1, r, h), primitives.cone_volume(r, h), span, geom)


def _rod(shape: RodShape) -> Form:
    length = shape.length
    geom = Geom(GeomKind.ROD, (length / 2,))
    return _form("rod", primitives.rod_inertia(1, length), None, (length, length), geom)


def _ellipsoid(shape: EllipsoidShape) -> Form:
    radii = shape.radii
    geom = Geom(GeomKind.ELLIPSOID, tuple(radii))
    span = (2 * min(radii), 2 * max(radii))
    return _form(
        "ellipsoid", primitives.ellipsoid_inertia(1, radii), primitives.ellipsoid_volume(radii), span, geom
    )


def _halfspace(shape: HalfspaceShape) -> Form:
    """Solid where x . normal <= offset, in the body's frame; its mass properties are infinite."""
    normal = np.asarray(shape.normal, dtype=np.float64)
    unit_normal = normal / np.linalg.norm(normal)
    geom = Geom(GeomKind.HALFSPACE, (), shape.offset * unit_normal, rotation.from_z_to(unit_normal))
    unit = MassProperties(inf, np.zeros(3), np.diag(np.full(3, inf)))
    return Form(unit, inf, "infinite (halfspace)", inf, inf, (geom,))


PRIMITIVES: Mapping[str, Callable[[Any], Form]] = MappingProxyType(
    {
        "sphere": _sphere,
        "hollow_sphere": _hollow_sphere,
        "box": _box,
        "cylinder": _cylinder,
        "capsule": _capsule,
        "cone": _cone,
        "rod": _rod,
        "ellipsoid": _ellipsoid,
        "halfspace": _halfspace,
    }
)
