"""The resolved scene: every default, SI, and the same spec when it is read again."""

from __future__ import annotations

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from physsim.scene import load_scene_text
from physsim.scene.scalars import meaning

TEXT = """\
physsim: 1
title: "no"
parameters: {drop: 50 cm}
simulation: {duration: 2 min, timestep: 3 ms}
materials: {"1e3": {density: 1 g/cm^3}, "~": {density: 1}, "0o7": {color: "#abc", density: 2}}
pairs: [{between: ["1e3", "~"], restitution: 0.1}, {between: ["1e3", "0o7"], static_friction: 1e-7}]
bodies:
  "on": {shape: {type: sphere, radius: 1 in}, material: "1e3", position: [0, 0, "${drop/3}"]}
  "<<": {shape: {type: convex, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}, material: "~"}
  '"é: [😀]"':
    shape:
      type: compound
      parts: [{shape: {type: cone, radius: 1, height: 1 ft}, orientation: {euler_xyz: [1 deg, 2, 3]}}]
    material: "0o7"
    orientation: {quaternion: [1, 2, 3, 4]}
    repeat: {count: [2, 1, 1], spacing: [1 m, 0, 0]}
  floor: {fixed: true, shape: {type: halfspace, normal: [1, 2, 3]}, material: steel}
no_contact: [["on", "*"]]
expect:
  - {quantity: bodies.on.position.z, value: 1 cm, within: 1 mm}
  - {quantity: energy.total, at: 1 min, min: -1 kJ}
"""


def test_reading_it_again_gives_the_same_spec() -> None:
    scene = load_scene_text(TEXT)
    text = scene.resolved_yaml()
    again = load_scene_text(text)
    assert again.spec == scene.spec
    assert again.resolved_yaml() == text


def test_every_default_is_in_it_and_every_number_is_bare() -> None:
    data = yaml.safe_load(load_scene_text(TEXT).resolved_yaml())
    assert data["simulation"]["integrator"] == "semi_implicit_euler"
    assert data["simulation"]["duration"] == 120.0
    assert data["world"]["gravity"] == [0.0, 0.0, -9.81]
    assert data["record"]["every"] == 0.009
    assert data["parameters"] == {"drop": 0.5}
    assert data["bodies"]["on"]["velocity"] == [0.0, 0.0, 0.0]


@settings(max_examples=60, deadline=None)
@given(
    st.tuples(*[st.floats(-1e6, 1e6)] * 4).filter(lambda q: max(map(abs, q)) > 1e-3),
    st.floats(1e-9, 1e9),
    st.sampled_from(
        ["1_0", "0x1F", ".inf", "=", "1:30", "null", "yes", "-", "?x", "a: b", "#x", "'", "\\", "é", "1" * 30]
    ),
)
def test_any_numbers_and_names_survive(quaternion: tuple[float, ...], radius: float, name: str) -> None:
    scene = load_scene_text(
        "physsim: 1\nsimulation: {duration: 1, timestep: 0.1}\nbodies: {}\n",
        overrides={
            "materials": {name: {"density": 1.0}},
            "bodies": {
                name: {
                    "shape": {"type": "sphere", "radius": radius},
                    "material": name,
                    "orientation": {"quaternion": list(quaternion)},
                }
            },
        },
    )
    assert load_scene_text(scene.resolved_yaml()).spec == scene.spec


@pytest.mark.parametrize("word", ["1e3", "~", "true", "0o7"])
def test_words_that_look_like_values_are_quoted(word: str) -> None:
    assert not isinstance(meaning(word), str)
    assert f'"{word}"' in load_scene_text(TEXT.replace('title: "no"', f'title: "{word}"')).resolved_yaml()
