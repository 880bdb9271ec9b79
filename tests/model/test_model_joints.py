"""Joints and their drives at the border: frames that coincide at the start, numbers, and who collides."""

from __future__ import annotations

from math import inf, pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_scenes import compiled, problems

from physsim.errors import dotted
from physsim.model import rotation

BODIES = """\
bodies:
  a: {shape: {type: box, size: [1, 1, 1]}, mass: 2 kg, position: [0, 0, 3], material: steel,
      orientation: {axis: [1, 2, 3], angle: 40 deg}}
  b: {shape: {type: cone, radius: 0.5, height: 1}, mass: 3 kg, position: [2, 0, 3], material: steel,
      orientation: {axis: [0, 1, 1], angle: -70 deg}}
"""
KINDS = {
    "distance": (0, "length: 2"),
    "ball": (1, "anchor: [1, 0, 3]"),
    "hinge": (2, "anchor: [1, 0, 3], axis: [1, 2, 2]"),
    "slider": (3, "anchor: [1, 0, 3], axis: [1, 2, 2]"),
    "fixed": (4, "anchor: [1, 0, 3]"),
    "cone": (5, "anchor: [1, 0, 3], axis: [1, 2, 2], max_angle: 30 deg, restitution: 0.5, damping: 2"),
    "universal": (6, "anchor: [1, 0, 3], axes: [[1, 2, 2], [2, -2, 1]]"),
    "cylindrical": (7, "anchor: [1, 0, 3], axis: [1, 2, 2]"),
    "planar": (8, "anchor: [1, 0, 3], normal: [1, 2, 2], axis: [2, -2, 1]"),
    "screw": (9, "anchor: [1, 0, 3], axis: [1, 2, 2], pitch: 2 mm"),
}


def border(joints: str) -> dict[str, Any]:
    return compiled(f"{BODIES}joints:\n{joints}\n").engine_input()


def one(kind: str, more: str = "", between: str = "a, b") -> dict[str, Any]:
    keys = KINDS[kind][1] + (f", {more}" if more else "")
    return border(f"  j: {{type: {kind}, between: [{between}], {keys}}}")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("between", ["a, b", "world, b", "a, world"])
def test_anchors_and_frames_of_both_ends_coincide_at_the_start(kind: str, between: str) -> None:
    """The way back to the world by each end, by hand: x = c + R r, and R q; measured error 9e-16."""
    found = one(kind, between=between)
    assert found["joint_kind"].tolist() == [KINDS[kind][0]]
    places, frames = [], []
    for end in range(2):
        number = found["joint_bodies"][0, end]
        world = number < 0
        center = np.zeros(3) if world else found["position"][number]
        turn = np.eye(3) if world else rotation.matrix(found["orientation"][number])
        places.append(center + turn @ found["joint_anchors"][0, end])
        frames.append(turn @ rotation.matrix(found["joint_frames"][0, end]))
    np.testing.assert_allclose(frames[0], frames[1], rtol=0, atol=1e-14)
    if kind != "distance":
        np.testing.assert_allclose(places, [[1, 0, 3]] * 2, rtol=0, atol=1e-14)
    if "[1, 2, 2]" in KINDS[kind][1]:
        np.testing.assert_allclose(frames[0][:, 2], np.array([1, 2, 2]) / 3, rtol=0, atol=1e-14)
    if kind in ("universal", "planar"):
        np.testing.assert_allclose(frames[0][:, 0], np.array([2, -2, 1]) / 3, rtol=0, atol=1e-14)


def test_parameters_of_each_kind() -> None:
    assert one("distance")["joint_parameters"].tolist() == [[2, 0, 0, 0]]
    assert one("cone")["joint_parameters"].tolist() == [[pi / 6, 0.5, 0, 0]]
    assert one("cone")["joint_damping"].tolist() == [2]
    assert one("screw")["joint_parameters"][0, 0] == pytest.approx(0.002 / (2 * pi))
    assert one("ball")["joint_break"].tolist() == [[inf, inf]]
    assert one("hinge", "break_force: 5 N, break_torque: 7 N*m")["joint_break"].tolist() == [[5, 7]]


def test_a_distance_as_placed_and_a_rope() -> None:
    given = border(
        "  rod: {type: distance, between: [a, b]}\n"
        "  rope: {type: distance, between: [a, b], limits: [0, 3], restitution: 0.5}"
    )
    assert given["joint_kind"].tolist() == [0, 11]
    assert given["joint_parameters"][0, 0] == pytest.approx(2, rel=1e-15)
    assert given["drive_joint"].tolist() == [1]
    assert (given["drive_limits"].tolist(), given["drive_restitution"].tolist()) == ([[0, 3]], [0.5])


def test_gears_name_their_joints_by_number_and_the_bodies_that_turn() -> None:
    given = border(
        "  g: {type: gear, joints: [right, left], ratio: -2, break_torque: 9}\n"
        "  left: {type: hinge, between: [world, a], anchor: [0, 0, 3], axis: [0, 1, 0]}\n"
        "  right: {type: hinge, between: [world, b], anchor: [2, 0, 3], axis: [0, 1, 0]}"
    )
    assert given["joint_parameters"][0].tolist() == [-2, 2, 1, 0]
    assert given["joint_bodies"][0].tolist() == [1, 0]
    assert given["joint_break"][0].tolist() == [inf, 9]


