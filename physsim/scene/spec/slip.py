"""How a validator tells what is wrong: `raise slip("must be finite", ...)`."""

from __future__ import annotations

from pydantic_core import PydanticCustomError

from physsim.errors import PathPart

CODE = "physsim"
TOLD_ELSEWHERE = "physsim_told_elsewhere"


def slip(
    message: str,
    *,
    allowed: str | None = None,
    hint: str | None = None,
    at: tuple[PathPart, ...] = (),
    points_at_key: bool = False,
) -> PydanticCustomError:
    """An error for pydantic to collect.

    at: where below the value that is being validated; the place of the whole value when empty.
    points_at_key: the caret goes to the key, since the trouble is that it is there, or what is missing beside
    it.
    """
    context = {"message": message, "allowed": allowed, "hint": hint, "at": at, "points_at_key": points_at_key}
    return PydanticCustomError(CODE, "{message}", context)


def silent() -> PydanticCustomError:
    """An error that is told elsewhere already (a parameter that is wrong itself)."""
    return PydanticCustomError(TOLD_ELSEWHERE, "told elsewhere")
