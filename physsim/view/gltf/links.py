"""Springs and strings in a glTF file: a coil that stretches, and a thin bar for a distance joint."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from physsim.recording import Trajectory
from physsim.recording.orientation import rotated
from physsim.view.gltf import axes as gltf_axes
from physsim.view.gltf.keyframes import shift
from physsim.view.gltf.motion import Rows, Track, rotations, translations
from physsim.view.gltf.nodes import Figures, pose
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.revolved import cylinder
from physsim.view.stage import WORLD, FloatArray, IntArray, Link, Stage

COIL_THICKNESS = 0.06
"""Radius of a coil, as a part of its length at the start."""
BAR_THICKNESS = 0.005
TURNS, PER_TURN, AROUND_WIRE = 10, 16, 6
WIRE = 0.15
"""Radius of the wire, as a part of the coil's."""


def drawn_links(stage: Stage) -> list[Link]:
    """Springs that pull and joints that keep a distance: all that is between two anchors."""
    return [link for link in (*stage.springs, *stage.joints) if link.kind in LOOKS]


def held_at(links: Sequence[Link]) -> FloatArray:
    """Where links end in the world, (K, 3) [m]."""
    ends = [link.anchors[end] for link in links for end in (0, 1) if link.bodies[end] == WORLD]
    return np.reshape(ends, (-1, 3))


def break_times(trajectory: Trajectory, links: Sequence[Link]) -> FloatArray:
    """When each of the links (L) breaks [s]; infinite for those that hold."""
    found = np.full(len(links), np.inf)
    if not trajectory.has("joints/broken"):
        return found
    ended = trajectory.series("joints/broken")[-1]
    for row, name in enumerate(trajectory.joint_names):
        if ended[row]:
            first = np.argmax(trajectory.series("joints/broken", row)[:])
            found[[link.name == name and link.kind == "distance" for link in links]] = trajectory.time[first]
    return found


class LinkMover:
    """Links as nodes (L): from anchor A, turned and stretched along z to anchor B, tolerance in m.

    A node does not twist: from one direction to the next it turns the shortest way. first: the poses of all
    bodies at the start, (N, 3) [m] and (N, 4). broken (L): when each breaks [s]; from then on it has no
    thickness.
    """

    def __init__(
        self,
        links: Sequence[Link],
        nodes: Rows,
        first: tuple[FloatArray, FloatArray],
        tolerance: float,
        broken: FloatArray,
    ) -> None:
        self._links, self._broken = links, broken
        positions, orientations = (values[None] for values in first)
        ahead = self._ends(positions, orientations, 1)[0] - self._ends(positions, orientations, 0)[0]
        lengths: FloatArray = np.linalg.norm(ahead, axis=1)
        self._thickness = lengths * [LOOKS[link.kind].thickness for link in links]
        self._direction = np.broadcast_to([0.0, 0.0, 1.0], ahead.shape)
        self._orientation = np.broadcast_to([1.0, 0.0, 0.0, 0.0], (len(links), 4))
        share = np.full(len(links), tolerance / 4)
        self.tracks = [
            translations(nodes, share),
            rotations(nodes, np.divide(share, lengths, out=share.copy(), where=lengths > 0)),
            Track("scale", nodes, share, np.full(len(nodes), np.inf), shift, gltf_axes.scales, width=3),
        ]
        self.first = self.values(np.array([-np.inf]), positions, orientations)

    def values(
        self, times: FloatArray, positions: FloatArray, orientations: FloatArray
    ) -> Sequence[FloatArray]:
        first = self._ends(positions, orientations, 0)
        ahead = self._ends(positions, orientations, 1) - first
        lengths = np.linalg.norm(ahead, axis=-1, keepdims=True)
        wide = np.where(times[:, None] < self._broken, self._thickness, 0.0)[..., None]
        turned = np.stack([self._turned(*step) for step in zip(ahead, lengths, strict=True)])
        return [first, turned, np.concatenate([wide, wide, lengths], axis=-1)]

    def _ends(self, positions: FloatArray, orientations: FloatArray, end: int) -> FloatArray:
        """Where the anchors are in the world, (m, L, 3)."""
        bodies = np.array([link.bodies[end] for link in self._links])
        anchors = np.broadcast_to(
            [link.anchors[end] for link in self._links], (len(positions), len(bodies), 3)
        )
        turns = rotated(orientations[:, bodies].reshape(-1, 4), anchors.reshape(-1, 3)).reshape(anchors.shape)
        return np.where((bodies == WORLD)[:, None], anchors, positions[:, bodies] + turns)

    def _turned(self, ahead: FloatArray, lengths: FloatArray) -> FloatArray:
        """The orientations (L, 4) at the next instant; a link without length keeps its direction."""
        direction = np.divide(ahead, lengths, out=self._direction.copy(), where=lengths > 0)
        self._orientation = product(shortest_turn(self._direction, direction), self._orientation)
        self._direction = direction
        return self._orientation


