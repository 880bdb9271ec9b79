"""What stands on the stage: bodies with their solids, joints and springs, all that does not change with time.

Every way of seeing a trajectory (page, glTF, picture, film) starts here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.recording import Trajectory

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]

WORLD = -1
"""The body number of the world."""


@dataclass(frozen=True)
class Actor:
    """A body. mass in kg, infinite for a half-space; center (3,) of mass [m] from its origin, body axes;
    inertia (3, 3) [kg m^2] about the centre of mass, body axes.
    """

    name: str
    material: str
    mass: float
    fixed: bool
    center: FloatArray
    inertia: FloatArray


@dataclass(frozen=True)
class Surface:
    """A triangle mesh: vertices (V, 3) [m], triangles (T, 3) counter-clockwise seen from outside."""

    vertices: FloatArray
    triangles: IntArray


@dataclass(frozen=True)
class Solid:
    """One geometry of a body.

    kind: sphere, capsule, box, cylinder, cone, ellipsoid, rod, halfspace or surface; parameters (4,) [m] as
    the file's /geometry/parameters says. position (3,) [m] from the body's ORIGIN, orientation (4,) wxyz, both
    in body axes. colour: "#rrggbb". shown: what the user drew; collides: what stands for it in contacts.
    """

    body: int
    kind: str
    parameters: FloatArray
    position: FloatArray
    orientation: FloatArray
    material: str
    colour: str
    shown: bool
    collides: bool
    surface: Surface | None


@dataclass(frozen=True)
class Link:
    """A joint or a spring. bodies: A and B, `WORLD` for the world; anchors (2, 3) [m], each in its body's own
    frame, from its origin; axis (3,) in A's frame, NaN where the kind has none.
    """

    name: str
    kind: str
    bodies: tuple[int, int]
    anchors: FloatArray
    axis: FloatArray


@dataclass(frozen=True)
class Stage:
    """All that does not change with time, in the order of the file."""

    title: str
    actors: tuple[Actor, ...]
    solids: tuple[Solid, ...]
    joints: tuple[Link, ...]
    springs: tuple[Link, ...]


def stage_of(trajectory: Trajectory) -> Stage:
    """The stage of a trajectory. Raises FileTrouble when the file keeps no shapes."""
    raise FileTrouble(f"{trajectory.path}: no shapes yet")


def staged(title: str, value: Callable[[str], Any]) -> Stage:
    """The stage from the fixed datasets of a file: `value(path)` gives each, None where there is none."""
    raise NotImplementedError
