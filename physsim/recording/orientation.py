"""Unit quaternions (w, x, y, z), body to world, of many bodies or frames at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Below this angle between two orientations a straight line and the arc are the same to rounding.
STRAIGHT = 1e-6


def rotation_matrices(q: Floats) -> Floats:
    """R (N, 3, 3) of unit quaternions (N, 4), scalar first, body to world: v = R v_body.

    R = (w² - u·u) 1 + 2 u uᵀ + 2 w [u]×, u the vector part; Diebel, "Representing Attitude" (2006), eq. 125.
    """
    w, u = q[:, 0], q[:, 1:]
    cross = np.zeros((len(q), 3, 3))
    cross[:, [2, 0, 1], [1, 2, 0]] = u
    cross[:, [1, 2, 0], [2, 0, 1]] = -u
    diagonal = (w**2 - (u**2).sum(axis=1))[:, None, None] * np.eye(3)
    rotation: Floats = diagonal + 2 * u[:, :, None] * u[:, None, :] + 2 * w[:, None, None] * cross
    return rotation


def rotated(q: Floats, vectors: Floats) -> Floats:
    """Vectors (N, 3) or one (3), given in body axes, in world axes, (N, 3)."""
    turned: Floats = np.einsum("nij,nj->ni", rotation_matrices(q), np.broadcast_to(vectors, (len(q), 3)))
    return turned


def between(first: Floats, second: Floats, fraction: Floats) -> Floats:
    """Orientations (N, 4) on the shorter arc from `first` to `second`, both (N, 4), at `fraction` (N) of it.

    Slerp: (sin((1-f) a) p + sin(f a) q) / sin a, cos a = p·q; Shoemake, "Animating Rotation with Quaternion
    Curves" (1985), section 3.3.
    """
    cosine = np.einsum("ni,ni->n", first, second)
    second = np.where(cosine[:, None] < 0, -second, second)
    angle = np.arccos(np.clip(np.abs(cosine), 0.0, 1.0))
    straight = angle < STRAIGHT
    sine = np.where(straight, 1.0, np.sin(angle))
    p = np.where(straight, 1 - fraction, np.sin((1 - fraction) * angle) / sine)
    q = np.where(straight, fraction, np.sin(fraction * angle) / sine)
    mixed = p[:, None] * first + q[:, None] * second
    return np.asarray(mixed / np.linalg.norm(mixed, axis=1, keepdims=True), np.float64)
