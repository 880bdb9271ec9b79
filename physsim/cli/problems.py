"""Mistakes in scenes, as people and as programs read them.

scene.yaml:14:7: bodies.ball.shape.radius: must be greater than 0, got -1
   14 |       radius: -1
      |               ^
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import click

from physsim.errors import Problem, dotted

COLOURS = {"error": "red", "warning": "yellow"}
WIDEST_LINE = 200


def as_text(problems: Sequence[Problem], file: str) -> str:
    """All problems, each with its place, its source line and a caret."""
    return "\n".join(one_as_text(problem, file) for problem in problems)


def one_as_text(problem: Problem, file: str) -> str:
    """One problem in up to three lines."""
    place = ":".join(str(part) for part in (file, problem.line, problem.column) if part is not None)
    word = click.style(f"{problem.severity}: ", fg=COLOURS[problem.severity], bold=True)
    where = f"{dotted(problem.path)}: " if problem.path else ""
    return "\n".join(
        [f"{click.style(place, bold=True)}: {word}{where}{sentence(problem)}", *_excerpt(problem)]
    )


def sentence(problem: Problem) -> str:
    """What is wrong, what was given, what is allowed, and the likely slip."""
    parts = [problem.message]
    if problem.given is not None:
        parts.append(f", got {problem.given}")
    if problem.hint is not None:
        parts.append(f"; {problem.hint}")
    if problem.allowed is not None:
        parts.append(f" (allowed: {problem.allowed})")
    return "".join(parts)


def as_data(problems: Sequence[Problem], file: str) -> list[dict[str, Any]]:
    """All problems for a JSON document; `path` is a list of keys and indices, `where` the same, dotted."""
    return [
        {
            "file": file,
            "line": problem.line,
            "column": problem.column,
            "severity": problem.severity,
            "path": list(problem.path),
            "where": dotted(problem.path),
            "message": problem.message,
            "given": problem.given,
            "allowed": problem.allowed,
            "hint": problem.hint,
        }
        for problem in problems
    ]


def _excerpt(problem: Problem) -> list[str]:
    if problem.source_line is None or problem.line is None:
        return []
    text = problem.source_line.rstrip("\n").replace("\t", " ")[:WIDEST_LINE]
    lines = [f"{problem.line:>5} | {text}"]
    if problem.column is not None and problem.column <= WIDEST_LINE:
        lines.append(f"      | {' ' * (problem.column - 1)}{click.style('^', fg=COLOURS[problem.severity])}")
    return lines
