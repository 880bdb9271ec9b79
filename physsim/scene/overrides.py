"""`--set path=value`: changes to a scene before it is validated, e.g. `bodies.crate.position[2]=0.7`.

A path is keys joined by points and indices in brackets. Keys that hold points or brackets themselves are
found by the longest match. The value is YAML, so `2 s`, `[0, 0, 1]` and `{type: sphere, radius: 1 cm}` are
all fine; `null` takes a key away. Later changes see earlier ones. Everything set this way is validated like
the file, and its errors name the override as their place.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from physsim.errors import PathPart, Problem
from physsim.scene import nodes
from physsim.scene.defaults import default_list
from physsim.scene.nodes import Entry, Node, Place, Scalar, Sequence
from physsim.scene.scalars import MAX_DIGITS
from physsim.scene.suggest import did_you_mean
from physsim.scene.yaml_reader import read_yaml

Overrides = Mapping[str, Any] | Iterable[str]
# Sections in which a misspelt name must not make a new entry in passing.
NAMED_SECTIONS = ("bodies", "springs", "joints", "forces")
MAX_VALUE_DEPTH = 32
_KEY = re.compile(r"[^.\[\]]+")
_INDEX = re.compile(r"\[(\d{1,9})\]")
_SHOWN = 80


class OverrideError(ValueError):
    """An override cannot be applied; `hint` names the likely slip."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


@dataclass(frozen=True)
class Override:
    """One change: the path as written, the value as a node, and how it is told in messages."""

    path: str
    value: Node
    origin: str


def apply_overrides(root: nodes.Mapping, overrides: Overrides | None) -> list[Problem]:
    """Change the scene in place. Returns a problem for every override that cannot be applied."""
    problems: list[Problem] = []
    for item in _items(overrides):
        origin = _origin(item)
        try:
            override, found = _read(item, origin)
            problems += found
            _set(root, override)
        except OverrideError as error:
            problems.append(Problem((), str(error), hint=error.hint, source_line=origin))
    return problems


def _items(overrides: Overrides | None) -> list[tuple[str, Any] | str]:
    if overrides is None:
        return []
    if isinstance(overrides, str):
        return [overrides]
    return list(overrides.items()) if isinstance(overrides, Mapping) else list(overrides)


def _origin(item: tuple[str, Any] | str) -> str:
    text = item if isinstance(item, str) else f"{item[0]}={item[1]}"
    text = "".join(c if c.isprintable() else " " for c in text)
    return f"--set {text if len(text) <= _SHOWN else text[: _SHOWN - 1] + '…'}"


def _read(item: tuple[str, Any] | str, origin: str) -> tuple[Override, list[Problem]]:
    if not isinstance(item, str):
        return Override(item[0].strip(), node_of(item[1], Place(1, 1, origin)), origin), []
    path, equals, text = item.partition("=")
    if not equals:
        raise OverrideError("must be path=value, e.g. simulation.duration=2 s")
    value, problems = _value(text.strip(), origin)
    return Override(path.strip(), value, origin), problems


def _value(text: str, origin: str) -> tuple[Node, list[Problem]]:
    place = Place(1, 1, origin)
    if text.startswith("#"):
        return Scalar(place, text, text), []
    document = read_yaml(text, origin)
    problems = [
        Problem(p.path, p.message, p.given, hint=p.hint, source_line=origin) for p in document.problems
    ]
    return document.root or Scalar(place, "", None), problems


def node_of(value: Any, place: Place, depth: int = 0) -> Node:
    """A Python value (also of numpy) as a node. Raises OverrideError for what no scene can hold."""
    if depth > MAX_VALUE_DEPTH:
        raise OverrideError(f"is nested deeper than {MAX_VALUE_DEPTH} levels")
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, Mapping):
        entries = {str(key): Entry(place, node_of(item, place, depth + 1)) for key, item in value.items()}
        return nodes.Mapping(place, True, entries)
    if isinstance(value, list | tuple):
        return Sequence(place, True, [node_of(item, place, depth + 1) for item in value])
    if isinstance(value, int) and abs(value) >= 10**MAX_DIGITS:
        raise OverrideError(f"is an integer of more than {MAX_DIGITS} digits")
    if value is None or isinstance(value, bool | int | float | str):
        return Scalar(place, str(value), value)
    raise OverrideError(f"is a {type(value).__name__}, which no scene can hold")


