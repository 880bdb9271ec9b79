"""How large things are, and where they go: what the ground, a camera and tolerances are made to fit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from physsim.recording.orientation import rotation_matrices
from physsim.view.clip import Clip
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.tessellate import Placed
from physsim.view.stage import FloatArray, Stage

LOOKED_AT = 200
"""The way of the bodies is taken from at most so many instants, evenly chosen."""


def radii(stage: Stage, meshes: Sequence[Mesh], placed: Sequence[Placed]) -> FloatArray:
    """Of each body the distance [m] of its farthest drawn point from its origin, (N); 0 for a half-space."""
    found = np.zeros(len(stage.actors))
    for one in placed:
        solid = stage.solids[one.solid]
        if solid.kind != "halfspace":
            middle = rotation_matrices(solid.orientation[None])[0].T @ solid.position
            farthest = np.linalg.norm(meshes[one.mesh].vertices * one.scale + middle, axis=1).max()
            found[solid.body] = max(found[solid.body], farthest)
    return found


def bounds(clip: Clip, around: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The corners (3) and (3) [m] of the box that holds the bodies of radius `around` (N) [m] on their way,
    and `points` (K, 3) [m]. Bodies without size do not count; when there are no others, it is a cube about
    the origin.
    """
    bodies = np.flatnonzero(around > 0)
    if bodies.size == 0:
        return -np.ones(3), np.ones(3)
    chosen = np.unique(np.linspace(0, len(clip.times) - 1, min(LOOKED_AT, len(clip.times))).astype(int))
    reach = around[bodies, None]
    lows, highs = list(points), list(points)
    for _, positions, _ in Clip(clip.trajectory, clip.times[chosen]).blocks():
        lows.append((positions[:, bodies] - reach).min(axis=(0, 1)))
        highs.append((positions[:, bodies] + reach).max(axis=(0, 1)))
    return np.min(lows, axis=0), np.max(highs, axis=0)
