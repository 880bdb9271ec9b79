"""FCL's answers for every pair of shapes, against constructed truth and against brute force."""

from __future__ import annotations

from itertools import combinations_with_replacement

import numpy as np
import pytest
from collision_asking import Asker
from collision_oracle import true_depth
from collision_shapes import (
    SOLIDS,
    THINGS,
    Floats,
    Thing,
    depth_along,
    product,
    random_direction,
    random_quaternion,
    rotation,
    touching,
)

PAIRS = list(combinations_with_replacement(SOLIDS, 2))
"""All pairs of bounded shapes, themselves included; "mesh" is one triangle, as exact meshes are asked for."""

# Errors measured over many random poses per pair are in docs/contacts.md. These tolerances are about three
# times the largest, for shapes of one metre.
DEPTH_TOLERANCE = 5e-6
NORMAL_TOLERANCE = 3e-3


def ask_twice(a: str, b: str) -> Asker:
    return Asker([THINGS[a], THINGS[b]])


def independent_depth(a: Thing, pose_a: Floats, b: Thing, pose_b: Floats, normal: Floats) -> float:
    return float(depth_along(a, pose_a, b, pose_b, normal[None])[0])


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_apart_the_gap_and_normal_are_the_constructed_ones(a: str, b: str) -> None:
    ask = ask_twice(a, b)
    rng = np.random.default_rng(11)
    for gap in (1e-3, 1e-2, 0.1, 1.0) * 5:
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], gap, rng)
        answer = ask(0, pose_a, 1, pose_b)
        assert answer.found
        assert np.linalg.norm(answer.normal) == pytest.approx(1.0, abs=1e-12)
        assert answer.normal == pytest.approx(n, abs=NORMAL_TOLERANCE)
        assert answer.depth == pytest.approx(-gap, abs=DEPTH_TOLERANCE)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_nearly_touching_the_gap_is_right_though_corners_have_no_clear_normal(a: str, b: str) -> None:
    ask = ask_twice(a, b)
    rng = np.random.default_rng(12)
    for gap in (1e-9, 1e-7, 1e-6, 1e-5) * 5:
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], gap, rng)
        answer = ask(0, pose_a, 1, pose_b)
        assert answer.found
        assert answer.depth == pytest.approx(-gap, abs=DEPTH_TOLERANCE)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_overlapping_the_depth_is_the_least_over_all_directions(a: str, b: str) -> None:
    """Two cases have a wider tolerance: shapes without volume that reach deep into one another, where the
    depth as a function of the direction has a crease between two nearly equal minima (measured: 2e-5)."""
    ask = ask_twice(a, b)
    rng = np.random.default_rng(13)
    for overlap in (1e-6, 1e-4, 1e-2, 0.1) * 2:
        pose_a, pose_b, n = touching(THINGS[a], THINGS[b], -overlap, rng)
        expected, _ = true_depth(THINGS[a], pose_a, THINGS[b], pose_b, n)
        answer = ask(0, pose_a, 1, pose_b)
        assert answer.found
        assert answer.depth == pytest.approx(expected, abs=DEPTH_TOLERANCE if overlap < 0.1 else 6e-5)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_the_depth_is_that_along_the_normal_and_moving_along_it_frees_a(a: str, b: str) -> None:
    """The sign of the normal, by independent support points: after a move of A by depth + gap they are
    apart."""
    ask = ask_twice(a, b)
    rng = np.random.default_rng(14)
    for overlap in (-1e-2, 1e-3, 0.05):
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], -overlap, rng)
        answer = ask(0, pose_a, 1, pose_b)
        along = independent_depth(THINGS[a], pose_a, THINGS[b], pose_b, answer.normal)
        assert answer.depth == pytest.approx(along, abs=1e-13)
        pose_a[:3] += (answer.depth + 1e-3) * answer.normal
        assert ask(0, pose_a, 1, pose_b).depth == pytest.approx(-1e-3, abs=DEPTH_TOLERANCE)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_exchanging_the_shapes_turns_the_normal_and_changes_no_bit(a: str, b: str) -> None:
    ask = ask_twice(a, b)
    rng = np.random.default_rng(15)
    for overlap in (-0.1, -1e-4, 1e-4, 0.1):
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], -overlap, rng)
        answer, other = ask(0, pose_a, 1, pose_b), ask(1, pose_b, 0, pose_a)
        assert other.found == answer.found
        assert other.depth == answer.depth
        assert (other.normal == -answer.normal).all()
        assert (other.position == answer.position).all()


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_moving_both_shapes_moves_the_answer_along(a: str, b: str) -> None:
    """A thousand metres away, where a rounding is 1e-13 m. The normal is compared by the depth along it,
    because two directions of equal depth are equally right."""
    ask = ask_twice(a, b)
    rng = np.random.default_rng(16)
    for overlap in (-0.1, -1e-3, 1e-3, 0.05):
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], -overlap, rng)
        q, t = random_quaternion(rng), 1e3 * random_direction(rng)
        moved_a, moved_b = (
            np.r_[rotation(q) @ pose[:3] + t, product(q, pose[3:])] for pose in (pose_a, pose_b)
        )
        answer, moved = ask(0, pose_a, 1, pose_b), ask(0, moved_a, 1, moved_b)
        assert moved.depth == pytest.approx(answer.depth, abs=2e-5)
        back = independent_depth(THINGS[a], pose_a, THINGS[b], pose_b, rotation(q).T @ moved.normal)
        assert back == pytest.approx(answer.depth, abs=2e-5)


