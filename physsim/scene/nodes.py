"""The scene as written: mappings, sequences and scalars, each knowing its place.

Nothing here knows the reader (`yaml_reader`) or what the words mean (`spec`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from physsim.errors import PathPart

Plain = None | bool | int | float | str | list["Plain"] | dict[str, "Plain"]


@dataclass(frozen=True, slots=True)
class Place:
    """Where something was written: line and column from 1, or an origin such as `--set a.b=3`."""

    line: int
    column: int
    origin: str | None = None


@dataclass(slots=True)
class Scalar:
    """A number, a word, true, false or nothing: what stood there, and what it means in YAML 1.2."""

    place: Place
    text: str
    value: bool | int | float | str | None


@dataclass(slots=True)
class Sequence:
    """A list; `flow` when written in brackets."""

    place: Place
    flow: bool
    items: list[Node] = field(default_factory=list)


@dataclass(slots=True)
class Entry:
    """One `key: value` of a mapping; `place` is the key's."""

    place: Place
    node: Node


@dataclass(slots=True)
class Mapping:
    """Keys and values in the order of the file; `flow` when written in braces."""

    place: Place
    flow: bool
    entries: dict[str, Entry] = field(default_factory=dict)


Node = Scalar | Sequence | Mapping


def plain(node: Node) -> Plain:
    """The node as dictionaries, lists and scalars."""
    if isinstance(node, Scalar):
        return node.value
    if isinstance(node, Sequence):
        return [plain(item) for item in node.items]
    return {key: plain(entry.node) for key, entry in node.entries.items()}


def copied(node: Node) -> Node:
    """An independent copy: what an alias stands for, so that changing one use leaves the others alone."""
    if isinstance(node, Scalar):
        return node
    if isinstance(node, Sequence):
        return Sequence(node.place, node.flow, [copied(item) for item in node.items])
    entries = {key: Entry(entry.place, copied(entry.node)) for key, entry in node.entries.items()}
    return Mapping(node.place, node.flow, entries)


def empty_places(root: Node) -> Iterator[tuple[tuple[PathPart, ...], Scalar]]:
    """Every place where a value should stand and nothing does, with its path."""
    waiting: list[tuple[tuple[PathPart, ...], Node]] = [((), root)]
    while waiting:
        path, node = waiting.pop()
        if isinstance(node, Mapping):
            waiting += [((*path, key), entry.node) for key, entry in node.entries.items()]
        elif isinstance(node, Sequence):
            waiting += [((*path, i), item) for i, item in enumerate(node.items)]
        elif node.value is None:
            yield path, node


def shown(node: Node, limit: int = 60) -> str:
    """The node in one line for messages, at most `limit` characters."""
    text = _shown(node, limit)
    return text if len(text) <= limit else text[: limit - 1] + "…"


def _shown(node: Node, limit: int) -> str:
    """Stops early: a huge list costs no more than what is shown of it."""
    if isinstance(node, Scalar):
        return node.text if node.value is not None else "nothing"
    parts: list[str] = []
    mapping = isinstance(node, Mapping)
    children = list(node.entries.items()) if isinstance(node, Mapping) else [("", n) for n in node.items]
    for key, child in children:
        inner = child.node if isinstance(child, Entry) else child
        parts.append(f"{key}: {_shown(inner, limit)}" if mapping else _shown(inner, limit))
        if sum(map(len, parts)) > limit:
            break
    return "{" + ", ".join(parts) + "}" if mapping else "[" + ", ".join(parts) + "]"
