"""What a valid scene means: SI values, defaults, orientations, shapes, repetition."""

from __future__ import annotations

import math
import pickle
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from scipy.spatial.transform import Rotation

from physsim.scene import Scene, load_scene_text
from physsim.scene.checks.inertia import inertia_trouble, principal_moments
from physsim.scene.patterns import matches
from physsim.scene.spec import InertiaSpec, OrientationSpec


def test_defaults_are_those_of_the_language(minimal: str) -> None:
    spec = load_scene_text(minimal).spec
    assert spec.world.gravity == (0.0, 0.0, -9.81)
    assert spec.world.gravitation == 0.0
    assert spec.simulation.model_dump() == {
        "duration": 1.0,
        "timestep": 0.001,
        "integrator": "semi_implicit_euler",
        "impacts": "stepped",
        "collision": "auto",
        "iterations": 50,
        "tolerance": 1e-6,
        "stabilization": "split_impulse",
        "baumgarte": 0.2,
        "slip_speed": 0.01,
        "bounce_speed": 0.0,
        "until": None,
        "seed": 0,
        "threads": 1,
    }
    assert spec.mixing.model_dump() == {"restitution": "minimum", "friction": "geometric_mean"}
    assert spec.record.model_dump() == {"every": 0.01, "contacts": True, "joints": True, "energy": True}
    body = spec.bodies["ball"]
    assert (body.fixed, body.collides, body.position, body.velocity) == (False, True, (0, 0, 0), (0, 0, 0))
    assert body.orientation.as_quaternion() == (1, 0, 0, 0)


def test_everything_of_the_language_is_read_in_si() -> None:
    scene = load_scene_text("""
physsim: 1
$schema: ../schemas/scene.schema.json
title: Crate on a moving plate
parameters: {drop: 0.5 m, e: 0.4}
world: {gravity: [0, 0, -1 g0]}
simulation: {duration: 5 s, timestep: 1 ms, slip_speed: 1 cm/s, until: at_rest}
materials:
  rubber: {density: 1.1 g/cm^3, restitution: 0.8, static_friction: 0.8, kinetic_friction: 0.75, color: "#d33"}
pairs:
  - {between: [rubber, steel], restitution: "${e}", static_friction: 0.7, kinetic_friction: 60 %}
mixing: {restitution: error, friction: product}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 2], offset: 1 cm}, material: concrete}
  plate: {shape: {type: box, size: [2 m, 2 m, 10 cm]}, material: steel, position: [0, 0, 5 cm]}
  crate:
    shape: {type: cylinder, radius: 1 in, height: 1 ft}
    mass: 12 lb
    inertia: {xx: 1, yy: 1, zz: 1 kg*m^2}
    material: rubber
    position: [0, 0, "${drop}"]
    orientation: {axis: [0, 2, 0], angle: 30 deg}
    velocity: [36 km/h, 0, 0]
    angular_velocity: [0, 0, 60 rpm]
  brick:
    repeat: {count: [2, 1, 3], spacing: [21 cm, 0, 7 cm]}
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
no_contact: [[crate, "brick*"], ["brick[0,0,0]", plate]]
record: {every: 10 ms, energy: false}
expect:
  - {quantity: bodies.crate.position.z, at: 5 s, value: 0.15 m, within: 1 cm}
  - {quantity: "bodies.brick[0,0,2].position.z", min: 0}
  - {quantity: time, max: 5 s}
""")
    spec = scene.spec
    assert spec.title == scene.title == "Crate on a moving plate"
    assert spec.parameters == {"drop": 0.5, "e": 0.4}
    assert spec.world.gravity[2] == -9.80665
    assert spec.materials["rubber"].density == 1100.0
    assert (spec.pairs[0].restitution, spec.pairs[0].kinetic_friction) == (0.4, 0.6)
    floor: Any = spec.bodies["floor"].shape
    assert (floor.normal, floor.offset) == ((0.0, 0.0, 1.0), 0.01)
    crate: Any = spec.bodies["crate"]
    assert (crate.shape.radius, crate.shape.height, crate.mass) == (0.0254, 0.3048, 5.44310844)
    assert (crate.position, crate.velocity) == ((0.0, 0.0, 0.5), (10.0, 0.0, 0.0))
    assert crate.angular_velocity[2] == 2 * math.pi
    assert crate.orientation.as_quaternion() == pytest.approx(
        (math.cos(math.pi / 12), 0, math.sin(math.pi / 12), 0)
    )
    assert spec.no_contact == (("crate", "brick*"), ("brick[0,0,0]", "plate"))
    assert (spec.expect[0].at, spec.expect[0].value, spec.expect[0].within) == (5.0, 0.15, 0.01)
    assert (spec.expect[1].at, spec.expect[1].parsed.name) == ("end", "brick[0,0,2]")
    assert (spec.simulation.steps, spec.steps_per_frame) == (5000, 10)


