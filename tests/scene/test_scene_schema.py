"""The JSON Schema: fresh in its file, taking what we take, refusing what editors should mark."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from marks import marked
from test_scene_mechanics_errors import CASES as MECHANICS

from physsim.scene.nodes import plain
from physsim.scene.schema import schema_text
from physsim.scene.spec.scene import SceneSpec
from physsim.scene.yaml_reader import read_yaml

ROOT = Path(__file__).parents[2]
FILE = ROOT / "schemas" / "scene.schema.json"
SCHEMA = json.loads(schema_text())
VALID = Path(__file__).with_name("everything.yaml").read_text(encoding="utf-8")


def trouble(text: str) -> list[str]:
    """Where the schema refuses a scene."""
    root = read_yaml(text).root
    assert root is not None
    return [error.json_path for error in Draft202012Validator(SCHEMA).iter_errors(plain(root))]


def test_the_file_is_fresh() -> None:
    renew = "renew it: python -m physsim.scene.schema > schemas/scene.schema.json"
    assert FILE.read_text(encoding="utf-8") == schema_text(), renew


def test_it_is_a_schema() -> None:
    Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert SceneSpec.model_json_schema() == SCHEMA


def test_it_takes_a_scene_with_every_key_of_the_language() -> None:
    assert trouble(VALID) == []
    assert keys_of(SCHEMA, set()) <= keys_in(plain(read_yaml(VALID).root))  # type: ignore[arg-type]


def keys_of(part: Any, found: set[str]) -> set[str]:
    """Every property that the schema knows."""
    if isinstance(part, dict):
        if isinstance(part.get("properties"), dict):
            found |= set(part["properties"])
        for value in part.values():
            keys_of(value, found)
    elif isinstance(part, list):
        for value in part:
            keys_of(value, found)
    return found


def keys_in(data: Any) -> set[str]:
    """Every key that the scene uses."""
    if isinstance(data, dict):
        return set(data).union(*(keys_in(value) for value in data.values()))
    return set().union(*(keys_in(value) for value in data)) if isinstance(data, list) else set()


@pytest.mark.parametrize("scene", sorted((ROOT / "scenes").glob("*.yaml")), ids=lambda path: path.stem)
def test_it_takes_the_example_scenes(scene: Path) -> None:
    assert trouble(scene.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (("  crate:", "  world:"), "$.bodies"),
        (("title:", "titel:"), "$"),
        (("radius: 1 in", "radius: -1"), "$.bodies.crate.shape"),
        (("radius: 1 in", "radius: [1]"), "$.bodies.crate.shape"),
        (("radius: 1 in", "radius: wide"), "$.bodies.crate.shape"),
        (("radius: 1 in", "radius: 1 in, radus: 1"), "$.bodies.crate.shape"),
        (("type: cylinder", "type: cilinder"), "$.bodies.crate.shape"),
        (("fixed: true", "fixed: yes"), "$.bodies.floor.fixed"),
        (("velocity: [36 km/h, 0, 0]", "velocity: [36 km/h, 0]"), "$.bodies.crate.velocity"),
        (("velocity: [36 km/h, 0, 0]", "velocity: [36 km/h, 0, 0, 0]"), "$.bodies.crate.velocity"),
        (("restitution: 0.8", "restitution: 1.1"), "$.materials.rubber.restitution"),
        (('"#d33"', "red"), "$.materials.rubber.color"),
        (("impacts: located", "impacts: sometimes"), "$.simulation.impacts"),
        (("iterations: 60", "iterations: 0"), "$.simulation.iterations"),
        (("physsim: 1", "physsim: 2"), "$.physsim"),
        (("mass: 12 lb", "mass:"), "$.bodies.crate.mass"),
        (("{axis: [0, 2, 0], angle: 30 deg}", "{axis: [0, 2, 0]}"), "$.bodies.crate.orientation"),
        (("drop: 0.5 m", "sin: 0.5 m"), "$.parameters"),
    ],
)
def test_it_refuses_broken_scenes(change: tuple[str, str], where: str) -> None:
    assert change[0] in VALID
    assert where in trouble(VALID.replace(*change, 1))


MARKED = (
    "nothing acts",
    "a coil that does nothing",
    "between one and the same",
    "damping twice",
    "damping and its curve",
    "a share of many stiffnesses",
    "a curve of one point",
    "a length below 0",
    "a length of a torsional spring",
    "acts now and then",
    "two lengths",
    "a ball joint holds no torque",
    "breaks at once",
    "motor that does nothing",
    "motor that wants both",
    "motor without an end",
    "servo without stiffness",
    "servo's damping of a motor",
    "travel of a hinge's motor",
    "spring without stiffness",
    "a drive that does nothing",
    "x without its direction",
    "gear of one",
    "gear between bodies",
    "ratio of nothing",
    "no force",
    "two kinds",
    "on the world",
    "force on a pattern",
    "point of no force",
    "region of a force",
    "drag that does nothing",
    "drag without area",
    "unknown type of profile",
    "expression that is a number",
    "of a free body",
    "nowhere",
    "of both kinds",
    "position without a profile",
    "rotation without an angle",
)


@pytest.mark.parametrize("case", MARKED)
def test_editors_mark_mistakes_of_mechanics(case: str) -> None:
    assert trouble(marked(MECHANICS[case][0])[0])


def test_every_key_is_described_and_every_number_tells_its_unit() -> None:
    nameless = []
    for name, part in {**SCHEMA["$defs"], "scene": SCHEMA}.items():
        for key, described in part.get("properties", {}).items():
            if key != "type" and "description" not in described:
                nameless.append(f"{name}.{key}")
    assert nameless == []
