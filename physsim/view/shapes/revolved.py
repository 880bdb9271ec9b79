"""Round solids: a line in the (radius, z) half-plane turned about z."""

from __future__ import annotations

from itertools import pairwise
from math import ceil, sqrt

import numpy as np

from physsim.view.shapes.mesh import Mesh
from physsim.view.stage import FloatArray, IntArray

SLANT = sqrt(0.5)


def sphere(segments: int) -> Mesh:
    """The unit sphere; `segments` around the equator, half as many from pole to pole."""
    return revolved(_arc(-0.5, 0.5, max(2, segments // 2)), segments)


def capsule(radius: float, half_height: float, segments: int) -> Mesh:
    """Two half spheres of `radius` [m] about (0, 0, -half_height) and (0, 0, half_height) [m], and the
    cylinder between them.
    """
    rings = ceil(segments / 4)
    caps = [_arc(-0.5, 0.0, rings), _arc(0.0, 0.5, rings)]
    for cap, side in zip(caps, (-1, 1), strict=True):
        cap[:, :2] *= radius
        cap[:, 1] += side * half_height
    return revolved(np.concatenate(caps), segments)


def cylinder(segments: int) -> Mesh:
    """Radius 1, z from -1 to 1."""
    return revolved(
        np.array(
            [
                [0, -1, 0, -1],
                [1, -1, 0, -1],
                [1, -1, 1, 0],
                [1, 1, 1, 0],
                [1, 1, 0, 1],
                [0, 1, 0, 1],
            ],
            dtype=np.float64,
        ),
        segments,
    )


def cone(segments: int) -> Mesh:
    """Radius 1 and height 1, the base at z = -1/4 and the apex at 3/4: the origin is the centre of mass."""
    return revolved(
        np.array([[0, -0.25, 0, -1], [1, -0.25, 0, -1], [1, -0.25, SLANT, SLANT], [0, 0.75, SLANT, SLANT]]),
        segments,
    )


def revolved(profile: FloatArray, segments: int) -> Mesh:
    """The surface that `profile` sweeps: rows of radius, z, and the radial and axial part of the normal, from
    the bottom up. A point given twice with two normals is a sharp edge.

    On the axis every triangle has a vertex of its own, half a segment on: a cone's tip has no one normal.
    """
    on_axis = profile[:, :1] == 0
    angles = 2 * np.pi * (np.arange(segments) + np.where(on_axis, 0.5, 0.0)) / segments
    around = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return Mesh(
        _rings(around, profile[:, 0], profile[:, 1]),
        _rings(around, profile[:, 2], profile[:, 3]),
        _bands(profile, segments),
    )


def _rings(around: FloatArray, radial: FloatArray, axial: FloatArray) -> FloatArray:
    """(P, segments, 2) directions, and lengths (P) along and across them -> (P * segments, 3)."""
    across = around * radial[:, None, None]
    along = np.broadcast_to(axial[:, None, None], (*around.shape[:2], 1))
    return np.concatenate([across, along], axis=-1).reshape(-1, 3)


def _bands(profile: FloatArray, segments: int) -> IntArray:
    """Two triangles per segment between neighbouring rings, one where either ring is a point."""
    here = np.arange(segments)
    ahead = np.roll(here, -1)
    parts = []
    for ring, (low, high) in enumerate(pairwise(profile)):
        if (low[:2] == high[:2]).all():
            continue
        a, b = ring * segments, (ring + 1) * segments
        if low[0] > 0:
            parts.append(np.stack([a + here, a + ahead, b + here], axis=-1))
        if high[0] > 0:
            parts.append(np.stack([a + ahead, b + ahead, b + here], axis=-1))
    return np.concatenate(parts).astype(np.int32)


def _arc(start: float, end: float, steps: int) -> FloatArray:
    """Profile of the unit circle from latitude `start` to `end` [pi rad]; poles lie on the axis exactly."""
    latitude = np.pi * np.linspace(start, end, steps + 1)
    radius, z = np.cos(latitude), np.sin(latitude)
    radius[np.abs(z) == 1] = 0
    return np.stack([radius, z, radius, z], axis=-1)
