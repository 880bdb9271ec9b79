"""What stands still in a glTF file: materials, meshes, and the nodes of bodies and their solids."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from physsim.view.gltf import axes as gltf_axes
from physsim.view.gltf.glb_file import INDICES, VERTICES, Binary
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.tessellate import Placed
from physsim.view.stage import Actor, FloatArray, Solid, Stage

ROUGHNESS = 0.6
"""Of every material: between varnish and rubber; physsim knows no gloss."""
METALNESS = 0.0
"""Also of metals: without surroundings to mirror, which the file does not have, they would look black."""

_FEW_VERTICES = 65535
_NO_TURN = (1.0, 0.0, 0.0, 0.0)


@dataclass
class Figures:
    """materials and meshes of the document, each there once; `mesh` hands out their numbers."""

    shapes: list[dict[str, Any]]
    materials: list[dict[str, Any]] = field(default_factory=list)
    meshes: list[dict[str, Any]] = field(default_factory=list)
    _known: dict[Hashable, int] = field(default_factory=dict)

    def mesh(self, shape: int, solid: Solid) -> int:
        """The number of the mesh of a shape in the material of the solid."""
        return self._mesh(shape, f"{solid.kind}, {solid.material}", solid.material, solid.colour)

    def _mesh(self, shape: int, name: str, material: str, colour: str) -> int:
        key = (shape, material, colour)
        if key not in self._known:
            primitive = self.shapes[shape] | {"material": self._material(material, colour)}
            self.meshes.append({"name": name, "primitives": [primitive]})
            self._known[key] = len(self.meshes) - 1
        return self._known[key]

    def plain(self, shape: int, name: str, colour: str) -> int:
        """The number of the mesh of a shape that is no part of a body; the material has its name."""
        return self._mesh(shape, name, name, colour)

    def document(self) -> dict[str, Any]:
        """The keys of the document that hold them; glTF forbids empty ones."""
        filled = {"materials": self.materials, "meshes": self.meshes}
        return {key: value for key, value in filled.items() if value}

    def _material(self, name: str, colour: str) -> int:
        key = (name, colour)
        if key not in self._known:
            look = {
                "baseColorFactor": [*linear_colour(colour), 1.0],
                "metallicFactor": METALNESS,
                "roughnessFactor": ROUGHNESS,
            }
            self.materials.append({"name": name, "pbrMetallicRoughness": look})
            self._known[key] = len(self.materials) - 1
        return self._known[key]


def shapes(meshes: Sequence[Mesh], binary: Binary) -> list[dict[str, Any]]:
    """Writes vertices, normals and triangles; a primitive without material for each mesh."""
    primitives: list[dict[str, Any]] = []
    binary.begin_view(VERTICES)
    for mesh in meshes:
        position = binary.add(gltf_axes.turned(mesh.vertices).astype(np.float32), bounds=True)
        normal = binary.add(gltf_axes.turned(mesh.normals).astype(np.float32))
        primitives.append({"attributes": {"POSITION": position, "NORMAL": normal}})
    binary.begin_view(INDICES)
    for mesh, primitive in zip(meshes, primitives, strict=True):
        kind = np.uint16 if len(mesh.vertices) <= _FEW_VERTICES else np.uint32
        primitive["indices"] = binary.add(mesh.triangles.reshape(-1).astype(kind))
    return primitives


def linear_colour(colour: str) -> list[float]:
    """`#rrggbb` -> red, green and blue in proportion to light, as glTF wants them; IEC 61966-2-1 (sRGB)."""
    parts = np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)]) / 255
    return gltf_axes.numbers(np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4))


def body_nodes(
    stage: Stage, placed: Sequence[Placed], figures: Figures, positions: FloatArray, orientations: FloatArray
) -> list[dict[str, Any]]:
    """The nodes of the bodies in their order, at the poses (N, 3) [m] and (N, 4), and then those of solids.

    A body whose one solid sits at its origin is that solid's node itself.
    """
    bodies = [
        pose(position, orientation) | {"name": actor.name, "extras": facts(actor)}
        for actor, position, orientation in zip(stage.actors, positions, orientations, strict=True)
    ]
    parts: list[dict[str, Any]] = []
    own: list[list[Placed]] = [[] for _ in stage.actors]
    for one in placed:
        own[stage.solids[one.solid].body].append(one)
    for body, ones in zip(bodies, own, strict=True):
        looks = [solid_node(stage.solids[one.solid], one, figures) for one in ones]
        if len(looks) == 1 and looks[0].keys() <= {"mesh", "scale"}:
            body.update(looks[0])
        elif looks:
            body["children"] = [len(bodies) + len(parts) + number for number in range(len(looks))]
            parts += [
                look | {"name": f"{body['name']}: {stage.solids[one.solid].kind}"}
                for look, one in zip(looks, ones, strict=True)
            ]
    return [*bodies, *parts]


def solid_node(solid: Solid, placed: Placed, figures: Figures) -> dict[str, Any]:
    """Mesh, scale and pose in the body; what changes nothing is left out."""
    node = pose(solid.position, solid.orientation) | {"mesh": figures.mesh(placed.mesh, solid)}
    if (placed.scale != 1).any():
        node["scale"] = gltf_axes.numbers(gltf_axes.scales(placed.scale))
    return node


def pose(position: FloatArray, orientation: FloatArray) -> dict[str, Any]:
    """translation and rotation of a node; what changes nothing is left out."""
    node: dict[str, Any] = {}
    if position.any():
        node["translation"] = gltf_axes.numbers(gltf_axes.turned(position))
    if tuple(orientation) != _NO_TURN:
        node["rotation"] = gltf_axes.numbers(gltf_axes.quaternions(orientation))
    return node


def facts(actor: Actor) -> dict[str, Any]:
    """What other programs show as properties of a body: material, mass [kg], and whether it is fixed."""
    mass = {"mass": actor.mass} if np.isfinite(actor.mass) else {}
    return {"material": actor.material, "fixed": actor.fixed, **mass}
