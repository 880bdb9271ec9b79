"""One broken scene per mistake in springs, joints, forces, profiles and motion: what is told, and where.

The mark » stands before the character that the caret must point at; it is taken out before the scene is read.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from marks import assert_told

HEAD = """\
physsim: 1
simulation: {duration: 4 s, timestep: 1 ms}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel}
  disc: {shape: {type: cylinder, radius: 5 cm, height: 1 cm}, material: steel}
  brick: {shape: {type: box, size: [1, 1, 1]}, material: wood, repeat: {count: [2, 1, 1], spacing: [2, 0, 0]}}
  wall: {fixed: true, shape: {type: halfspace}, material: concrete}
"""


def spring(keys: str) -> str:
    """A scene with a linear spring `s`."""
    return f"{HEAD}springs:\n  s: {{type: linear, between: [world, ball], {keys}}}\n"


def coil(keys: str) -> str:
    """A scene with a torsional spring `s`."""
    return f"{HEAD}springs:\n  s: {{type: torsional, between: [world, ball], axis: [0, 0, 1], {keys}}}\n"


def joint(keys: str) -> str:
    """A scene with one joint `j` and nothing else."""
    return f"{HEAD}joints:\n  j: {{{keys}}}\n"


def hinge(keys: str) -> str:
    """A scene with a hinge `j`."""
    return joint(f"type: hinge, between: [ball, disc], anchor: [0, 0, 0], axis: [0, 0, 1],\n    {keys}")


def gear(keys: str) -> str:
    """A scene with two hinges, a ball joint and a gear."""
    two = "anchor: [0, 0, 0], axis: [0, 0, 1]}\n"
    return (
        f"{HEAD}joints:\n  a: {{type: hinge, between: [world, ball], {two}"
        f"  b: {{type: hinge, between: [world, disc], {two}"
        f"  c: {{type: ball, between: [ball, disc], anchor: [0, 0, 0]}}\n  g: {{type: gear, {keys}}}\n"
    )


def force(keys: str) -> str:
    """A scene with one force `f`."""
    return f"{HEAD}forces:\n  f: {{{keys}}}\n"


def profile(keys: str) -> str:
    """A scene with a force that follows a profile."""
    return force(f"body: ball, force: [1, 0, 0], profile: {{{keys}}}")


def motion(keys: str, fixed: str = "true") -> str:
    """A scene with a body that is moved."""
    shape = "shape: {type: box, size: [1, 1, 1]}, material: wood"
    return HEAD + f"  table:\n    {{{shape}, fixed: {fixed},\n      {keys}}}\n"


def expect(quantity: str, more: str = "max: 1") -> str:
    """A scene with a spring, a coil, a hinge and a ball joint, and an expectation."""
    return (
        spring("stiffness: 1").replace(
            "\n  s:", "\n  c: {type: torsional, between: [world, ball], axis: [0, 0, 1], stiffness: 1}\n  s:"
        )
        + "joints:\n  h: {type: hinge, between: [ball, disc], anchor: [0, 0, 0], axis: [0, 0, 1]}\n"
        + "  b: {type: ball, between: [world, disc], anchor: [0, 0, 0]}\n"
        + f"expect:\n  - {{quantity: {quantity}, {more}}}\n"
    )


SPRINGS = {
    "nothing acts": (
        f"{HEAD}springs:\n  »s: {{type: linear, between: [world, ball]}}\n",
        "springs.s: does nothing: give stiffness, damping, or a curve",
    ),
    "no stiffness is no spring": (
        f"{HEAD}springs:\n  »s: {{type: linear, between: [world, ball], stiffness: 0, damping: 0}}\n",
        "springs.s: does nothing: give stiffness, damping, or a curve",
    ),
    "unknown body": (
        spring("stiffness: 1").replace("ball]", "»bal]"),
        "springs.s.between[1]: there is no body 'bal'; did you mean 'ball'?",
    ),
    "between one and the same": (
        spring("stiffness: 1").replace("[world, ball]", "»[ball, ball]"),
        "springs.s.between: must be two different bodies, got ball twice",
    ),
    "between fixed bodies": (
        spring("stiffness: 1").replace("[world, ball]", "»[world, wall]"),
        "springs.s.between: are both fixed: there is nothing to move",
    ),
    "between one": (
        spring("stiffness: 1").replace("[world, ball]", "»[ball]"),
        "springs.s.between: must be a list of 2, got [ball]",
    ),
    "stiffness of a torsional spring": (
        spring("stiffness: »1 N*m/rad"),
        "springs.s.stiffness: must be a stiffness, not a value in kg m^2/s^2/rad, got 1 N*m/rad "
        "(allowed: a stiffness in N/m (or kN/m))",
    ),
    "damping twice": (
        spring("stiffness: 1, damping: 1, damping_ratio: »1"),
        "springs.s.damping_ratio: cannot be given together with damping",
    ),
    "damping and its curve": (
        spring("stiffness: 1, damping: 1, damping_curve: »[[0, 0], [1, 1]]"),
        "springs.s.damping_curve: cannot be given together with damping",
    ),
    "a share of no damping": (
        spring("damping_ratio: »0.1"),
        "springs.s.damping_ratio: needs stiffness: it is a share of critical damping",
    ),
    "a share of many stiffnesses": (
        spring("force_curve: [[0, 0], [1, 1]], damping_ratio: »0.1"),
        "springs.s.damping_ratio: cannot be given together with force_curve: it needs one stiffness",
    ),
    "stiffness and its curve": (
        spring("stiffness: 1, force_curve: »[[0, 0], [1, 1]]"),
        "springs.s.force_curve: cannot be given together with stiffness",
    ),
    "a curve of one point": (
        spring("force_curve: »[[0, 0]]"),
        "springs.s.force_curve: must have at least 2 items, got [[0, 0]]",
    ),
    "a curve that falls back": (
        spring("force_curve: [[0, 0], [2, 1], [»1, 3]]"),
        "springs.s.force_curve[2][0]: must be greater than the one before it, got 1",
    ),
    "a curve that stands": (
        spring("damping_curve: [[0, 0], [»0, 1]]"),
        "springs.s.damping_curve[1][0]: must be greater than the one before it, got 0",
    ),
    "a curve in other units": (
        spring("damping_curve: [[0, 0], [»1 m, 1]]"),
        "springs.s.damping_curve[1][0]: must be a speed, not a value in m, got 1 m "
        "(allowed: a speed in m/s (or cm/s, km/h, mph))",
    ),
    "limits of length": (
        spring("stiffness: 1, limits: »[2, 1]"),
        "springs.s.limits: must be the lower limit, then the upper one",
    ),
    "a length below 0": (
        spring("stiffness: 1, limits: [»-1, 1]"),
        "springs.s.limits[0]: must be at least 0, got -1",
    ),
    "stops that are not there": (
        spring("stiffness: 1, restitution: »0.5"),
        "springs.s.restitution: needs limits beside it",
    ),
    "acts now and then": (
        spring("stiffness: 1, acts: »pull"),
        "springs.s.acts: must be one of the allowed words, got pull (allowed: always, tension, compression)",
    ),
    "a length of a torsional spring": (
        coil("stiffness: 1, »rest_length: 1"),
        "springs.s.rest_length: unknown key; did you mean 'rest_angle'?",
    ),
    "a coil that does nothing": (
        f"{HEAD}springs:\n  »s: {{type: torsional, between: [world, ball], axis: [0, 0, 1]}}\n",
        "springs.s: does nothing: give stiffness, damping, or a curve",
    ),
    "torque curve that falls back": (
        coil("torque_curve: [[0, 0], [»-1, 1]]"),
        "springs.s.torque_curve[1][0]: must be greater than the one before it, got -1",
    ),
    "unknown type of spring": (
        spring("stiffness: 1").replace("linear", "»liner"),
        "springs.s.type: unknown type, got liner; did you mean 'linear'? (allowed: linear, torsional)",
    ),
}

JOINTS = {
    "unknown type of joint": (
        hinge("").replace("hinge", "»hing"),
        "joints.j.type: unknown type, got hing; did you mean 'hinge'? (allowed: distance, ball, hinge, "
        "slider, fixed, cone, universal, cylindrical, planar, screw, gear)",
    ),
    "no anchor": (
        f"{HEAD}joints:\n  »j: {{type: ball, between: [world, ball]}}\n",
        "joints.j.anchor: is required but missing",
    ),
    "joint between fixed bodies": (
        hinge("").replace("[ball, disc]", "»[wall, world]"),
        "joints.j.between: are both fixed: there is nothing to move",
    ),
    "joint of a repeated body": (
        hinge("").replace("[ball, disc]", "[»brick, disc]"),
        """joints.j.between[0]: 'brick' is repeated; name one of its copies, such as "brick[0,0,0]\"""",
    ),
    "cone too wide": (
        joint("type: cone, between: [world, ball], anchor: [0, 0, 0], axis: [0, 0, 1], max_angle: »200 deg"),
        "joints.j.max_angle: must be at most 3.14159 rad, got 200 deg",
    ),
    "two lengths": (
        joint("type: distance, between: [world, ball], length: 1, limits: »[0, 2]"),
        "joints.j.limits: cannot be given together with length",
    ),
    "a rod cannot end": (
        joint("type: distance, between: [world, ball], length: 1, restitution: »0.5"),
        "joints.j.restitution: needs limits beside it",
    ),
    "distances in order": (
        joint("type: distance, between: [world, ball], limits: »[2, 1]"),
        "joints.j.limits: must be the lower limit, then the upper one",
    ),
    "a ball joint holds no torque": (
        joint("type: ball, between: [world, ball], anchor: [0, 0, 0], »break_torque: 1"),
        "joints.j.break_torque: unknown key; did you mean 'break_force'?",
    ),
    "breaks at once": (
        hinge("break_force: »0"),
        "joints.j.break_force: must be greater than 0, got 0",
    ),
    "axis of no direction": (
        hinge("").replace("[0, 0, 1]", "»[0, 0, 0]"),
        "joints.j.axis: must not be zero: it gives a direction, got [0, 0, 0]",
    ),
    "limits in order": (
        hinge("limits: »[45 deg, -45 deg]"),
        "joints.j.limits: must be the lower limit, then the upper one",
    ),
    "limits that are one": (
        hinge("limits: »[0, 0]"),
        "joints.j.limits: must be the lower limit, then the upper one",
    ),
    "limits not around the start": (
        hinge("limits: »[10 deg, 45 deg]"),
        "joints.j.limits: must have 0 between them: the angle is 0 as placed",
    ),
    "travel as an angle": (
        hinge("limits: [»-1 m, 1]"),
        "joints.j.limits[0]: must be an angle, not a value in m, got -1 m "
        "(allowed: an angle in rad (or deg, turn))",
    ),
    "bounces at nothing": (
        hinge("restitution: »0.5"),
        "joints.j.restitution: needs limits beside it",
    ),
    "friction below 0": (hinge("friction: »-1"), "joints.j.friction: must be at least 0, got -1"),
    "motor that does nothing": (
        hinge("»motor: {}"),
        "joints.j.motor: needs exactly one of speed and angle, none is given",
    ),
    "motor that wants both": (
        hinge("»motor: {speed: 1, max_torque: 1, angle: 1, stiffness: 1}"),
        "joints.j.motor: needs exactly one of speed and angle, not both",
    ),
    "motor without an end": (
        hinge("»motor: {speed: 1}"),
        "joints.j.motor.max_torque: is required beside speed",
    ),
    "servo without stiffness": (
        hinge("»motor: {angle: 1}"),
        "joints.j.motor.stiffness: is required beside angle",
    ),
    "servo's damping of a motor": (
        hinge("motor: {speed: 1, max_torque: 1, damping: »1}"),
        "joints.j.motor.damping: is for a servo: give angle in place of speed",
    ),
    "travel of a hinge's motor": (
        hinge("motor: {»travel: 1, angle: 1, stiffness: 1}"),
        "joints.j.motor.travel: unknown key (allowed: speed, angle, stiffness, damping, max_torque, profile)",
    ),
    "motor's profile": (
        hinge("motor: {speed: 1, max_torque: 1, profile: {type: ramp, over: »0}}"),
        "joints.j.motor.profile.over: must be greater than 0, got 0",
    ),
    "motor's table": (
        hinge("motor: {speed: 1, max_torque: 1, profile: {type: table, samples: [[1, 0], [»1, 1]]}}"),
        "joints.j.motor.profile.samples[1][0]: must be later than the sample before it, got 1",
    ),
    "spring without stiffness": (
        hinge("»spring: {rest: 1}"),
        "joints.j.spring.stiffness: is required but missing",
    ),
    "a screw without thread": (
        joint("type: screw, between: [world, ball], anchor: [0, 0, 0], axis: [0, 0, 1], pitch: »0 mm"),
        "joints.j.pitch: must not be 0, got 0 mm",
    ),
    "universal axes": (
        joint("type: universal, between: [world, ball], anchor: [0, 0, 0], axes: »[[1, 0, 0], [1, 1, 0]]"),
        "joints.j.axes: must be perpendicular to each other: the angle is 45 deg, not 90",
    ),
    "a drive that does nothing": (
        joint(
            "type: universal, between: [world, ball], anchor: [0, 0, 0], axes: [[1, 0, 0], [0, 1, 0]], "
            "»angle_1: {}"
        ),
        "joints.j.angle_1: does nothing: give limits, friction, damping, spring or motor",
    ),
    "a drive's mistake": (
        joint(
            "type: cylindrical, between: [world, ball], anchor: [0, 0, 0], axis: [1, 0, 0], "
            "travel: {limits: »[1 cm, 2 cm]}"
        ),
        "joints.j.travel.limits: must have 0 between them: the travel is 0 as placed",
    ),
    "axis out of the plane": (
        joint("type: planar, between: [world, ball], anchor: [0, 0, 0], normal: [0, 0, 1], axis: »[0, 1, 1]"),
        "joints.j.axis: must be in the plane: the angle is 45 deg, not 90",
    ),
    "x without its direction": (
        joint(
            "type: planar, between: [world, ball], anchor: [0, 0, 0], normal: [0, 0, 1], »x: {friction: 1}"
        ),
        "joints.j.x: needs axis beside it: the direction of x",
    ),
    "gear of nothing": (
        gear("joints: [a, »d], ratio: 2"),
        "joints.g.joints[1]: there is no joint 'd'",
    ),
    "gear of a ball joint": (
        gear("joints: [a, »c], ratio: 2"),
        "joints.g.joints[1]: does not turn about one axis, got ball (allowed: hinge, screw, cylindrical)",
    ),
    "gear of one": (
        gear("joints: »[a, a], ratio: 2"),
        "joints.g.joints: must be two different joints, got a twice",
    ),
    "ratio of nothing": (gear("joints: [a, b], ratio: »0"), "joints.g.ratio: must not be 0, got 0"),
    "gear between bodies": (
        gear("joints: [a, b], ratio: 2, »between: [ball, disc]"),
        "joints.g.between: unknown key (allowed: type, joints, ratio, break_torque)",
    ),
}

