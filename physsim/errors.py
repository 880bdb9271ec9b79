"""What can go wrong, and what the command line answers with.

Physics code says what is wrong under which name (`Problem.path`); the scene room adds line and column.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

PathPart = str | int


@dataclass(frozen=True)
class Problem:
    """One mistake in a scene.

    path: keys and indices from the root, e.g. ``("bodies", "ball", "shape", "radius")``.
    message: what is wrong, in words, e.g. ``must be greater than 0``.
    given, allowed, hint: what stood there, what may stand there, the likely slip; None where there is none.
    line, column: from 1, None until the scene room has placed the problem.
    source_line: the text of that line, for the caret.
    """

    path: tuple[PathPart, ...]
    message: str
    given: str | None = None
    allowed: str | None = None
    hint: str | None = None
    severity: Literal["error", "warning"] = "error"
    line: int | None = None
    column: int | None = None
    source_line: str | None = None


class PhyssimError(Exception):
    """Base of every error that is told to the user in plain words, never as a traceback."""

    exit_code = 1


class RunFailed(PhyssimError):
    """The run stopped before its end: blow-up, NaN, or a failure of the engine."""


class SceneError(PhyssimError):
    """The scene is not valid. `problems` holds every mistake that was found, `file` the scene's name."""

    exit_code = 2

    def __init__(self, problems: Sequence[Problem], file: str) -> None:
        self.problems = tuple(problems)
        self.file = file
        super().__init__(f"{file}: {len(self.problems)} problem(s), first: {_first(self.problems)}")


class FileTrouble(PhyssimError):
    """A file is missing, exists already, cannot be read or written, or the disk is full."""

    exit_code = 3


class ExpectationFailed(PhyssimError):
    """An `expect` entry of the scene did not hold."""

    exit_code = 4


def dotted(path: Sequence[PathPart]) -> str:
    """`("bodies", "ball", "size", 0)` -> `bodies.ball.size[0]`."""
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
        else:
            text += f".{part}" if text else part
    return text


def _first(problems: Sequence[Problem]) -> str:
    return f"{dotted(problems[0].path)}: {problems[0].message}" if problems else "none"
