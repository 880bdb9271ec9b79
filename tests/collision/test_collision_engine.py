"""The engine's own contacts against FCL's, and the manifolds that the engine builds from either."""

from __future__ import annotations

from itertools import combinations_with_replacement

import numpy as np
import pytest
from collision_asking import Asker
from collision_shapes import (
    SOLIDS,
    THINGS,
    Floats,
    Thing,
    depth_along,
    engine_input,
    random_quaternion,
    touching,
)

from physsim._engine import World
from physsim.collision import FclAnswers

UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])
ROUND = ("cylinder", "cone", "ellipsoid")
CONVEX = [name for name in SOLIDS if name != "mesh"]
PAIRS = list(combinations_with_replacement(CONVEX, 2))

# Between bodies of one metre: the direction search ends within 2e-6 m of the least depth (docs/contacts.md).
DEPTH_TOLERANCE = 5e-6


class Two:
    """A pair of things in an engine world: asked from its kernels, and through FCL."""

    def __init__(self, a: Thing, b: Thing) -> None:
        self.a, self.b = a, b
        arrays = engine_input([a, b])
        self.world, self.fcl = World(arrays), FclAnswers(arrays)
        assert not self.world.needs_answer()

    def kernel(self, pose_a: Floats, pose_b: Floats, margin: float = 0.05) -> dict[str, Floats]:
        return self.world.collide_pair(0, pose_a, 1, pose_b, margin)

    def through_fcl(self, pose_a: Floats, pose_b: Floats, margin: float = 0.05) -> dict[str, Floats]:
        return self.world.collide_pair(0, pose_a, 1, pose_b, margin, self.fcl)

    def routes(self):
        return [self.kernel, self.through_fcl]


def deepest(points: dict[str, Floats]) -> tuple[float, Floats]:
    k = int(np.argmax(points["depth"]))
    return float(points["depth"][k]), points["normal"][k]


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_kernels_find_the_overlaps_that_fcl_finds(a: str, b: str) -> None:
    """Depths agree; and measured by support points, the kernel's direction is no worse than FCL's."""
    two, ask = Two(THINGS[a], THINGS[b]), Asker([THINGS[a], THINGS[b]])
    rng = np.random.default_rng(31)
    for overlap in (1e-6, 1e-5, 1e-4, 1e-3, 0.02, 0.1):
        pose_a, pose_b, _ = touching(two.a, two.b, -overlap, rng)
        expected = ask(0, pose_a, 1, pose_b)
        if expected.depth <= 0.0:
            continue
        depth, normal = deepest(two.kernel(pose_a, pose_b))
        along = depth_along(two.a, pose_a, two.b, pose_b, normal[None])[0]
        assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-12)
        assert along <= expected.depth + DEPTH_TOLERANCE
        assert depth == pytest.approx(expected.depth, abs=DEPTH_TOLERANCE)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_kernels_see_no_contact_that_fcl_does_not_see(a: str, b: str) -> None:
    """Polytopes' kernels try the directions of faces and of crossing edges: between two corners that near
    each other they may be silent until these touch, or find too small a gap, never an overlap.
    """
    two, ask = Two(THINGS[a], THINGS[b]), Asker([THINGS[a], THINGS[b]])
    rng = np.random.default_rng(36)
    for gap in (1e-6, 1e-4, 1e-2, 0.06, 0.2):
        pose_a, pose_b, _ = touching(two.a, two.b, gap, rng)
        points = two.kernel(pose_a, pose_b, margin=0.05)
        assert (points["depth"] <= DEPTH_TOLERANCE).all()
        assert ask(0, pose_a, 1, pose_b, margin=0.05).found is (gap < 0.05)
        if gap > 0.1:
            assert len(points["depth"]) == 0


