"""Reading of mesh files, and the checks that need nothing but the file.

A mesh file is foreign material: its size is bounded, nothing it names (material files, textures) is opened,
and whatever the reader raises becomes one sentence about that file.
"""

from __future__ import annotations

import hashlib
import io
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from physsim.model import polyhedron
from physsim.model.mesh_obj import read_obj
from physsim.model.mesh_text import geometry_only
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray
from physsim.model.trouble import ShapeTrouble

MAX_BYTES = 200_000_000
MAX_TRIANGLES = 1_000_000
"""Beyond this a mesh takes gigabytes and minutes before the first step."""

WELD = 1e-7
"""Vertices closer than this part of the mesh's size are one, when exact equality leaves gaps.

STL repeats every corner, and its 32-bit numbers carry an error of 6e-8 of the coordinate.
"""

FLAT = 1e-9
"""A closed surface whose volume is below this part of size^3 encloses nothing."""

FORMATS: Mapping[str, str] = MappingProxyType({".obj": "obj", ".stl": "stl", ".ply": "ply", ".off": "off"})


@dataclass(frozen=True)
class TriangleMesh:
    """A surface in units of its file.

    vertices (V, 3); triangles (T, 3), counter-clockwise seen from outside; open_edges: edges that do not join
    exactly two triangles of like winding (0: closed); dropped: triangles without area that were left out.
    """

    vertices: FloatArray
    triangles: IntArray
    open_edges: int
    dropped: int
    sha256: str

    @property
    def closed(self) -> bool:
        """Whether the surface has an inside."""
        return self.open_edges == 0

    def size(self) -> float:
        """Diagonal of the bounding box, in file units."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))


def read_mesh(path: Path) -> TriangleMesh:
    """The surface in a mesh file (OBJ, STL, PLY, OFF), welded, without empty triangles.

    Raises ShapeTrouble when the file is missing, too large, unreadable, empty, not finite, degenerate or
    inside out.
    """
    data = _read_bytes(path)
    vertices, triangles = _parsed(data, _format(path))
    if len(triangles) == 0:
        raise ShapeTrouble("is empty: it holds no triangle", key="file")
    _check_finite(vertices)
    return _cleaned(vertices, triangles, hashlib.sha256(data).hexdigest())


def read_points(path: Path) -> tuple[FloatArray, str]:
    """The vertices (V, 3) of a mesh file and its sha256, for a convex body: triangles may be missing or
    open.
    """
    data = _read_bytes(path)
    vertices, _ = _parsed(data, _format(path))
    _check_finite(vertices)
    return vertices, hashlib.sha256(data).hexdigest()


def _read_bytes(path: Path) -> bytes:
    try:
        size = path.stat().st_size
        if size > MAX_BYTES:
            raise ShapeTrouble(
                f"is too large: {size} bytes", key="file", allowed=f"at most {MAX_BYTES} bytes"
            )
        data = path.read_bytes()
    except FileNotFoundError:
        raise ShapeTrouble("does not exist", key="file", given=str(path)) from None
    except OSError as error:
        raise ShapeTrouble(f"cannot be read: {error.strerror}", key="file", given=str(path)) from None
    if not data:
        raise ShapeTrouble("is empty", key="file")
    return data


def _format(path: Path) -> str:
    kind = FORMATS.get(path.suffix.lower())
    if kind is None:
        raise ShapeTrouble(
            "is of no known mesh format", key="file", given=path.name, allowed=", ".join(FORMATS)
        )
    return kind


def _parsed(data: bytes, file_type: str) -> tuple[FloatArray, IntArray]:
    """Vertices (V, 3) and triangles (T, 3) as the file lists them, checked for shape and index range only."""
    try:
        if file_type == "obj":
            vertices, triangles = read_obj(data, MAX_TRIANGLES)
        else:
            vertices, triangles = _by_trimesh(geometry_only(data, file_type), file_type)
    except ShapeTrouble:
        raise
    except MemoryError:
        raise ShapeTrouble("needs more memory than there is", key="file") from None
    except Exception as error:  # the reader raises whatever a broken file makes it trip over
        raise ShapeTrouble(f"cannot be read as {file_type.upper()}: {_one_line(error)}", key="file") from None
    _check_count(triangles)
    if len(triangles) and (triangles.min() < 0 or triangles.max() >= len(vertices)):
        raise ShapeTrouble("names vertices that it does not have", key="file")
    return vertices, triangles


def _by_trimesh(data: bytes, file_type: str) -> tuple[FloatArray, IntArray]:
    import trimesh  # noqa: PLC0415  (0.3 s, needed by scenes with meshes only)

    loaded: Any = trimesh.load_mesh(
        io.BytesIO(data),
        file_type=file_type,
        process=False,
        validate=False,
        skip_materials=True,
        resolver=None,
    )
    vertices = np.array(getattr(loaded, "vertices", ()), dtype=np.float64).reshape(-1, 3)
    triangles = np.array(getattr(loaded, "faces", ()), dtype=np.int64).reshape(-1, 3)
    return vertices, np.clip(triangles, -1, 2**31 - 1).astype(np.int32)


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split()) or type(error).__name__
    return text if len(text) <= 120 else text[:117] + "..."


def _check_count(triangles: IntArray) -> None:
    if len(triangles) > MAX_TRIANGLES:
        raise ShapeTrouble(
            "has too many triangles",
            key="file",
            allowed=f"at most {MAX_TRIANGLES}",
            hint="simplify it in the program that made it",
        )


def _check_finite(vertices: FloatArray) -> None:
    if len(vertices) == 0:
        raise ShapeTrouble("is empty: it holds no vertex", key="file")
    bad = int((~np.isfinite(vertices)).any(axis=1).sum())
    if bad:
        raise ShapeTrouble(f"has {bad} vertices that are not finite numbers", key="file")
    if float(np.abs(vertices).max()) > 1e100:
        raise ShapeTrouble("has vertices farther out than 1e100 units", key="file")


def _cleaned(vertices: FloatArray, triangles: IntArray, sha256: str) -> TriangleMesh:
    size = float(np.linalg.norm(np.ptp(vertices[triangles.ravel()], axis=0)))
    if size == 0:
        raise ShapeTrouble("is degenerate: all its triangles lie in one point", key="file")
    mesh = _welded(vertices, triangles, vertices, sha256)
    if not mesh.closed:
        grid = np.round(vertices / (WELD * size))
        loose = _welded(vertices, triangles, grid, sha256)
        mesh = loose if loose.open_edges < mesh.open_edges else mesh
    _check_surface(mesh, size)
    return mesh


def _welded(vertices: FloatArray, triangles: IntArray, keys: FloatArray, sha256: str) -> TriangleMesh:
    """Vertices with equal `keys` become one; what has no triangle left is dropped."""
    _, first, inverse = np.unique(keys + 0.0, axis=0, return_index=True, return_inverse=True)
    joined = inverse.reshape(-1)[triangles]
    whole = (joined[:, 0] != joined[:, 1]) & (joined[:, 1] != joined[:, 2]) & (joined[:, 2] != joined[:, 0])
    used, renumbered = np.unique(joined[whole], return_inverse=True)
    kept = renumbered.reshape(-1, 3).astype(np.int32)
    return TriangleMesh(vertices[first[used]], kept, count_open_edges(kept), int((~whole).sum()), sha256)


def count_open_edges(triangles: IntArray) -> int:
    """Edges that are not passed exactly once in each direction: 0 for a closed surface of one winding."""
    if len(triangles) == 0:
        return 0
    start = triangles.astype(np.int64).ravel()
    end = triangles[:, [1, 2, 0]].astype(np.int64).ravel()
    width = int(triangles.max()) + 1
    low, high = np.minimum(start, end), np.maximum(start, end)
    _, which = np.unique(low * width + high, return_inverse=True)
    forward = np.bincount(which, weights=start < end)
    backward = np.bincount(which, weights=start > end)
    return int(((forward != 1) | (backward != 1)).sum())


def _check_surface(mesh: TriangleMesh, size: float) -> None:
    corners = mesh.vertices[mesh.triangles]
    if len(corners) == 0 or float(polyhedron.triangle_areas(corners).max()) <= 1e-14 * size**2:
        raise ShapeTrouble("is degenerate: none of its triangles has an area", key="file")
    if not mesh.closed:
        return
    volume = polyhedron.solid(mesh.vertices, mesh.triangles).mass
    if volume < -FLAT * size**3:
        raise ShapeTrouble(
            f"is inside out: its triangles run clockwise seen from outside (volume {volume:.6g})",
            key="file",
            hint="turn the faces (flip the normals) in the program that made it",
        )
