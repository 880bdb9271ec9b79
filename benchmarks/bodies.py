"""Masses, inertias, rotations: what scenes, adapters and the judge share."""

from __future__ import annotations

import numpy as np

from benchmarks.scene import Ball, Body, Floats, Scene


def mass_and_inertia(body: Body, hull: Floats | None) -> tuple[float, Floats]:
    """Mass [kg] and principal moments (3,) [kg m^2] in the body's own axes."""
    mass, moments = _of_unit_density(body, hull)
    return body.density * mass, body.density * moments


def _of_unit_density(body: Body, hull: Floats | None) -> tuple[float, Floats]:
    if body.kind == "sphere":
        volume = 4 / 3 * np.pi * body.size[0] ** 3
        return volume, np.full(3, 0.4 * volume * body.size[0] ** 2)
    if body.kind == "box":
        squares, volume = np.square(body.size), 8 * float(np.prod(body.size))
        return volume, volume / 3 * (squares.sum() - squares)
    if body.kind == "capsule":
        return _capsule(*body.size)
    assert hull is not None
    return _polyhedron(hull)


def _capsule(radius: float, half: float) -> tuple[float, Floats]:
    """Cylinder and two half balls, whose centres of mass lie 3/8 radius beyond the ends."""
    tube, ball = 2 * np.pi * radius**2 * half, 4 / 3 * np.pi * radius**3
    axial = tube * radius**2 / 2 + 0.4 * ball * radius**2
    lateral = tube * (radius**2 / 4 + half**2 / 3) + ball * (0.4 * radius**2 + half**2 + 0.75 * radius * half)
    return tube + ball, np.array([lateral, lateral, axial])


def _polyhedron(hull: Floats) -> tuple[float, Floats]:
    """Tetrahedra between the origin and the faces: x x^T over each is V/20 (sum v v^T + s s^T)."""
    from scipy.spatial import ConvexHull  # noqa: PLC0415

    corners = hull[ConvexHull(hull).simplices]
    volumes = np.abs(np.linalg.det(corners)) / 6
    squares = (corners**2).sum(axis=1) + corners.sum(axis=1) ** 2
    second = (volumes[:, None] / 20 * squares).sum(axis=0)
    return float(volumes.sum()), second.sum() - second


def rotated(q: Floats, v: Floats) -> Floats:
    """Vectors (..., 3) turned by quaternions (..., 4)."""
    q, v = np.asarray(q, float), np.asarray(v, float)
    twice = 2 * np.cross(q[..., 1:], v)
    turned: Floats = v + q[..., :1] * twice + np.cross(q[..., 1:], twice)
    return turned


def conjugate(q: Floats) -> Floats:
    """The turn back."""
    return np.asarray(q, float) * (1.0, -1.0, -1.0, -1.0)


def product(p: Floats, q: Floats) -> Floats:
    """First q, then p, (..., 4)."""
    p, q = np.broadcast_arrays(np.asarray(p, float), np.asarray(q, float))
    scalar = p[..., :1] * q[..., :1] - (p[..., 1:] * q[..., 1:]).sum(axis=-1, keepdims=True)
    vector = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)


def local_anchor(scene: Scene, joint: Ball, body: int) -> Floats:
    """A joint's point in a body's own axes; in the world's for -1."""
    if body < 0:
        return np.array(joint.anchor, float)
    b = scene.bodies[body]
    return rotated(conjugate(np.array(b.orientation)), np.subtract(joint.anchor, b.position))
