"""What a body collides with: the kinds and parameters that the engine knows."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum

import numpy as np

from physsim.model import rotation
from physsim.model.hull import Hull
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray


class GeomKind(IntEnum):
    """Kind numbers of the engine, with their parameters."""

    SPHERE = 0  # radius
    CAPSULE = 1  # radius, half height of the cylindrical part; axis z
    BOX = 2  # half extents
    CYLINDER = 3  # radius, half height; axis z
    CONE = 4  # radius, height; axis z, origin at the centre of mass: base at -height/4, apex at +3 height/4
    ELLIPSOID = 5  # half axes
    ROD = 6  # half length; axis z, no thickness
    HULL = 7  # index of the hull
    HALFSPACE = 8  # solid where z <= 0
    MESH = 9  # index of the surface; fixed bodies only


@dataclass(frozen=True)
class Surface:
    """An exact triangle mesh: vertices (V, 3), triangles (T, 3) counter-clockwise seen from outside."""

    vertices: FloatArray
    triangles: IntArray


@dataclass(frozen=True)
class Geom:
    """One collision shape. position (3,) [m] and orientation (4,) place its frame in the frame of its
    owner.
    """

    kind: GeomKind
    parameters: tuple[float, ...] = ()
    position: FloatArray = field(default_factory=lambda: np.zeros(3))
    orientation: FloatArray = field(default_factory=lambda: np.array(rotation.IDENTITY))
    material: str = ""
    hull: Hull | None = None
    surface: Surface | None = None

    def moved(self, quaternion: FloatArray, translation: FloatArray) -> Geom:
        """The same geom seen from the frame in which its owner's frame is turned and then shifted."""
        return Geom(
            self.kind,
            self.parameters,
            rotation.matrix(quaternion) @ self.position + translation,
            rotation.product(quaternion, self.orientation),
            self.material,
            self.hull,
            self.surface,
        )

    def of(self, material: str) -> Geom:
        """The same geom made of `material`."""
        return Geom(
            self.kind, self.parameters, self.position, self.orientation, material, self.hull, self.surface
        )


@dataclass(frozen=True)
class Look:
    """A geom and its part: shown, what the user drew; collides, what stands for it in contacts."""

    geom: Geom
    shown: bool
    collides: bool


def hull_geom(hull: Hull) -> Geom:
    """A geom whose frame sits in the middle of the hull, where numbers are small."""
    middle = (hull.vertices.max(axis=0) + hull.vertices.min(axis=0)) / 2
    return Geom(GeomKind.HULL, position=middle, hull=Hull(hull.vertices - middle, hull.faces))


def surface_geom(vertices: FloatArray, triangles: IntArray) -> Geom:
    """A geom whose frame sits in the middle of the surface; triangles without area are left out."""
    middle = (vertices.max(axis=0) + vertices.min(axis=0)) / 2
    return Geom(GeomKind.MESH, position=middle, surface=Surface(vertices - middle, triangles))
