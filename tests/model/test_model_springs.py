"""Springs at the border: what crosses it, and damping ratios against the closed form of the sheet."""

from __future__ import annotations

from math import pi, sqrt
from typing import Any

import numpy as np
import pytest
from small_scenes import compiled

from physsim.model import rotation

# A cube of 2 kg at (1, 0, 0), turned by 90 degrees about z, and a rod of 3 kg along z.
BODIES = """\
bodies:
  cube: {shape: {type: box, size: [0.6, 0.6, 0.6]}, mass: 2 kg, position: [1, 0, 0], collides: false,
         orientation: {axis: [0, 0, 1], angle: 90 deg}}
  rod: {shape: {type: rod, length: 1.2}, mass: 3 kg, position: [4, 0, 0], collides: false}
  wall: {shape: {type: halfspace}, fixed: true, collides: false}
"""
CUBE = 2 * 0.6**2 / 6
ROD = 3 * 1.2**2 / 12


def border(springs: str) -> dict[str, Any]:
    return compiled(f"{BODIES}springs:\n  s: {{{springs}}}\n").engine_input()


def parameters(springs: str) -> list[float]:
    return border(springs)["spring_parameters"][0].tolist()


def test_anchors_leave_from_the_centres_of_mass() -> None:
    """A corner tetrahedron: its centre of mass is at a quarter of each edge; the world has none."""
    given = compiled(
        "bodies:\n  t: {shape: {type: convex, points: [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, mass: 1 kg, "
        "collides: false, position: [5, 5, 5]}\n"
        "springs: {s: {type: linear, between: [world, t], anchors: [[1, 2, 3], [1, 0, 0]], stiffness: 1}}\n"
    ).engine_input()
    assert given["spring_bodies"].tolist() == [[-1, 0]]
    np.testing.assert_allclose(
        given["spring_anchors"][0], [[1, 2, 3], [0.75, -0.25, -0.25]], rtol=0, atol=1e-15
    )


def test_rest_length_as_placed_or_as_given() -> None:
    """The anchor of the cube is turned with it: (0, 0.3, 0) of its own is (-0.3, 0, 0) of the world."""
    spring = "type: linear, between: [world, cube], anchors: [[0, 0, 0], [0, 0.3, 0]], stiffness: 5"
    assert parameters(spring)[0] == pytest.approx(0.7, rel=1e-15)
    assert parameters(f"{spring}, rest_length: 20 cm, preload: 3 N") == pytest.approx([0.2, 5, 0, 3, 0])


@pytest.mark.parametrize(("acts", "number"), [("always", 0), ("tension", 1), ("compression", 2)])
def test_what_it_acts_against(acts: str, number: int) -> None:
    assert parameters(f"type: linear, between: [world, cube], stiffness: 5, acts: {acts}")[4] == number


def test_damping_ratio_with_two_free_ends_through_the_centres() -> None:
    """1/m_eff = 1/2 + 1/3 along the line of centres, where no end turns."""
    k, zeta = 100.0, 0.25
    found = parameters(f"type: linear, between: [cube, rod], stiffness: {k}, damping_ratio: {zeta}")
    assert found[2] == pytest.approx(2 * zeta * sqrt(k / (1 / 2 + 1 / 3)), rel=1e-14)


def test_damping_ratio_with_an_arm() -> None:
    """Tied to the rod's end, 0.6 m above its centre, along x: 1/m_eff = 1/m + r^2 / I = (1 + 3) / m."""
    found = parameters(
        "type: linear, between: [world, rod], anchors: [[0, 0, 0.6], [0, 0, 0.6]], stiffness: 100, "
        "damping_ratio: 1"
    )
    assert found[2] == pytest.approx(2 * sqrt(100 * 3 / 4), rel=1e-14)


def test_fixed_bodies_count_as_the_world() -> None:
    spring = (
        "type: linear, between: [{}, cube], anchors: [[-1, 0, 0], [0, 0, 0]], stiffness: 9, damping_ratio: 1"
    )
    assert parameters(spring.format("wall")) == parameters(spring.format("world"))