@pytest.mark.parametrize("name", CONVEX)
def test_halfspaces_meet_fcl_to_rounding(name: str) -> None:
    two, ask = Two(THINGS[name], THINGS["halfspace"]), Asker([THINGS[name], THINGS["halfspace"]])
    rng = np.random.default_rng(32)
    for overlap in (-0.04, -1e-6, 1e-6, 0.1):
        plane = np.r_[rng.normal(size=3), random_quaternion(rng)]
        pose = np.r_[plane[:3], random_quaternion(rng)]
        normal = ask(0, pose, 1, plane).normal
        pose[:3] += (ask(0, pose, 1, plane).depth - overlap) * normal
        for route in two.routes():
            depth, found = deepest(route(pose, plane))
            assert depth == pytest.approx(overlap, abs=1e-14)
            assert found == pytest.approx(normal, abs=1e-14)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_manifolds_through_fcl_have_its_depth(a: str, b: str) -> None:
    two, ask = Two(THINGS[a], THINGS[b]), Asker([THINGS[a], THINGS[b]])
    rng = np.random.default_rng(33)
    for overlap in (-0.04, -1e-3, 1e-4, 1e-2, 0.1):
        pose_a, pose_b, _ = touching(two.a, two.b, -overlap, rng)
        points, answer = two.through_fcl(pose_a, pose_b), ask(0, pose_a, 1, pose_b, margin=0.05)
        assert (1 if answer.found else 0) <= len(points["depth"]) <= 8
        assert np.linalg.norm(points["normal"], axis=1) == pytest.approx(1.0, abs=1e-12)
        if answer.found:
            assert deepest(points)[0] == pytest.approx(answer.depth, abs=DEPTH_TOLERANCE)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_exchanging_the_bodies_turns_the_manifold(a: str, b: str) -> None:
    two, other = Two(THINGS[a], THINGS[b]), Two(THINGS[b], THINGS[a])
    rng = np.random.default_rng(34)
    for overlap in (-1e-3, 1e-3, 0.05):
        pose_a, pose_b, _ = touching(two.a, two.b, -overlap, rng)
        for route, turned_route in zip(two.routes(), other.routes(), strict=True):
            one, turned = route(pose_a, pose_b), turned_route(pose_b, pose_a)
            assert max(one["depth"], default=0) == pytest.approx(max(turned["depth"], default=0), abs=1e-6)
            if "sphere" in {a, b} or not {a, b} & set(ROUND):
                assert_turned(one, turned)


def assert_turned(one: dict[str, Floats], turned: dict[str, Floats]) -> None:
    assert len(one["depth"]) == len(turned["depth"])
    for point, normal in zip(one["position"], one["normal"], strict=True):
        k = nearest(turned["position"], point)
        assert turned["position"][k] == pytest.approx(point, abs=1e-9)
        assert turned["normal"][k] == pytest.approx(-normal, abs=1e-9)


def nearest(points: Floats, point: Floats) -> int:
    return int(np.argmin(np.linalg.norm(points - point, axis=1)))


def lying(z: float, quaternion: Floats = UPRIGHT) -> Floats:
    return np.r_[0.1, -0.2, z, quaternion]


SLAB = Thing("box", (2.0, 2.0, 0.5))
"""Its top is at 0 when its centre is half a metre below."""

FLOORS = {
    "halfspace": (Thing("halfspace"), np.r_[0.0, 0.0, 0.0, UPRIGHT]),
    "box": (SLAB, np.r_[0.0, 0.0, -0.5, UPRIGHT]),
}
ON_ITS_SIDE = np.array([np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0])
SUNK = 1e-4


@pytest.mark.parametrize("floor", FLOORS)
def test_a_box_stands_on_its_four_corners(floor: str) -> None:
    plate, at = FLOORS[floor]
    two = Two(THINGS["box"], plate)
    for route in two.routes():
        points = route(lying(0.2 - SUNK), at)
        corners = sorted(map(tuple, (points["position"][:, :2] - (0.1, -0.2)).round(9).tolist()))
        assert corners == [(-0.5, -0.3), (-0.5, 0.3), (0.5, -0.3), (0.5, 0.3)]
        assert points["depth"] == pytest.approx(SUNK, abs=1e-12)
        assert points["normal"] == pytest.approx(np.tile([0.0, 0.0, 1.0], (4, 1)), abs=1e-12)
        assert points["position"][:, 2] == pytest.approx(-0.5 * SUNK, abs=1e-12)


@pytest.mark.parametrize("floor", FLOORS)
def test_each_corner_of_a_tilted_box_has_its_own_depth(floor: str) -> None:
    """A thousandth of a radian about y: one side is 1 mm deeper than the other."""
    plate, at = FLOORS[floor]
    two = Two(THINGS["box"], plate)
    tilt = 1e-3
    pose = lying(0.2, np.array([np.cos(tilt / 2), 0.0, np.sin(tilt / 2), 0.0]))
    for route in two.routes():
        points = route(pose, at)
        assert len(points["depth"]) == 4
        lever = points["position"][:, 0] - 0.1
        expected = lever * np.sin(tilt) + 0.2 * (np.cos(tilt) - 1.0)
        assert points["depth"] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("floor", FLOORS)
