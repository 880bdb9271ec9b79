"""Convex hulls as closed sets of convex polygons.

Qhull answers in triangles. A box face of two triangles would give the contact solver a false edge across
it, so neighbouring triangles in one plane are joined again.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.model.coplanar import merged_faces
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray
from physsim.model.trouble import ShapeTrouble

MAX_TRIANGLES = 50_000
"""Qhull's triangles; a hull with more corners than half of that would take the solver's whole day."""

THIN = 2e-6
"""A point set whose spread across is below this part of its size is flat: twice the `PLANAR` of faces, or
both sides of a foil would be one face.
"""


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
    if len(triangles) > MAX_TRIANGLES:
        raise ShapeTrouble(
            f"has a convex hull of {len(triangles)} triangles",
            allowed=f"at most {MAX_TRIANGLES}",
            hint="simplify it; a few hundred are plenty for contacts",
        )
    faces = merged_faces(scaled, triangles)
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
