"""Rules between the keys of one mapping, in JSON Schema, so that editors mark what the checks refuse."""

from __future__ import annotations

from typing import Any

Schema = dict[str, Any]


def any_of(*keys: str) -> Schema:
    """At least one of the keys."""
    return {"anyOf": [{"required": [key]} for key in keys]}


def none_of(*keys: str) -> Schema:
    """None of the keys."""
    return {"not": any_of(*keys)}


def not_together(*pairs: tuple[str, str]) -> list[Schema]:
    """Of each pair at most one."""
    return [{"not": {"required": list(pair)}} for pair in pairs]


def all_of(*rules: Schema) -> Schema:
    """All of the rules. The generator of the schema keeps `anyOf` beside a title for numbers."""
    return {"allOf": list(rules)}


def only_with(**needs: str) -> Schema:
    """Keys that mean something only beside another one."""
    return {"dependentRequired": {key: [other] for key, other in needs.items()}}


SOMETHING: Schema = {"minProperties": 1}
"""At least one key."""
ALL_DIFFERENT: Schema = {"uniqueItems": True}
"""A list without repetition."""