def test_a_standing_cylinder_rests_on_a_ring(floor: str) -> None:
    plate, at = FLOORS[floor]
    two = Two(THINGS["cylinder"], plate)
    for route in two.routes():
        points = route(lying(0.3 - SUNK), at)
        arms = points["position"][:, :2] - (0.1, -0.2)
        assert len(arms) >= 4
        assert np.linalg.norm(arms, axis=1) == pytest.approx(0.4, abs=1e-9)
        assert arms.mean(axis=0) == pytest.approx([0.0, 0.0], abs=1e-9)
        assert points["depth"] == pytest.approx(SUNK, abs=1e-9)


@pytest.mark.parametrize("floor", FLOORS)
def test_a_standing_cone_rests_on_a_ring(floor: str) -> None:
    plate, at = FLOORS[floor]
    two = Two(THINGS["cone"], plate)
    for route in two.routes():
        points = route(lying(0.225 - SUNK), at)
        arms = points["position"][:, :2] - (0.1, -0.2)
        assert len(arms) >= 4
        assert np.linalg.norm(arms, axis=1) == pytest.approx(0.4, abs=1e-9)
        assert points["depth"] == pytest.approx(SUNK, abs=1e-9)


@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize(
    ("name", "radius", "half"), [("cylinder", 0.4, 0.3), ("capsule", 0.3, 0.5), ("rod", 0.0, 0.6)]
)
def test_on_its_side_it_rests_on_a_line(floor: str, name: str, radius: float, half: float) -> None:
    plate, at = FLOORS[floor]
    two = Two(THINGS[name], plate)
    for route in two.routes():
        points = route(lying(radius - SUNK, ON_ITS_SIDE), at)
        arms = points["position"][:, :2] - (0.1, -0.2)
        assert len(arms) == 2
        assert sorted(arms[:, 1]) == pytest.approx([-half, half], abs=1e-9)
        assert arms[:, 0] == pytest.approx(0.0, abs=1e-9)
        assert points["depth"] == pytest.approx(SUNK, abs=1e-9)


def flat_mesh() -> Thing:
    """A square of 4 m at height 0, in 32 triangles that face up."""
    steps = np.linspace(-2.0, 2.0, 5)
    corners = np.array([[x, y, 0.0] for x in steps for y in steps])
    squares = [5 * i + j for i in range(4) for j in range(4)]
    triangles = [t for k in squares for t in ([k, k + 5, k + 6], [k, k + 6, k + 1])]
    return Thing("mesh", (), corners, np.array(triangles, dtype=np.int32))


@pytest.mark.parametrize("name", CONVEX)
def test_the_triangles_of_a_flat_mesh_act_as_one_plane(name: str) -> None:
    """No inner edge may push sideways, and the deepest point is that of a half-space."""
    mesh, plane = Two(THINGS[name], flat_mesh()), Two(THINGS[name], THINGS["halfspace"])
    at = np.r_[0.0, 0.0, 0.0, UPRIGHT]
    rng = np.random.default_rng(37)
    for _ in range(10):
        pose = np.r_[rng.uniform(-1.0, 1.0, 2), 0.0, random_quaternion(rng)]
        lowest = depth_along(
            THINGS[name], pose, Thing("box", (0.0, 0.0, 0.0)), at, np.array([[0.0, 0.0, 1.0]])
        )
        pose[2] += lowest[0] - 1e-3
        on_mesh, on_plane = mesh.kernel(pose, at, 1e-3), plane.kernel(pose, at, 1e-3)
        assert on_mesh["normal"] == pytest.approx(
            np.tile([0.0, 0.0, 1.0], (len(on_mesh["depth"]), 1)), abs=1e-6
        )
        assert deepest(on_mesh)[0] == pytest.approx(deepest(on_plane)[0], abs=1e-9)


def test_overhanging_faces_meet_in_their_clipped_polygon() -> None:
    """A box half over the edge of a slab touches it on the half that the slab reaches."""
    two = Two(THINGS["box"], SLAB)
    for route in two.routes():
        points = route(np.r_[2.0, 0.0, 0.2 - SUNK, UPRIGHT], FLOORS["box"][1])
        corners = sorted(map(tuple, points["position"][:, :2].round(9).tolist()))
        assert corners == [(1.5, -0.3), (1.5, 0.3), (2.0, -0.3), (2.0, 0.3)]
        assert points["depth"] == pytest.approx(SUNK, abs=1e-12)


