"""Pillow, which writes PNG and GIF and sets text: an extra."""

# ruff: noqa: PLC0415  imported when it is needed

from __future__ import annotations

from typing import Any

from physsim.errors import PhyssimError


class MissingExtra(PhyssimError):
    """A package of an extra is not installed."""

    exit_code = 2


def pillow() -> Any:
    """The module PIL.Image. Raises MissingExtra."""
    try:
        from PIL import Image
    except ImportError:
        raise missing("pictures", "Pillow") from None
    return Image


def missing(what: str, package: str) -> MissingExtra:
    """The error that says how to get it."""
    return MissingExtra(f"{what} need {package}: pip install 'physsim[view]'")
