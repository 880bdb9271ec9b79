"""Every key of the scene language with its values, default and meaning, from the types that check scenes."""

from __future__ import annotations

import inspect
import math
from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from physsim.scene import SceneSpec
from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import Name
from physsim.scene.spec.values import Bounds, Number, Whole

EMPTY = ({}, (), [], None, "")


def as_markdown() -> str:
    """One section per mapping of the language, in the order in which a scene names them."""
    sections = []
    for where, spec in mappings():
        rows = [row(name, field) for name, field in spec.model_fields.items() if not is_tag(name, field)]
        if rows:
            table = ["| key | value | default | meaning |", "|---|---|---|---|", *rows]
            sections.append("\n".join([f"### {where}", "", prose(spec), "", *table, ""]))
    return "\n".join(sections)


def mappings() -> list[tuple[str, type[Spec]]]:
    """Where each mapping stands (`bodies.NAME.shape`), each type once, at the first place that names it."""
    found: dict[type[Spec], str] = {}
    waiting = [("the scene", SceneSpec)]
    while waiting:
        where, spec = waiting.pop(0)
        if spec in found:
            continue
        found[spec] = where
        for name, field in spec.model_fields.items():
            below = f"{'' if spec is SceneSpec else where + '.'}{field.alias or name}"
            waiting += [
                (place(below, inner, field.annotation), inner) for inner in specs_in(field.annotation)
            ]
    return [(where, spec) for spec, where in found.items()]


def place(below: str, spec: type[Spec], annotation: Any) -> str:
    """`bodies.NAME`, `pairs[i]`, and for one of several types `bodies.NAME.shape, type box`."""
    if get_origin(annotation) is dict or dict in [get_origin(part) for part in get_args(annotation)]:
        below += ".NAME"
    elif any(Ellipsis in get_args(part) for part in (annotation, *get_args(annotation))):
        below += "[i]"
    tag = spec.model_fields.get("type")
    return (
        f"{below}, type {get_args(tag.annotation)[0]}" if tag is not None and is_tag("type", tag) else below
    )


def specs_in(annotation: Any) -> Iterator[type[Spec]]:
    """Every mapping type inside an annotation."""
    if inspect.isclass(annotation) and issubclass(annotation, Spec):
        yield annotation
    for part in get_args(annotation):
        yield from specs_in(part)


def is_tag(name: str, field: FieldInfo) -> bool:
    """Whether the field only says which of several types it is."""
    return name == "type" and get_origin(field.annotation) is Literal


def prose(spec: type[Spec]) -> str:
    """The docstring, unwrapped."""
    paragraphs = inspect.getdoc(spec).split("\n\n")
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)


def row(name: str, field: FieldInfo) -> str:
    """One line of the table."""
    examples = [f"`{example}`" for example in field.examples or ()]
    meaning = " ".join(
        [str(field.description), *([f"For example {', '.join(examples)}."] if examples else [])]
    )
    cells = [
        f"`{field.alias or name}`",
        " or ".join(values(field.annotation, field.metadata)),
        default(field),
        meaning,
    ]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def values(annotation: Any, metadata: list[Any]) -> list[str]:
    """What may stand there, in words."""
    for mark in (*metadata, *getattr(annotation, "__metadata__", ())):
        if isinstance(mark, Number):
            return [f"{mark.kind.unit or 'number'}{span(mark.bounds)}"]
        if isinstance(mark, Whole):
            return [f"whole number{span(Bounds(at_least=mark.at_least, at_most=mark.at_most))}"]
        if isinstance(mark, Name):
            return ["name"]
    return unmarked(getattr(annotation, "__origin__", annotation) if is_marked(annotation) else annotation)


def is_marked(annotation: Any) -> bool:
    """Whether it is `Annotated[...]`."""
    return hasattr(annotation, "__metadata__")


def unmarked(annotation: Any) -> list[str]:
    """What may stand there, of a type that carries no unit and no bounds itself."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Literal:
        return [f"`{word}`" for word in parts]
    if origin is tuple:
        return [listed(parts)]
    if origin is dict:
        return [f"names, each with {' or '.join(values(parts[1], []))}"]
    inner = [word for part in parts if part is not type(None) for word in values(part, [])]
    return list(dict.fromkeys(inner)) or [plain(annotation)]


def listed(parts: tuple[Any, ...]) -> str:
    """A list: how many parts, and what each is."""
    each = [" or ".join(values(part, [])) for part in parts if part is not Ellipsis]
    if Ellipsis in parts:
        return f"list, each {each[0]}"
    if len(set(each)) == 1:
        return f"list of {len(parts)}, each {each[0]}"
    return f"list of {len(parts)}: {' and '.join(each)}"


def plain(annotation: Any) -> str:
    """A type without further marks."""
    if inspect.isclass(annotation) and issubclass(annotation, Spec):
        return "mapping, see below"
    return {bool: "`true` or `false`", str: "text", float: "number", int: "whole number"}[annotation]


def span(bounds: Bounds) -> str:
    """`, > 0`, `, 0 to 1`; nothing when every number is allowed."""
    if bounds.at_least is not None and bounds.at_most is not None:
        return f", {figure(bounds.at_least)} to {figure(bounds.at_most)}"
    signs = ((">", bounds.above), ("≥", bounds.at_least), ("<", bounds.below), ("≤", bounds.at_most))
    return "".join(f", {sign} {figure(value)}" for sign, value in signs if value is not None)


def figure(value: float) -> str:
    """Whole numbers in full, pi by name, others short."""
    if value == math.pi:
        return "π"
    return str(int(value)) if value == int(value) else f"{value:g}"


def default(field: FieldInfo) -> str:
    """The default as one would write it; `required` where there is none."""
    if field.is_required():
        return "**required**"
    value = field.default
    if value is PydanticUndefined or value in EMPTY or isinstance(value, Spec):
        return ""
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if isinstance(value, tuple):
        return (
            "`[" + ", ".join(f"{part:g}" for part in value) + "]`"
            if all(isinstance(p, float) for p in value)
            else ""
        )
    return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"
