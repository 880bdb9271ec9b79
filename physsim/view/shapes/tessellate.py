"""The one place that turns geometry kinds into triangles: page, glTF and pictures all draw these."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, field

import numpy as np

from physsim.view.shapes.creases import creased
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.revolved import capsule, cone, cylinder, sphere
from physsim.view.stage import FloatArray, Solid, Stage, Surface

__all__ = ["Mesh", "Placed", "tessellated"]

ROD_THINNESS = 100
"""A rod has no thickness; it is drawn with a radius of its length / 100."""


@dataclass(frozen=True)
class Placed:
    """A mesh at a solid: index of the mesh, index into `stage.solids`, and scale (3,) along the axes of the
    solid, applied before its orientation.
    """

    mesh: int
    solid: int
    scale: FloatArray


def tessellated(stage: Stage, fineness: int, ground: float) -> tuple[list[Mesh], list[Placed]]:
    """All solids as triangles, one `Placed` each in their order; equal meshes are there once.

    fineness: segments around a circle, at least 3; ground: half width [m] of the square at which a half-space
    is drawn. Vertices lie on the true surface, so a round solid is drawn too small, by a part of its volume
    that falls as fineness^-2.
    """
    if fineness < 3:
        raise ValueError(f"fineness must be at least 3, got {fineness}")
    meshes = _Meshes(fineness)
    return meshes.kept, [
        Placed(meshes.of(solid), number, _scale(solid, ground)) for number, solid in enumerate(stage.solids)
    ]


@dataclass
class _Meshes:
    """The distinct meshes so far, in the order of their first use."""

    fineness: int
    kept: list[Mesh] = field(default_factory=list)
    _known: dict[Hashable, int] = field(default_factory=dict)

    def of(self, solid: Solid) -> int:
        """The index of the solid's mesh."""
        if solid.surface is not None:
            return self._of_surface(solid.surface)
        if solid.kind == "capsule":
            radius, half_height = (float(part) for part in solid.parameters[:2])
            return self._once(
                ("capsule", radius, half_height), lambda: capsule(radius, half_height, self.fineness)
            )
        make = UNIT[solid.kind]
        return self._once(make, lambda: make(self.fineness))

    def _of_surface(self, surface: Surface) -> int:
        """By content, which is read once for an object that many solids share."""
        known = self._known.get(id(surface))
        if known is None:
            content = (surface.vertices.tobytes(), surface.triangles.tobytes())
            known = self._once(content, lambda: creased(surface.vertices, surface.triangles))
            self._known[id(surface)] = known
        return known

    def _once(self, key: Hashable, make: Callable[[], Mesh]) -> int:
        if key not in self._known:
            self._known[key] = len(self.kept)
            self.kept.append(make())
        return self._known[key]


def _box(_: int) -> Mesh:
    """The cube from -1 to 1 along each axis."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return creased(
        corners, np.array([half for a, b, c, d in sides for half in ((a, b, c), (a, c, d))], np.int32)
    )


def _square(_: int) -> Mesh:
    """The square from -1 to 1 in the xy plane, seen from above."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=np.float64)
    return creased(corners, np.array([(0, 1, 2), (0, 2, 3)], np.int32))


UNIT: dict[str, Callable[[int], Mesh]] = {
    "sphere": sphere,
    "ellipsoid": sphere,
    "box": _box,
    "cylinder": cylinder,
    "rod": cylinder,
    "cone": cone,
    "halfspace": _square,
}


def _scale(solid: Solid, ground: float) -> FloatArray:
    """How far the solid's mesh is stretched along each axis."""
    p = [float(part) for part in solid.parameters]
    match solid.kind:
        case "sphere":
            scale = [p[0], p[0], p[0]]
        case "box" | "ellipsoid":
            scale = p[:3]
        case "cylinder" | "cone":
            scale = [p[0], p[0], p[1]]
        case "rod":
            thickness = 2 * p[0] / ROD_THINNESS
            scale = [thickness, thickness, p[0]]
        case "halfspace":
            scale = [ground, ground, 1.0]
        case _:
            scale = [1.0, 1.0, 1.0]
    return np.array(scale)