def _set(root: nodes.Mapping, override: Override) -> None:
    """Follow the path and put the value at its end."""
    rest = override.path
    if not rest:
        raise OverrideError("has no path before '='")
    node: Node = root
    path: list[PathPart] = []
    while True:
        part, rest = _next_part(node, rest, path)
        if not rest:
            _put(node, part, override.value, override)
            return
        path.append(part)
        node = _below(node, part, path, rest, override)


def _next_part(node: Node, rest: str, path: list[PathPart]) -> tuple[PathPart, str]:
    """The first part of what is left of a path, and what follows it without its point."""
    index = _INDEX.match(rest)
    if index and not isinstance(node, nodes.Mapping):
        return int(index[1]), _behind(rest, index.end())
    if isinstance(node, nodes.Mapping):
        known = [key for key in node.entries if _begins(rest, key)]
        if known:
            key = max(known, key=len)
            return key, _behind(rest, len(key))
        new = _KEY.match(rest)
        if new:
            return new[0], _behind(rest, new.end())
    raise OverrideError(
        f"cannot be followed at '{rest[:_SHOWN]}'", _copy_hint(rest, path) or _items_hint(node)
    )


def _copy_hint(rest: str, path: list[PathPart]) -> str | None:
    """`bodies.brick[0,0,3].mass`: the copies of a body are changed together."""
    if path[:1] == ["bodies"] and re.match(r"\[\d+,", rest):
        return f"copies of a repeated body are set together: bodies.{path[-1]}"
    return None


def _begins(rest: str, key: str) -> bool:
    return rest == key or (bool(key) and rest.startswith((f"{key}.", f"{key}[")))


def _behind(rest: str, end: int) -> str:
    following = rest[end:]
    if following in (".",) or (following and following[0] not in ".["):
        raise OverrideError(f"cannot be followed at '{following[:_SHOWN]}'")
    return following[1:] if following.startswith(".") else following


def _below(node: Node, part: PathPart, path: list[PathPart], rest: str, override: Override) -> Node:
    """The node under `part`, made when it is missing and may be."""
    if isinstance(node, nodes.Mapping):
        key = str(part)
        if key not in node.entries or _is_nothing(node.entries[key].node):
            node.entries[key] = Entry(Place(1, 1, override.origin), _new(node, path, rest, override))
        return node.entries[key].node
    if isinstance(node, Sequence) and isinstance(part, int) and part < len(node.items):
        return node.items[part]
    raise OverrideError(f"cannot be followed at '{_part_text(part)}'", _items_hint(node))


def _is_nothing(node: Node) -> bool:
    return isinstance(node, Scalar) and node.value is None


def _new(parent: nodes.Mapping, path: list[PathPart], rest: str, override: Override) -> Node:
    """What a missing key holds: the default of a vector when an item of it is set, else an empty mapping."""
    place = Place(1, 1, override.origin)
    if len(path) == 2 and path[0] in NAMED_SECTIONS:
        hint = did_you_mean(str(path[1]), parent.entries)
        raise OverrideError(f"there is no '{path[1]}' in {path[0]}", hint or "set the whole entry to add one")
    if not rest.startswith("["):
        return nodes.Mapping(place, True)
    default = default_list(path)
    if default is None:
        raise OverrideError(f"sets an item of '{path[-1]}', which is not given", "set the whole list")
    return node_of(default, place)


def _put(node: Node, part: PathPart, value: Node, override: Override) -> None:
    if isinstance(node, nodes.Mapping) and _is_nothing(value):
        node.entries.pop(str(part), None)
    elif isinstance(node, nodes.Mapping):
        node.entries[str(part)] = Entry(Place(1, 1, override.origin), value)
    elif isinstance(node, Sequence) and isinstance(part, int) and part < len(node.items):
        node.items[part] = value
    elif isinstance(node, Sequence) and part == len(node.items):
        node.items.append(value)
    else:
        raise OverrideError(f"cannot be followed at '{_part_text(part)}'", _items_hint(node))


def _part_text(part: PathPart) -> str:
    return f"[{part}]" if isinstance(part, int) else part


def _items_hint(node: Node) -> str | None:
    if isinstance(node, Sequence):
        return f"the list has {len(node.items)} items, counted from 0"
    return f"'{nodes.shown(node)}' stands there" if isinstance(node, Scalar) else None


def told(overrides: Overrides | None) -> tuple[str, ...]:
    """The overrides as `path=value` texts, for those who keep a record of them."""
    return tuple(item if isinstance(item, str) else f"{item[0]}={item[1]}" for item in _items(overrides))