FORCES = {
    "no force": (
        f"{HEAD}forces:\n  »f: {{body: ball}}\n",
        "forces.f: does nothing: give force, torque, drag or acceleration",
    ),
    "two kinds": (
        f"{HEAD}forces:\n  »f: {{body: ball, force: [1, 0, 0], drag: {{linear: 1}}}}\n",
        "forces.f: must be of one kind, not force and drag together",
    ),
    "on no body": (
        force("body: »bal, force: [1, 0, 0]"),
        "forces.f.body: there is no body 'bal'; did you mean 'ball'?",
    ),
    "on the world": (
        force("body: »world, force: [1, 0, 0]"),
        "forces.f.body: the name 'world' is taken, got world",
    ),
    "on a fixed body": (
        force("body: »wall, force: [1, 0, 0]"),
        "forces.f.body: is fixed: nothing moves it, got wall",
    ),
    "force on a pattern": (
        force('body: »"*", force: [1, 0, 0]'),
        "forces.f.body: must name one body; `*` is for drag and acceleration, got *",
    ),
    "pattern that fits nothing": (
        force('body: »"bricks*", drag: {linear: 1}'),
        "forces.f.body: fits the name of no body, got bricks*; did you mean 'brick'?",
    ),
    "pattern that fits fixed bodies": (
        force('body: »"w*", drag: {linear: 1}'),
        "forces.f.body: fits fixed bodies only: nothing moves them, got w*",
    ),
    "point of no force": (
        force("body: ball, torque: [1, 0, 0], at: »[0, 0, 1]"),
        "forces.f.at: does nothing without force",
    ),
    "axes of no force": (
        force("body: ball, acceleration: [1, 0, 0], frame: »body"),
        "forces.f.frame: does nothing without force or torque, got body",
    ),
    "region of a force": (
        force("body: ball, force: [1, 0, 0], region: »[[0, 0, 0], [1, 1, 1]]"),
        "forces.f.region: does nothing without acceleration",
    ),
    "region without room": (
        force("body: ball, acceleration: [1, 0, 0], region: »[[0, 0, 0], [1, 0, 1]]"),
        "forces.f.region: must be the lower corner, then the upper one",
    ),
    "drag that starts": (
        force("body: ball, drag: {linear: 1}, from: »1 s"),
        "forces.f.from: cannot be given together with drag, which acts all the time",
    ),
    "drag that does nothing": (
        force("body: ball, »drag: {}"),
        "forces.f.drag: does nothing: give linear, angular, or density, area and coefficient",
    ),
    "drag without area": (
        force("body: ball, »drag: {density: 1.2, coefficient: 1}"),
        "forces.f.drag.area: is required beside density and coefficient",
    ),
    "area below 0": (
        force("body: ball, drag: {density: 1.2, area: »-1 cm^2, coefficient: 1}"),
        "forces.f.drag.area: must be greater than 0, got -1 cm^2",
    ),
    "end before the start": (
        force("body: ball, force: [1, 0, 0], from: 2, until: »1 s"),
        "forces.f.until: must be after the start (2 s), got 1 s",
    ),
}

