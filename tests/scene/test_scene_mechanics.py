"""What valid springs, joints, forces, profiles and motions mean: SI values, defaults, round trips."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import pytest

from physsim.scene import Scene, load_scene_text
from physsim.scene.program import run
from physsim.scene.spec import ExpressionProfile, HingeJoint, LinearSpring, TorsionalSpring
from physsim.scene.spec.joints import COORDINATES, drives_of

HINGE = "joints: {j: {type: hinge, between: [world, ball], anchor: [0, 0, 1], axis: [0, 0, 2]}}\n"
EVERYTHING = Path(__file__).with_name("everything.yaml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def everything() -> Scene:
    """The scene that has every key."""
    return load_scene_text(EVERYTHING)


def test_a_scene_with_every_key_is_valid(everything: Scene) -> None:
    assert everything.warnings == ()


def test_it_reads_back_to_the_same_spec(everything: Scene) -> None:
    text = everything.resolved_yaml()
    again = load_scene_text(text)
    assert again.spec == everything.spec
    assert again.resolved_yaml() == text
    assert pickle.loads(pickle.dumps(again.spec)) == everything.spec


def test_springs_are_in_si(everything: Scene) -> None:
    springs = everything.spec.springs
    assert springs["tether"].model_dump() == {
        "type": "linear",
        "between": ("world", "crate"),
        "anchors": ((0, 0, 3), (0, 0, 0)),
        "rest_length": 2.0,
        "stiffness": 100.0,
        "damping": 5.0,
        "damping_ratio": None,
        "preload": 3.0,
        "acts": "always",
        "force_curve": None,
        "damping_curve": None,
        "limits": (0.1, 4.0),
        "restitution": 0.2,
    }
    bumper, coil = springs["bumper"], springs["coil"]
    assert isinstance(bumper, LinearSpring)
    assert isinstance(coil, TorsionalSpring)
    assert (bumper.stiffness, bumper.rest_length, bumper.acts) == (0.0, None, "compression")
    assert bumper.force_curve == ((-0.01, -9.0), (0.0, 0.0), (0.01, 1.0))
    assert coil.torque_curve == ((-math.pi / 2, -1.0), (math.pi / 2, 1.0))
    assert coil.damping_curve == ((0.0, 0.0), (2 * math.pi, 0.1))


def test_a_hinge_is_in_si_and_its_drive_is_itself(everything: Scene) -> None:
    hinge = everything.spec.joints["hinge"]
    assert isinstance(hinge, HingeJoint)
    assert hinge.limits == (-math.pi / 2, math.pi / 4)
    assert (hinge.restitution, hinge.friction, hinge.damping) == (0.1, 0.2, 0.01)
    assert hinge.spring is not None
    assert (hinge.spring.stiffness, hinge.spring.rest) == (2.0, math.radians(10))
    assert hinge.motor is not None
    assert (hinge.motor.speed, hinge.motor.max_torque, hinge.motor.angle) == (2.0, 10.0, None)
    assert list(drives_of(hinge)) == [(0, (), hinge)]


def test_drives_are_numbered_as_the_coordinates_are(everything: Scene) -> None:
    found = {
        name: [(number, path) for number, path, _ in drives_of(joint)]
        for name, joint in everything.spec.joints.items()
    }
    assert found == {
        "rod": [],
        "leash": [],
        "socket": [],
        "weld": [],
        "hinge": [(0, ())],
        "slider": [(0, ())],
        "piston": [(0, ("travel",)), (1, ("angle",))],
        "cardan": [(0, ("angle_1",)), (1, ("angle_2",))],
        "table": [(0, ("x",)), (1, ("y",)), (2, ("angle",))],
        "thread": [(0, ())],
        "cone": [],
        "gear": [],
    }
    types = {joint.type for joint in everything.spec.joints.values()}
    assert set(COORDINATES) == types - {"ball", "fixed", "cone", "gear"}


def test_joints_without_drives_have_the_defaults_of_the_language(minimal: str) -> None:
    text = minimal + HINGE
    assert load_scene_text(text).spec.joints["j"].model_dump() == {
        "type": "hinge",
        "between": ("world", "ball"),
        "anchor": (0, 0, 1),
        "axis": (0, 0, 1),
        "collide": False,
        "break_force": None,
        "break_torque": None,
        "limits": None,
        "restitution": 0.0,
        "friction": 0.0,
        "damping": 0.0,
        "spring": None,
        "motor": None,
    }


def test_a_pitch_is_per_whole_turn_and_has_a_sign(everything: Scene) -> None:
    assert everything.spec.joints["thread"].pitch == -0.002  # type: ignore[union-attr]


def test_forces_are_in_si(everything: Scene) -> None:
    forces = everything.spec.forces
    assert (forces["push"].force, forces["push"].until, forces["push"].frame) == ((150, 0, 0), 2.0, "body")
    drag = forces["air"].drag
    assert drag is not None
    assert drag.model_dump() == {
        "linear": 0.1,
        "angular": 1e-3,
        "density": 1.2,
        "area": 0.008,
        "coefficient": 0.47,
    }
    wind = forces["wind"]
    assert (wind.body, wind.acceleration, wind.from_) == ("brick*", (1, 0, 0), 1.0)
    assert wind.region == ((-1, -1, 0), (1, 1, 2))


def test_an_expression_uses_parameters_and_is_compiled_once(everything: Scene) -> None:
    profile = everything.spec.forces["fade"].profile
    assert isinstance(profile, ExpressionProfile)
    t = 0.7
    expected = math.sin(2 * math.pi * t) * math.exp(-t / 3) / 2
    assert run(profile.program, t) == pytest.approx(expected, rel=1e-15)
    assert "drop" in profile.value


def test_a_parameter_of_an_expression_counts_as_used(minimal: str) -> None:
    force = "forces: {f: {body: ball, force: [1, 0, 0], profile: {type: expression, value: sin(w*t)}}}\n"
    scene = load_scene_text(f"parameters: {{w: 3 rad/s, q: 1}}\n{minimal}{force}")
    assert [warning.path for warning in scene.warnings] == [("parameters", "q")]


def test_a_changed_parameter_changes_the_program(minimal: str) -> None:
    force = "forces: {f: {body: ball, force: [1, 0, 0], profile: {type: expression, value: w*t}}}\n"
    scene = load_scene_text(f"parameters: {{w: 3}}\n{minimal}{force}", overrides=["parameters.w=5"])
    assert run(scene.spec.forces["f"].profile.program, 2.0) == 10.0  # type: ignore[union-attr]


def test_motion_and_belts_are_in_si(everything: Scene) -> None:
    belt, crank = everything.bodies["belt"], everything.bodies["crank"]
    assert belt.surface_velocity == (1, 0, 0)
    assert belt.motion is not None
    assert belt.motion.is_position
    assert belt.motion.rotation is not None
    assert (belt.motion.translation, belt.motion.rotation.angle) == ((0.05, 0, 0), 3 / 180 * math.pi)
    assert crank.motion is not None
    assert not crank.motion.is_position
    assert crank.motion.angular_velocity == (0, 0, math.pi)
    assert (crank.motion.from_, crank.motion.until, crank.motion.profile) == (1.0, 2.0, None)


def test_friction_against_turning_belongs_to_pairs(everything: Scene) -> None:
    first, second = everything.spec.pairs
    assert (first.rolling_friction, first.spinning_friction) == (0.0, 0.0)
    assert (second.rolling_friction, second.spinning_friction) == (0.0005, 0.0001)


def test_the_kind_of_a_coordinate_is_that_of_its_joint(everything: Scene) -> None:
    units = {entry.quantity: entry.parsed.kind.unit for entry in everything.spec.expect}
    assert units["joints.piston.coordinate"] == "m"
    assert units["joints.piston.coordinate_2"] == "rad"
    assert [entry.max for entry in everything.spec.expect[3:5]] == [0.1, 2 * math.pi]


def test_overrides_reach_into_joints(minimal: str) -> None:
    text = minimal + HINGE
    scene = load_scene_text(text, overrides=["joints.j.limits=[-1, 2 deg]", "joints.j.damping=3"])
    joint = scene.spec.joints["j"]
    assert isinstance(joint, HingeJoint)
    assert (joint.limits, joint.damping) == ((-1.0, math.radians(2)), 3.0)


def test_several_mistakes_of_mechanics_are_told_at_once(minimal: str, headlines) -> None:  # type: ignore[no-untyped-def]
    told = headlines(
        minimal
        + """springs:
  s: {type: linear, between: [world, bal], stiffness: 1 kg}
  r: {type: linear, between: [world, bal], damping: 1, damping_ratio: 1}
joints:
  h: {type: hinge, between: [ball, ball], anchor: [0, 0], axis: [0, 0, 1], limits: [2, 1], motor: {speed: 1}}
  u: {type: universal, between: [world, ball], anchor: [0, 0, 0], axes: [[1, 0, 0], [1, 0, 0]], angle_1: {}}
  g: {type: gear, joints: [h, q], ratio: 0}
forces:
  f: {body: ball, at: [0, 0, 0], profile: {type: expression, value: 1/t}}
"""
    )
    assert [line.split(": ")[0].split(":", 1)[1] + " " + line.split(": ")[1] for line in told] == [
        "8:55 springs.s.stiffness",
        "9:38 springs.r.between[1]",
        "9:71 springs.r.damping_ratio",
        "11:51 joints.h.anchor",
        "12:73 joints.u.axes",
        "12:97 joints.u.angle_1",
        "13:42 joints.g.ratio",
        "15:3 forces.f",
        "15:23 forces.f.at",
        "15:69 forces.f.profile.value",
    ]
