"""Unit quaternions (w, x, y, z), body -> world, and the rotation matrices they stand for."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

IDENTITY: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)


def matrix(quaternion: Sequence[float] | FloatArray) -> FloatArray:
    """Rotation matrix R, shape (3, 3), with v_world = R v_body, of a unit quaternion (w, x, y, z).

    Source: Diebel, "Representing Attitude" (2006), eq. 125, transposed because he maps world -> body.
    """
    w, x, y, z = (float(part) for part in quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def product(a: Sequence[float] | FloatArray, b: Sequence[float] | FloatArray) -> FloatArray:
    """The Hamilton product a b, shape (4,): turn by b first, then by a."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return np.array(
        [
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ]
    )


def from_z_to(direction: Sequence[float] | FloatArray) -> FloatArray:
    """The shortest turn, shape (4,), that takes the z axis into `direction` (any length but zero).

    Half-angle form q = (1 + z.d, z x d) normalised. For d = -z every axis in the xy plane is as short; x is
    taken.
    """
    d = np.asarray(direction, dtype=np.float64)
    d = d / np.linalg.norm(d)
    if d[2] < -1 + 1e-15:
        return np.array([0.0, 1.0, 0.0, 0.0])
    q = np.array([1 + d[2], -d[1], d[0], 0.0])
    unit: FloatArray = q / np.linalg.norm(q)
    return unit
