"""Triangles of a convex surface -> its flat faces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from physsim.model.rotation import FloatArray

PLANAR = 1e-6
"""Triangles are one face when their corners lie within this distance of one plane, for a hull of size 1.

STL files carry 6e-8 of rounding; a sphere of 20 000 triangles has neighbours that differ by 1e-4.
"""

_SLACK = 10
"""Neighbours farther apart than this many `PLANAR` are not even tried; a long thin one may seem so far."""

Triangles = npt.NDArray[np.int64]


def merged_faces(points: FloatArray, triangles: Triangles) -> list[tuple[int, ...]]:
    """Polygons of the closed convex surface `triangles` (T, 3), counter-clockwise from outside like them.

    A face grows from the largest triangle over its neighbours as long as they stay in the plane of that first
    one, so that no error adds up. A set that is not one convex loop is left as triangles.
    """
    surface = _Surface(points, triangles)
    free = set(range(len(triangles)))
    faces: list[tuple[int, ...]] = []
    for seed in np.argsort(-surface.areas, kind="stable").tolist():
        if seed in free:
            region = surface.plane_around(seed, free)
            loop = _boundary(triangles[region].tolist()) if len(region) > 1 else None
            if loop is None or not _is_convex(points[list(loop)], surface.normal(seed)):
                region, loop = [seed], tuple(triangles[seed].tolist())
            free.difference_update(region)
            faces.append(loop)
    return faces


class _Surface:
    """corners (T, 3, 3) and doubled (T, 3), normals with the length of twice the area."""

    def __init__(self, points: FloatArray, triangles: Triangles) -> None:
        self.corners = points[triangles]
        edges = self.corners[:, 1:] - self.corners[:, :1]
        self.doubled = np.cross(edges[:, 0], edges[:, 1])
        self.areas = np.linalg.norm(self.doubled, axis=1)
        self.neighbours = self._near_neighbours(triangles)

    def normal(self, triangle: int) -> FloatArray:
        """Unit normal; zero for a triangle without area."""
        unit: FloatArray = self.doubled[triangle] / max(self.areas[triangle], np.finfo(np.float64).tiny)
        return unit

    def plane_around(self, seed: int, free: set[int]) -> list[int]:
        """The free triangles connected to `seed` that lie in its plane and look the same way."""
        normal, origin = self.normal(seed), self.corners[seed, 0]
        region, waiting = {seed}, [seed]
        while waiting:
            for other in self.neighbours.get(waiting.pop(), ()):
                if other not in free or other in region or self.doubled[other] @ normal < 0:
                    continue
                if np.abs((self.corners[other] - origin) @ normal).max() <= PLANAR:
                    region.add(other)
                    waiting.append(other)
        return sorted(region)

    def _near_neighbours(self, triangles: Triangles) -> dict[int, list[int]]:
        """Triangles across an edge that could lie in one plane, judged by the plane of the larger one."""
        a, b = _across_edges(triangles)
        swap = self.areas[a] < self.areas[b]
        large, small = np.where(swap, b, a), np.where(swap, a, b)
        away = self.corners[small] - self.corners[large, :1]
        distances = np.abs(np.einsum("eci,ei->ec", away, self.doubled[large])).max(axis=1)
        near = distances <= _SLACK * PLANAR * self.areas[large]
        found: dict[int, list[int]] = {}
        for one, other in zip(large[near].tolist(), small[near].tolist(), strict=True):
            found.setdefault(one, []).append(other)
            found.setdefault(other, []).append(one)
        return found


def _across_edges(triangles: Triangles) -> tuple[Triangles, Triangles]:
    """Pairs of triangles that share an edge; the surface is closed, so every edge has two."""
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    codes = np.minimum(start, end) * (triangles.max() + 1) + np.maximum(start, end)
    order = np.argsort(codes, kind="stable")
    same = codes[order][:-1] == codes[order][1:]
    owners = order // 3
    return owners[:-1][same], owners[1:][same]


def _boundary(region: Sequence[Sequence[int]]) -> tuple[int, ...] | None:
    """The one loop around a set of triangles, or None when it is not one simple loop."""
    edges = {(t[i], t[(i + 1) % 3]) for t in region for i in range(3)}
    outline = [(start, end) for start, end in edges if (end, start) not in edges]
    follows = dict(outline)
    loop = [min(follows)] if follows else []
    while loop and follows[loop[-1]] != loop[0] and len(loop) <= len(outline):
        loop.append(follows[loop[-1]])
    return tuple(loop) if len(loop) == len(outline) == len(follows) else None


def _is_convex(polygon: FloatArray, normal: FloatArray) -> bool:
    """Whether no corner bends inwards by more than the planarity tolerance."""
    ahead = np.roll(polygon, -1, axis=0) - polygon
    behind = polygon - np.roll(polygon, 1, axis=0)
    turns = np.cross(behind, ahead) @ normal
    lengths = np.linalg.norm(ahead, axis=1) + np.linalg.norm(behind, axis=1)
    return bool((turns >= -PLANAR * lengths).all())