PROFILES = {
    "unknown type of profile": (
        profile("type: »sin, frequency: 1"),
        "forces.f.profile.type: unknown type, got sin; did you mean 'sine'? "
        "(allowed: sine, ramp, step, table, expression)",
    ),
    "table that stands": (
        profile("type: table, samples: [[1, 0], [»1, 1]]"),
        "forces.f.profile.samples[1][0]: must be later than the sample before it, got 1",
    ),
    "table of nothing": (
        profile("type: table, samples: »[]"),
        "forces.f.profile.samples: must not be empty, got []",
    ),
    "step before the start": (
        profile("type: step, at: »-1 s"),
        "forces.f.profile.at: must be at least 0, got -1 s",
    ),
    "expression that cannot be read": (
        profile("type: expression, value: »2 *"),
        "forces.f.profile.value: ends too early, got 2 *",
    ),
    "expression of something else": (
        profile("type: expression, value: »2 * x"),
        "forces.f.profile.value: uses 'x', which is no parameter of this scene, got 2 * x",
    ),
    "expression of a length": (
        profile("type: expression, value: »t * 2 m"),
        "forces.f.profile.value: gives a value in m, not a plain number, got t * 2 m",
    ),
    "expression in braces": (
        profile('type: expression, value: »"${sin(t)}"'),
        "forces.f.profile.value: is an expression already: write it without ${ }, got ${sin(t)}",
    ),
    "expression that is a number": (
        profile("type: expression, value: »2"),
        'forces.f.profile.value: must be text, got 2; put it in quotes: "2"',
    ),
    "expression without end": (
        profile("type: expression, value: »1 / t"),
        "forces.f.profile.value: gives a number that is not finite at t = 0 s, got 1 / t",
    ),
    "expression that ends before the run": (
        profile("type: expression, value: »sqrt(2 - t)"),
        "forces.f.profile.value: gives a number that is not finite at t = 2.2 s, got sqrt(2 - t)",
    ),
    "two times": (
        "parameters: {t: 1 s}\n" + profile("type: expression, value: »sin(t)"),
        "forces.f.profile.value: uses 't', which is the time here and a parameter of this scene, got sin(t); "
        "give the parameter another name",
    ),
    "parameter that is wrong itself": (
        "parameters: {a: »1 parsec}\n" + profile("type: expression, value: a * t"),
        "parameters.a: has the unknown unit 'parsec', got 1 parsec",
    ),
}

