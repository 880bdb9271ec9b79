"""Contacts that FCL answers: which direction, how deep, where. fcl is imported when `FclAnswers` is first
asked for."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from physsim.collision.answers import FclAnswers

__all__ = ["FclAnswers"]


def __getattr__(name: str) -> Any:
    if name != "FclAnswers":
        raise AttributeError(f"module 'physsim.collision' has no attribute {name!r}")
    return importlib.import_module("physsim.collision.answers").FclAnswers
