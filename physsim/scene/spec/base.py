"""The base of every part of a spec."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationInfo, model_validator

from physsim.scene.spec.reading import Reading
from physsim.scene.spec.slip import slip


class Spec(BaseModel):
    """Frozen, no unknown keys, every number finite and in SI.

    Validators are built when they are needed: for a scene those of the whole, not those of each part besides.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)

    @model_validator(mode="before")
    @classmethod
    def _remember(cls, data: Any, info: ValidationInfo) -> Any:
        """Note which keys belong to this mapping, so that an unknown one can be compared with them."""
        if not isinstance(data, dict):
            raise slip("must be a mapping (key: value)")
        if isinstance(info.context, Reading):
            info.context.models[id(data)] = cls
        return data


def keys_of(model: type[BaseModel]) -> list[str]:
    """The keys of a mapping as they are written in a scene."""
    return [field.alias or name for name, field in model.model_fields.items()]
