"""Problems as people and as programs read them."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import replace

from physsim.errors import Problem, dotted

# More mistakes than this are counted, not told: nobody reads them, and a huge file takes minutes to tell.
MAX_TOLD = 1000
MAX_PATH = 160
MAX_WIDTH = 120


def told_in_order(problems: Sequence[Problem]) -> list[Problem]:
    """The problems in the order of the file, those of overrides last; beyond MAX_TOLD only their number."""
    ordered = sorted(problems, key=lambda p: (p.line is None, p.line or 0, p.column or 0))
    if len(ordered) <= MAX_TOLD:
        return ordered
    rest = replace(ordered[MAX_TOLD], message=f"and {len(ordered) - MAX_TOLD} more mistakes from here on")
    return [*ordered[:MAX_TOLD], replace(rest, given=None, allowed=None, hint=None)]


def format_problem(problem: Problem, file: str) -> str:
    """`scene.yaml:14:7: bodies.ball.mass: must be greater than 0, got -1`, then the line and a caret."""
    head = _printable(f"{_where(problem, file)}: {_what(problem)}")
    return "\n".join([head, *_excerpt(problem)])


def format_problems(problems: Sequence[Problem], file: str) -> str:
    """All problems, each as `format_problem` gives it."""
    return "\n".join(format_problem(problem, file) for problem in problems)


def problem_as_dict(problem: Problem, file: str) -> dict[str, object]:
    """The problem for `--json`: `keys` is the path in parts, `origin` an override (`--set a=b`) or None."""
    return {
        "file": file,
        "line": problem.line,
        "column": problem.column,
        "origin": problem.source_line if problem.line is None else None,
        "severity": problem.severity,
        "path": dotted(problem.path),
        "keys": list(problem.path),
        "message": problem.message,
        "given": problem.given,
        "allowed": problem.allowed,
        "hint": problem.hint,
    }


def _where(problem: Problem, file: str) -> str:
    if problem.line is not None:
        return f"{file}:{problem.line}:{problem.column}"
    return problem.source_line if problem.source_line is not None else file


def _what(problem: Problem) -> str:
    path = dotted(problem.path)
    if len(path) > MAX_PATH:
        path = f"{path[:MAX_PATH]}…"
    text = "warning: " if problem.severity == "warning" else ""
    text += f"{path}: {problem.message}" if path else problem.message
    text += f", got {problem.given}" if problem.given is not None else ""
    text += f"; {problem.hint}" if problem.hint else ""
    return text + (f" (allowed: {problem.allowed})" if problem.allowed else "")


def _excerpt(problem: Problem) -> list[str]:
    """The source line and the caret below it; a long line is shown around the caret."""
    if problem.line is None or problem.source_line is None or problem.column is None:
        return []
    column = min(problem.column - 1, len(problem.source_line))
    start = max(0, column - MAX_WIDTH * 2 // 3) if len(problem.source_line) > MAX_WIDTH else 0
    shown = _printable(problem.source_line[start : start + MAX_WIDTH])
    caret = " " * sum(_width(c) for c in shown[: column - start]) + "^"
    margin = max(5, len(str(problem.line)))
    return [f"{problem.line:>{margin}} | {shown}".rstrip(), f"{'':>{margin}} | {caret}"]


def _printable(text: str) -> str:
    """The text without what would move the cursor, colour the terminal or turn the line around."""
    return "".join(c if c.isprintable() else " " for c in text)


def _width(character: str) -> int:
    """Columns that a character takes in a terminal (Unicode Standard Annex 11)."""
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1
