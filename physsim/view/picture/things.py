"""What the engine draws: meshes at their places, collected into the arrays that it takes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np

from physsim.view.shapes.mesh import Mesh
from physsim.view.stage import FloatArray


class Finish(IntEnum):
    """How a thing is painted; the numbers are the engine's."""

    PLAIN = 0
    QUARTERED = 1
    SIGN = 2


@dataclass(frozen=True)
class Extra:
    """A mesh in world axes [m], beside the bodies: colour (3) linear RGB."""

    mesh: Mesh
    colour: FloatArray
    finish: Finish = Finish.PLAIN


@dataclass(frozen=True)
class Cast:
    """Things that stay from picture to picture, in order: mesh (n) as index into `meshes`, colour (n, 3)
    linear RGB, finish (n), closed (n).
    """

    meshes: Sequence[Mesh]
    mesh: Sequence[int]
    colour: Sequence[FloatArray]
    finish: Sequence[Finish]
    closed: Sequence[bool]


def rows(cast: Cast, matrices: FloatArray, positions: FloatArray, extras: Sequence[Extra]) -> dict[str, Any]:
    """The engine's arrays of all things: the cast at `matrices` (n, 3, 3) and `positions` (n, 3), then the
    extras.
    """
    count, first = len(extras), len(cast.meshes)
    meshes = [*cast.meshes, *(extra.mesh for extra in extras)]
    return {
        "meshes": [(mesh.vertices, mesh.normals, mesh.triangles) for mesh in meshes],
        "mesh": np.array([*cast.mesh, *range(first, first + count)], np.int32),
        "matrix": np.concatenate([matrices, np.tile(np.eye(3), (count, 1, 1))]),
        "position": np.concatenate([positions, np.zeros((count, 3))]),
        "colour": np.array([*cast.colour, *(extra.colour for extra in extras)], np.float64).reshape(-1, 3),
        "finish": np.array([*cast.finish, *(extra.finish for extra in extras)], np.int32),
        "closed": np.array([*cast.closed, *[True] * count], np.int32),
    }


def closed(mesh: Mesh) -> bool:
    """Whether every edge of every triangle is also, the other way round, that of a neighbour."""
    _, merged = np.unique(mesh.vertices, axis=0, return_inverse=True)
    corners = merged.reshape(-1)[mesh.triangles].astype(np.int64)
    a, b = corners.reshape(-1), corners[:, [1, 2, 0]].reshape(-1)
    size = len(mesh.vertices)
    return bool(np.array_equal(np.sort(a * size + b), np.sort(b * size + a)))