SHAPES = [
    "{type: sphere, radius: 1}",
    "{type: hollow_sphere, radius: 1}",
    "{type: box, size: [1, 2, 3]}",
    "{type: cylinder, radius: 1, height: 2}",
    "{type: capsule, radius: 1, height: 2}",
    "{type: cone, radius: 1, height: 2}",
    "{type: ellipsoid, radii: [1, 2, 3]}",
    "{type: convex, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}",
    "{type: compound, parts: [{shape: {type: sphere, radius: 1}, position: [1, 0, 0], material: wood}]}",
]


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_is_read(shape: str, minimal: str) -> None:
    text = minimal.replace("{type: sphere, radius: 5 cm}", shape)
    assert load_scene_text(text).spec.bodies["ball"].shape.type in shape


def test_a_rod_needs_a_mass_and_then_is_fine(minimal: str) -> None:
    text = minimal.replace("{type: sphere, radius: 5 cm}", "{type: rod, length: 1 m}")
    assert load_scene_text(f"{text}    mass: 1 kg\n").spec.bodies["ball"].mass == 1.0


def test_meshes_are_found_beside_the_scene(minimal: str, tmp_path: Any) -> None:
    (tmp_path / "meshes").mkdir()
    file = tmp_path / "meshes" / "crate.obj"
    file.touch()
    text = minimal.replace(
        "{type: sphere, radius: 5 cm}", "{type: mesh, file: meshes/crate.obj, scale: 1 mm}"
    )
    scene = load_scene_text(text, folder=tmp_path)
    shape: Any = scene.spec.bodies["ball"].shape
    assert (shape.scale, shape.collision, shape.inertia) == (0.001, "hull", "solid")
    assert scene.resolve_file(shape.file) == file
    # Without a folder, files are not looked for yet: a scene out of a trajectory file can be read anywhere.
    assert load_scene_text(text).spec == scene.spec


def test_bodies_that_do_not_collide_need_no_material(minimal: str) -> None:
    text = minimal.replace("    material: steel\n", "    mass: 1\n    collides: false\n")
    assert load_scene_text(text).spec.bodies["ball"].material is None


def test_parts_with_materials_need_none_of_the_body(minimal: str) -> None:
    text = minimal.replace(
        "{type: sphere, radius: 5 cm}",
        "{type: compound, parts: [{shape: {type: sphere, radius: 1}, material: wood}]}",
    ).replace("    material: steel\n", "")
    assert load_scene_text(text).spec.bodies["ball"].material is None


# Orientations, against scipy

ANGLE = st.floats(-7, 7)


def same_rotation(quaternion: tuple[float, ...], expected: Rotation) -> bool:
    """Equal up to sign; largest error seen 4e-16."""
    w, x, y, z = quaternion
    return (Rotation.from_quat([x, y, z, w]) * expected.inv()).magnitude() < 1e-7 and math.isclose(
        abs(np.dot([x, y, z, w], expected.as_quat())), 1.0, abs_tol=1e-14
    )


@given(ANGLE, ANGLE, ANGLE)
def test_euler_angles_turn_about_x_then_the_new_y_then_the_new_z(x: float, y: float, z: float) -> None:
    ours = OrientationSpec(euler_xyz=(x, y, z)).as_quaternion()
    assert same_rotation(ours, Rotation.from_euler("XYZ", [x, y, z]))


@given(ANGLE, ANGLE, ANGLE)
def test_rotation_vectors(x: float, y: float, z: float) -> None:
    ours = OrientationSpec(rotation_vector=(x, y, z)).as_quaternion()
    assert same_rotation(ours, Rotation.from_rotvec([x, y, z]))


@given(st.tuples(*[st.floats(-1e6, 1e6)] * 3).filter(lambda v: np.linalg.norm(v) > 1e-6), ANGLE)
def test_axis_and_angle(axis: tuple[float, float, float], angle: float) -> None:
    ours = OrientationSpec(axis=axis, angle=angle).as_quaternion()
    unit = np.array(axis) / np.linalg.norm(axis)
    assert same_rotation(ours, Rotation.from_rotvec(unit * angle))


@given(st.tuples(*[st.floats(-1e20, 1e20)] * 4).filter(any))
def test_quaternions_are_brought_to_length_1_and_stay_there(given: tuple[float, float, float, float]) -> None:
    unit = OrientationSpec(quaternion=given).as_quaternion()
    assert math.hypot(*unit) == pytest.approx(1, abs=1e-15)
    assert OrientationSpec(quaternion=unit).as_quaternion() == unit


# Inertia, against numpy's eigenvalues

ELEMENT = st.floats(-1, 1)


@settings(max_examples=200)
@given(st.tuples(*[st.floats(0.01, 2)] * 3), st.tuples(*[ELEMENT] * 3), st.integers(-30, 30))
def test_principal_moments_are_the_eigenvalues(
    moments: tuple[float, float, float], products: tuple[float, float, float], power: int
) -> None:
    xx, yy, zz, xy, xz, yz = (10.0**power * v for v in (*moments, *products))
    ours = principal_moments(InertiaSpec(xx=xx, yy=yy, zz=zz, xy=xy, xz=xz, yz=yz))
    theirs = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    # Closed forms lose half of the digits where two moments are nearly equal: largest difference seen 3e-9.
    assert ours == pytest.approx(theirs, abs=1e-7 * max(abs(theirs)))


