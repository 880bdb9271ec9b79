"""Forms of meshes and convex bodies: inertia from the surface as drawn, contacts from what `collision` asks
for.

The inertia always comes from the original surface, never from the convex pieces that collide in its place.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from physsim.errors import FileTrouble
from physsim.model import polyhedron
from physsim.model.form import Form
from physsim.model.geom import Geom, hull_geom, surface_geom
from physsim.model.hull import Hull, convex_hull
from physsim.model.inertia import MassProperties
from physsim.model.mesh import FLAT, TriangleMesh, read_mesh, read_points
from physsim.model.pieces import convex_pieces
from physsim.model.rotation import FloatArray
from physsim.model.trouble import ShapeTrouble

if TYPE_CHECKING:
    from physsim.scene.spec.shapes import ConvexShape, MeshShape


@dataclass
class MeshMemory:
    """What was read from mesh files and made of it; one may serve many scenes that use the same files."""

    meshes: dict[Path, TriangleMesh] = field(default_factory=dict)
    forms: dict[tuple[Path, MeshShape, bool, bool], Form] = field(default_factory=dict)


@dataclass
class MeshFiles:
    """Reads every mesh file once, and remembers its hash under the name that the scene gives it.

    find: name -> path; raises FileTrouble when there is no such file.
    """

    find: Callable[[str], Path]
    memory: MeshMemory = field(default_factory=MeshMemory)
    sha256: dict[str, str] = field(default_factory=dict)

    def mesh(self, file: str) -> TriangleMesh:
        """The surface in a file. Raises ShapeTrouble."""
        path, meshes = self.path(file), self.memory.meshes
        if path not in meshes:
            meshes[path] = read_mesh(path)
        self.sha256[file] = meshes[path].sha256
        return meshes[path]

    def points(self, file: str) -> FloatArray:
        """The vertices (V, 3) in a file. Raises ShapeTrouble."""
        points, self.sha256[file] = read_points(self.path(file))
        return points

    def path(self, file: str) -> Path:
        """Where a file is. Raises ShapeTrouble."""
        try:
            return self.find(file)
        except FileTrouble as trouble:
            raise ShapeTrouble(str(trouble), key="file", given=file) from None


def mesh_form(shape: MeshShape, files: MeshFiles, fixed: bool, collides: bool) -> Form:
    """The form of `mesh {file, scale, collision, inertia}`; a fixed body needs no inertia, so its mesh may
    be open, and one that never collides needs nothing that stands for it in contacts.

    Raises ShapeTrouble.
    """
    mesh, forms = files.mesh(shape.file), files.memory.forms
    key = (files.path(shape.file), shape, fixed, collides)
    if key not in forms:
        forms[key] = _made(mesh, shape, fixed, collides)
    return forms[key]


def _made(mesh: TriangleMesh, shape: MeshShape, fixed: bool, collides: bool) -> Form:
    vertices = mesh.vertices * shape.scale
    unit, volume, method = _mass_properties(mesh, vertices, shape.inertia, fixed)
    spans = np.ptp(vertices, axis=0)
    exact = shape.collision == "exact"
    geoms = _geoms(mesh, vertices, shape) if collides or exact else ()
    drawn = None if exact else surface_geom(vertices, mesh.triangles)
    return Form(unit, volume, method, float(spans.min()), float(np.linalg.norm(spans)), geoms, drawn)


def convex_form(shape: ConvexShape, files: MeshFiles) -> Form:
    """The form of `convex {points | file}`. Raises ShapeTrouble."""
    key = "points" if shape.file is None else "file"
    points = np.array(shape.points, dtype=np.float64) if shape.file is None else files.points(shape.file)
    if shape.scale is not None:
        points = points * shape.scale
    try:
        hull = convex_hull(points)
    except ShapeTrouble as trouble:
        raise ShapeTrouble(trouble.message, key=key) from None
    solid = polyhedron.solid(hull.vertices, hull.triangles())
    spans = np.ptp(hull.vertices, axis=0)
    return Form(
        solid.scaled(1.0),
        solid.mass,
        f"convex, solid, {len(hull.vertices)} vertices",
        float(spans.min()),
        float(np.linalg.norm(spans)),
        (hull_geom(hull),),
    )


def _mass_properties(
    mesh: TriangleMesh, vertices: FloatArray, inertia: str, fixed: bool
) -> tuple[MassProperties, float | None, str]:
    """Properties of one kilogram, volume, and the method in words."""
    count = f"{len(mesh.triangles)} triangles"
    if inertia == "shell" or (fixed and not mesh.closed):
        return polyhedron.shell(vertices, mesh.triangles).scaled(1.0), None, f"mesh, shell, {count}"
    if inertia == "hull":
        hull = convex_hull(vertices)
        solid = polyhedron.solid(hull.vertices, hull.triangles())
        return solid.scaled(1.0), solid.mass, f"mesh, hull, {len(hull.vertices)} vertices"
    _require_closed(mesh, "the mass and inertia of a solid")
    solid = polyhedron.solid(vertices, mesh.triangles)
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    if solid.mass <= FLAT * size**3:
        raise ShapeTrouble(
            "encloses no volume", key="file", hint="give it a thickness, or use inertia: shell"
        )
    return solid.scaled(1.0), solid.mass, f"mesh, solid, {count}"


def _require_closed(mesh: TriangleMesh, purpose: str) -> None:
    if not mesh.closed:
        raise ShapeTrouble(
            f"is not closed: {mesh.open_edges} edges do not join exactly two triangles of like winding, "
            f"and {purpose} needs an inside",
            key="file",
            hint="close it, or use inertia: hull or inertia: shell with collision: hull",
        )


def _geoms(mesh: TriangleMesh, vertices: FloatArray, shape: MeshShape) -> tuple[Geom, ...]:
    if shape.collision == "exact":
        corners = vertices[mesh.triangles]
        with_area = polyhedron.triangle_areas(corners) > 0
        return (surface_geom(vertices, mesh.triangles[with_area]),)
    if shape.collision == "pieces":
        _require_closed(mesh, "cutting into pieces")
        pieces = convex_pieces(mesh.vertices, mesh.triangles)
        return tuple(hull_geom(hull) for hull in _piece_hulls(pieces, shape.scale))
    return (hull_geom(convex_hull(vertices)),)


def _piece_hulls(pieces: list[FloatArray], scale: float) -> list[Hull]:
    """Hulls of the pieces; a sliver without volume, which CoACD leaves now and then, is no obstacle to
    anything.
    """
    hulls = []
    for piece in pieces:
        try:
            hulls.append(convex_hull(piece * scale))
        except ShapeTrouble:
            continue
    if not hulls:
        raise ShapeTrouble("was cut into nothing but slivers", key="collision", given="pieces")
    return hulls
