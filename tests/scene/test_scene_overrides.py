"""`--set path=value`: what it changes, and what it says when it cannot."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from physsim.scene import Scene, load_scene_text

TEXT = """\
physsim: 1
parameters: {e: 0.4, drop: 1 m}
simulation: {duration: 1 s, timestep: 1 ms}
pairs:
  - {between: [steel, wood], restitution: "${e}"}
bodies:
  crate:
    shape: {type: box, size: [1, 2, 3]}
    material: steel
    position: [0, 0, "${drop}"]
  brick:
    shape: {type: box, size: [1, 2, 3]}
    material: wood
    repeat: {count: [2, 1, 1], spacing: [2, 2, 2]}
  "a.b[1]":
    shape: {type: sphere, radius: 1}
    material: wood
"""


def changed(*overrides: str) -> Scene:
    return load_scene_text(TEXT, overrides=list(overrides))


def at(scene: Scene, path: str) -> Any:
    value: Any = scene.spec
    for part in path.split("/"):
        value = (
            value[int(part) if part.isdigit() else part]
            if isinstance(value, tuple | dict)
            else getattr(value, part)
        )
    return value


@pytest.mark.parametrize(
    ("override", "path", "value"),
    [
        ("simulation.duration=2 s", "simulation/duration", 2.0),
        ("simulation.duration = 2 min", "simulation/duration", 120.0),
        ("bodies.crate.position[2]=0.7", "bodies/crate/position", (0.0, 0.0, 0.7)),
        ("bodies.crate.position=[1, 2 cm, 3]", "bodies/crate/position", (1.0, 0.02, 3.0)),
        ("bodies.crate.shape={type: sphere, radius: 1 cm}", "bodies/crate/shape/radius", 0.01),
        ("parameters.e=0.5", "pairs/0/restitution", 0.5),
        ("parameters.drop=${2*e}", "bodies/crate/position", (0.0, 0.0, 0.8)),
        ("pairs[0].restitution=0.9", "pairs/0/restitution", 0.9),
        ("pairs[1]={between: [steel, steel], restitution: 0.6}", "pairs/1/restitution", 0.6),
        ("bodies.brick.repeat.count[0]=3", "bodies/brick/repeat/count", (3, 1, 1)),
        ("bodies.brick.repeat=null", "bodies/brick/repeat", None),
        ("bodies.a.b[1].shape.radius=7", "bodies/a.b[1]/shape/radius", 7.0),
        ("bodies.crate.velocity[1]=3", "bodies/crate/velocity", (0.0, 3.0, 0.0)),
        ("world.gravity[0]=1", "world/gravity", (1.0, 0.0, -9.81)),
        ("world.gravity=[0, 0, 0]", "world/gravity", (0.0, 0.0, 0.0)),
        ("simulation.until=at_rest", "simulation/until", "at_rest"),
        ("materials.steel.color=#123456", "materials/steel/color", "#123456"),
        ("bodies.crate.fixed=true", "bodies/crate/fixed", True),
        ("bodies.new={shape: {type: sphere, radius: 1}, material: steel}", "bodies/new/material", "steel"),
        ("title=a=b", "title", "a=b"),
        ("record.every=5 ms", "record/every", 0.005),
    ],
)
def test_any_value_can_be_set(override: str, path: str, value: object) -> None:
    assert at(changed(override), path) == value


def test_later_overrides_see_earlier_ones() -> None:
    scene = changed(
        "bodies.crate.shape={type: sphere, radius: 1}",
        "bodies.crate.shape.radius=2",
        "bodies.crate.shape.radius=3",
    )
    assert at(scene, "bodies/crate/shape/radius") == 3.0
    assert scene.overrides[0] == "bodies.crate.shape={type: sphere, radius: 1}"
    assert scene.text == TEXT


def test_python_values_are_taken_as_they_are() -> None:
    scene = load_scene_text(
        TEXT,
        overrides={
            "simulation.duration": 2,
            "simulation.timestep": np.float64(0.002),
            "bodies.crate.position": np.array([1.0, 2.0, 3.0]),
            "bodies.brick.repeat.count[0]": np.int64(4),
            "bodies.crate.velocity": ("1 cm/s", 0, 0.5),
            "title": "2024: [a draft]",
            "bodies.crate.fixed": False,
        },
    )
    assert (scene.spec.simulation.duration, scene.spec.simulation.timestep) == (2.0, 0.002)
    assert scene.spec.bodies["crate"].position == (1.0, 2.0, 3.0)
    assert scene.spec.bodies["crate"].velocity == (0.01, 0.0, 0.5)
    assert scene.spec.title == "2024: [a draft]"
    assert len(scene.bodies) == 6


@pytest.mark.parametrize(
    ("override", "told"),
    [
        ("bodies.crate.mass=-1", "bodies.crate.mass: must be greater than 0, got -1"),
        (
            "bodies.crate.mass=3 m",
            "bodies.crate.mass: must be a mass, not a value in m, got 3 m (allowed: a mass in kg "
            "(or g, t, lb))",
        ),
        ("bodies.crate.positon[2]=1", "sets an item of 'positon', which is not given; set the whole list"),
        ("bodies.crate.positon=[0, 0, 1]", "bodies.crate.positon: unknown key; 'position' is given already"),
        ("bodies.crat.mass=1", "there is no 'crat' in bodies; did you mean 'crate'?"),
        ("bodies.other.mass=1", "there is no 'other' in bodies; set the whole entry to add one"),
        (
            "bodies.brick[0,0,0].mass=1",
            "cannot be followed at '[0,0,0].mass'; copies of a repeated body are set together: bodies.brick",
        ),
        (
            "bodies.crate.position[3]=1",
            "bodies.crate.position: must have at most 3 items, got [0, 0, ${drop}, 1]",
        ),
        ("bodies.crate.position[7]=1", "cannot be followed at '[7]'; the list has 3 items, counted from 0"),
        ("bodies.crate.position.z=1", "cannot be followed at 'z'"),
        ("bodies.crate.material.x=1", "cannot be followed at 'x'; 'steel' stands there"),
        ("bodies..mass=1", "cannot be followed at '.mass'"),
        ("bodies.=1", "cannot be followed at '.'"),
        ("[0]=1", "cannot be followed at '[0]'"),
        ("simulation.duration", "must be path=value, e.g. simulation.duration=2 s"),
        ("=1", "has no path before '='"),
        ("title=[1", "is not valid YAML: while parsing a flow sequence: did not find expected ',' or ']'"),
        (
            "title=!!python/name:os.system x",
            "YAML tags are not part of the scene language, got tag:yaml.org,2002:python/name:os.system",
        ),
        ("durations=3", "durations: unknown key"),
        ("physsim=null", "physsim: is required but missing"),
        ("pairs[0]=null", "pairs[0]: is empty: give a value, or leave the key out"),
    ],
)
def test_what_cannot_be_set_is_told_with_the_override_as_its_place(
    override: str, told: str, headlines: Callable[..., list[str]]
) -> None:
    lines = headlines(TEXT, overrides=[override])
    assert len(lines) == 1
    place = "s.yaml:1:1" if override == "physsim=null" else f"--set {override}"
    assert lines[0].startswith(f"{place}: {told}")


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (float("nan"), "bodies.crate.mass: must be finite, got nan"),
        (10**400, "is an integer of more than 20 digits"),
        (object, "is a type, which no scene can hold"),
        (b"x", "is a bytes, which no scene can hold"),
        (True, "bodies.crate.mass: must be a number, got True"),
    ],
)
def test_python_values_that_no_scene_can_hold(
    value: object, told: str, headlines: Callable[..., list[str]]
) -> None:
    lines = headlines(TEXT, overrides={"bodies.crate.mass": value})
    assert len(lines) == 1
    assert told in lines[0]


def test_a_value_that_contains_itself_is_refused(headlines: Callable[..., list[str]]) -> None:
    value: list[Any] = []
    value.append(value)
    assert "nested deeper than 32" in headlines(TEXT, overrides={"title": value})[0]


def test_all_mistakes_of_file_and_overrides_are_told_together(headlines: Callable[..., list[str]]) -> None:
    text = TEXT.replace("material: wood", "material: woood", 1)
    lines = headlines(text, overrides=["bodies.crate.mass=-1", "bodies.crat.mass=1"])
    assert [line.split(": ")[0] for line in lines] == [
        "s.yaml:13:15",
        "--set bodies.crat.mass=1",
        "--set bodies.crate.mass=-1",
    ]
