"""Forces, drag, fields, profiles, prescribed motion and turning friction at the border."""

from __future__ import annotations

from math import inf, pi
from typing import Any

import numpy as np
import pytest
from small_scenes import compiled

BODIES = """\
bodies:
  floor: {fixed: true, shape: {type: halfspace}, material: concrete}
  ball: {repeat: {count: [3, 1, 1], spacing: [1, 0, 0]}, shape: {type: sphere, radius: 0.1}, material: steel,
         position: [0, 0, 1], mass: 2 kg}
  t: {shape: {type: convex, points: [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, mass: 1 kg, material: steel,
      position: [0, 0, 5]}
"""
CUBE = "shape: {type: box, size: [1, 1, 1]}, material: steel"


def border(forces: str) -> dict[str, Any]:
    return compiled(f"{BODIES}forces:\n{forces}\n").engine_input()


def test_a_force_at_a_point_of_the_bodys_own_frame() -> None:
    """The tetrahedron's centre of mass is at a quarter of each edge."""
    given = border(
        "  f: {body: t, force: [1, 2, 3], torque: [4, 5, 6], at: [1, 0, 0], frame: body, from: 1, until: 2}"
    )
    assert given["force_body"].tolist() == [4]
    assert given["force_force"].tolist() == [[1, 2, 3]]
    assert given["force_torque"].tolist() == [[4, 5, 6]]
    assert given["force_at"].tolist() == [[0.75, -0.25, -0.25]]
    assert given["force_frame"].tolist() == [1]
    assert given["force_window"].tolist() == [[1, 2]]
    assert given["force_profile"].tolist() == [-1]


def test_without_a_point_it_acts_at_the_centre_of_mass_for_ever() -> None:
    given = border("  f: {body: t, force: [1, 2, 3]}")
    assert given["force_at"].tolist() == given["force_torque"].tolist() == [[0, 0, 0]]
    assert given["force_window"].tolist() == [[0, inf]]


def test_drag_of_moving_bodies_that_fit() -> None:
    """1/2 rho C A = 0.5 * 1.2 * 0.5 * 2 = 0.6 kg/m; the floor is fixed and left out."""
    given = border('  d: {body: "*", drag: {linear: 3, angular: 4, density: 1.2, area: 2, coefficient: 0.5}}')
    assert given["drag_body"].tolist() == [1, 2, 3, 4]
    assert given["drag_linear"].tolist() == [3] * 4
    assert given["drag_angular"].tolist() == [4] * 4
    np.testing.assert_allclose(given["drag_quadratic"], 0.6, rtol=1e-15)


def test_fields_everywhere_or_in_a_region() -> None:
    given = border(
        '  wind: {body: "ball*", acceleration: [1, 0, 0], region: [[0, 0, 0], [1, 2, 3]], until: 4}\n'
        "  lift: {body: t, acceleration: [0, 0, 9]}"
    )
    assert given["field_body"].tolist() == [1, 2, 3, 4]
    assert given["field_acceleration"].tolist() == [[1, 0, 0]] * 3 + [[0, 0, 9]]
    assert given["field_region"][0].tolist() == [[0, 0, 0], [1, 2, 3]]
    assert given["field_region"][3].tolist() == [[-inf] * 3, [inf] * 3]
    assert given["field_window"].tolist() == [[0, 4]] * 3 + [[0, inf]]


def test_profiles_are_numbered_and_equal_ones_shared() -> None:
    given = border(
        "  a: {body: t, force: [1, 0, 0], profile: {type: sine, frequency: 2, phase: 90 deg}}\n"
        "  b: {body: t, force: [1, 0, 0], profile: {type: ramp, over: 3}}\n"
        "  c: {body: t, force: [1, 0, 0], profile: {type: step, at: 4}}\n"
        "  d: {body: t, force: [1, 0, 0], profile: {type: table, samples: [[0, 1], [2, 3]]}}\n"
        '  e: {body: t, force: [1, 0, 0], profile: {type: expression, value: "2 - t"}}\n'
        "  f: {body: t, force: [1, 0, 0], profile: {type: ramp, over: 3 s}}"
    )
    assert given["force_profile"].tolist() == [0, 1, 2, 3, 4, 1]
    assert given["profile_kind"].tolist() == [1, 2, 3, 4, 5]
    data = [numbers.tolist() for numbers in given["profile_data"]]
    assert data == [[2, pi / 2], [3], [4], [0, 1, 2, 3], [0, 2, 1, 0, 3, 0]]