def prism(sides: int) -> tuple[Thing, list[list[int]]]:
    """An upright prism of height 1 with polygon faces, as the compiler hands hulls over."""
    turn = 2.0 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    points = np.concatenate([np.c_[ring, np.full(sides, z)] for z in (-0.5, 0.5)])
    walls = [[k, (k + 1) % sides, (k + 1) % sides + sides, k + sides] for k in range(sides)]
    caps = [list(range(sides))[::-1], list(range(sides, 2 * sides))]
    return Thing("hull", (), points, np.zeros((0, 3), dtype=np.int32)), walls + caps


@pytest.mark.parametrize("sides", [3, 4, 5, 6])
def test_prisms_stand_on_all_corners_of_their_base(sides: int) -> None:
    """Hulls with polygon faces, on a slab and on a half-space."""
    thing, faces = prism(sides)
    for plate, at in FLOORS.values():
        arrays = engine_input([thing, plate]) | {"hull_faces": [faces]}
        world, fcl = World(arrays), FclAnswers(arrays)
        for answer in (None, fcl):
            points = world.collide_pair(0, lying(0.5 - SUNK), 1, at, 0.01, answer)
            arms = points["position"][:, :2] - (0.1, -0.2)
            assert len(arms) == sides
            assert np.linalg.norm(arms, axis=1) == pytest.approx(1.0, abs=1e-9)
            assert points["depth"] == pytest.approx(SUNK, abs=1e-12)


@pytest.mark.parametrize("name", ["box", "cylinder", "cone", "hull", "ellipsoid"])
def test_a_hair_s_breadth_does_not_change_a_manifold(name: str) -> None:
    """Impulses are carried from step to step, point by point: resting bodies must keep their points."""
    two = Two(THINGS[name], SLAB)
    height = {"box": 0.2, "cylinder": 0.3, "cone": 0.225, "hull": 0.4, "ellipsoid": 0.2}[name]
    rng = np.random.default_rng(35)
    for route in two.routes():
        rest = route(lying(height - SUNK), FLOORS["box"][1])
        for _ in range(10):
            nudge = np.r_[1e-10 * rng.normal(size=3), 1e-10 * rng.normal(size=4)]
            moved = route(lying(height - SUNK) + nudge, FLOORS["box"][1])
            assert len(moved["depth"]) == len(rest["depth"])
            for point in rest["position"]:
                assert moved["position"][nearest(moved["position"], point)] == pytest.approx(point, abs=1e-5)


@pytest.mark.parametrize("name", ["sphere", "box", "capsule", "hull", "cylinder", "cone", "ellipsoid"])
def test_runs_with_collision_fcl_follow_those_with_auto(name: str) -> None:
    """A fall of 5 mm with a spin, a bounce and rest on a slab, stepped both ways: 0.2 s."""
    states = [fall(name, collision) for collision in ("auto", "fcl")]
    assert states[0]["position"] == pytest.approx(states[1]["position"], abs=1e-6)
    assert states[0]["orientation"] == pytest.approx(states[1]["orientation"], abs=1e-5)


def fall(name: str, collision: str) -> dict[str, Floats]:
    height = {"sphere": 0.5, "capsule": 0.8, "hull": 0.6, "cylinder": 0.3, "cone": 0.225}.get(name, 0.2)
    settings = {
        "collision": collision,
        "fixed": np.array([0, 1], dtype=np.int32),
        "position": np.array([[0.0, 0.0, height + 5e-3], [0.0, 0.0, -0.5]]),
        "angular_velocity": np.array([[0.3, -0.2, 0.1], [0.0, 0.0, 0.0]]),
        "inertia": np.tile(0.1 * np.eye(3), (2, 1, 1)),
        "restitution": np.full((1, 1), 0.3),
        "static_friction": np.full((1, 1), 0.5),
        "kinetic_friction": np.full((1, 1), 0.4),
    }
    arrays = engine_input([THINGS[name], SLAB], **settings)
    world, answer = World(arrays), FclAnswers(arrays)
    assert world.needs_answer() is (collision == "fcl")
    world.advance(200, answer)
    return world.state()
