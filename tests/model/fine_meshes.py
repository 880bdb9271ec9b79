"""Primitives as triangle surfaces of rising fineness, built without the code under test."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import trimesh

Mesher = Callable[[int], trimesh.Trimesh]


def sphere(radius: float) -> Mesher:
    """Every level halves the edges."""
    return lambda level: trimesh.creation.icosphere(subdivisions=level + 1, radius=radius)


def ellipsoid(radii: tuple[float, float, float]) -> Mesher:
    """A stretched unit sphere."""

    def mesh(level: int) -> trimesh.Trimesh:
        surface = sphere(1.0)(level)
        surface.apply_scale(radii)
        return surface

    return mesh


def cylinder(radius: float, height: float) -> Mesher:
    """A prism of 16, 32, 64 ... sides."""
    return lambda level: trimesh.creation.cylinder(radius=radius, height=height, sections=16 * 2**level)


def cone(radius: float, height: float) -> Mesher:
    """A pyramid of 16, 32, 64 ... sides with its base at z = 0."""
    return lambda level: trimesh.creation.cone(radius=radius, height=height, sections=16 * 2**level)


def capsule(radius: float, height: float) -> Mesher:
    """A surface of revolution whose profile is cut as finely as its circumference."""

    def mesh(level: int) -> trimesh.Trimesh:
        steps = 8 * 2**level
        angles = np.linspace(-np.pi / 2, np.pi / 2, 2 * steps + 1)
        profile = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
        lower, upper = profile[: steps + 1].copy(), profile[steps:].copy()
        lower[:, 1] -= height / 2
        upper[:, 1] += height / 2
        profile = np.vstack([lower, upper])
        profile[[0, -1], 0] = 0.0
        return trimesh.creation.revolve(profile, sections=2 * steps)

    return mesh


def box(size: tuple[float, float, float]) -> Mesher:
    """Exact at every level."""
    return lambda level: trimesh.creation.box(size)
