"""Problems as they are shown to people and given to programs."""

from __future__ import annotations

import pytest

from physsim.errors import Problem, SceneError
from physsim.scene import format_problem, format_problems, load_scene_text, problem_as_dict


def test_the_form_that_users_were_promised() -> None:
    problem = Problem(
        ("bodies", "ball", "shape", "radius"),
        "must be greater than 0",
        given="-1",
        line=14,
        column=7,
        source_line="      radius: -1",
    )
    assert format_problem(problem, "scene.yaml") == (
        "scene.yaml:14:7: bodies.ball.shape.radius: must be greater than 0, got -1\n"
        "   14 |       radius: -1\n"
        "      |       ^"
    )


def test_a_warning_says_so() -> None:
    problem = Problem(("bodies",), "looks odd", severity="warning", line=3, column=1, source_line="bodies:")
    assert format_problem(problem, "s.yaml").startswith("s.yaml:3:1: warning: bodies: looks odd\n")


def test_a_problem_without_a_place_names_the_file() -> None:
    assert format_problem(Problem((), "the file is empty"), "s.yaml") == "s.yaml: the file is empty"


def test_hint_and_allowed_are_told() -> None:
    problem = Problem(("a",), "unknown type", "spere", "sphere, box", "did you mean 'sphere'?")
    assert format_problem(problem, "s") == (
        "s: a: unknown type, got spere; did you mean 'sphere'? (allowed: sphere, box)"
    )


def test_a_long_line_is_shown_around_the_caret() -> None:
    source = "a" * 500 + "X" + "b" * 500
    head, shown, caret = format_problem(Problem((), "x", line=1, column=501, source_line=source), "s").split(
        "\n"
    )
    assert head == "s:1:501: x"
    assert len(shown) <= 130
    assert shown[caret.index("^")] == "X"


@pytest.mark.parametrize("before", ["ää", "日本", "e\u0301", "\t\t", "a\u200db"])
def test_the_caret_stands_under_its_character(before: str) -> None:
    source = f"{before}X"
    problem = Problem((), "x", line=1, column=len(before) + 1, source_line=source)
    caret = format_problem(problem, "s").split("\n")[2]
    width = {"ää": 2, "日本": 4, "e\u0301": 1, "\t\t": 2, "a\u200db": 3}[before]
    assert caret == " " * 6 + "| " + " " * width + "^"


def test_control_characters_never_reach_the_terminal() -> None:
    shown = format_problem(Problem((), "x", line=1, column=1, source_line="a\x1b[31mb\x07"), "s")
    assert "\x1b" not in shown
    assert "\x07" not in shown
    head = format_problem(Problem(("bodies", "a\nb"), "x", given="\u202e1"), "s")
    assert head == "s: bodies.a b: x, got  1"


def test_a_problem_for_programs() -> None:
    head = "physsim: 1\nsimulation: {duration: 1, timestep: 1 ms}\nbodies:\n"
    text = f"{head}  b: {{shape: {{type: box, size: [1, 2, -3]}}}}\n"
    with pytest.raises(SceneError) as caught:
        load_scene_text(text, name="s.yaml")
    assert [problem_as_dict(problem, caught.value.file) for problem in caught.value.problems] == [
        {
            "file": "s.yaml",
            "line": 4,
            "column": 39,
            "origin": None,
            "severity": "error",
            "path": "bodies.b.shape.size[2]",
            "keys": ["bodies", "b", "shape", "size", 2],
            "message": "must be greater than 0",
            "given": "-3",
            "allowed": None,
            "hint": None,
        }
    ]


def test_every_mistake_of_a_scene_is_told_at_once_and_in_its_order() -> None:
    text = """\
physsim: 1
simulation: {duration: 5 s, timestep: 1 ms, integrator: rk5}
bodies:
  ball:
    shape: {type: spere, radius: 5 cm}
    material: steel
  brick:
    mass: -1
    material: stel
    shape: {type: box, size: [1, 2, 2 cubits]}
    positon: [0, 0, 1]
  top: {material: steel, shape: {type: sphere}}
  side: {material: stel, shape: {type: sphere, radius: 1}}
pairs:
  - {between: [steel, wood], restitution: 2}
  - {between: [ball, steel], restitution: 0.1}
joints:
  j: {type: ball, between: [ball, bell], anchor: [0, 0, 0]}
no_contact: [[ball, ball]]
no_contact: [[ball, wall]]
"""
    with pytest.raises(SceneError) as caught:
        load_scene_text(text, name="s.yaml")
    told = [
        line
        for line in format_problems(caught.value.problems, "s.yaml").split("\n")
        if line.startswith("s.y")
    ]
    assert [line.split(": ")[0] + " " + line.split(": ")[1] for line in told] == [
        "s.yaml:2:57 simulation.integrator",
        "s.yaml:5:19 bodies.ball.shape.type",
        "s.yaml:8:11 bodies.brick.mass",
        "s.yaml:10:37 bodies.brick.shape.size[2]",
        "s.yaml:11:5 bodies.brick.positon",
        "s.yaml:12:26 bodies.top.shape.radius",
        "s.yaml:13:20 bodies.side.material",
        "s.yaml:15:43 pairs[0].restitution",
        "s.yaml:16:16 pairs[1].between[0]",
        "s.yaml:18:35 joints.j.between[1]",
        "s.yaml:20:1 no_contact",
    ]


def test_places_of_other_rooms_lead_to_the_declaration_of_a_copy() -> None:
    text = (
        "physsim: 1\nsimulation: {duration: 1, timestep: 1 ms}\nbodies:\n  b:\n    material: steel\n"
        "    shape: {type: sphere, radius: 1}\n    repeat: {count: [2, 1, 1], spacing: [3, 0, 0]}\n"
    )
    scene = load_scene_text(text)
    places = {
        ("bodies", "b[1,0,0]"): (4, 3),
        ("bodies", "b[1,0,0]", "shape", "radius"): (6, 35),
        ("bodies", "b", "shape", "file"): (6, 5),
        ("bodies", "other"): (3, 1),
        ("pairs",): (1, 1),
    }
    for path, (line, column) in places.items():
        placed = scene.place(Problem(path, "x"))
        assert (placed.line, placed.column) == (line, column)
        assert placed.source_line == text.split("\n")[line - 1]


def test_places_of_what_an_override_set_name_the_override() -> None:
    text = (
        "physsim: 1\nsimulation: {duration: 1, timestep: 1 ms}\n"
        "bodies: {b: {material: steel, shape: {type: sphere, radius: 1}}}\n"
    )
    scene = load_scene_text(text, overrides=["bodies.b.mass=3"])
    placed = scene.place(Problem(("bodies", "b", "mass"), "is odd", severity="warning"))
    assert format_problem(placed, "s.yaml") == "--set bodies.b.mass=3: warning: bodies.b.mass: is odd"
