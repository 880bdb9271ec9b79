"""What a scene of the comparison is made of, in words that every engine understands.

Z is up, SI units, quaternions are (w, x, y, z). Shapes are named by kind and size: sphere (radius), box (half
extents), capsule (radius, half length of the cylindrical part, axis z), hull (the scene's `hull`, as points).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

ORIGIN: Vector = (0.0, 0.0, 0.0)
LEVEL: Quaternion = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Body:
    """Something that moves. density in kg/m^3, velocity and spin in world axes."""

    kind: str
    size: tuple[float, ...]
    position: Vector
    orientation: Quaternion = LEVEL
    velocity: Vector = ORIGIN
    spin: Vector = ORIGIN
    density: float = 1000.0


@dataclass(frozen=True)
class Obstacle:
    """Something that stands: a box, or `ground`, z <= 0 (a box of half extents `size` to some)."""

    kind: str
    size: Vector
    position: Vector


@dataclass(frozen=True)
class Ball:
    """A ball joint at a world point; parent -1 is the world."""

    parent: int
    child: int
    anchor: Vector


@dataclass(frozen=True)
class Scene:
    """bodies never collide when `collides` is false; busy and rest are the windows [s] that are timed."""

    name: str
    bodies: tuple[Body, ...]
    obstacles: tuple[Obstacle, ...] = ()
    joints: tuple[Ball, ...] = ()
    gravity: float = 9.81
    friction: float = 0.5
    collides: bool = True
    hull: Floats | None = None
    duration: float = 4.0
    busy: tuple[float, float] = (0.2, 1.0)
    rest: tuple[float, float] = (3.5, 4.0)

    def column(self, name: str) -> Floats:
        """One property of all bodies, a row each."""
        return np.array([getattr(body, name) for body in self.bodies], float)
