"""What is typed but not simulated yet is refused at its line, and its own mistakes are told as well."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from physsim.scene.checks import connections, forces
from physsim.scene.draft import Draft, draft_of
from physsim.scene.nodes import plain
from physsim.scene.not_yet import NOT_YET
from physsim.scene.parameters import Parameters
from physsim.scene.spec.reading import Reading
from physsim.scene.spec.scene import SceneSpec
from physsim.scene.yaml_reader import read_yaml

SPRINGS = """\
springs:
  tether: {type: linear, between: [world, ball], stiffness: 100 N/m, damping: 5 N*s/m, rest_length: 2 m}
  wind_up: {type: torsional, between: [other, ball], axis: [0, 0, 2], stiffness: 3 N*m/deg, damping_ratio: 1}
"""
JOINTS = """\
joints:
  d: {type: distance, between: [world, ball], length: 2 m}
  b: {type: ball, between: [other, ball], anchor: [0, 0, 1]}
  h: {type: hinge, between: [other, ball], anchor: [0, 0, 1], axis: [0, 1, 0], limits: [-90 deg, 45 deg],
      motor: {speed: 20 rpm, max_torque: 10 N*m}}
  s: {type: slider, between: [other, ball], anchor: [0, 0, 1], axis: [0, 1, 0], limits: [0, 1 m],
      motor: {speed: 1 m/s, max_force: 10 N}, collide: true}
  f: {type: fixed, between: [other, ball], anchor: [0, 0, 1]}
  c: {type: cone, between: [other, ball], anchor: [0, 0, 1], axis: [0, 1, 0], max_angle: 30 deg}
"""
FORCES = """\
forces:
  push: {body: ball, force: [150 N, 0, 0], from: 0 s, until: 2 s, profile: {type: sine, frequency: 2 Hz}}
  turn: {body: ball, torque: [0, 0, 1 N*m], at: [0, 0, 1 cm], frame: body, profile: {type: ramp, over: 1 s}}
  table: {body: ball, force: [1, 0, 0], profile: {type: table, samples: [[0, 0], [1 s, 1], [2 s, 0]]}}
"""


@pytest.fixture
def two_balls(minimal: str) -> str:
    return minimal + "  other: {shape: {type: sphere, radius: 1}, material: wood, fixed: true}\n"


@pytest.mark.parametrize(
    ("text", "entries"),
    [(SPRINGS, ["tether", "wind_up"]), (JOINTS, list("dbhsfc")), (FORCES, ["push", "turn", "table"])],
)
def test_every_entry_is_refused_at_its_line_and_nothing_else_is_wrong(
    text: str, entries: list[str], two_balls: str, headlines: Callable[[str], list[str]]
) -> None:
    section = text.partition(":")[0]
    lines = (two_balls + text).split("\n")
    told = [
        f"s.yaml:{next(i for i, line in enumerate(lines, 1) if line.startswith(f'  {name}:'))}:3: "
        f"{section}.{name}: not supported yet: {section}"
        for name in entries
    ]
    assert headlines(two_balls + text) == told


@pytest.mark.parametrize(
    ("setting", "told"),
    [
        (
            "simulation.integrator=rk4",
            "simulation.integrator: not supported yet: this integrator (allowed: semi_implicit_euler)",
        ),
        (
            "simulation.impacts=located",
            "simulation.impacts: not supported yet: located impacts (allowed: stepped)",
        ),
        (
            "simulation.threads=2",
            "simulation.threads: not supported yet: more than one thread (allowed: 1)",
        ),
        ("world.gravitation=6.674e-11", "world.gravitation: not supported yet: gravitation (allowed: 0.0)"),
    ],
)
def test_every_setting_is_refused(
    setting: str, told: str, minimal: str, headlines: Callable[..., list[str]]
) -> None:
    assert headlines(minimal, overrides=[setting]) == [f"--set {setting}: {told}"]


def test_the_table_is_all_covered_here() -> None:
    assert len(NOT_YET) == 7


def draft(text: str) -> Draft:
    """What the checks look at, whatever is supported."""
    root = read_yaml(text).root
    assert root is not None
    spec = SceneSpec.model_validate(plain(root), context=Reading(Parameters({})))
    return draft_of(spec, Path())


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ("{type: ball, between: [ball, ball], anchor: [0, 0, 1]}", "between: must be two different bodies"),
        ("{type: ball, between: [ball, bell], anchor: [0, 0, 1]}", "between/1: there is no body 'bell'"),
        (
            "{type: ball, between: [world, other], anchor: [0, 0, 1]}",
            "between: are both fixed: there is nothing to move",
        ),
        (
            "{type: hinge, between: [world, ball], anchor: [0, 0, 1], axis: [0, 1, 0], limits: [1, 0]}",
            "limits: must be the lower limit, then the upper one",
        ),
    ],
)
def test_mistakes_of_joints(entry: str, told: str, two_balls: str) -> None:
    problems = list(connections.check(draft(f"{two_balls}joints:\n  j: {entry}\n")))
    assert [f"{'/'.join(map(str, p.path[2:]))}: {p.message}" for p in problems] == [told]


def test_two_ways_to_give_damping(two_balls: str) -> None:
    spring = "{type: linear, between: [world, ball], stiffness: 1, damping: 1, damping_ratio: 1}"
    problems = list(connections.check(draft(f"{two_balls}springs:\n  s: {spring}\n")))
    assert [(p.path[2:], p.message) for p in problems] == [
        (("damping_ratio",), "cannot be given together with damping")
    ]


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ("{body: bell, force: [1, 0, 0]}", "body: there is no body 'bell'"),
        ("{body: ball}", ": does nothing: give force or torque"),
        ("{body: ball, force: [1, 0, 0], from: 2, until: 1}", "until: must be after the start (2 s)"),
        (
            "{body: ball, force: [1, 0, 0], profile: {type: table, samples: [[1, 0], [1, 1]]}}",
            "profile/samples/1: must be later than the sample before it",
        ),
    ],
)
def test_mistakes_of_forces(entry: str, told: str, two_balls: str) -> None:
    problems = list(forces.check(draft(f"{two_balls}forces:\n  f: {entry}\n")))
    assert [f"{'/'.join(map(str, p.path[2:]))}: {p.message}" for p in problems] == [told]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "joints: {j: {type: hing, between: [world, ball]}}",
            "joints.j.type: unknown type, got hing; did you mean 'hinge'?",
        ),
        ("joints: {j: {type: ball, between: [world, ball]}}", "joints.j.anchor: is required but missing"),
        (
            "joints: {j: {type: cone, between: [world, ball], anchor: [0, 0, 0], axis: [0, 0, 1], "
            "max_angle: 200 deg}}",
            "joints.j.max_angle: must be at most 3.14159 rad, got 200 deg",
        ),
        (
            "springs: {s: {type: linear, between: [ball], stiffness: 1}}",
            "springs.s.between: must be a list of 2, got [ball]",
        ),
        (
            "springs: {s: {type: linear, between: [world, ball], stiffness: 1 N*m/rad}}",
            "springs.s.stiffness: must be a stiffness, not a value in kg m^2/s^2/rad, got 1 N*m/rad",
        ),
        (
            "forces: {f: {body: world, force: [1, 0, 0]}}",
            "forces.f.body: the name 'world' is taken, got world",
        ),
    ],
)
def test_values_are_checked_although_they_are_not_supported_yet(
    text: str, told: str, minimal: str, headlines: Callable[[str], list[str]]
) -> None:
    assert told in "\n".join(headlines(f"{minimal}{text}\n"))