def test_what_drives_a_coordinate() -> None:
    motor = "motor: {angle: 1, stiffness: 5, damping: 2, profile: {type: sine, frequency: 3}}"
    given = one(
        "hinge",
        "limits: [-90 deg, 1], restitution: 0.5, friction: 4, damping: 3, "
        f"spring: {{stiffness: 6, rest: 2}}, {motor}",
    )
    assert given["drive_limits"][0] == pytest.approx([-pi / 2, 1])
    assert [given[f"drive_{name}"].tolist() for name in ("restitution", "friction", "damping")] == [
        [0.5],
        [4],
        [3],
    ]
    assert given["drive_spring"].tolist() == [[6, 2]]
    assert (given["drive_motor_kind"].tolist(), given["drive_motor"].tolist()) == ([2], [[1, 5, 2, inf]])
    assert given["profile_kind"].tolist() == [1]
    assert given["drive_profile"].tolist() == [0]


def test_speed_motors_have_a_bound() -> None:
    given = one("slider", "motor: {speed: 2 m/s, max_force: 30 N}")
    assert given["drive_motor_kind"].tolist() == [1]
    assert given["drive_motor"].tolist() == [[2, 30, 0, 0]]
    assert given["drive_profile"].tolist() == [-1]
    assert given["drive_limits"].tolist() == [[-inf, inf]]


def test_coordinates_are_numbered_and_idle_ones_left_out() -> None:
    given = one("planar", "angle: {friction: 1}, x: {damping: 1}")
    assert sorted(zip(given["drive_coordinate"].tolist(), given["drive_friction"].tolist(), strict=True)) == [
        (0, 0),
        (2, 1),
    ]
    assert len(one("hinge")["drive_joint"]) == 0


@pytest.mark.parametrize(
    ("joints", "pairs"),
    [
        ("  j: {type: ball, between: [b, a], anchor: [1, 0, 3]}", [[0, 1]]),
        ("  j: {type: ball, between: [b, a], anchor: [1, 0, 3], collide: true}", []),
        ("  j: {type: ball, between: [world, a], anchor: [1, 0, 3]}", []),
    ],
)
def test_joined_bodies_do_not_collide_unless_they_say_so(joints: str, pairs: list[list[int]]) -> None:
    assert border(joints)["no_contact"].tolist() == pairs


def test_joined_pairs_and_named_pairs_are_one_list() -> None:
    model = compiled(
        f"{BODIES}joints:\n  j: {{type: ball, between: [b, a], anchor: [1, 0, 3]}}\n"
        'no_contact: [["a", "*"]]\n'
    )
    assert model.no_contact.tolist() == [[0, 1]]


def test_a_distance_joint_without_direction_is_an_error() -> None:
    (problem,) = problems(
        f"{BODIES}joints:\n  j: {{type: distance, between: [world, a], anchors: [[0, 0, 3], [0, 0, 0]], "
        "length: 1}\n"
    )
    assert dotted(problem.path) == "joints.j.anchors"
    assert "coincide" in problem.message
    assert "type: ball" in str(problem.hint)


def warnings(text: str) -> list[tuple[str, str]]:
    return [(dotted(problem.path), problem.message) for problem in compiled(text).warnings]


def test_placed_at_another_distance() -> None:
    """Centres are 2 m apart; a nanometre is not told, a millimetre is."""
    scene = BODIES + "joints:\n  j: {type: distance, between: [a, b], LENGTH}\n"
    assert warnings(scene.replace("LENGTH", "length: 2.000000001")) == []
    assert warnings(scene.replace("LENGTH", "limits: [1, 2]")) == []
    ((path, message),) = warnings(scene.replace("LENGTH", "length: 2.001"))
    assert path == "joints.j.length"
    assert "2 m" in message
    ((path, message),) = warnings(scene.replace("LENGTH", "limits: [0, 1.5]"))
    assert path == "joints.j.limits"


def test_a_spring_without_direction() -> None:
    ((path, message),) = warnings(
        BODIES + "springs:\n  s: {type: linear, between: [world, a], anchors: [[0, 0, 3], [0, 0, 0]], "
        "stiffness: 1}\n"
    )
    assert path == "springs.s.anchors"
    assert "coincide" in message


@given(st.tuples(*[st.floats(-1, 1)] * 3), st.tuples(*[st.floats(-1, 1)] * 3))
def test_frames_of_axes_are_rotations(z: tuple[float, ...], x: tuple[float, ...]) -> None:
    """Any two directions that are not parallel; measured error 4e-16."""
    if np.linalg.norm(np.cross(z, x)) < 1e-3:
        return
    turn = rotation.matrix(rotation.from_axes(z, x))
    unit = np.array(z) / np.linalg.norm(z)
    across = np.array(x) - unit * (unit @ np.array(x))
    np.testing.assert_allclose(turn[:, 2], unit, rtol=0, atol=1e-14)
    np.testing.assert_allclose(turn[:, 0], across / np.linalg.norm(across), rtol=0, atol=1e-12)
