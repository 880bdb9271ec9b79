"""The list of everything wrong or doubtful in a scene, gathered while it is compiled."""

from __future__ import annotations

from dataclasses import dataclass, field

from physsim.errors import PathPart, Problem
from physsim.model.trouble import ShapeTrouble

Path = tuple[PathPart, ...]


@dataclass
class Findings:
    """Errors stop the compilation at its end, warnings travel with the model."""

    errors: list[Problem] = field(default_factory=list)
    warnings: list[Problem] = field(default_factory=list)

    def error(
        self,
        path: Path,
        message: str,
        *,
        given: str | None = None,
        allowed: str | None = None,
        hint: str | None = None,
    ) -> None:
        """Note a mistake at `path`."""
        self.errors.append(Problem(path, message, given, allowed, hint))

    def warn(
        self,
        path: Path,
        message: str,
        *,
        given: str | None = None,
        allowed: str | None = None,
        hint: str | None = None,
    ) -> None:
        """Note something that is probably not what the user wanted."""
        self.warnings.append(Problem(path, message, given, allowed, hint, severity="warning"))

    def trouble(self, path: Path, trouble: ShapeTrouble) -> None:
        """Note what a shape raised; `path` leads to the shape."""
        where = (*path, trouble.key) if trouble.key else path
        self.error(where, trouble.message, given=trouble.given, allowed=trouble.allowed, hint=trouble.hint)