MOTION = {
    "of a free body": (
        motion("»motion: {velocity: [1, 0, 0]}", fixed="false"),
        "bodies.table.motion: is for fixed bodies only; add fixed: true",
    ),
    "nowhere": (
        motion("»motion: {from: 1 s}"),
        "bodies.table.motion: does nothing: give translation, rotation, velocity or angular_velocity",
    ),
    "of both kinds": (
        motion("»motion: {translation: [1, 0, 0], velocity: [1, 0, 0], profile: {type: ramp, over: 1}}"),
        "bodies.table.motion: needs translation and rotation, or velocity and angular_velocity, "
        "not of both kinds",
    ),
    "position without a profile": (
        motion("»motion: {translation: [1, 0, 0]}"),
        "bodies.table.motion.profile: is required beside translation and rotation",
    ),
    "position that jumps": (
        motion("motion: {translation: [1, 0, 0], profile: {type: »step, at: 1 s}}"),
        "bodies.table.motion.profile.type: jumps, and a position must not, got step (allowed: ramp)",
    ),
    "position that begins elsewhere": (
        motion("motion: {translation: [1, 0, 0], »profile: {type: sine, frequency: 1, phase: 90 deg}}"),
        "bodies.table.motion.profile: must begin at 0, or the body jumps; it begins at 1",
    ),
    "table that begins elsewhere": (
        motion("motion: {translation: [1, 0, 0], »profile: {type: table, samples: [[1, 2]]}}"),
        "bodies.table.motion.profile: must begin at 0, or the body jumps; it begins at 2",
    ),
    "expression that begins elsewhere": (
        motion("motion: {translation: [1, 0, 0], »profile: {type: expression, value: cos(t)}}"),
        "bodies.table.motion.profile: must begin at 0, or the body jumps; it begins at 1",
    ),
    "motion that ends first": (
        motion("motion: {velocity: [1, 0, 0], from: 1, until: »1}"),
        "bodies.table.motion.until: must be after the start (1 s), got 1 s",
    ),
    "rotation without an angle": (
        motion("motion: {»rotation: {axis: [0, 0, 1]}, profile: {type: ramp, over: 1}}"),
        "bodies.table.motion.rotation.angle: is required but missing",
    ),
    "belt that touches nothing": (
        motion("surface_velocity: »[1, 0, 0], collides: false"),
        "bodies.table.surface_velocity: does nothing: the body does not collide",
    ),
    "rolling friction without a unit of length": (
        f"{HEAD}pairs:\n  - {{between: [steel, wood], rolling_friction: »0.1 N}}\n",
        "pairs[0].rolling_friction: must be a length, not a value in kg m/s^2, got 0.1 N "
        "(allowed: a length in m (or mm, cm, km, in, ft))",
    ),
}

