"""Defaults of lists by path: what `--set world.gravity[0]=1` starts from when no gravity is given."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, get_args, get_origin

from pydantic import BaseModel

from physsim.errors import PathPart
from physsim.scene.spec.scene import SceneSpec


def default_list(path: Sequence[PathPart]) -> list[Any] | None:
    """The default at ("bodies", "ball", "velocity") and the like; None when it is no list."""
    model: Any = SceneSpec
    parts = list(path)
    while parts:
        field = next((f for n, f in model.model_fields.items() if (f.alias or n) == parts[0]), None)
        if field is None:
            return None
        parts.pop(0)
        if not parts:
            return list(field.default) if isinstance(field.default, tuple) else None
        model = field.annotation
        if get_origin(model) is dict:
            model = get_args(model)[1]
            parts.pop(0)
        if not (isinstance(model, type) and issubclass(model, BaseModel)):
            return None
    return None
