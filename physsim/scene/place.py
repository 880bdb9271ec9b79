"""Where in the text a problem is: path -> line and column, the caret at the key or at the value."""

from __future__ import annotations

import re
from collections.abc import Sequence as Items
from dataclasses import dataclass, replace

from physsim.errors import PathPart, Problem
from physsim.scene.nodes import Entry, Mapping, Node, Place, Scalar, Sequence
from physsim.scene.yaml_reader import lines_of

_COPY = re.compile(r"\[\d+,\d+,\d+\]\Z")
MAX_SOURCE_LINE = 2000


@dataclass(frozen=True)
class Found:
    """The deepest node on a path, its key's place (None without one), and whether the path ends there."""

    node: Node
    key_place: Place | None
    complete: bool


def find(root: Node, path: Items[PathPart]) -> Found:
    """Follow the path as far as the text goes; copies of a repeated body lead to its declaration."""
    found = Found(root, None, True)
    for part in path:
        below = _step(found.node, part)
        if below is None:
            return replace(found, complete=False)
        found = Found(below.node, below.place, True) if isinstance(below, Entry) else Found(below, None, True)
    return found


def _step(node: Node, part: PathPart) -> Entry | Node | None:
    if isinstance(node, Mapping):
        key = str(part)
        return node.entries.get(key) or node.entries.get(_COPY.sub("", key))
    if isinstance(node, Sequence) and isinstance(part, int) and 0 <= part < len(node.items):
        return node.items[part]
    return None


def place_of(root: Node, path: Items[PathPart], at_key: bool = False) -> Place:
    """The place of the path's value; of its key when at_key and where there is little to point at."""
    found = find(root, path)
    if found.complete and not at_key and _stands_in_line(found.node):
        return found.node.place
    return found.key_place or found.node.place


def _stands_in_line(node: Node) -> bool:
    """Whether the value itself can be pointed at: a word or number that is there, or a list in brackets."""
    return node.value is not None if isinstance(node, Scalar) else isinstance(node, Sequence) and node.flow


class Places:
    """Adds places to problems of one scene."""

    def __init__(self, root: Node | None, text: str) -> None:
        self._root = root
        self._lines = lines_of(text)

    def place(self, problem: Problem, at_key: bool = False) -> Problem:
        """The problem with line, column and source line of its path.

        What an override set has no line: its source line is the override, e.g. `--set bodies.ball.mass=-1`.
        """
        if problem.line is None and problem.source_line is None and self._root is not None:
            place = place_of(self._root, problem.path, at_key)
            if place.origin is not None:
                return replace(problem, source_line=place.origin)
            problem = replace(problem, line=place.line, column=place.column)
        return self.with_source(problem)

    def with_source(self, problem: Problem) -> Problem:
        """The problem with the text of its line."""
        if problem.line is None or problem.source_line is not None or problem.line > len(self._lines):
            return problem
        return replace(problem, source_line=self._lines[problem.line - 1][:MAX_SOURCE_LINE])
