"""Shapes to ask about, as rows of the engine's input, and poses to put them in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from physsim.model import compile_scene
from physsim.scene.loader import load_scene_text

Floats = NDArray[np.float64]

KINDS = ("sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "rod", "hull", "halfspace", "mesh")


@dataclass(frozen=True)
class Thing:
    """A shape: kind and parameters as in the engine's input; vertices and outward triangles of hulls and
    meshes."""

    kind: str
    parameters: tuple[float, ...] = ()
    vertices: Floats | None = None
    triangles: NDArray[np.int32] | None = None

    def scaled(self, factor: float) -> Thing:
        vertices = None if self.vertices is None else factor * self.vertices
        return Thing(self.kind, tuple(factor * p for p in self.parameters), vertices, self.triangles)


def hull(points: Floats) -> Thing:
    """The convex hull of points f64[V, 3], all faces triangles."""
    corners = points[ConvexHull(points).vertices]
    found = ConvexHull(corners)
    a, b, c = (corners[found.simplices[:, k]] for k in range(3))
    inward = (np.cross(b - a, c - a) * found.equations[:, :3]).sum(axis=1) < 0
    triangles = np.where(inward[:, None], found.simplices[:, ::-1], found.simplices)
    return Thing("hull", (), corners, triangles.astype(np.int32))


def triangle(*corners: Sequence[float]) -> Thing:
    """A mesh of one triangle."""
    return Thing("mesh", (), np.array(corners, dtype=float), np.array([[0, 1, 2]], dtype=np.int32))


THINGS = {
    "sphere": Thing("sphere", (0.5,)),
    "capsule": Thing("capsule", (0.3, 0.5)),
    "box": Thing("box", (0.5, 0.3, 0.2)),
    "cylinder": Thing("cylinder", (0.4, 0.3)),
    "cone": Thing("cone", (0.4, 0.9)),
    "ellipsoid": Thing("ellipsoid", (0.5, 0.3, 0.2)),
    "rod": Thing("rod", (0.6,)),
    "hull": hull(0.35 * np.random.default_rng(5).normal(size=(20, 3))),
    "mesh": triangle((-0.4, -0.3, 0.1), (0.5, -0.2, 0.05), (0.1, 0.6, -0.1)),
    "halfspace": Thing("halfspace"),
}
"""One of each kind, all about a metre across."""

SOLIDS = tuple(name for name in THINGS if name != "halfspace")


def engine_input(things: Sequence[Thing], **settings: object) -> dict[str, object]:
    """The engine's input: one body per thing, at rest in the origin; half-spaces and meshes are fixed."""
    count = len(things)
    zeros = np.zeros((count, 3))
    upright = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    made: dict[str, object] = {
        **_settings(),
        **_nothing_else(),
        **_geometry(things),
        "fixed": np.array([thing.kind in ("halfspace", "mesh") for thing in things], dtype=np.int32),
        "mass": np.ones(count),
        "inertia": np.tile(np.eye(3), (count, 1, 1)),
        "position": zeros,
        "orientation": upright,
        "velocity": zeros,
        "angular_velocity": zeros,
        "surface_velocity": zeros,
        "attracting_mass": np.ones(count),
        "geom_body": np.arange(count, dtype=np.int32),
        "geom_position": zeros,
        "geom_orientation": upright,
        "geom_material": np.zeros(count, dtype=np.int32),
    }
    return made | settings


def _geometry(things: Sequence[Thing]) -> dict[str, object]:
    parameters = np.zeros((len(things), 4))
    listed: dict[str, list[Thing]] = {"hull": [], "mesh": []}
    for row, thing in zip(parameters, things, strict=True):
        if thing.kind in listed:
            row[0] = len(listed[thing.kind])
            listed[thing.kind].append(thing)
        row[: len(thing.parameters)] = thing.parameters
    return {
        "geom_kind": np.array([KINDS.index(thing.kind) for thing in things], dtype=np.int32),
        "geom_parameters": parameters,
        "hull_vertices": [thing.vertices for thing in listed["hull"]],
        "hull_faces": [thing.triangles.tolist() for thing in listed["hull"]],
        "mesh_vertices": [thing.vertices for thing in listed["mesh"]],
        "mesh_triangles": [thing.triangles for thing in listed["mesh"]],
    }


def _nothing_else() -> dict[str, object]:
    """Springs, joints, forces and motions of a scene that has none."""
    ball = "{shape: {type: sphere, radius: 1}, mass: 1, collides: false}"
    head = "physsim: 1\nsimulation: {duration: 1, timestep: 1}\n"
    scene = load_scene_text(f"{head}bodies: {{ball: {ball}}}\n")
    return compile_scene(scene).mechanics.engine_input()


