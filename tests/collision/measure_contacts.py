"""Measures every pair of shapes and renews the tables of docs/contacts.md.

Run it from anywhere: python tests/collision/measure_contacts.py. It takes about two minutes.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable
from itertools import combinations_with_replacement
from pathlib import Path
from typing import NamedTuple

import fcl
import numpy as np
from collision_asking import Asker
from collision_oracle import true_depth
from collision_shapes import SOLIDS, THINGS, Floats, Thing, engine_input, rotation, touching

from physsim._engine import World
from physsim.collision import FclAnswers

PAGE = Path(__file__).resolve().parents[2] / "docs" / "contacts.md"

APART = (1e-3, 1e-2, 0.1, 1.0)
NEAR = (1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4)
OVERLAPS = (1e-6, 1e-4, 1e-2, 0.1)

UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


def main() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for name, lines in (("pairs", pair_table()), ("fcl", raw_table()), ("abort", abort_line())):
        begin, end = f"<!-- measured: {name} -->", "<!-- end -->"
        pattern = re.compile(f"{re.escape(begin)}.*?{re.escape(end)}", re.DOTALL)
        table = "\n".join(lines)
        text = pattern.sub(lambda _, b=begin, t=table, e=end: f"{b}\n{t}\n{e}", text)
    PAGE.write_text(text, encoding="utf-8")


def pair_table() -> Iterable[str]:
    yield (
        "| pair | points | engine: normal, apart | depth, apart | depth, near | depth, overlapping "
        "| FCL: normal, apart | depth, apart | depth, near | depth, overlapping "
        "| normal of the manifold | depth of the manifold |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|---|---|"
    names = (*SOLIDS, "halfspace")
    for a, b in combinations_with_replacement(names, 2):
        if a in ("mesh", "halfspace"):
            continue
        label = f"{a}, triangle of a mesh" if b == "mesh" else f"{a}, {b}"
        worst = halfspace_errors(a) if b == "halfspace" else errors(a, b, Asker([THINGS[a], THINGS[b]]))
        own = errors(a, b, Engine(a, b)) if b not in ("mesh", "halfspace") else None
        of_engine = map(text_of, own) if own else ("",) * 4
        columns = (*of_engine, *map(text_of, (*worst, *manifold_errors(a, b))))
        yield f"| {label} | {most_points(a, b)} | {' | '.join(columns)} |"


class Deepest(NamedTuple):
    """The deepest point of a manifold."""

    normal: Floats
    depth: float


class Engine:
    """The engine's own answers about a pair, asked like FCL's."""

    def __init__(self, a: str, b: str) -> None:
        self._world = World(engine_input([THINGS[a], THINGS[b]]))

    def __call__(self, a: int, pose_a: Floats, b: int, pose_b: Floats) -> Deepest | None:
        """None between corners of polytopes that are apart."""
        points = self._world.collide_pair(a, pose_a, b, pose_b, 10.0)
        if not len(points["depth"]):
            return None
        deepest = int(np.argmax(points["depth"]))
        return Deepest(points["normal"][deepest], float(points["depth"][deepest]))


def errors(a: str, b: str, ask: Asker | Engine) -> tuple[float, float, float, float]:
    """Largest errors of the normal and depth apart, of the depth near touching, of the depth of overlaps."""
    rng = np.random.default_rng(41)
    normal, apart, near, overlapping = [], [], [], []
    for gap in APART * 20:
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], gap, rng)
        if answer := ask(0, pose_a, 1, pose_b):
            normal.append(np.linalg.norm(answer.normal - n))
            apart.append(abs(answer.depth + gap))
    for gap in NEAR * 15:
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], gap, rng)
        if answer := ask(0, pose_a, 1, pose_b):
            near.append(abs(answer.depth + gap))
    for overlap in OVERLAPS * 8:
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], -overlap, rng)
        expected, _ = true_depth(THINGS[a], pose_a, THINGS[b], pose_b, n)
        if answer := ask(0, pose_a, 1, pose_b):
            overlapping.append(abs(answer.depth - expected))
    return max(normal, default=0.0), max(apart, default=0.0), max(near, default=0.0), max(overlapping)


def halfspace_errors(a: str) -> tuple[float, float, float, float]:
    """As `errors`; the plane's normal and the lowest point are known."""
    ask = Asker([THINGS[a], THINGS["halfspace"]])
    rng = np.random.default_rng(42)
    point = Thing("box", (0.0, 0.0, 0.0))
    normal: list[float] = []
    worst: list[float] = []
    for gaps in (APART, NEAR, [-x for x in OVERLAPS]):
        depth = []
        for gap in [*gaps] * 10:
            pose, plane, n = touching(THINGS[a], point, gap, rng)
            plane[3:] = facing(n)
            answer = ask(0, pose, 1, plane)
            normal.append(np.linalg.norm(answer.normal - rotation(plane[3:])[:, 2]))
            depth.append(abs(answer.depth + gap))
        worst.append(max(depth))
    return max(normal), worst[0], worst[1], worst[2]


