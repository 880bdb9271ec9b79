"""The JSON Schema of scenes, made from the models: `python -m physsim.scene.schema > schemas/scene.schema.json`."""

from __future__ import annotations

import json
from typing import Any

from pydantic.json_schema import GenerateJsonSchema

from physsim.scene.spec.scene import SceneSpec


def scene_schema() -> dict[str, Any]:
    """The schema (JSON Schema, draft 2020-12)."""
    schema = SceneSpec.model_json_schema(by_alias=True, mode="validation")
    return {"$schema": GenerateJsonSchema.schema_dialect, **schema}


def schema_text() -> str:
    """The schema as the text of its file."""
    return json.dumps(scene_schema(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    print(schema_text(), end="")
