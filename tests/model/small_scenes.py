"""Scenes of one or two bodies, from text."""

from __future__ import annotations

from pathlib import Path

from physsim.errors import Problem, SceneError
from physsim.model import Model, compile_scene
from physsim.scene import load_scene_text

HEAD = "physsim: 1\nsimulation: {duration: 1 s, timestep: 1 ms}\n"


def compiled(text: str, folder: Path | None = None) -> Model:
    """The model of HEAD and `text`."""
    return compile_scene(load_scene_text(HEAD + text, folder=folder))


def body(keys: str, folder: Path | None = None) -> Model:
    """The model of one body, `thing`, given by its keys in braces."""
    return compiled(f"bodies:\n  thing: {{{keys}}}\n", folder)


def problems(text: str, folder: Path | None = None) -> tuple[Problem, ...]:
    """Every problem of HEAD and `text`, which must have some."""
    try:
        compiled(text, folder)
    except SceneError as error:
        return error.problems
    raise AssertionError("the scene has no problem")


def body_problem(keys: str, folder: Path | None = None) -> Problem:
    """The one problem of a body, placed on its line."""
    (problem,) = problems(f"bodies:\n  thing: {{{keys}}}\n", folder)
    assert problem.line == 4
    assert problem.severity == "error"
    return problem