@pytest.mark.parametrize(
    ("tensor", "trouble"),
    [
        ({"xx": 1, "yy": 1, "zz": 2}, None),
        ({"xx": 1, "yy": 1, "zz": 1}, None),
        ({"xx": 1e-40, "yy": 1e-40, "zz": 1e-40}, None),
        ({"xx": 1, "yy": 1, "zz": 2.001}, "breaks the triangle inequality"),
        ({"xx": 2, "yy": 2, "zz": 2, "xy": 1.9}, "breaks the triangle inequality"),
        ({"xx": 1, "yy": 1, "zz": 1, "yz": 1.0}, "is not positive definite"),
    ],
)
def test_impossible_inertia(tensor: dict[str, float], trouble: str | None) -> None:
    told = inertia_trouble(InertiaSpec(**tensor))
    assert told is None if trouble is None else str(told).startswith(trouble)


# Repetition

REPEAT = "repeat: {count: [2, 1, 3], spacing: [21 cm, 0, -7 cm]}"


def test_copies_stand_on_a_lattice_in_world_axes(ball: Callable[[str], Scene]) -> None:
    scene = ball(f"{REPEAT}\n    position: [1, 2, 3]\n    orientation: {{axis: [1, 0, 0], angle: 1}}")
    assert list(scene.bodies) == [f"ball[{i},0,{k}]" for i in range(2) for k in range(3)]
    assert scene.bodies["ball[1,0,2]"].position == pytest.approx((1.21, 2, 2.86), abs=1e-15)
    assert scene.bodies["ball[0,0,0]"].position == (1, 2, 3)
    assert all(body.repeat is None for body in scene.bodies.values())
    assert scene.bodies["ball[1,0,2]"].orientation == scene.spec.bodies["ball"].orientation


@pytest.mark.parametrize(
    ("quantity", "trouble"),
    [
        ("ball[1,0,2]", None),
        ("ball", "'ball' is repeated; name one of its copies, such as \"ball[0,0,0]\""),
        ("ball[2,0,0]", "'ball' has no such copy; the last one is ball[1,0,2]"),
        ("twin[0,0,0]", "'twin' is not repeated; name it 'twin'"),
        ("bell[0,0,0]", "there is no body 'bell[0,0,0]'"),
    ],
)
def test_references_to_copies(
    quantity: str, trouble: str | None, minimal: str, headlines: Callable[[str], list[str]]
) -> None:
    twin = "  twin: {shape: {type: sphere, radius: 1}, material: steel}\n"
    expect = f'expect: [{{quantity: "bodies.{quantity}.speed", max: 1}}]\n'
    told = headlines(f"{minimal}    {REPEAT}\n{twin}{expect}")
    assert [line.partition("quantity: ")[2] for line in told] == ([] if trouble is None else [trouble])


# Patterns


@settings(max_examples=300)
@given(st.text("ab*", max_size=8), st.text("ab", max_size=10))
def test_patterns_match_as_regular_expressions_would(pattern: str, name: str) -> None:
    expected = re.fullmatch(".*".join(re.escape(piece) for piece in pattern.split("*")), name) is not None
    assert matches(pattern, name) is expected


# The scene as an object


def test_a_spec_cannot_be_changed(minimal: str) -> None:
    spec = load_scene_text(minimal).spec
    with pytest.raises(ValidationError, match="frozen"):
        spec.simulation.duration = 3.0


def test_a_scene_can_be_sent_to_another_process(minimal: str) -> None:
    scene = load_scene_text(minimal)
    again = pickle.loads(pickle.dumps(scene))
    assert again.spec == scene.spec
    assert again.text == scene.text


@pytest.mark.parametrize(
    ("duration", "timestep", "steps"),
    [("1 s", "1 ms", 1000), ("1 s", "0.3 ms", 3334), ("0.3", "0.1", 3), ("1e-3", "1e-3", 1), ("1", "0.7", 2)],
)
def test_the_last_step_is_the_first_that_reaches_the_duration(
    duration: str, timestep: str, steps: int, minimal: str
) -> None:
    text = minimal.replace("duration: 1 s, timestep: 1 ms", f"duration: {duration}, timestep: {timestep}")
    assert load_scene_text(text).spec.simulation.steps == steps


@pytest.mark.parametrize(
    ("timestep", "every"), [("1 ms", 0.01), ("3 ms", 0.009), ("0.25 ms", 0.01), ("0.1", 0.1)]
)
def test_frames_are_about_10_ms_apart_when_nothing_is_said(timestep: str, every: float, minimal: str) -> None:
    spec = load_scene_text(minimal.replace("timestep: 1 ms", f"timestep: {timestep}")).spec
    assert spec.record.every == pytest.approx(every, rel=1e-15)
    assert spec.steps_per_frame == round(every / spec.simulation.timestep)
