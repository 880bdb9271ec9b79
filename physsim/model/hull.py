"""Convex hulls as closed sets of convex polygons.

Qhull answers in triangles. A box face of two triangles would give the contact solver a false edge across
it, so neighbouring triangles in one plane are joined again.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray
from physsim.model.trouble import ShapeTrouble

PLANAR = 1e-6
"""Triangles are one face when their corners lie within this part of the hull's size of one plane.

STL files carry 6e-8 of rounding; a sphere of 20 000 triangles has neighbours that differ by 1e-4.
"""

THIN = 1e-7
"""A point set thinner than this part of its size is flat."""


@dataclass(frozen=True)
class Hull:
    """vertices (V, 3); faces: vertex numbers of convex polygons, counter-clockwise seen from outside."""

    vertices: FloatArray
    faces: tuple[tuple[int, ...], ...]

    def triangles(self) -> IntArray:
        """The faces as fans of triangles (T, 3)."""
        fans = [(face[0], face[i], face[i + 1]) for face in self.faces for i in range(1, len(face) - 1)]
        return np.array(fans, dtype=np.int32)


def convex_hull(points: FloatArray) -> Hull:
    """The convex hull of points (P, 3), coplanar triangles merged into polygons.

    Raises ShapeTrouble when the points do not span a volume.
    """
    size, middle = _extent(points)
    scaled = (points - middle) / size
    triangles = _qhull_triangles(scaled)
    faces = _merged(scaled, triangles)
    corners = _corner_vertices(faces)
    kept = [tuple(v for v in face if v in corners) for face in faces]
    numbers = {old: new for new, old in enumerate(sorted(corners))}
    return Hull(
        np.ascontiguousarray(points[sorted(corners)]),
        tuple(sorted(_rotated_to_smallest([numbers[v] for v in face]) for face in kept if len(face) >= 3)),
    )


def _extent(points: FloatArray) -> tuple[float, FloatArray]:
    if len(points) < 4:
        raise ShapeTrouble(f"spans no volume: {len(points)} points, a convex body needs 4 or more")
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    centred = points - points.mean(axis=0)
    if size == 0 or float(np.linalg.svd(centred, compute_uv=False)[2]) <= THIN * size * len(points) ** 0.5:
        raise ShapeTrouble("spans no volume: its points lie in one plane")
    return size, middle


def _qhull_triangles(points: FloatArray) -> npt.NDArray[np.int64]:
    """Hull triangles (T, 3), counter-clockwise seen from outside."""
    from scipy.spatial import ConvexHull, QhullError  # noqa: PLC0415  (0.2 s, needed by convex shapes only)

    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError) as error:
        first = str(error).strip().splitlines()[0]
        raise ShapeTrouble(f"has no convex hull: {first}") from None
    triangles: npt.NDArray[np.int64] = hull.simplices.astype(np.int64)
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ti,ti->t", normals, hull.equations[:, :3]) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return triangles


def _merged(points: FloatArray, triangles: npt.NDArray[np.int64]) -> list[tuple[int, ...]]:
    """Polygons, grown from the largest triangle over its neighbours as long as they stay in its plane."""
    corners = points[triangles]
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(doubled, axis=1)
    neighbours = _neighbours(triangles)
    free = set(range(len(triangles)))
    faces: list[tuple[int, ...]] = []
    for seed in np.argsort(-areas, kind="stable").tolist():
        if seed not in free:
            continue
        normal = doubled[seed] / max(float(areas[seed]), np.finfo(np.float64).tiny)
        plane = _Plane(corners[seed, 0], normal)
        region = _grown(seed, free, neighbours, lambda t, p=plane: p.holds(corners[t], doubled[t]))  # type: ignore[misc]
        loop = _boundary([triangles[t] for t in region])
        if loop is None or not _is_convex(points[list(loop)], normal):
            region, loop = [seed], tuple(triangles[seed].tolist())
        free.difference_update(region)
        faces.append(loop)
    return faces


@dataclass(frozen=True)
class _Plane:
    origin: FloatArray
    normal: FloatArray

    def holds(self, corners: FloatArray, doubled: FloatArray) -> bool:
        """Whether a triangle lies in the plane and looks the same way."""
        near = np.abs((corners - self.origin) @ self.normal).max() <= PLANAR
        return bool(near and doubled @ self.normal >= 0)


def _grown(
    seed: int, free: set[int], neighbours: dict[int, list[int]], fits: Callable[[int], bool]
) -> list[int]:
    """The free triangles connected to `seed` that fit."""
    region, waiting = {seed}, [seed]
    while waiting:
        for other in neighbours[waiting.pop()]:
            if other in free and other not in region and fits(other):
                region.add(other)
                waiting.append(other)
    return sorted(region)


def _neighbours(triangles: npt.NDArray[np.int64]) -> dict[int, list[int]]:
    by_edge: dict[tuple[int, int], list[int]] = defaultdict(list)
    for number, (a, b, c) in enumerate(triangles.tolist()):
        for start, end in ((a, b), (b, c), (c, a)):
            by_edge[min(start, end), max(start, end)].append(number)
    found: dict[int, list[int]] = defaultdict(list)
    for sharing in by_edge.values():
        for number in sharing:
            found[number].extend(other for other in sharing if other != number)
    return found


def _boundary(region: Sequence[npt.NDArray[np.int64]]) -> tuple[int, ...] | None:
    """The one loop around a set of triangles, or None when it is not one simple loop."""
    edges = {(int(t[i]), int(t[(i + 1) % 3])) for t in region for i in range(3)}
    follows = {start: end for start, end in edges if (end, start) not in edges}
    outline = sum((end, start) not in edges for start, end in edges)
    loop = [min(follows)] if follows else []
    while loop and follows[loop[-1]] != loop[0] and len(loop) <= outline:
        loop.append(follows[loop[-1]])
    return tuple(loop) if len(loop) == outline == len(follows) else None


def _is_convex(polygon: FloatArray, normal: FloatArray) -> bool:
    """Whether no corner bends inwards by more than the planarity tolerance."""
    ahead = np.roll(polygon, -1, axis=0) - polygon
    behind = polygon - np.roll(polygon, 1, axis=0)
    turns = np.cross(behind, ahead) @ normal
    lengths = np.linalg.norm(ahead, axis=1) + np.linalg.norm(behind, axis=1)
    return bool((turns >= -PLANAR * lengths).all())


def _corner_vertices(faces: Sequence[tuple[int, ...]]) -> set[int]:
    """Vertices in three faces or more: those in one or two lie inside a face or on an edge, by rounding
    only.
    """
    counts: dict[int, int] = defaultdict(int)
    for face in faces:
        for vertex in face:
            counts[vertex] += 1
    return {vertex for vertex, count in counts.items() if count >= 3}


def _rotated_to_smallest(face: Sequence[int]) -> tuple[int, ...]:
    start = face.index(min(face))
    return tuple(face[start:]) + tuple(face[:start])