@pytest.mark.parametrize(("a", "b"), PAIRS)
def test_nothing_is_found_beyond_the_margin(a: str, b: str) -> None:
    ask = ask_twice(a, b)
    rng = np.random.default_rng(17)
    for gap in (1e-3, 0.1, 3.0):
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], gap, rng)
        assert not ask(0, pose_a, 1, pose_b, margin=0.99 * gap).found
        assert ask(0, pose_a, 1, pose_b, margin=1.01 * gap).found


@pytest.mark.parametrize("name", SOLIDS)
def test_a_halfspace_is_asked_for_in_closed_form(name: str) -> None:
    """Depth and normal to rounding, overlapping or apart; the normal is the plane's whatever the shape
    does."""
    thing, plane = THINGS[name], THINGS["halfspace"]
    ask = Asker([thing, plane])
    rng = np.random.default_rng(18)
    for _ in range(20):
        pose, plane_pose = (np.r_[rng.normal(size=3), random_quaternion(rng)] for _ in range(2))
        n = rotation(plane_pose[3:])[:, 2]
        lowest = -depth_along(thing, pose, Thing("box", (0.0, 0.0, 0.0)), plane_pose, n[None])[0]
        answer, other = ask(0, pose, 1, plane_pose), ask(1, plane_pose, 0, pose)
        assert answer.depth == pytest.approx(-lowest, abs=1e-14)
        assert answer.normal == pytest.approx(n, abs=1e-15)
        assert (other.normal == -answer.normal).all()
        assert n @ (answer.position - plane_pose[:3]) == pytest.approx(0.5 * lowest, abs=1e-14)


@pytest.mark.parametrize("name", [name for name in SOLIDS if name != "sphere"])
def test_the_point_against_a_sphere_lies_on_its_radius(name: str) -> None:
    """The witness point has a closed form there: centre - normal * (radius - depth / 2)."""
    ask = ask_twice("sphere", name)
    rng = np.random.default_rng(19)
    for overlap in (-0.1, -1e-3, 1e-3, 0.1):
        pose_a, pose_b, _ = touching(THINGS["sphere"], THINGS[name], -overlap, rng)
        answer = ask(0, pose_a, 1, pose_b)
        expected = pose_a[:3] - (0.5 - 0.5 * answer.depth) * answer.normal
        assert answer.position == pytest.approx(expected, abs=3e-4)


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e3, 1e6])
@pytest.mark.parametrize(
    ("a", "b"), [("box", "cylinder"), ("cone", "ellipsoid"), ("hull", "hull"), ("sphere", "hull")]
)
def test_lengths_have_no_preferred_unit(a: str, b: str, scale: float) -> None:
    """FCL's own tolerances are absolute, 1e-6: without units that suit the pair a millimetre would be
    coarse."""
    small, large = ask_twice(a, b), Asker([THINGS[a].scaled(scale), THINGS[b].scaled(scale)])
    rng = np.random.default_rng(20)
    for overlap in (-0.1, -1e-3, 1e-3, 0.1):
        pose_a, pose_b, _ = touching(THINGS[a], THINGS[b], -overlap, rng)
        wide_a, wide_b = (np.r_[scale * pose[:3], pose[3:]] for pose in (pose_a, pose_b))
        one, other = small(0, pose_a, 1, pose_b), large(0, wide_a, 1, wide_b, margin=10.0 * scale)
        assert other.depth / scale == pytest.approx(one.depth, abs=2e-5)


def test_a_grain_on_a_great_slab_gets_the_slab_s_normal() -> None:
    """Near the slab's border the line of centres is nearly flat; and FCL's units must suit the grain, not
    the slab."""
    slab, grain = Thing("box", (50.0, 50.0, 0.1)), Thing("cylinder", (1e-3, 2e-3))
    ask = Asker([grain, slab])
    at = np.array([1.0, 0.0, 0.0, 0.0])
    answer = ask(0, np.r_[49.9, -49.9, 0.1 + 2e-3 - 1e-6, at], 1, np.r_[0.0, 0.0, 0.0, at])
    assert answer.normal == pytest.approx([0.0, 0.0, 1.0], abs=1e-9)
    assert answer.depth == pytest.approx(1e-6, abs=1e-11)


@pytest.mark.parametrize(
    ("thing", "depth"),
    [
        (THINGS["sphere"], 1.0),
        (THINGS["capsule"], 0.6),
        (THINGS["box"], 0.4),
        (THINGS["cylinder"], 0.6),
        (THINGS["ellipsoid"], 0.4),
        (Thing("ellipsoid", (0.5, 0.5, 0.5)), 1.0),
        (THINGS["rod"], 0.0),
    ],
)
def test_one_within_the_other_the_least_width_is_the_depth(thing: Thing, depth: float) -> None:
    """Same place, same orientation: no line of centres, and FCL's own penetration never ends for two
    spheres here."""
    ask = Asker([thing, thing])
    pose = np.array([1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0])
    answer = ask(0, pose, 1, pose)
    assert answer.found
    assert np.linalg.norm(answer.normal) == pytest.approx(1.0, abs=1e-12)
    assert answer.depth == pytest.approx(depth, abs=1e-5)
