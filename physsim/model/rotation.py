"""Unit quaternions (w, x, y, z), body -> world, and the rotation matrices they stand for."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, hypot, sin

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

    By the angle atan2(|z x d|, z.d) about z x d, which keeps its digits near d = -z, where the form
    (1 + z.d, z x d) loses them. For d = -z every axis in the xy plane is as short; x is taken.
    """
    x, y, z = (float(part) for part in direction)
    across = hypot(x, y)
    half = atan2(across, z) / 2
    axis = (-y / across, x / across) if across > 1e-150 else (1.0, 0.0)  # below it the quotients lose digits
    return np.array([cos(half), sin(half) * axis[0], sin(half) * axis[1], 0.0])


def conjugate(quaternion: Sequence[float] | FloatArray) -> FloatArray:
    """The inverse of a unit quaternion, shape (4,): world -> body for body -> world."""
    w, x, y, z = (float(part) for part in quaternion)
    return np.array([w, -x, -y, -z])


def from_axes(z: Sequence[float] | FloatArray, x: Sequence[float] | FloatArray) -> FloatArray:
    """The turn, shape (4,), that takes the z axis into `z` and the x axis as near to `x` as that allows.

    Lengths do not count; `x` must not be parallel to `z`. First z the shortest way, then about z by the angle
    that is left, atan2 of what `x` is along the turned y and x axes.
    """
    first = from_z_to(z)
    toward = matrix(first).T @ np.asarray(x, dtype=np.float64)
    half = atan2(toward[1], toward[0]) / 2
    return product(first, (cos(half), 0.0, 0.0, sin(half)))
