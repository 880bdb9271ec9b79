"""What validators know of the scene around them, handed through pydantic's context."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from physsim.scene.parameters import Parameters

if TYPE_CHECKING:
    from pydantic import BaseModel, ValidationInfo


@dataclass
class Reading:
    """One validation: the parameters, and which model each mapping (by identity) was read as.

    joint_types: the type of each joint by name, as it was written.
    """

    parameters: Parameters
    joint_types: Mapping[str, str] = field(default_factory=dict)
    models: dict[int, type[BaseModel]] = field(default_factory=dict)


def reading_of(info: ValidationInfo) -> Reading:
    """The reading of this validation; one without parameters when a model is validated by itself."""
    context: Any = info.context
    return context if isinstance(context, Reading) else Reading(Parameters({}))