EXPECT = {
    "unknown spring": (expect("»springs.z.length"), "expect[0].quantity: there is no spring 'z'"),
    "angle of a linear spring": (
        expect("»springs.s.angle"),
        "expect[0].quantity: a linear spring has no angle; it has length",
    ),
    "force of a coil": (
        expect("»springs.c.force"),
        "expect[0].quantity: a torsional spring has no force; it has torque",
    ),
    "unknown joint": (expect("»joints.z.reaction"), "expect[0].quantity: there is no joint 'z'"),
    "coordinate of a ball joint": (
        expect("»joints.b.coordinate"),
        "expect[0].quantity: a ball joint has no coordinate",
    ),
    "second coordinate of a hinge": (
        expect("»joints.h.coordinate_2"),
        "expect[0].quantity: a hinge joint has no coordinate_2; it has coordinate",
    ),
    "angle in metres": (
        expect("joints.h.coordinate", "max: »1 m"),
        "expect[0].max: must be an angle, not a value in m, got 1 m "
        "(allowed: an angle in rad (or deg, turn))",
    ),
    "what is not recorded": (
        expect("»springs.s.length") + "record: {joints: false}\n",
        "expect[0].quantity: is not recorded: record.joints is false",
    ),
    "force as a vector": (
        expect("»joints.h.force"),
        "expect[0].quantity: names a vector, an expectation needs one number, got joints.h.force "
        "(allowed: joints.h.force.x, joints.h.force.y, joints.h.force.z)",
    ),
}
CASES = {**SPRINGS, **JOINTS, **FORCES, **PROFILES, **MOTION, **EXPECT}


def test_no_two_mistakes_have_one_name() -> None:
    assert len(CASES) == sum(map(len, (SPRINGS, JOINTS, FORCES, PROFILES, MOTION, EXPECT)))


@pytest.mark.parametrize("case", CASES)
def test_mistake_is_told_with_its_place(case: str, tmp_path: Path) -> None:
    text, expected = CASES[case]
    assert_told(text, expected, tmp_path)