def test_prescribed_motion_of_fixed_bodies() -> None:
    """A position is a rotation vector and a way, a velocity is one as it stands."""
    given = compiled(
        "bodies:\n"
        f"  table: {{fixed: true, {CUBE}, position: [7, 8, 9], motion: {{translation: [1, 2, 3], "
        "rotation: {axis: [0, 2, 0], angle: 0.5}, profile: {type: sine, frequency: 1}}}\n"
        f"  belt: {{fixed: true, {CUBE}, motion: {{velocity: [4, 5, 6], from: 1, until: 2}}}}\n"
    ).engine_input()
    expected: dict[str, list[Any]] = {
        "body": [0, 1],
        "kind": [0, 1],
        "linear": [[1, 2, 3], [4, 5, 6]],
        "angular": [[0, 0.5, 0], [0, 0, 0]],
        "center": [[7, 8, 9], [0, 0, 0]],
        "window": [[0, inf], [1, 2]],
        "profile": [0, -1],
    }
    for name, values in expected.items():
        assert np.asarray(given[f"motion_{name}"]).tolist() == values, name


def test_surfaces_that_move_and_masses_that_attract() -> None:
    """A half-space has no mass to attract with; a fixed ball has the one of its material."""
    given = compiled(
        "bodies:\n"
        "  floor: {fixed: true, shape: {type: halfspace}, material: concrete, surface_velocity: [1, 0, 0]}\n"
        f"  sun: {{fixed: true, {CUBE}, mass: 5 kg, position: [0, 0, 3]}}\n"
        "  ball: {shape: {type: sphere, radius: 0.1}, mass: 2 kg, material: steel, position: [0, 0, 9]}\n"
    ).engine_input()
    assert np.asarray(given["surface_velocity"]).tolist() == [[1, 0, 0], [0, 0, 0], [0, 0, 0]]
    assert np.asarray(given["attracting_mass"]).tolist() == [0, 5, 2]


def test_turning_friction_is_that_of_the_scenes_pairs() -> None:
    model = compiled(
        f"{BODIES}pairs: [{{between: [steel, concrete], rolling_friction: 1 mm, spinning_friction: 2 mm}}]\n"
    )
    assert model.material_names == ("concrete", "steel")
    assert model.pairs.rolling_friction.tolist() == [[0, 0.001], [0.001, 0]]
    assert model.pairs.spinning_friction.tolist() == [[0, 0.002], [0.002, 0]]


def test_nothing_is_an_array_without_rows() -> None:
    """The border takes every array in every scene."""
    given = compiled(BODIES).engine_input()
    for name in (
        "spring_anchors",
        "joint_frames",
        "drive_motor",
        "force_at",
        "field_region",
        "motion_linear",
    ):
        assert np.asarray(given[name]).shape[0] == 0, name
    assert given["profile_data"] == given["spring_force_curve"] == []


@pytest.mark.parametrize("name", ["spring", "joint", "drive", "force", "drag", "field", "motion"])
def test_arrays_of_one_kind_have_equally_many_rows(name: str) -> None:
    given = compiled(
        f"{BODIES}"
        f"  plate: {{fixed: true, {CUBE}, motion: {{velocity: [1, 0, 0]}}}}\n"
        "springs: {s: {type: linear, between: [world, t], stiffness: 1, anchors: [[0, 0, 9], [0, 0, 0]]}}\n"
        "joints: {j: {type: hinge, between: [world, t], anchor: [0, 0, 0], axis: [1, 0, 0], friction: 1}}\n"
        "forces:\n  f: {body: t, force: [1, 0, 0]}\n  d: {body: t, drag: {linear: 1}}\n"
        "  a: {body: t, acceleration: [1, 0, 0]}\n"
    ).engine_input()
    rows = {key: len(value) for key, value in given.items() if key.startswith(f"{name}_")}  # type: ignore[arg-type]
    assert len(rows) >= 4
    assert set(rows.values()) == {1}, rows