def test_torsional_springs_turn_both_ends() -> None:
    """1/I_eff = 1/I_cube + 1/I_rod about y; the axis is y of the world and -x of the turned cube."""
    given = border(
        "type: torsional, between: [cube, rod], axis: [0, 2, 0], stiffness: 3, damping_ratio: 0.5, "
        "rest_angle: 90 deg"
    )
    assert given["spring_kind"].tolist() == [1]
    np.testing.assert_allclose(given["spring_axis"][0], [[1, 0, 0], [0, 1, 0]], rtol=0, atol=1e-15)
    rest, k, c, *_ = given["spring_parameters"][0].tolist()
    assert (rest, k) == (pi / 2, 3)
    assert c == pytest.approx(2 * 0.5 * sqrt(3 / (1 / CUBE + 1 / ROD)), rel=1e-14)


def test_curves_cross_as_they_are() -> None:
    given = border(
        "type: linear, between: [world, cube], force_curve: [[-1, -8], [0, 0], [1, 2]], "
        "damping_curve: [[0, 0], [1, 4]]"
    )
    assert given["spring_force_curve"][0].tolist() == [[-1, -8], [0, 0], [1, 2]]
    assert given["spring_damping_curve"][0].tolist() == [[0, 0], [1, 4]]
    assert given["spring_parameters"][0].tolist()[1:3] == [0, 0]


def test_limits_are_stops_behind_the_declared_joints() -> None:
    given = compiled(
        f"{BODIES}springs: {{s: {{type: linear, between: [world, cube], anchors: [[0, 0, 3], [0, 0.1, 0]], "
        "limits: [1, 4], restitution: 0.5}}\n"
        "joints: {j: {type: ball, between: [cube, rod], anchor: [2, 0, 0]}}\n"
    ).engine_input()
    assert given["joint_kind"].tolist() == [1, 11]
    assert given["joint_bodies"].tolist() == [[0, 1], [-1, 0]]
    assert given["joint_anchors"][1].tolist() == given["spring_anchors"][0].tolist()
    assert given["drive_joint"].tolist() == [1]
    assert given["drive_limits"].tolist() == [[1, 4]]
    assert given["drive_restitution"].tolist() == [0.5]


def test_oscillation_about_rest() -> None:
    """omega = sqrt(k/m), f = omega / 2 pi, c_crit = 2 sqrt(k m); of curves the mean slope in the corner."""
    model = compiled(
        f"{BODIES}springs:\n"
        "  s: {type: linear, between: [world, cube], stiffness: 50, damping: 4}\n"
        "  n: {type: linear, between: [world, cube], force_curve: [[-1, -8], [0, 0], [1, 2]], "
        "damping_curve: [[-1, -1], [1, 1]]}\n"
        "  d: {type: linear, between: [world, cube], damping: 4}\n"
    )
    s, n, d = (row.oscillation for row in model.mechanics.springs.rows)
    assert s.angular_frequency == pytest.approx(5)
    assert s.frequency == pytest.approx(5 / (2 * pi))
    assert s.critical_damping == pytest.approx(20)
    assert s.damping_ratio == pytest.approx(0.2)
    assert (n.stiffness, n.damping) == (5, 1)
    assert (d.angular_frequency, d.critical_damping, d.damping_ratio) == (0, None, None)


def test_frames_from_two_axes() -> None:
    """The first axis is kept, the second comes as near as that allows."""
    turn = rotation.matrix(rotation.from_axes((0, 0, -2), (1, 1, 5)))
    half = sqrt(0.5)
    np.testing.assert_allclose(turn[:, 2], [0, 0, -1], rtol=0, atol=1e-15)
    np.testing.assert_allclose(turn[:, 0], [half, half, 0], rtol=0, atol=1e-15)
    assert np.linalg.det(turn) == pytest.approx(1)
