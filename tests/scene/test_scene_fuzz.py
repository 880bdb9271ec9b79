"""Mutated scenes: whatever is done to a scene, loading it gives a scene or an error in plain words.

A longer run: `PHYSSIM_FUZZ=20000 python -m pytest tests/scene/test_scene_fuzz.py`.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from physsim.errors import SceneError
from physsim.scene import format_problems, load_scene_text, problem_as_dict
from physsim.scene.nodes import plain
from physsim.scene.yaml_reader import read_yaml

EVERYTHING = Path(__file__).with_name("everything.yaml").read_text(encoding="utf-8")
EXAMPLES = int(os.environ.get("PHYSSIM_FUZZ", "150"))
fuzzed = settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck))

MARKS = [
    "{",
    "}",
    "[",
    "]",
    ":",
    ": ",
    "- ",
    "\n",
    "\n  ",
    ",",
    "#",
    "&a ",
    "*a",
    "<<: ",
    "!!x ",
    "? ",
    "|\n",
    ">\n",
]
WORDS = ["1e999", ".nan", "-1", "0", "1e-300", "null", "true", "yes", "world", "brick", "repeat: ", "9" * 30]
OTHERS = [
    "'",
    '"',
    "\\",
    "\t",
    "\0",
    "\x85",
    "\u2028",
    "\ufeff",
    "\ud7ff",
    "😀",
    "é",
    "%",
    "@",
    "`",
    "---\n",
    "\r",
    "*",
]
EXPRESSIONS = [
    "sin(2*pi*t)",
    "t/0",
    "type: step",
    "${",
    "${1/0}",
    "${drop}",
    "${2*drop} cm",
    "${a",
    "type: compound",
    "brick[0,0,0]",
]
PIECES = st.sampled_from(MARKS + WORDS + OTHERS + EXPRESSIONS)


@st.composite
def mutated(draw: Any) -> str:
    """A scene with some stretches cut out, doubled, moved or replaced."""
    text = EVERYTHING
    for _ in range(draw(st.integers(1, 6))):
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.sampled_from([0, 1, 2, 5, 20, 200])))
        new = draw(st.one_of(PIECES, st.text(max_size=5), st.just(""), st.just(text[start:end] * 2)))
        text = text[:start] + new + text[end:]
    return text


KEYS = st.sampled_from(["type", "shape", "radius", "parts", "position", "crate", "", "a.b"])
TEXTS = st.sampled_from(["1 m", "${drop}", "${", "1 kg", "world", "crate", "-1", "1e400", "#", "x" * 3000])
VALUES = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8), TEXTS),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(KEYS, inner, max_size=4)),
    max_leaves=8,
)


def places_of(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Every path in nested data."""
    found = [path]
    if isinstance(data, dict):
        children = list(data.items())
    else:
        children = list(enumerate(data)) if isinstance(data, list) else []
    for key, value in children:
        found += places_of(value, (*path, key))
    return found


def places_in(text: str) -> list[tuple[Any, ...]]:
    """Every path in a scene, the root left out."""
    root = read_yaml(text).root
    assert root is not None
    return places_of(plain(root))[1:]


def dotted(path: tuple[Any, ...]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path).removeprefix(".")


def load(text: str, overrides: Any = None) -> None:
    """Load and, whatever comes of it, tell it."""
    try:
        scene = load_scene_text(text, name="s.yaml", overrides=overrides)
    except SceneError as refused:
        error = refused
    else:
        assert load_scene_text(scene.resolved_yaml()).spec == scene.spec
        return
    assert format_problems(error.problems, error.file).startswith(("s.yaml:", "--set "))
    assert all(problem_as_dict(problem, error.file)["message"] for problem in error.problems)
    assert all(p.line is not None or str(p.source_line).startswith("--set ") for p in error.problems)


def test_the_scene_to_mutate_is_valid() -> None:
    assert load_scene_text(EVERYTHING).bodies


@fuzzed
@given(mutated())
def test_mutated_text(text: str) -> None:
    load(text)


@fuzzed
@given(st.lists(st.tuples(st.sampled_from(places_in(EVERYTHING)), VALUES), min_size=1, max_size=4))
def test_any_value_in_any_place(changes: list[tuple[tuple[Any, ...], Any]]) -> None:
    load(EVERYTHING, {dotted(path): value for path, value in changes})


@fuzzed
@given(st.text(alphabet="abodiescrt.[]012=: ${}\"'!&*", max_size=40))
def test_any_override(text: str) -> None:
    load(EVERYTHING, [text])


@fuzzed
@given(st.text(alphabet=st.characters(codec="utf-8"), max_size=80))
def test_any_text_at_all(text: str) -> None:
    load(text)