def manifold_errors(a: str, b: str) -> tuple[float, float]:
    """Of what the engine makes of FCL's answer at a gap of 1 mm: the nearest point's normal and depth."""
    arrays = engine_input([THINGS[a], THINGS[b]])
    world, answer = World(arrays), FclAnswers(arrays)
    rng = np.random.default_rng(45)
    shape = Thing("box", (0.0, 0.0, 0.0)) if b == "halfspace" else THINGS[b]
    normal, depth = [0.0], [0.0]
    for _ in range(60):
        pose_a, pose_b, n = touching(THINGS[a], shape, 1e-3, rng)
        if b == "halfspace":
            pose_b[3:] = facing(n)
        points = world.collide_pair(0, pose_a, 1, pose_b, 2e-3, answer)
        if len(points["depth"]):
            nearest = int(np.argmax(points["depth"]))
            normal.append(float(np.linalg.norm(points["normal"][nearest] - n)))
            depth.append(abs(float(points["depth"][nearest]) + 1e-3))
    return max(normal), max(depth)


def facing(n: Floats) -> Floats:
    """A quaternion that turns z to n."""
    q = np.r_[1.0 + n[2], np.cross([0.0, 0.0, 1.0], n)]
    return q / np.linalg.norm(q)


def most_points(a: str, b: str) -> int:
    """The most points of a manifold seen where the bodies lie face to face, edge to face, or line to face."""
    arrays = engine_input([THINGS[a], THINGS[b]])
    world = World(arrays)
    rng = np.random.default_rng(43)
    count = 0
    for _ in range(200):
        pose_a, pose_b = aligned(rng), aligned(rng)
        found, normal, depth, _ = FclAnswers(arrays)(*parts(b), pose_a[None], pose_b[None], np.array([10.0]))
        if found[0]:
            pose_a[:3] += (depth[0] - 1e-4) * normal[0]
            count = max(count, len(world.collide_pair(0, pose_a, 1, pose_b, 1e-3)["depth"]))
    return count


def parts(b: str) -> list[Floats]:
    return [np.array([k], dtype=np.int32) for k in (0, 1, -1, 0 if b == "mesh" else -1)]


def aligned(rng: np.random.Generator) -> Floats:
    half = 0.5 * rng.integers(0, 4) * np.pi / 2
    return np.r_[0.2 * rng.normal(size=3), np.cos(half), np.sin(half) * np.eye(3)[rng.integers(0, 3)]]


def raw_table() -> Iterable[str]:
    """What FCL's own calls say, asked directly and in metres."""
    yield "| pair | `distance`, gap 0.1 mm | | `collide`, overlap 1 cm | | `collide`, GST_INDEP | |"
    yield "|---|---|---|---|---|---|---|"
    yield "| | distance | normal | depth | normal | depth | normal |"
    for a, b in (
        ("sphere", "sphere"),
        ("sphere", "box"),
        ("sphere", "hull"),
        ("capsule", "capsule"),
        ("box", "box"),
        ("box", "cylinder"),
        ("box", "hull"),
        ("hull", "hull"),
        ("cylinder", "cylinder"),
        ("cone", "cone"),
        ("ellipsoid", "ellipsoid"),
    ):
        yield f"| {a}, {b} | {' | '.join(map(text_of, raw_errors(a, b)))} |"


