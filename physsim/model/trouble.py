"""What is raised where a shape cannot be right; `compile` adds the place in the scene."""

from __future__ import annotations


class ShapeTrouble(Exception):
    """A shape that cannot be simulated.

    key: the key below `shape` (or beside it) that is at fault, e.g. ``file``; "" for the shape as a whole.
    """

    def __init__(
        self,
        message: str,
        *,
        key: str = "",
        given: str | None = None,
        allowed: str | None = None,
        hint: str | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.key = key
        self.given = given
        self.allowed = allowed
        self.hint = hint
