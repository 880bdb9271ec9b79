"""Mistakes in scenes with colours: words, place and caret are those of `physsim.scene.problems`."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import click

from physsim.errors import Problem

COLOURS = {"error": "red", "warning": "yellow"}


def as_text(problems: Sequence[Problem], file: str) -> str:
    """All problems, each with its place, its source line and a caret."""
    return "\n".join(one_as_text(problem, file) for problem in problems)


def one_as_text(problem: Problem, file: str) -> str:
    """The headline bold, the caret in the colour of its severity."""
    from physsim.scene.problems import format_problem

    headline, *excerpt = format_problem(problem, file).split("\n")
    lines = [click.style(headline, bold=True), *excerpt[:-1]]
    return "\n".join([*lines, *(click.style(caret, fg=COLOURS[problem.severity]) for caret in excerpt[-1:])])


def as_data(problems: Sequence[Problem], file: str) -> list[dict[str, Any]]:
    """All problems for a JSON document."""
    from physsim.scene.problems import problem_as_dict

    return [problem_as_dict(problem, file) for problem in problems]
