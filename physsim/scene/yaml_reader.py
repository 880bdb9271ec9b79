"""YAML text -> nodes with places. The only file that imports yaml for reading, so that the parser can be
replaced.

PyYAML (libyaml) is used for its events only; what they mean is decided here, in one loop without recursion:
YAML 1.2 scalars (`scalars`), no tags, no merge keys, no duplicate keys, one document, and bounds on depth,
size and on what aliases may multiply. Depth is checked on the events, since building nested objects first
would overflow the stack (PyYAML issue 895).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

import yaml

from physsim.errors import PathPart, Problem
from physsim.scene.nodes import Entry, Mapping, Node, Place, Scalar, Sequence, copied
from physsim.scene.problems import MAX_TOLD
from physsim.scene.scalars import meaning

MAX_DEPTH = 64
# Thirty thousand bodies with all their keys are 1.2 million.
MAX_NODES = 2_000_000
MAX_ALIASED_NODES = 100_000
MAX_SHOWN = 40
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
# libyaml where PyYAML was built with it (every wheel); the Python parser gives the same events, ten times
# slower.
_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_LINE_BREAK = re.compile(r"\r\n|[\n\r\x85\u2028\u2029]")


def lines_of(text: str) -> list[str]:
    """The lines of the text as YAML counts them."""
    return _LINE_BREAK.split(text)


@dataclass(frozen=True)
class Document:
    """What was read: the root (None when nothing could be read) and every problem met on the way, placed."""

    root: Node | None
    problems: tuple[Problem, ...]


def read_yaml(text: str, origin: str | None = None) -> Document:
    """Read one YAML document.

    origin: given to every place, e.g. `--set a=b` when the text is not a file.
    Never raises for what the text contains: problems are returned.
    """
    builder = _Builder(origin)
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            builder.take(event)
    except _GiveUp as stop:
        return Document(None, (*builder.problems, stop.problem))
    except yaml.YAMLError as error:
        return Document(None, (*builder.problems, _syntax_problem(error, text, origin)))
    return Document(builder.root, tuple(builder.problems))


class _GiveUp(Exception):
    """Reading cannot go on."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


@dataclass(slots=True)
class _Open:
    """A mapping or sequence that is not closed yet."""

    node: Mapping | Sequence
    anchor: str | None
    first_node: int
    height: int = 0
    key: str | None = None
    key_place: Place | None = None


@dataclass(frozen=True, slots=True)
class _Anchored:
    """What an alias may refer to; node is None while it is still open."""

    node: Node | None
    size: int = 0
    height: int = 0


