"""YAML read by our rules: what scalars mean, what is refused, and the attacks that must cost nothing."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from physsim.scene import load_scene_text, yaml_reader
from physsim.scene.nodes import plain
from physsim.scene.scalars import meaning
from physsim.scene.yaml_reader import read_yaml


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1e-3", 1e-3),
        ("1E3", 1e3),
        (".5", 0.5),
        ("5.", 5.0),
        ("+1.5", 1.5),
        ("-0", 0),
        ("0777", 777),
        ("0o17", 15),
        ("0x1F", 31),
        ("-.inf", -math.inf),
        ("1e999", math.inf),
        ("true", True),
        ("FALSE", False),
        ("null", None),
        ("~", None),
        ("", None),
        ("Null", None),
    ],
)
def test_scalars_follow_the_core_schema_of_yaml_1_2(text: str, value: object) -> None:
    assert meaning(text) == value
    assert type(meaning(text)) is type(value)


@pytest.mark.parametrize(
    "text",
    [
        "no",
        "on",
        "yes",
        "off",
        "y",
        "12:30:45",
        "1_000",
        "2026-01-01",
        "0b101",
        "tRUE",
        "nan",
        "inf",
        "1e",
        ".",
        "-",
        "+",
    ],
)
def test_words_of_yaml_1_1_are_text(text: str) -> None:
    assert meaning(text) == text


def test_nan_is_a_number_that_no_scene_takes() -> None:
    assert math.isnan(meaning(".nan"))  # type: ignore[arg-type]


def test_quoted_numbers_stay_text_and_plain_ones_do_not() -> None:
    document = read_yaml("a: '1'\nb: 1\n\"c\": no\n")
    assert document.root is not None
    assert plain(document.root) == {"a": "1", "b": 1, "c": "no"}


def test_an_alias_is_a_copy(minimal: str) -> None:
    text = minimal.replace("{type: sphere, radius: 5 cm}", "&s {type: sphere, radius: 5 cm}")
    scene = load_scene_text(
        f"{text}  twin: {{shape: *s, material: wood}}\n", overrides=["bodies.twin.shape.radius=7 cm"]
    )
    assert (scene.spec.bodies["ball"].shape.radius, scene.spec.bodies["twin"].shape.radius) == (0.05, 0.07)


BILLION_LAUGHS = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 9)}]\n"
    for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)
DEEP_ALIASES = "a0: &a0 [x]\n" + "".join(f"a{i + 1}: &a{i + 1} [*a{i}]\n" for i in range(80))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (BILLION_LAUGHS, "aliases multiply the scene beyond 100000 values"),
        ("a: &a [*a]\n", "s.yaml:1:8: a[0]: alias *a refers to what it stands in"),
        ("a: &a {b: *a}\n", "s.yaml:1:11: a.b: alias *a refers to what it stands in"),
        ("a: *b\n", "s.yaml:1:4: a: alias *b has no anchor &b before it"),
        (DEEP_ALIASES, "is nested deeper than 64 levels through alias *a62"),
        ("[" * 100_000, "s.yaml:1:65:"),
        ("{a: " * 100_000, "is nested deeper than 64 levels"),
        ("- " * 100_000, "s.yaml:1:129:"),
        ("? " * 100_000, "s.yaml:1:129: is nested deeper than 64 levels"),
        ("<<: {a: 1}\n", "s.yaml:1:1: merge keys (<<) are not part of the scene language"),
        (
            "x: !!python/object/apply:os.system [ls]\n",
            "s.yaml:1:4: x: YAML tags are not part of the scene language, "
            "got tag:yaml.org,2002:python/object/apply:o",
        ),
        ("x: !!binary aGVsbG8=\n", "s.yaml:1:4: x: YAML tags are not part of the scene language"),
        ("x: ! 3\n", "s.yaml:1:4: x: YAML tags are not part of the scene language, got !"),
        (
            "a: 1\n---\nb: 2\n",
            "s.yaml:2:1: holds more than one document; a scene is one (remove the line '---')",
        ),
        ("? [a, b]\n: 1\n", "s.yaml:1:3: a key must be a word, not a list or a mapping"),
        ('a: "x\\0y"\n', "s.yaml:1:4: a: holds a control character"),
        ("a: \x01\n", "s.yaml:1:4: holds the control character U+0001"),
        ("a: [1, 2\n", "is not valid YAML: while parsing a flow sequence: did not find expected ',' or ']'"),
        ("a: 1\n\tb: 2\n", "indent with spaces, not with tabs"),
        ("a: [1, ${2*b}]\n", 'inside [...] and {...} an expression needs quotes: "${...}"'),
        (
            "a: [world, brick[0,0,0]]\n",
            'inside [...] and {...} a name with brackets needs quotes: "brick[0,0,0]"',
        ),
        (f"a: {'9' * 5001}\n", "s.yaml:1:4: a: is an integer of more than 20 digits"),
        (f"a: 0x{'f' * 5001}\n", "s.yaml:1:4: a: is an integer of more than 20 digits"),
        ("", "s.yaml:1:1: the file is empty"),
        ("# only words\n", "s.yaml:1:1: the file is empty"),
        ("---\n...\n", "s.yaml:1:1: the file is empty"),
        ("- a\n- b\n", "s.yaml:1:1: a scene must be a mapping (key: value)"),
        ("just a word\n", "s.yaml:1:1: a scene must be a mapping (key: value)"),
    ],
)
def test_attack_or_trap_is_told(text: str, expected: str, headlines: Callable[[str], list[str]]) -> None:
    told = headlines(text)
    assert any(expected in line for line in told), told


def test_every_duplicate_key_names_its_first_line(headlines: Callable[[str], list[str]]) -> None:
    told = headlines("physsim: 1\nphyssim: 1\nbodies:\n  a: {mass: 1, mass: 2}\n  a: {}\n")
    assert [line for line in told if "twice" in line] == [
        "s.yaml:2:1: physsim: is given twice, first on line 1",
        "s.yaml:4:16: bodies.a.mass: is given twice, first on line 4",
        "s.yaml:5:3: bodies.a: is given twice, first on line 4",
    ]


def test_too_many_values_are_refused(
    headlines: Callable[[str], list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(yaml_reader, "MAX_NODES", 1000)
    assert headlines("a: [" + "1," * 1000 + "]\n") == ["s.yaml:1:2003: a[999]: holds more than 1000 values"]


def test_columns_count_characters_not_bytes(headlines: Callable[[str], list[str]], minimal: str) -> None:
    line = '  "😀é": {material: steel, shape: {type: sphere, radius: -1}}'
    told = headlines(f"{minimal}{line}\n")
    assert told == [
        f"s.yaml:7:{line.index('-1') + 1}: bodies.😀é.shape.radius: must be greater than 0, got -1"
    ]


def test_line_numbers_survive_windows_line_ends(headlines: Callable[[str], list[str]], minimal: str) -> None:
    told = headlines((minimal + "    mass: -1\n").replace("\n", "\r\n"))
    assert told == ["s.yaml:7:11: bodies.ball.mass: must be greater than 0, got -1"]
