"""Normals of a triangle mesh: smooth where its faces meet softly, split where they meet at an edge."""

from __future__ import annotations

import numpy as np

from physsim.view.shapes.mesh import Mesh
from physsim.view.stage import FloatArray, IntArray

CREASE = np.cos(np.radians(30.0))
"""Faces whose normals differ by more than 30 degrees meet at an edge that is seen: the 24-sided prism that
stands for a cylinder stays smooth (15 degrees), a hexagonal nut keeps its edges (60)."""


def creased(vertices: FloatArray, triangles: IntArray) -> Mesh:
    """The mesh with a vertex for every smooth part around each point.

    Two faces are of one part at a point when a chain of soft edges that end there joins them. The normal of
    a part is the mean of its faces' normals weighted by their angles at the point (Thürmer and Wüthrich,
    "Computing vertex normals from polygonal facets", 1998): how a flat face is cut into triangles does not
    count. Points that several vertices share count as one.
    """
    points, merged = np.unique(vertices, axis=0, return_inverse=True)
    corners = merged.reshape(-1)[triangles].astype(np.int32)
    faces = _face_normals(points, corners)
    parts = _smooth_parts(corners, faces)
    first, of_corner = np.unique(parts, return_index=True, return_inverse=True)[1:]
    weighted = (_angles(points, corners)[..., None] * faces[:, None]).reshape(-1, 3)
    sums = np.zeros((len(first), 3))
    np.add.at(sums, of_corner, weighted)
    return Mesh(points[corners.reshape(-1)[first]], _unit(sums), of_corner.reshape(-1, 3).astype(np.int32))


def _smooth_parts(corners: IntArray, faces: FloatArray) -> IntArray:
    """A number per corner (3 T), the same for the corners of one point that are smooth with each other."""
    a, b = _across_soft_edges(corners, faces)
    labels = np.arange(corners.size, dtype=np.int32)
    while True:
        lower = np.minimum(labels[a], labels[b])
        if (labels[a] == lower).all() and (labels[b] == lower).all():
            return labels
        np.minimum.at(labels, a, lower)
        np.minimum.at(labels, b, lower)
        labels = labels[labels]


def _across_soft_edges(corners: IntArray, faces: FloatArray) -> tuple[IntArray, IntArray]:
    """Pairs of corners at the same point, of the two faces beside a soft edge."""
    count = len(corners)
    start = np.arange(3 * count)
    end = start + 1 - 3 * (start % 3 == 2)  # the next corner of the same triangle
    point = corners.reshape(-1)
    low, high = np.minimum(point[start], point[end]), np.maximum(point[start], point[end])
    order = np.lexsort((high, low))
    same = (low[order[1:]] == low[order[:-1]]) & (high[order[1:]] == high[order[:-1]])
    one, other = order[:-1][same], order[1:][same]
    soft = np.einsum("ij,ij->i", faces[one // 3], faces[other // 3]) > CREASE
    one, other = one[soft], other[soft]
    turned = point[start[one]] != point[start[other]]
    first, second = np.where(turned, end[other], start[other]), np.where(turned, start[other], end[other])
    return np.concatenate([start[one], end[one]]), np.concatenate([first, second])


def _face_normals(points: FloatArray, corners: IntArray) -> FloatArray:
    a, b, c = (points[corners[:, k]] for k in range(3))
    return _unit(np.cross(b - a, c - a))


def _angles(points: FloatArray, corners: IntArray) -> FloatArray:
    """The angle [rad] of every triangle at each of its corners, (T, 3)."""
    at = points[corners]
    ahead, back = np.roll(at, -1, axis=1) - at, np.roll(at, 1, axis=1) - at
    across = np.linalg.norm(np.cross(ahead, back), axis=-1)
    angles: FloatArray = np.arctan2(across, np.einsum("tkx,tkx->tk", ahead, back))
    return angles


def _unit(vectors: FloatArray) -> FloatArray:
    """Of length 1; z where there is no direction, as of a triangle without area."""
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    unit: FloatArray = np.where(size > 0, vectors / np.where(size > 0, size, 1), [0.0, 0.0, 1.0])
    return unit