def _settings() -> dict[str, object]:
    return {
        "gravity": np.array([0.0, 0.0, -9.81]),
        "gravitation": 0.0,
        "timestep": 1e-3,
        "integrator": "semi_implicit_euler",
        "impacts": "stepped",
        "collision": "auto",
        "iterations": 50,
        "tolerance": 1e-6,
        "stabilization": "split_impulse",
        "baumgarte": 0.2,
        "slip_speed": 0.01,
        "bounce_speed": 0.0,
        "threads": 1,
        "restitution": np.zeros((1, 1)),
        "static_friction": np.zeros((1, 1)),
        "kinetic_friction": np.zeros((1, 1)),
        "rolling_friction": np.zeros((1, 1)),
        "spinning_friction": np.zeros((1, 1)),
        "no_contact": np.zeros((0, 2), dtype=np.int32),
    }


def rotation(quaternion: Floats) -> Floats:
    """f64[3, 3] body -> world of a unit quaternion (w, x, y, z)."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def product(p: Floats, q: Floats) -> Floats:
    """The quaternion that rotates first by q, then by p."""
    return np.r_[p[0] * q[0] - p[1:] @ q[1:], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])]


def random_direction(rng: np.random.Generator) -> Floats:
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def random_quaternion(rng: np.random.Generator) -> Floats:
    q = rng.normal(size=4)
    return q / np.linalg.norm(q)


def support(thing: Thing, directions: Floats) -> Floats:
    """f64[K, 3]: the point of the shape (in its own axes) that is farthest along each direction f64[K, 3]."""
    if thing.vertices is not None:
        return thing.vertices[np.argmax(directions @ thing.vertices.T, axis=1)]
    return _SUPPORTS[thing.kind](directions, *thing.parameters)


def world_support(thing: Thing, pose: Floats, directions: Floats) -> Floats:
    """As `support`, in the world, for a pose (x y z, w x y z)."""
    r = rotation(pose[3:])
    return support(thing, directions @ r) @ r.T + pose[:3]


def depth_along(a: Thing, pose_a: Floats, b: Thing, pose_b: Floats, directions: Floats) -> Floats:
    """f64[K]: overlap of A and B along unit directions (from B to A), from their support points."""
    reach = world_support(b, pose_b, directions) - world_support(a, pose_a, -directions)
    return (reach * directions).sum(axis=1)


def touching(
    a: Thing, b: Thing, gap: float, rng: np.random.Generator, normal: Floats | None = None
) -> tuple[Floats, Floats, Floats]:
    """Random poses of A and B whose support points along a random normal face each other at a gap [m].

    For a positive gap these points are the nearest ones, and the normal is the true one: the planes through
    them separate the shapes by the gap. For a negative gap the depth along the normal is known, the true
    depth is not greater.
    """
    n = random_direction(rng) if normal is None else normal
    pose_b = np.r_[0.3 * rng.normal(size=3), random_quaternion(rng)]
    pose_a = np.r_[0.0, 0.0, 0.0, random_quaternion(rng)]
    pose_a[:3] = world_support(b, pose_b, n[None])[0] - world_support(a, pose_a, -n[None])[0] + gap * n
    return pose_a, pose_b, n


def _along_z(directions: Floats, half: float) -> Floats:
    points = np.zeros_like(directions)
    points[:, 2] = np.where(directions[:, 2] >= 0.0, half, -half)
    return points


def _ball(directions: Floats, radius: float) -> Floats:
    return radius * directions / np.linalg.norm(directions, axis=1, keepdims=True)


def _disc(directions: Floats, radius: float) -> Floats:
    flat = directions * (1.0, 1.0, 0.0)
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    return radius * flat / np.where(length > 0.0, length, 1.0)


def _cone(directions: Floats, radius: float, height: float) -> Floats:
    rim = _disc(directions, radius) - (0.0, 0.0, 0.25 * height)
    apex = np.array([0.0, 0.0, 0.75 * height])
    return np.where((directions @ apex > (directions * rim).sum(axis=1))[:, None], apex, rim)


def _ellipsoid(directions: Floats, *radii: float) -> Floats:
    return np.array(radii) * _ball(directions * radii, 1.0)


_SUPPORTS: dict[str, Callable[..., Floats]] = {
    "sphere": _ball,
    "capsule": lambda d, radius, half: _ball(d, radius) + _along_z(d, half),
    "box": lambda d, *half: np.where(d >= 0.0, 1.0, -1.0) * half,
    "cylinder": lambda d, radius, half: _disc(d, radius) + _along_z(d, half),
    "cone": _cone,
    "ellipsoid": _ellipsoid,
    "rod": _along_z,
}
