"""What pydantic found -> problems in the words of the scene language, placed."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, ClassVar

from pydantic import ValidationError

from physsim.errors import PathPart, Problem
from physsim.scene import nodes
from physsim.scene.nodes import Mapping, Node, Scalar
from physsim.scene.place import Places, find
from physsim.scene.problems import MAX_TOLD
from physsim.scene.spec.base import keys_of
from physsim.scene.spec.reading import Reading
from physsim.scene.spec.slip import CODE, TOLD_ELSEWHERE
from physsim.scene.suggest import nearest

Path = tuple[PathPart, ...]
_QUOTED = re.compile(r"'([^']*)'")


class Translator:
    """Turns the errors of one validation into problems.

    root: the scene as written; data: the plain data that was validated, whose mappings `reading` knows by
    identity.
    """

    def __init__(self, root: Node, data: Any, reading: Reading, places: Places) -> None:
        self._root = root
        self._data = data
        self._models = reading.models
        self._places = places

    def problems(self, error: ValidationError) -> list[Problem]:
        """Every problem once, in the order of the file."""
        found: dict[tuple[Path, str], Problem] = {}
        errors = error.errors(include_url=False)[: MAX_TOLD + 1]
        wanted = self._wanted_lengths(errors)
        for details in errors:
            problem = self._problem(dict(details), wanted)
            if problem is not None:
                found.setdefault((problem.path, problem.message), problem)
        return list(found.values())

    def _problem(self, details: dict[str, Any], wanted: dict[Path, int]) -> Problem | None:
        path = self._path(details["loc"])
        kind: str = details["type"]
        context = details.get("ctx", {})
        if "[key]" in details["loc"]:
            context = {**context, "points_at_key": True}
        if kind == TOLD_ELSEWHERE or (kind == "too_short" and self._is_long_enough(path, context)):
            return None
        if kind == "missing":
            return self._missing(path, wanted)
        handler = self._HANDLERS.get(kind)
        if handler is not None:
            return handler(self, path, context)
        problem = Problem(path, _message(kind, context) or details["msg"], self._given(path))
        if kind == "too_long":
            first_too_many = self._places.place(Problem((*path, context["max_length"]), ""))
            return replace(first_too_many, path=path, message=problem.message, given=problem.given)
        return self._places.place(problem)

    def _is_long_enough(self, path: Path, context: dict[str, Any]) -> bool:
        """pydantic does not count items that are wrong in themselves; those are told one by one."""
        value = _below(self._data, path)
        return isinstance(value, list | dict) and len(value) >= context["min_length"]

    def _own(self, path: Path, context: dict[str, Any]) -> Problem:
        path = (*path, *context["at"])
        at_key = context["points_at_key"]
        given = None if at_key else self._given(path)
        problem = Problem(path, context["message"], given, context["allowed"], context["hint"])
        return self._places.place(problem, at_key=at_key)

    def _missing(self, path: Path, wanted: dict[Path, int]) -> Problem:
        if isinstance(path[-1], int):
            return self._at_value(path[:-1], f"must be a list of {wanted[path[:-1]]}")
        return self._places.place(Problem(path, "is required but missing"), at_key=True)

    def _unknown_key(self, path: Path, context: dict[str, Any]) -> Problem:
        parent = _below(self._data, path[:-1])
        model = self._models.get(id(parent))
        known = keys_of(model) if model is not None else []
        near = nearest(str(path[-1]), known)
        hint = f"did you mean '{near}'?" if near else None
        if near and isinstance(parent, dict) and near in parent:
            hint = f"'{near}' is given already"
        allowed = None if hint else ", ".join(known)
        return self._places.place(Problem(path, "unknown key", None, allowed, hint), at_key=True)

    def _no_type(self, path: Path, context: dict[str, Any]) -> Problem:
        return self._places.place(Problem((*path, "type"), "is required but missing"), at_key=True)

    def _unknown_type(self, path: Path, context: dict[str, Any]) -> Problem:
        return self._not_among((*path, "type"), "unknown type", context["expected_tags"])

    def _unknown_word(self, path: Path, context: dict[str, Any]) -> Problem:
        return self._not_among(path, "must be one of the allowed words", context["expected"])

    def _not_among(self, path: Path, message: str, expected: str) -> Problem:
        known = _QUOTED.findall(expected)
        given = self._given(path)
        near = nearest(given or "", known)
        hint = f"did you mean '{near}'?" if near else None
        return self._places.place(Problem(path, message, given, ", ".join(known), hint))

    def _at_value(self, path: Path, message: str) -> Problem:
        return self._places.place(Problem(path, message, self._given(path)))

    def _given(self, path: Path) -> str | None:
        found = find(self._root, path)
        return nodes.shown(found.node) if found.complete else None

    def _path(self, loc: Sequence[PathPart]) -> Path:
        """pydantic's location without what is no key: the tags of unions and the mark of a mapping's key."""
        parts: list[PathPart] = []
        node: Node | None = self._root
        tag_passed = False
        for part in loc:
            if part == "[key]" or (not tag_passed and _is_tag(node, part)):
                tag_passed = True
                continue
            parts.append(part)
            found = find(node, (part,)) if node is not None else None
            node = found.node if found is not None and found.complete else None
            tag_passed = False
        return tuple(parts)

    _HANDLERS: ClassVar[dict[str, Callable[[Translator, Path, dict[str, Any]], Problem]]] = {
        CODE: _own,
        "extra_forbidden": _unknown_key,
        "union_tag_invalid": _unknown_type,
        "union_tag_not_found": _no_type,
        "literal_error": _unknown_word,
    }

    def _wanted_lengths(self, errors: Sequence[Any]) -> dict[Path, int]:
        """The length of each list that has too few items: pydantic reports every missing one by its index."""
        lengths: dict[Path, int] = {}
        for details in errors:
            path = self._path(details["loc"])
            if details["type"] == "missing" and path and isinstance(path[-1], int):
                lengths[path[:-1]] = max(lengths.get(path[:-1], 0), path[-1] + 1)
        return lengths


def _is_tag(node: Node | None, part: PathPart) -> bool:
    if not isinstance(node, Mapping) or "type" not in node.entries:
        return False
    tag = node.entries["type"].node
    return isinstance(tag, Scalar) and tag.value == part


def _below(data: Any, path: Path) -> Any:
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def _message(kind: str, context: dict[str, Any]) -> str | None:
    """pydantic's remaining kinds of errors in our words; None for those that have no better ones."""
    if kind == "too_long":
        return f"must have at most {context['max_length']} items"
    if kind == "too_short":
        least = context["min_length"]
        return "must not be empty" if least == 1 else f"must have at least {least} items"
    return {
        "tuple_type": "must be a list, in brackets or with a dash per line",
        "dict_type": "must be a mapping (name: ...)",
        "model_type": "must be a mapping (key: value)",
        "model_attributes_type": "must be a mapping (key: value)",
    }.get(kind)