def raw_errors(a: str, b: str) -> list[float]:
    rng = np.random.default_rng(44)
    solids = [fcl.CollisionObject(raw_geometry(THINGS[name])) for name in (a, b)]
    worst = np.zeros(6)
    for _ in range(20):
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], 1e-4, rng)
        worst[:2] = np.maximum(worst[:2], raw_distance(solids, (a, b), (pose_a, pose_b), n))
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], -1e-2, rng)
        depth, normal = true_depth(THINGS[a], pose_a, THINGS[b], pose_b, n)
        place(solids, (a, b), (pose_a, pose_b))
        for k, solver in ((2, fcl.GJKSolverType.GST_LIBCCD), (4, fcl.GJKSolverType.GST_INDEP)):
            result = fcl.CollisionResult()
            fcl.collide(solids[1], solids[0], fcl.CollisionRequest(1, True, gjk_solver_type=solver), result)
            if result.contacts and depth > 0.0:
                contact = result.contacts[0]
                error = abs(contact.penetration_depth - depth), np.linalg.norm(contact.normal - normal)
                worst[k : k + 2] = np.maximum(worst[k : k + 2], error)
    return worst.tolist()


def raw_distance(solids, names, poses, n: Floats) -> tuple[float, float]:
    place(solids, names, poses)
    result = fcl.DistanceResult()
    distance = fcl.distance(solids[1], solids[0], fcl.DistanceRequest(True), result)
    arm = result.nearest_points[1] - result.nearest_points[0]
    length = float(np.linalg.norm(arm))
    return abs(distance - 1e-4), float(np.linalg.norm(arm / length - n)) if length > 0.0 else 2.0


def place(solids, names, poses) -> None:
    for solid, name, pose in zip(solids, names, poses, strict=True):
        lift = 0.25 * THINGS[name].parameters[1] if name == "cone" else 0.0
        solid.setTransform(fcl.Transform(pose[3:], pose[:3] + rotation(pose[3:]) @ (0.0, 0.0, lift)))


def raw_geometry(thing: Thing):
    p = thing.parameters
    if thing.kind == "hull":
        faces = np.c_[np.full(len(thing.triangles), 3), thing.triangles]
        return fcl.Convex(thing.vertices, len(faces), faces.ravel())
    return {
        "sphere": lambda: fcl.Sphere(p[0]),
        "capsule": lambda: fcl.Capsule(p[0], 2.0 * p[1]),
        "box": lambda: fcl.Box(2.0 * p[0], 2.0 * p[1], 2.0 * p[2]),
        "cylinder": lambda: fcl.Cylinder(p[0], 2.0 * p[1]),
        "cone": lambda: fcl.Cone(p[0], p[1]),
        "ellipsoid": lambda: fcl.Ellipsoid(*p),
    }[thing.kind]()


ABORTING = """
import fcl, numpy as np
a, b = (fcl.CollisionObject(fcl.Box(4096.0, 2457.6, 1638.4)) for _ in range(2))
rng = np.random.default_rng(0)
corner = np.array([2048.0, 1228.8, 819.2])
for _ in range(20000):
    q = rng.normal(size=(2, 4)); q /= np.linalg.norm(q, axis=1, keepdims=True)
    a.setTransform(fcl.Transform(q[0], np.zeros(3))); b.setTransform(fcl.Transform(q[1], np.zeros(3)))
    n = rng.normal(size=3); n /= np.linalg.norm(n)
    ra, rb = a.getRotation(), b.getRotation()
    at = ra @ (np.sign(ra.T @ n) * corner) + rb @ (np.sign(rb.T @ n) * corner) - 4e-6 * n
    b.setTransform(fcl.Transform(q[1], at))
    fcl.distance(a, b, fcl.DistanceRequest(True, True), fcl.DistanceResult())
"""


def abort_line() -> Iterable[str]:
    """Runs FCL's signed distance on boxes whose corners touch, in a process of its own."""
    done = subprocess.run([sys.executable, "-c", ABORTING], capture_output=True, text=True, check=False)
    ended = f"ended by signal {-done.returncode}" if done.returncode < 0 else f"returned {done.returncode}"
    version = fcl.__version__ if hasattr(fcl, "__version__") else "?"
    yield f"20 000 pairs of boxes whose corners touch, python-fcl {version}: the process was {ended}."


def text_of(error: float) -> str:
    return "< 1e-12" if error < 1e-12 else f"{error:.0e}".replace("e-0", "e-").replace("e+00", "")


if __name__ == "__main__":
    main()
