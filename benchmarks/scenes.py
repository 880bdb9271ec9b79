"""The scenes of the comparison.

Every number is drawn from a seeded generator: a scene is the same for all engines and on all days.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.bodies import mass_and_inertia
from benchmarks.scene import ORIGIN, Ball, Body, Floats, Obstacle, Quaternion, Scene, Vector

Shape = tuple[str, tuple[float, ...]]


def _vector(values: Floats) -> Vector:
    x, y, z = (float(v) for v in values)
    return (x, y, z)


def _grid(count: int, across: int, spacing: float, lift: float, seed: int) -> list[Vector]:
    """Places in layers of across x across, each shifted by up to 2 cm: nothing is balanced by chance."""
    random = np.random.default_rng(seed)
    cell = np.array([[i % across, i // across % across, i // across**2] for i in range(count)], float)
    cell[:, :2] -= (across - 1) / 2
    places = cell * spacing + (0.0, 0.0, lift) + random.uniform(-0.02, 0.02, (count, 3))
    return [_vector(place) for place in places]


def _turns(count: int, seed: int) -> list[Quaternion]:
    q = np.random.default_rng(seed).normal(size=(count, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    return [(float(w), float(x), float(y), float(z)) for w, x, y, z in q]


def _ground(half: float) -> Obstacle:
    return Obstacle("ground", (half, half, 1.0), ORIGIN)


def _tub(half: float, height: float = 4.0, thick: float = 0.5) -> tuple[Obstacle, ...]:
    """Ground, and four walls around |x|, |y| < half."""
    long, off = half + 2 * thick, half + thick
    walls = [
        Obstacle("box", size, place)
        for sign in (-1, 1)
        for size, place in (
            ((thick, long, height), (sign * off, 0.0, height)),
            ((long, thick, height), (0.0, sign * off, height)),
        )
    ]
    return (_ground(half + 2.0), *walls)


def spheres(count: int) -> Scene:
    """Balls of 10 cm fall into a tub."""
    across = max(2, round(count ** (1 / 3)))
    balls = [Body("sphere", (0.1,), place) for place in _grid(count, across, 0.25, 0.3, seed=1)]
    return Scene(f"spheres{count}", tuple(balls), _tub(across * 0.125))


def pyramid(base: int) -> Scene:
    """A wall of unit cubes, each on two, laid without gaps upwards and with 5 % sideways."""
    cubes = [
        Body("box", (0.5, 0.5, 0.5), ((i - (base - row - 1) / 2) * 1.05, 0.0, 0.5 + row))
        for row in range(base)
        for i in range(base - row)
    ]
    return Scene(f"pyramid{base}", tuple(cubes), (_ground(float(base)),), busy=(0.0, 0.5))


def columns(side: int = 10, height: int = 10) -> Scene:
    """Columns of unit cubes, side x side of them."""
    cubes = [
        Body("box", (0.5, 0.5, 0.5), (1.5 * (i - side / 2), 1.5 * (j - side / 2), 0.5 + k))
        for i in range(side)
        for j in range(side)
        for k in range(height)
    ]
    ground = _ground(2.0 * side)
    return Scene(f"columns{side * side * height}", tuple(cubes), (ground,), busy=(0.0, 0.5))


def mixed(count: int) -> Scene:
    """Balls, cubes and capsules, turned at random, fall onto open ground."""
    across: int = round(count ** (1 / 3))
    shapes: list[Shape] = [("sphere", (0.1,)), ("box", (0.1, 0.1, 0.1)), ("capsule", (0.07, 0.1))]
    places, turns = _grid(count, across, 0.4, 0.4, seed=3), _turns(count, seed=33)
    bodies = [
        Body(*shapes[(i + i // across) % 3], place, turn)
        for i, (place, turn) in enumerate(zip(places, turns, strict=True))
    ]
    return Scene(f"mixed{count}", tuple(bodies), (_ground(60.0),))


def pebble() -> Floats:
    """Corners of a squashed dodecahedron, (20, 3): 12 flat pentagons."""
    golden = (1 + 5**0.5) / 2
    signs = (-1.0, 1.0)
    corners = [(x, y, z) for x in signs for y in signs for z in signs]
    for a in signs:
        for b in signs:
            p, q = a / golden, b * golden
            corners += [(0.0, p, q), (p, q, 0.0), (q, 0.0, p)]
    return np.array(corners) / 3**0.5 * 0.15 * (1.0, 0.8, 0.6)


def hulls(count: int) -> Scene:
    """Pebbles of 20 corners, turned at random, fall into a tub."""
    places, turns = _grid(count, 5, 0.35, 0.4, seed=4), _turns(count, seed=44)
    bodies = [Body("hull", (), place, turn) for place, turn in zip(places, turns, strict=True)]
    return Scene(f"hulls{count}", tuple(bodies), _tub(0.95), hull=pebble())


LINK = (0.02, 0.055)
PITCH = 0.15


def chain(links: int) -> Scene:
    """Capsules on ball joints, let go while level."""
    along_x: Quaternion = (0.5**0.5, 0.0, 0.5**0.5, 0.0)
    top = links * PITCH + 2.0
    bodies = [Body("capsule", LINK, ((i + 0.5) * PITCH, 0.0, top), along_x) for i in range(links)]
    joints = [Ball(i - 1, i, (i * PITCH, 0.0, top)) for i in range(links)]
    return _chained(f"chain{links}", bodies, joints)


def loaded_chain(links: int, ratio: float) -> Scene:
    """The same, hanging, with a ball of `ratio` links' mass at its end, a little out of the line."""
    top, radius = links * PITCH + 2.0, 0.3
    bodies = [Body("capsule", LINK, (0.0, 0.0, top - (i + 0.5) * PITCH)) for i in range(links)]
    joints = [Ball(i - 1, i, (0.0, 0.0, top - i * PITCH)) for i in range(links)]
    end = top - links * PITCH
    density = ratio * mass_and_inertia(bodies[0], None)[0] / (4 / 3 * np.pi * radius**3)
    bodies.append(
        Body("sphere", (radius,), (0.0, 0.0, end - radius), velocity=(0.5, 0.0, 0.0), density=density)
    )
    joints.append(Ball(links - 1, links, (0.0, 0.0, end)))
    return _chained(f"chain{links}w{ratio:g}", bodies, joints)


