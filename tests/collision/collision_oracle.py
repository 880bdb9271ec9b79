"""The depth of two overlapping convex shapes by brute force: no GJK, no FCL, only support points.

The depth is the least overlap over all directions. Many directions are tried, among them those of all faces
and of all crossings of edges, where polytopes have their minima, and the best are refined by a shrinking
random search.
"""

from __future__ import annotations

import numpy as np
from collision_shapes import Floats, Thing, depth_along, rotation

SPREAD = 1500
STARTS = 6
ITERATIONS = 400


def true_depth(a: Thing, pose_a: Floats, b: Thing, pose_b: Floats, known: Floats) -> tuple[float, Floats]:
    """Depth [m] and direction (from B to A); `known` is one more direction to start from."""
    flats = np.concatenate(
        [known[None], _faces(a, pose_a), _faces(b, pose_b), _crossings(_edges(a, pose_a), _edges(b, pose_b))]
    )
    candidates = np.concatenate([_spiral(SPREAD), flats, -flats])
    depths = depth_along(a, pose_a, b, pose_b, candidates)
    normals = _distinct(candidates[np.argsort(depths)[:300]])
    normals, depths = _refined(lambda n: depth_along(a, pose_a, b, pose_b, n), normals)
    best = int(np.argmin(depths))
    return float(depths[best]), normals[best]


def _spiral(count: int) -> Floats:
    i = np.arange(count) + 0.5
    z = 1.0 - 2.0 * i / count
    turn = np.pi * (1.0 + 5.0**0.5) * i
    return np.stack([np.sqrt(1.0 - z * z) * np.cos(turn), np.sqrt(1.0 - z * z) * np.sin(turn), z], axis=1)


def _distinct(directions: Floats) -> Floats:
    chosen: list[Floats] = []
    for direction in directions:
        if len(chosen) < STARTS and all(direction @ other < 0.995 for other in chosen):
            chosen.append(direction)
    return np.array(chosen)


def _refined(depth, normals: Floats) -> tuple[Floats, Floats]:
    """Twelve directions on a shrinking, randomly turned circle around each normal; the best one moves on."""
    rng = np.random.default_rng(0)
    count = len(normals)
    depths, radius, failures = depth(normals), np.full(count, 0.05), np.zeros(count, dtype=int)
    for _ in range(ITERATIONS):
        if radius.max() < 1e-11:
            break
        angles = np.arange(12) * np.pi / 6 + rng.uniform(0.0, np.pi, (count, 1))
        u, v = _tangents(normals)
        ring = np.cos(angles)[..., None] * u[:, None] + np.sin(angles)[..., None] * v[:, None]
        tried = normals[:, None] + radius[:, None, None] * ring
        tried /= np.linalg.norm(tried, axis=2, keepdims=True)
        values = depth(tried.reshape(-1, 3)).reshape(count, 12)
        pick = values.argmin(axis=1)
        better = values[np.arange(count), pick] < depths
        normals = np.where(better[:, None], tried[np.arange(count), pick], normals)
        depths = np.where(better, values[np.arange(count), pick], depths)
        failures = np.where(better, 0, failures + 1)
        radius = np.where(better, 1.3 * radius, np.where(failures >= 2, 0.4 * radius, radius))
        failures[failures >= 2] = 0
    return normals, depths


def _tangents(normals: Floats) -> tuple[Floats, Floats]:
    helper = np.where(np.abs(normals[:, :1]) < 0.6, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    u = np.cross(normals, helper)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    return u, np.cross(normals, u)


def _faces(thing: Thing, pose: Floats) -> Floats:
    """Normals of flat faces, world."""
    if thing.vertices is not None:
        a, b, c = (thing.vertices[thing.triangles[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
    else:
        normals = np.eye(3)
    return normals @ rotation(pose[3:]).T / np.linalg.norm(normals, axis=1, keepdims=True)


def _edges(thing: Thing, pose: Floats) -> Floats:
    """Directions of straight edges, world."""
    if thing.vertices is not None:
        corners = thing.vertices[thing.triangles]
        edges = (corners - np.roll(corners, 1, axis=1)).reshape(-1, 3)
    else:
        edges = np.eye(3)
    return edges @ rotation(pose[3:]).T / np.linalg.norm(edges, axis=1, keepdims=True)


def _crossings(edges_a: Floats, edges_b: Floats) -> Floats:
    crossed = np.cross(edges_a[:, None], edges_b[None]).reshape(-1, 3)
    length = np.linalg.norm(crossed, axis=1)
    return crossed[length > 1e-9] / length[length > 1e-9, None]
