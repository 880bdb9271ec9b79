"""One broken scene per mistake: what is told, and where.

The mark » stands before the character that the caret must point at; it is taken out before the scene is read.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from marks import assert_told

HEAD = "physsim: 1\nsimulation: {duration: 1 s, timestep: 1 ms}\n"
BALL = "bodies:\n  ball:\n    shape: {type: sphere, radius: 5 cm}\n    material: steel\n"
FLOOR = "bodies:\n  floor: {fixed: true, shape: {type: halfspace}, material: concrete}\n"


def ball(line: str) -> str:
    """A scene whose ball has one more line; the ball begins on line 4."""
    return (
        HEAD
        + f"bodies:\n  ball:\n    shape: {{type: sphere, radius: 5 cm}}\n    material: steel\n    {line}\n"
    )


def shape(text: str) -> str:
    """A scene whose body has that shape."""
    return f"{HEAD}bodies:\n  thing:\n    material: steel\n    shape: {text}\n"


def more(text: str) -> str:
    """A scene with a ball and more top-level keys."""
    return f"{HEAD}bodies:\n  ball: {{shape: {{type: sphere, radius: 5 cm}}, material: steel}}\n{text}\n"


def simulation(text: str) -> str:
    """A scene with those settings."""
    body = "bodies:\n  ball: {shape: {type: sphere, radius: 1}, material: steel}\n"
    return f"physsim: 1\nsimulation: {text}\n{body}"


CASES = {
    # keys
    "unknown key": (
        ball("»positon: [0, 0, 1]"),
        "bodies.ball.positon: unknown key; did you mean 'position'?",
    ),
    "key given beside its misspelling": (
        ball("»shap: 3"),
        "bodies.ball.shap: unknown key; 'shape' is given already",
    ),
    "unknown key at the top": (more("»joint: {}"), "joint: unknown key; did you mean 'joints'?"),
    "duplicate key": (
        ball("»material: wood"),
        "bodies.ball.material: is given twice, first on line 6",
    ),
    "duplicate body": (
        more("").replace("steel}\n", "steel}\n  »ball: {}\n"),
        "bodies.ball: is given twice, first on line 4",
    ),
    "missing key": (
        shape("{type: box}").replace("shape:", "»shape:"),
        "bodies.thing.shape.size: is required but missing",
    ),
    "missing section": (
        "»physsim: 1\nbodies: {b: {shape: {type: sphere, radius: 1}, material: steel}}\n",
        "simulation: is required but missing",
    ),
    "missing version": (
        more("").removeprefix("physsim: 1\n").replace("simulation", "»simulation", 1),
        "physsim: is required but missing",
    ),
    "unknown version": (
        more("").replace("physsim: 1", "physsim: »2"),
        "physsim: is a version of the scene language that is not known, got 2 (allowed: 1)",
    ),
    "no bodies": (f"{HEAD}»bodies: {{}}\n", "bodies: must not be empty, got {}"),
    "empty value": (ball("»mass:"), "bodies.ball.mass: is empty: give a value, or leave the key out"),
    "empty switch": (ball("»fixed:"), "bodies.ball.fixed: is empty: give a value, or leave the key out"),
    "empty word": (ball("»repeat:"), "bodies.ball.repeat: is empty: give a value, or leave the key out"),
    "a colour that is a comment": (
        more("materials:\n  mine: {density: 1, »color:\n# d33\n    }"),
        "materials.mine.color: is empty: give a value, or leave the key out; "
        'a colour starts with #, which begins a comment: put it in quotes, "#d33"',
    ),
    # types
    "text for a number": (
        ball("mass: »heavy"),
        "bodies.ball.mass: is not a number, got heavy (allowed: a mass in kg (or g, t, lb))",
    ),
    "list for a number": (
        ball("mass: »[1]"),
        "bodies.ball.mass: must be a number, got [1] (allowed: a mass in kg (or g, t, lb))",
    ),
    "truth for a number": (
        ball("mass: »true"),
        "bodies.ball.mass: must be a number, got true (allowed: a mass in kg (or g, t, lb))",
    ),
    "number for a list": (
        ball("position: »3"),
        "bodies.ball.position: must be a list, in brackets or with a dash per line, got 3",
    ),
    "too short a list": (ball("position: »[1, 2]"), "bodies.ball.position: must be a list of 3, got [1, 2]"),
    "empty list": (ball("position: »[]"), "bodies.ball.position: must be a list of 3, got []"),
    "too long a list": (
        ball("position: [1, 2, 3, »4]"),
        "bodies.ball.position: must have at most 3 items, got [1, 2, 3, 4]",
    ),
    "word for a switch": (
        ball("fixed: »yes"),
        "bodies.ball.fixed: must be true or false, got yes; write true",
    ),
    "number for a name": (
        more("").replace("material: steel", "material: »3"),
        'bodies.ball.material: must be a name, got 3; put it in quotes: "3"',
    ),
    "number for a title": (more("title: »2024"), 'title: must be text, got 2024; put it in quotes: "2024"'),
    "word for a mapping": (
        ball("orientation: »up"),
        "bodies.ball.orientation: must be a mapping (key: value), got up",
    ),
    "list for a section": (f"{HEAD}bodies: »[1]\n", "bodies: must be a mapping (name: ...), got [1]"),
    "unknown word": (
        simulation("{duration: 1 s, timestep: 1 ms, integrator: »rk5}"),
        "simulation.integrator: must be one of the allowed words, got rk5; did you mean 'rk4'? "
        "(allowed: explicit_euler, semi_implicit_euler, verlet, velocity_verlet, leapfrog, rk4)",
    ),
    "unknown shape": (
        shape("{type: »spere, radius: 1}"),
        "bodies.thing.shape.type: unknown type, got spere; did you mean 'sphere'? (allowed: sphere, "
        "hollow_sphere, box, cylinder, capsule, cone, rod, ellipsoid, mesh, convex, halfspace, compound)",
    ),
    "no shape type": (
        shape("{radius: 1}").replace("shape:", "»shape:"),
        "bodies.thing.shape.type: is required but missing",
    ),
    # units
    "unknown unit": (
        ball("mass: »3 kilos"),
        "bodies.ball.mass: has the unknown unit 'kilos', got 3 kilos (allowed: a mass in kg (or g, t, lb))",
    ),
    "slip in a unit": (
        ball("position: [0, 0, »3 Cm]"),
        "bodies.ball.position[2]: has the unknown unit 'Cm', got 3 Cm; did you mean 'cm'? "
        "(allowed: a length in m (or mm, cm, km, in, ft))",
    ),
    "wrong dimension": (
        ball("mass: »2 m"),
        "bodies.ball.mass: must be a mass, not a value in m, got 2 m (allowed: a mass in kg (or g, t, lb))",
    ),
    "frequency for an angular speed": (
        ball("angular_velocity: [0, 0, »5 Hz]"),
        "bodies.ball.angular_velocity[2]: must be an angular speed, not a value in 1/s, got 5 Hz "
        "(allowed: an angular speed in rad/s (or deg/s, rpm))",
    ),
    "unit where none belongs": (
        more("pairs:\n  - {between: [steel, wood], restitution: »0.5 m}"),
        "pairs[0].restitution: must be a number, not a value in m, got 0.5 m "
        "(allowed: a number without a unit)",
    ),
    "decimal comma": (
        ball('mass: »"1,5 kg"'),
        "bodies.ball.mass: is not a number, got 1,5 kg; write the decimals after a point, and digits "
        "without separators (allowed: a mass in kg (or g, t, lb))",
    ),
    # ranges
    "negative mass": (ball("mass: »-1"), "bodies.ball.mass: must be greater than 0, got -1"),
    "zero radius": (
        shape("{type: sphere, radius: »0}"),
        "bodies.thing.shape.radius: must be greater than 0, got 0",
    ),
    "negative radius": (
        shape("{type: sphere, radius: »-1}"),
        "bodies.thing.shape.radius: must be greater than 0, got -1",
    ),
    "radius of nothing": (
        shape("{type: sphere, radius: »1e-200}"),
        "bodies.thing.shape.radius: must be at least 1e-09 m, got 1e-200",
    ),
    "radius of everything": (
        shape("{type: sphere, radius: »1e200}"),
        "bodies.thing.shape.radius: must not exceed 1e+15 m, got 1e200",
    ),
    "not a number at all": (ball("mass: ».nan"), "bodies.ball.mass: must be finite, got .nan"),
    "infinite": (ball("position: [0, 0, »-.inf]"), "bodies.ball.position[2]: must be finite, got -.inf"),
    "overflowing": (ball("mass: »1e999"), "bodies.ball.mass: must be finite, got 1e999"),
    "overflowing with its unit": (
        ball("mass: »1e308 t"),
        "bodies.ball.mass: must be finite, got 1e308 t (allowed: a mass in kg (or g, t, lb))",
    ),
    "integer of 40 digits": (
        ball(f"mass: »{'1' * 40}"),
        f"bodies.ball.mass: is an integer of more than 20 digits, got {'1' * 40}",
    ),
    "restitution above 1": (
        more("pairs:\n  - {between: [steel, wood], restitution: »1.1}"),
        "pairs[0].restitution: must be at most 1, got 1.1",
    ),
    "restitution below 0": (
        more("materials:\n  m: {density: 1, restitution: »-0.1}"),
        "materials.m.restitution: must be at least 0, got -0.1",
    ),
    "half an iteration": (
        simulation("{duration: 1, timestep: 1 ms, iterations: »1.5}"),
        "simulation.iterations: must be a whole number, got 1.5",
    ),
    "no iterations": (
        simulation("{duration: 1, timestep: 1 ms, iterations: »0}"),
        "simulation.iterations: must be at least 1, got 0",
    ),
    # times
    "timestep beyond the duration": (
        simulation("{duration: 1 s, timestep: »2 s}"),
        "simulation.timestep: must not exceed the duration (1 s), got 2 s",
    ),
    "too many steps": (
        simulation("{duration: 1e6 s, timestep: »1 ns}"),
        "simulation.timestep: asks for more than 1e+12 steps, got 1e-09 s",
    ),
    "frames between steps": (
        more("record: {every: »2.5 ms}"),
        "record.every: must be a whole number of timesteps (0.001 s), got 0.0025 s; "
        "nearest: 0.002 s or 0.003 s",
    ),
    "frames finer than steps": (
        more("record: {every: »0.1 ms}"),
        "record.every: must be a whole number of timesteps (0.001 s), got 0.0001 s; nearest: 0.001 s",
    ),
    # materials and pairs
    "unknown material": (
        more("").replace("material: steel", "material: »stel"),
        "bodies.ball.material: there is no material 'stel'; did you mean 'steel'?",
    ),
    "unknown material of a part": (
        shape("{type: compound, parts: [{shape: {type: sphere, radius: 1}, material: »woood}]}"),
        "bodies.thing.shape.parts[0].material: there is no material 'woood'; did you mean 'wood'?",
    ),
    "unknown material in a pair": (
        more("pairs:\n  - {between: [steel, »woood], restitution: 0.5}"),
        "pairs[0].between[1]: there is no material 'woood'; did you mean 'wood'?",
    ),
    "pair listed twice": (
        more(
            "pairs:\n  - {between: [steel, wood], restitution: 0.5}\n"
            "  - {between: »[wood, steel], restitution: 0.6}"
        ),
        "pairs[1].between: steel and wood are a pair already, in pairs[0]",
    ),
    "pair that says nothing": (
        more("pairs:\n  - »{between: [steel, wood]}"),
        "pairs[0]: says nothing: give restitution or a friction",
    ),
    "mu_s below mu_k in a pair": (
        more("pairs:\n  - {between: [steel, wood], static_friction: 0.2, kinetic_friction: »0.3}"),
        "pairs[0].kinetic_friction: must not exceed static_friction (0.2), got 0.3",
    ),
    "mu_s below mu_k in a material": (
        more("materials:\n  m: {density: 1, static_friction: 0.2, kinetic_friction: »0.3}"),
        "materials.m.kinetic_friction: must not exceed static_friction (0.2), got 0.3",
    ),
    "no colour": (
        more("materials:\n  m: {density: 1, color: »red}"),
        'materials.m.color: must be a colour, got red (allowed: "#rgb" or "#rrggbb" in hexadecimal digits)',
    ),
    # bodies
    "no material": (
        more("").replace(", material: steel", ", mass: 1").replace("ball:", "»ball:"),
        "bodies.ball.material: is required for a body that collides",
    ),
    "no mass, density or material": (
        more("").replace(", material: steel", ", collides: false").replace("ball:", "»ball:"),
        "bodies.ball.mass: is required: neither mass, nor density, nor a material is given",
    ),
    "material without density": (
        more("materials:\n  m: {restitution: 0.3}")
        .replace("material: steel", "material: m")
        .replace("ball:", "»ball:"),
        "bodies.ball.mass: is required: neither density nor the density of 'm' is given",
    ),
    "mass and density": (
        ball("mass: 1 kg\n    density: »1000"),
        "bodies.ball.density: cannot be given together with mass",
    ),
    "rod without mass": (
        shape("{type: rod, length: 1}").replace("thing:", "»thing:"),
        "bodies.thing.mass: is required: a rod has no volume that a density could fill",
    ),
    "half-space with a mass": (
        HEAD + FLOOR.replace("fixed: true", "fixed: true, mass: »3"),
        "bodies.floor.mass: does not apply to a halfspace, which has no end",
    ),
    "half-space that falls": (
        shape("{type: »halfspace}"),
        "bodies.thing.shape.type: is for fixed bodies only; add fixed: true, got halfspace",
    ),
    "half-space without a direction": (
        HEAD + FLOOR.replace("{type: halfspace}", "{type: halfspace, normal: »[0, 0, 0]}"),
        "bodies.floor.shape.normal: must not be zero: it gives a direction, got [0, 0, 0]",
    ),
    "half-space in a compound": (
        shape("{type: compound, parts: [{shape: {type: »halfspace}}]}"),
        "bodies.thing.shape.parts[0].shape.type: unknown type, got halfspace (allowed: sphere, "
        "hollow_sphere, box, cylinder, capsule, cone, rod, ellipsoid, mesh, convex)",
    ),
    "fixed and moving": (
        HEAD + FLOOR.replace("fixed: true", "fixed: true, velocity: »[1, 0, 0]"),
        "bodies.floor.velocity: must be zero: the body is fixed; give motion to move it",
    ),
    "zero quaternion": (
        ball("orientation: {quaternion: »[0, 0, 0, 0]}"),
        "bodies.ball.orientation.quaternion: must not be the zero quaternion, got [0, 0, 0, 0]",
    ),
    "zero axis": (
        ball("orientation: {axis: »[0, 0, 0], angle: 1}"),
        "bodies.ball.orientation.axis: must not be zero: it gives a direction, got [0, 0, 0]",
    ),
    "axis without angle": (
        ball("orientation: {»axis: [0, 0, 1]}"),
        "bodies.ball.orientation.axis: needs angle beside it",
    ),
    "angle without axis": (
        ball("orientation: {»angle: 1}"),
        "bodies.ball.orientation.angle: needs axis beside it",
    ),
    "two orientations": (
        ball("»orientation: {euler_xyz: [0, 0, 1], rotation_vector: [0, 0, 1]}"),
        "bodies.ball.orientation: needs exactly one way to write the rotation, not "
        "euler_xyz and rotation_vector together "
        "(allowed: quaternion, axis with angle, euler_xyz, rotation_vector)",
    ),
    "no orientation": (
        ball("»orientation: {}"),
        "bodies.ball.orientation: needs exactly one way to write the rotation, none is given "
        "(allowed: quaternion, axis with angle, euler_xyz, rotation_vector)",
    ),
    "inertia not positive definite": (
        ball("»inertia: {xx: 1, yy: 1, zz: 1, xy: 2}"),
        "bodies.ball.inertia: is not positive definite (principal moments -1, 1, 3 kg m^2)",
    ),
    "inertia against the triangle inequality": (
        ball("»inertia: {xx: 1, yy: 1, zz: 3}"),
        "bodies.ball.inertia: breaks the triangle inequality: no body turns so hard about one axis "
        "(principal moments 1, 1, 3 kg m^2)",
    ),
    "negative moment": (
        ball("inertia: {xx: »-1, yy: 1, zz: 1}"),
        "bodies.ball.inertia.xx: must be greater than 0, got -1",
    ),
    "body called world": (
        more("").replace("ball:", "»world:"),
        "bodies.world: the name 'world' is taken",
    ),
    "body with a star": (
        more("").replace("ball:", '»"a*b":'),
        "bodies.a*b: a name must be printable, without '*', and without blanks at its ends",
    ),
    "mesh file missing": (
        shape("{type: mesh, file: »no/such.obj}"),
        "bodies.thing.shape.file: there is no such file in {folder}, got no/such.obj",
    ),
    "mesh file that is a folder": (
        shape("{type: mesh, file: »..}"),
        "bodies.thing.shape.file: is not a regular file, got ..",
    ),
    "mesh from an address": (
        shape('{type: mesh, file: »"https://example.org/a.obj"}'),
        "bodies.thing.shape.file: is an address; a mesh must be a file on this machine, got https://example.org/a.obj",
    ),
    "convex from nothing": (
        shape("{type: convex}").replace("shape:", "»shape:"),
        "bodies.thing.shape: needs exactly one of points and file",
    ),
    "convex of three points": (
        shape("{type: convex, points: »[[0, 0, 0], [1, 0, 0], [0, 1, 0]]}"),
        "bodies.thing.shape.points: must have at least 4 items, got [[0, 0, 0], [1, 0, 0], [0, 1, 0]]",
    ),
    "scale of points": (
        shape("{type: convex, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], »scale: 2}"),
        "bodies.thing.shape.scale: belongs to file; points carry their own units",
    ),
    # repeat
    "no copies": (
        ball("repeat: {count: [»0, 1, 1], spacing: [1, 1, 1]}"),
        "bodies.ball.repeat.count[0]: must be at least 1, got 0",
    ),
    "too many bodies": (
        ball("repeat: {count: [100, 100, 11], spacing: [1, 1, 1]}").replace("bodies:", "»bodies:"),
        "bodies: must be at most 100000 bodies in all, got 110000",
    ),
    "body called like a copy": (
        ball(
            'repeat: {count: [2, 1, 1], spacing: [1, 1, 1]}\n  »"ball[1,0,0]": '
            "{shape: {type: sphere, radius: 1}, material: steel}"
        ),
        "bodies.ball[1,0,0]: is the name of a copy of 'ball', which is repeated",
    ),
    # references
    "pattern that fits nothing": (
        more("no_contact: [[ball, »bal1*]]"),
        "no_contact[0][1]: fits the name of no body, got bal1*; did you mean 'ball'?",
    ),
    "quantity of no body": (
        more("expect:\n  - {quantity: »bodies.bal.position.z, max: 1}"),
        "expect[0].quantity: there is no body 'bal'; did you mean 'ball'?",
    ),
    "quantity that is none": (
        more("expect:\n  - {quantity: »bodies.ball.positon.z, max: 1}"),
        "expect[0].quantity: names no quantity of a body, got bodies.ball.positon.z "
        "(allowed: bodies.NAME.(position | orientation | velocity | angular_velocity | speed "
        "| angular_speed | kinetic_energy | momentum | angular_momentum | contact_force))",
    ),
    "quantity that is a vector": (
        more("expect:\n  - {quantity: »bodies.ball.velocity, max: 1}"),
        "expect[0].quantity: names a vector, an expectation needs one number, got bodies.ball.velocity "
        "(allowed: bodies.ball.velocity.x, bodies.ball.velocity.y, bodies.ball.velocity.z)",
    ),
    "expected value of a wrong dimension": (
        more("expect:\n  - {quantity: bodies.ball.position.z, value: 1, within: »1 s}"),
        "expect[0].within: must be a length, not a value in s, got 1 s "
        "(allowed: a length in m (or mm, cm, km, in, ft))",
    ),
    "value without within": (
        more("expect:\n  - {quantity: energy.total, »value: 1}"),
        "expect[0].value: needs within beside value: how far off it may be",
    ),
    "within without value": (
        more("expect:\n  - {quantity: energy.total, »within: 1}"),
        "expect[0].within: needs value beside it",
    ),
    "nothing expected": (
        more("expect:\n  - »{quantity: energy.total}"),
        "expect[0]: checks nothing: give value and within, or min, or max",
    ),
    "bounds the wrong way": (
        more("expect:\n  - {quantity: energy.total, min: »2, max: 1}"),
        "expect[0].min: must not exceed max, got 2",
    ),
    "expected after the end": (
        more("expect:\n  - {quantity: energy.total, max: 1, at: »2 s}"),
        "expect[0].at: is after the end of the run (1 s), got 2 s",
    ),
    # expressions
    "unknown parameter": (
        ball("mass: »${heavy}"),
        "bodies.ball.mass: uses 'heavy', which is no parameter of this scene, got ${heavy} "
        "(allowed: a mass in kg (or g, t, lb))",
    ),
    "parameter of a wrong dimension": (
        "parameters: {drop: 2 m}\n" + ball("mass: »${drop}"),
        "bodies.ball.mass: must be a mass, not a value in m, got ${drop} "
        "(allowed: a mass in kg (or g, t, lb))",
    ),
    "parameters in a circle": (
        'parameters: {a: »"${a}", b: 1}\n' + ball("mass: ${b}"),
        "parameters.a: refers to itself: a -> a, got ${a}",
    ),
    "parameter called like a function": (
        "parameters: {»sin: 1}\n" + more(""),
        "parameters.sin: the name 'sin' is that of a function",
    ),
    "parameter that is no word": (
        "parameters: {»a-b: 1}\n" + more(""),
        "parameters.a-b: a parameter's name is letters, digits and underscores, at most 60, no digit first",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_mistake_is_told_with_its_place(case: str, tmp_path: Path) -> None:
    text, expected = CASES[case]
    assert_told(text, expected.replace("{folder}", str(tmp_path)), tmp_path)
