"""How large things are, and where they go: what the ground, a camera and tolerances are made to fit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from physsim.recording.orientation import rotated
from physsim.view.clip import Clip
from physsim.view.mesh import Mesh
from physsim.view.stage import FloatArray, Stage
from physsim.view.tessellate import Placed

LOOKED_AT = 200
"""The way of the bodies is taken from at most so many instants, evenly chosen."""


def radii(stage: Stage, meshes: Sequence[Mesh], placed: Sequence[Placed]) -> FloatArray:
    """Of each body the distance [m] of its farthest drawn point from its origin, (N); 0 for a half-space."""
    found = np.zeros(len(stage.actors))
    for one in placed:
        solid = stage.solids[one.solid]
        if solid.kind != "halfspace":
            corners = meshes[one.mesh].vertices * one.scale
            turned = rotated(np.broadcast_to(solid.orientation, (len(corners), 4)), corners)
            farthest = np.linalg.norm(turned + solid.position, axis=1).max()
            found[solid.body] = max(found[solid.body], farthest)
    return found


def bounds(clip: Clip, around: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The corners (3) and (3) [m] of the box that holds the bodies of radius `around` (N) [m] on their way;
    those without size do not count. The unit cube about the origin when there are none.
    """
    bodies = np.flatnonzero(around > 0)
    if bodies.size == 0:
        return -np.ones(3), np.ones(3)
    chosen = np.unique(np.linspace(0, len(clip.times) - 1, min(LOOKED_AT, len(clip.times))).astype(int))
    poses = list(Clip(clip.trajectory, clip.times[chosen]).blocks())
    reach = around[bodies, None]
    low = np.min([(positions[:, bodies] - reach).min(axis=(0, 1)) for _, positions, _ in poses], axis=0)
    high = np.max([(positions[:, bodies] + reach).max(axis=(0, 1)) for _, positions, _ in poses], axis=0)
    return low, high