def shortest_turn(first: FloatArray, second: FloatArray) -> FloatArray:
    """Quaternions (L, 4) that take unit vectors (L, 3) into others: (1 + a·b, a x b) made unit; half a turn
    about an axis across where they are opposite.
    """
    cosine = np.einsum("ri,ri->r", first, second)[:, None]
    across = np.cross(first, np.where(np.abs(first[:, :1]) < 0.9, [[1.0, 0, 0]], [[0, 1.0, 0]]))
    opposite = cosine < -1 + 1e-12
    raw = np.concatenate(
        [np.where(opposite, 0, 1 + cosine), np.where(opposite, across, np.cross(first, second))], axis=1
    )
    unit: FloatArray = raw / np.linalg.norm(raw, axis=1, keepdims=True)
    return unit


def product(a: FloatArray, b: FloatArray) -> FloatArray:
    """Hamilton products (L, 4): turn by b first, then by a."""
    scalar = a[:, :1] * b[:, :1] - np.einsum("ri,ri->r", a[:, 1:], b[:, 1:])[:, None]
    vector = a[:, :1] * b[:, 1:] + b[:, :1] * a[:, 1:] + np.cross(a[:, 1:], b[:, 1:])
    return np.concatenate([scalar, vector], axis=1)


def link_nodes(
    links: Sequence[Link], meshes: Mapping[str, int], values: Sequence[FloatArray]
) -> list[dict[str, Any]]:
    """A node for each, at the values (1, L, k) of its tracks. meshes: the number of the mesh of each kind."""
    first = (track[0] for track in values)
    return [
        pose(position, orientation)
        | {
            "name": link.name,
            "mesh": meshes[link.kind],
            "scale": gltf_axes.numbers(gltf_axes.scales(scale)),
            "extras": {"type": link.kind},
        }
        for link, position, orientation, scale in zip(links, *first, strict=True)
    ]


def link_meshes(links: Sequence[Link], figures: Figures, first: int) -> dict[str, int]:
    """The number of the mesh of each kind that there is; their shapes are numbered from `first`."""
    kinds = [kind for kind in LOOKS if any(link.kind == kind for link in links)]
    return {
        kind: figures.plain(first + number, LOOKS[kind].name, LOOKS[kind].colour)
        for number, kind in enumerate(kinds)
    }


def bar() -> Mesh:
    """Radius 1, z from 0 to 1."""
    mesh = cylinder(AROUND_WIRE * 2)
    return Mesh(mesh.vertices * [1, 1, 0.5] + [0, 0, 0.5], mesh.normals, mesh.triangles)


def coil() -> Mesh:
    """A helix of radius 1, z from 0 to 1, of a wire that is round when the coil is stretched by its thickness
    across and by 1 along.
    """
    along = np.linspace(0, 1, TURNS * PER_TURN + 1)[:, None]
    angle = 2 * np.pi * TURNS * along
    round_wire = 2 * np.pi * np.arange(AROUND_WIRE) / AROUND_WIRE
    outward = np.cos(round_wire) * np.ones_like(along)
    upward = np.sin(round_wire) * np.ones_like(along)
    wide = 1 - WIRE + WIRE * outward
    height = along + (WIRE * COIL_THICKNESS) * upward
    vertices = np.stack([wide * np.cos(angle), wide * np.sin(angle), height], axis=-1)
    normals = np.stack(
        [COIL_THICKNESS * outward * np.cos(angle), COIL_THICKNESS * outward * np.sin(angle), upward], axis=-1
    )
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return Mesh(vertices.reshape(-1, 3), normals.reshape(-1, 3), _tube(len(along)))


def _tube(rings: int) -> IntArray:
    """Triangles between neighbouring rings of `AROUND_WIRE` vertices, and over both ends."""
    here = np.arange(AROUND_WIRE)
    ahead = np.roll(here, -1)
    start = AROUND_WIRE * np.arange(rings - 1)[:, None]
    a, b = start + here, start + ahead
    c, d = a + AROUND_WIRE, b + AROUND_WIRE
    side = np.concatenate([np.stack([a, c, b], axis=-1), np.stack([b, c, d], axis=-1)]).reshape(-1, 3)
    fan = np.stack([np.zeros(AROUND_WIRE - 2), here[1:-1], here[2:]], axis=-1).astype(np.intp)
    last = AROUND_WIRE * (rings - 1) + fan[:, ::-1]
    return np.concatenate([side, fan, last]).astype(np.int32)


@dataclass(frozen=True)
class Look:
    """How a kind of link is drawn: name and colour of its material, its mesh, and its radius as a part of its
    length at the start.
    """

    name: str
    colour: str
    mesh: Callable[[], Mesh]
    thickness: float


LOOKS = {
    "linear": Look("spring", "#8c8c8c", coil, COIL_THICKNESS),
    "distance": Look("string", "#4d4d4d", bar, BAR_THICKNESS),
}