def _chained(name: str, bodies: list[Body], joints: list[Ball]) -> Scene:
    busy, rest = (0.5, 1.5), (2.5, 3.0)
    return Scene(name, tuple(bodies), (), tuple(joints), collides=False, duration=3.0, busy=busy, rest=rest)


def free(count: int) -> Scene:
    """Boxes that tumble in empty space about their middle axis, which is unstable."""
    random = np.random.default_rng(6)
    across = max(1, round(count ** (1 / 3)))
    spins = random.normal(size=(count, 3)) * 0.2 + (0.0, 5.0, 0.0)
    speeds = random.normal(size=(count, 3))
    bodies = [
        Body(
            "box",
            (0.1, 0.2, 0.3),
            (float(i % across), float(i // across % across), float(i // across**2)),
            velocity=_vector(speeds[i]),
            spin=_vector(spins[i]),
        )
        for i in range(count)
    ]
    busy, rest = (0.0, 1.0), (1.0, 2.0)
    name = f"free{count}"
    return Scene(name, tuple(bodies), gravity=0.0, collides=False, duration=2.0, busy=busy, rest=rest)


def small() -> Scene:
    """Five cubes and five balls fall onto the ground: what a batch repeats."""
    random = np.random.default_rng(0)
    shift = random.uniform(-0.03, 0.03, (10, 2))
    shapes: list[Shape] = [("sphere", (0.1,)), ("box", (0.1, 0.1, 0.1))]
    bodies = [
        Body(
            *shapes[i % 2],
            (0.22 * (i % 3) + float(shift[i, 0]), 0.22 * (i // 3 % 3) + float(shift[i, 1]), 0.3 + 0.25 * i),
        )
        for i in range(10)
    ]
    return Scene("small", tuple(bodies), (_ground(50.0),))


SCENES: dict[str, Callable[[], Scene]] = {
    "spheres1000": lambda: spheres(1000),
    "pyramid30": lambda: pyramid(30),
    "columns1000": columns,
    "mixed1000": lambda: mixed(1000),
    "hulls200": lambda: hulls(200),
    "chain100": lambda: chain(100),
    "chain100w1000": lambda: loaded_chain(100, 1000.0),
    "free10000": lambda: free(10_000),
    "free1": lambda: free(1),
    "small": small,
    "free1000": lambda: free(1000),
    "spheres100": lambda: spheres(100),
    "spheres8000": lambda: spheres(8000),
    "spheres30000": lambda: spheres(30_000),
    "columns30000": lambda: columns(55, 10),
    "pyramid10": lambda: pyramid(10),
    "mixed8000": lambda: mixed(8000),
}
STANDARD = tuple(SCENES)[:10]
