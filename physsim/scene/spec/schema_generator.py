"""How models become JSON Schema that editors and validators understand well."""

from __future__ import annotations

import re
from typing import Any

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaMode, JsonSchemaValue
from pydantic_core import core_schema


class SchemaGenerator(GenerateJsonSchema):
    """JSON Schema, draft 2020-12, without null: in a scene, what is not given is left out."""

    def generate(
        self, schema: core_schema.CoreSchema, mode: JsonSchemaMode = "validation"
    ) -> JsonSchemaValue:
        """The whole document."""
        shared: dict[str, Any] = {}
        document = _shared(super().generate(schema, mode), shared)
        document["$defs"] = {**document.get("$defs", {}), **shared}
        return {"$schema": self.schema_dialect, **document}

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        described = super().default_schema(schema)
        return {key: value for key, value in described.items() if (key, value) != ("default", None)}

    def tuple_schema(self, schema: core_schema.TupleSchema) -> JsonSchemaValue:
        """`items` where all items are alike: editors know it better than `prefixItems`."""
        described = super().tuple_schema(schema)
        items = described.get("prefixItems", [])
        if not items or any(item != items[0] for item in items):
            return described
        rest = {key: value for key, value in described.items() if key != "prefixItems"}
        return {**rest, "items": items[0]}

    def field_title_should_be_set(self, schema: Any) -> bool:
        """No titles made from field names: they say nothing that the key does not."""
        return False


def _shared(part: Any, shared: dict[str, Any]) -> Any:
    """The schema with kinds of numbers moved to `shared`, where each is described once.

    The keyword `discriminator` is OpenAPI's, not JSON Schema's, and is left out.
    """
    if isinstance(part, list):
        return [_shared(item, shared) for item in part]
    if not isinstance(part, dict):
        return part
    if "anyOf" not in part or "title" not in part:
        return {key: _shared(value, shared) for key, value in part.items() if key != "discriminator"}
    name = re.sub(r"\W+", "_", part["title"])
    shared[name] = {"title": part["title"], "anyOf": part["anyOf"]}
    rest = {key: value for key, value in part.items() if key not in shared[name]}
    return {"$ref": f"#/$defs/{name}", **rest}
