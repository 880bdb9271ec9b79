"""Scenes for the tests of the scene room: small, and written out where they are used."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from physsim.errors import SceneError
from physsim.scene import Scene, load_scene_text
from physsim.scene.problems import format_problem

pytest.register_assert_rewrite("marks")
HEAD = """\
physsim: 1
simulation: {duration: 1 s, timestep: 1 ms}
"""
BALL = """\
bodies:
  ball:
    shape: {type: sphere, radius: 5 cm}
    material: steel
"""


@pytest.fixture
def minimal() -> str:
    """The text of a small valid scene with one body, `ball`; lines 1 to 6."""
    return HEAD + BALL


@pytest.fixture
def headlines() -> Callable[..., list[str]]:
    """The first line of every problem of a scene text called `s.yaml`; empty when it is valid."""

    def told(text: str, **options: object) -> list[str]:
        try:
            load_scene_text(text, name="s.yaml", **options)  # type: ignore[arg-type]
        except SceneError as error:
            return [format_problem(problem, error.file).split("\n")[0] for problem in error.problems]
        return []

    return told


@pytest.fixture
def ball(minimal: str) -> Callable[[str], Scene]:
    """The small scene with one more line for the ball."""
    return lambda line: load_scene_text(f"{minimal}    {line}\n")