class _Builder:
    """Turns events into nodes with an explicit stack."""

    def __init__(self, origin: str | None) -> None:
        self.origin = origin
        self.root: Node | None = None
        self.problems: list[Problem] = []
        self.stack: list[_Open] = []
        self.anchors: dict[str, _Anchored] = {}
        self.nodes = 0
        self.aliased = 0
        self.documents = 0

    def take(self, event: Any) -> None:
        handler = _HANDLERS.get(type(event))
        if handler is not None:
            handler(self, event)

    def document(self, event: Any) -> None:
        self.documents += 1
        if self.documents > 1:
            raise self.stop("holds more than one document; a scene is one (remove the line '---')", event)

    def scalar(self, event: Any) -> None:
        place = self.place(event)
        self.refuse_tag(event, place)
        text: str = event.value
        if _CONTROL.search(text):
            self.report("holds a control character", place, given=repr(text)[:MAX_SHOWN])
            text = _CONTROL.sub("?", text)
        unquoted = event.implicit[0]
        value = self.meaning(text, place) if unquoted else text
        self.attach(Scalar(place, text, value), event.anchor, 1, 0, merge=unquoted and text == "<<")

    def meaning(self, text: str, place: Place) -> bool | int | float | str | None:
        try:
            return meaning(text)
        except ValueError as error:
            self.report(str(error), place, given=text[:MAX_SHOWN])
            return 0

    def open(self, event: Any) -> None:
        place = self.place(event)
        self.refuse_tag(event, place)
        if len(self.stack) >= MAX_DEPTH:
            raise self.stop(f"is nested deeper than {MAX_DEPTH} levels", event)
        kind = Mapping if isinstance(event, yaml.MappingStartEvent) else Sequence
        if event.anchor is not None:
            self.anchors[event.anchor] = _Anchored(None)
        self.stack.append(_Open(kind(place, bool(event.flow_style)), event.anchor, self.nodes))

    def close(self, event: Any) -> None:
        done = self.stack.pop()
        self.attach(done.node, done.anchor, 1 + self.nodes - done.first_node, done.height + 1)

    def alias(self, event: Any) -> None:
        target = self.anchors.get(event.anchor)
        if target is None:
            raise self.stop(f"alias *{event.anchor} has no anchor &{event.anchor} before it", event)
        if target.node is None:
            raise self.stop(f"alias *{event.anchor} refers to what it stands in", event)
        self.aliased += target.size
        if self.aliased > MAX_ALIASED_NODES:
            raise self.stop(f"aliases multiply the scene beyond {MAX_ALIASED_NODES} values", event)
        if len(self.stack) + target.height > MAX_DEPTH:
            raise self.stop(f"is nested deeper than {MAX_DEPTH} levels through alias *{event.anchor}", event)
        self.attach(copied(target.node), None, target.size, target.height, place=self.place(event))

    def attach(
        self,
        node: Node,
        anchor: str | None,
        size: int,
        height: int,
        *,
        merge: bool = False,
        place: Place | None = None,
    ) -> None:
        """Hang a finished node under the one that is open."""
        self.nodes += size if place is not None else 1
        if self.nodes > MAX_NODES:
            raise _GiveUp(self.problem(f"holds more than {MAX_NODES} values", node.place))
        if anchor is not None:
            self.anchors[anchor] = _Anchored(node, size, height)
        if not self.stack:
            self.root = node
            return
        parent = self.stack[-1]
        parent.height = max(parent.height, height)
        if isinstance(parent.node, Sequence):
            parent.node.items.append(node)
        elif parent.key_place is None:
            self.key(parent, node, place or node.place, merge)
        else:
            self.value(parent, parent.node, node)

    def key(self, parent: _Open, node: Node, place: Place, merge: bool) -> None:
        parent.key_place = place
        parent.key = node.text if isinstance(node, Scalar) and not merge else None
        if merge:
            self.report("merge keys (<<) are not part of the scene language", place)
        elif not isinstance(node, Scalar):
            self.report("a key must be a word, not a list or a mapping", place)

    def value(self, parent: _Open, mapping: Mapping, node: Node) -> None:
        key, place = parent.key, parent.key_place
        parent.key = parent.key_place = None
        if key is None or place is None:
            return
        if key in mapping.entries:
            first = mapping.entries[key].place
            self.report(f"is given twice, first on line {first.line}", place, ends_with=key)
            return
        mapping.entries[key] = Entry(place, node)

    def refuse_tag(self, event: Any, place: Place) -> None:
        if event.tag is not None:
            self.report("YAML tags are not part of the scene language", place, given=event.tag[:MAX_SHOWN])

    def place(self, event: Any) -> Place:
        mark = event.start_mark
        return Place(mark.line + 1, mark.column + 1, self.origin)

    def path(self, ends_with: str | None = None) -> tuple[PathPart, ...]:
        """Where the reading stands, as keys and indices from the root."""
        parts: list[PathPart] = []
        for level in self.stack:
            if isinstance(level.node, Sequence):
                parts.append(len(level.node.items))
            elif level.key is not None:
                parts.append(level.key)
        return (*parts, ends_with) if ends_with is not None else tuple(parts)

    def report(
        self, message: str, place: Place, given: str | None = None, ends_with: str | None = None
    ) -> None:
        if len(self.problems) <= MAX_TOLD:
            self.problems.append(self.problem(message, place, given, ends_with))

    def problem(
        self, message: str, place: Place, given: str | None = None, ends_with: str | None = None
    ) -> Problem:
        path = self.path(ends_with)
        return Problem(path, message, given=given, line=place.line, column=place.column)

    def stop(self, message: str, event: Any) -> _GiveUp:
        return _GiveUp(self.problem(message, self.place(event)))


_HANDLERS: dict[type, Any] = {
    yaml.DocumentStartEvent: _Builder.document,
    yaml.ScalarEvent: _Builder.scalar,
    yaml.MappingStartEvent: _Builder.open,
    yaml.SequenceStartEvent: _Builder.open,
    yaml.MappingEndEvent: _Builder.close,
    yaml.SequenceEndEvent: _Builder.close,
    yaml.AliasEvent: _Builder.alias,
}


def _syntax_problem(error: yaml.YAMLError, text: str, origin: str | None) -> Problem:
    if isinstance(error, yaml.MarkedYAMLError):
        return _marked_problem(error, text)
    if isinstance(error, yaml.reader.ReaderError):
        return _character_problem(error, text)
    return Problem((), f"is not YAML: {error}")


def _marked_problem(error: yaml.MarkedYAMLError, text: str) -> Problem:
    mark = error.problem_mark or error.context_mark
    line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
    context = f"{error.context}: " if error.context else ""
    message = f"is not valid YAML: {context}{error.problem or 'cannot be read'}"
    lines = lines_of(text)
    source = lines[line - 1] if line <= len(lines) else ""
    return Problem((), message, hint=_syntax_hint(source), line=line, column=column)


def _syntax_hint(source: str) -> str | None:
    """The slips behind most syntax errors of scenes."""
    if "\t" in source[: len(source) - len(source.lstrip())]:
        return "indent with spaces, not with tabs"
    if "${" in source:
        return 'inside [...] and {...} an expression needs quotes: "${...}"'
    if re.search(r"\w\[\d", source):
        return 'inside [...] and {...} a name with brackets needs quotes: "brick[0,0,0]"'
    return None


def _character_problem(error: Any, text: str) -> Problem:
    position = max(0, min(int(error.position), len(text)))
    before = lines_of(text[:position])
    message = (
        f"holds the control character U+{ord(text[position]):04X}"
        if position < len(text)
        else "cannot be read"
    )
    return Problem((), message, line=len(before), column=len(before[-1]) + 1)
