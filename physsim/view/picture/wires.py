"""Meshes of what is drawn beside the solids: tubes, coils, arrows."""

from __future__ import annotations

import numpy as np

from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.revolved import cone, cylinder, sphere
from physsim.view.stage import FloatArray

SIDES = 8
TURNS = 9
POINTS_A_TURN = 14
STRAIGHT_PART = 0.12
"""A coil has a straight end of this part of its length on both sides."""


def tube(points: FloatArray, radius: float, sides: int = SIDES) -> Mesh:
    """A round tube along points (k, 3) [m], k at least 2, open at its ends."""
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
    across = _carried(along)
    other = np.cross(along, across)
    angles = 2 * np.pi * np.arange(sides) / sides
    normals = np.cos(angles)[:, None] * across[:, None] + np.sin(angles)[:, None] * other[:, None]
    ring, side = np.meshgrid(np.arange(len(points) - 1), np.arange(sides), indexing="ij")
    a, b = ring * sides + side, ring * sides + (side + 1) % sides
    quads = np.stack([a, b, b + sides, a, b + sides, a + sides], axis=-1)
    return Mesh(
        (points[:, None] + radius * normals).reshape(-1, 3),
        normals.reshape(-1, 3),
        quads.reshape(-1, 3).astype(np.int32),
    )


def _carried(along: FloatArray) -> FloatArray:
    """Unit vectors across a curve that turn about it as little as can be: each is the one before without its
    part along the curve.
    """
    across = np.empty_like(along)
    last = across_one(along[0])
    for k, tangent in enumerate(along):
        kept = last - (last @ tangent) * tangent
        length = np.linalg.norm(kept)
        last = kept / length if length > 1e-9 else across_one(tangent)
        across[k] = last
    return across


def across_one(direction: FloatArray) -> FloatArray:
    """A unit vector across another (3)."""
    least = np.eye(3)[np.argmin(np.abs(direction))]
    found = np.cross(direction, least)
    return np.asarray(found / max(float(np.linalg.norm(found)), 1e-300))


def coil(ends: FloatArray, radius: float, wire: float) -> Mesh:
    """A coil spring between two ends (2, 3) [m]: coil and wire of these radii [m]."""
    along = ends[1] - ends[0]
    length = float(np.linalg.norm(along))
    if length <= 0:
        return tube(ends + np.array([[0, 0, 0], [0, 0, 1e-9]]), wire)
    axis = along / length
    across = across_one(axis)
    other = np.cross(axis, across)
    part = np.linspace(0, 1, TURNS * POINTS_A_TURN + 1)
    angle = 2 * np.pi * TURNS * part
    rise = np.minimum(1, np.minimum(part, 1 - part) * TURNS)  # from the axis out, over one turn
    place = STRAIGHT_PART + (1 - 2 * STRAIGHT_PART) * part
    turns = (
        ends[0]
        + place[:, None] * along
        + (rise * radius * np.cos(angle))[:, None] * across
        + (rise * radius * np.sin(angle))[:, None] * other
    )
    return tube(np.vstack([ends[0], turns, ends[1]]), wire, sides=6)


def spiral(middle: FloatArray, axis: FloatArray, radius: float, wire: float) -> Mesh:
    """A flat spiral about an axis (3): the sign of a torsional spring."""
    across = across_one(axis)
    other = np.cross(axis, across)
    angle = np.linspace(0, 5 * np.pi, 70)
    away = radius * (0.2 + 0.8 * angle / angle[-1])
    points = middle + (away * np.cos(angle))[:, None] * across + (away * np.sin(angle))[:, None] * other
    return tube(points, wire, sides=6)


def ball(middle: FloatArray, radius: float) -> Mesh:
    """A ball [m]."""
    unit = sphere(20)
    return Mesh(middle + radius * unit.vertices, unit.normals, unit.triangles)


def pin(middle: FloatArray, axis: FloatArray, length: float, radius: float) -> Mesh:
    """A cylinder [m] about its middle."""
    return _placed(cylinder(20), middle, axis, np.array([radius, radius, length / 2]))


def arrow(start: FloatArray, vector: FloatArray, radius: float) -> Mesh:
    """An arrow from `start` along `vector` (3) [m], its shaft of this radius."""
    length = float(np.linalg.norm(vector))
    axis = vector / max(length, 1e-300)
    head = min(6 * radius, length)
    shaft = pin(start + axis * (length - head) / 2, axis, max(length - head, 1e-9), radius)
    tip = _placed(
        cone(20), start + axis * (length - 0.75 * head), axis, np.array([2.4 * radius, 2.4 * radius, head])
    )
    return joined([shaft, tip])


def joined(meshes: list[Mesh]) -> Mesh:
    """Several meshes as one."""
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    return Mesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts, strict=False)]).astype(
            np.int32
        ),
    )


def _placed(unit: Mesh, middle: FloatArray, axis: FloatArray, scale: FloatArray) -> Mesh:
    """A mesh about z, stretched and turned to an axis (3)."""
    unit_axis = axis / max(float(np.linalg.norm(axis)), 1e-300)
    across = across_one(unit_axis)
    turn = np.column_stack([across, np.cross(unit_axis, across), unit_axis])
    normals = unit.normals / scale
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Mesh(middle + (unit.vertices * scale) @ turn.T, normals @ turn.T, unit.triangles)
