"""The built-in library, read from `library.json` beside this file.

What the single numbers of a material mean: `restitution` is against a hard, heavy floor or, where the notes
say so, against the same material; `static_friction` and `kinetic_friction` are against the same material
unless the notes say otherwise. They serve the mixing rule only; a pair of the table is always better.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from importlib import resources
from types import MappingProxyType
from typing import Any


@dataclass(frozen=True)
class Number:
    """One published value.

    source: short name of the source that `value` rests on; sources: full citations of it and of all others,
    with a mark on those that were not read themselves; low, high: the published range (equal to the value
    where there is none); conditions: speed, surface, temperature, and what was decided where sources differ.
    """

    value: float
    source: str
    sources: tuple[str, ...]
    low: float
    high: float
    conditions: str


@dataclass(frozen=True)
class Material:
    """density [kg/m^3] and single-material coefficients; None where no source gives one."""

    name: str
    notes: str
    color: str | None = None
    density: Number | None = None
    restitution: Number | None = None
    static_friction: Number | None = None
    kinetic_friction: Number | None = None


@dataclass(frozen=True)
class Pair:
    """Coefficients of two materials against each other (alphabetical order); None where no source gives
    one.
    """

    between: tuple[str, str]
    notes: str
    restitution: Number | None = None
    static_friction: Number | None = None
    kinetic_friction: Number | None = None


def material_names() -> frozenset[str]:
    """Names of all materials in the library."""
    return frozenset(_materials())


def material(name: str) -> Material:
    """The material of that name. Raises KeyError, with the nearest name, when there is none."""
    try:
        return _materials()[name]
    except KeyError:
        near = get_close_matches(name, _materials(), n=1)
        raise KeyError(f"no material '{name}'" + (f", did you mean '{near[0]}'?" if near else "")) from None


def pairs() -> tuple[Pair, ...]:
    """All pairs of the table, in alphabetical order."""
    return tuple(_pairs().values())


def pair(a: str, b: str) -> Pair | None:
    """The row of two materials, in either order, or None."""
    return _pairs().get(_key(a, b))


def _key(a: str, b: str) -> tuple[str, str]:
    return (a, b) if a <= b else (b, a)


@lru_cache(maxsize=1)
def _data() -> Any:
    text = resources.files(__package__).joinpath("library.json").read_text(encoding="utf-8")
    return json.loads(text)


@lru_cache(maxsize=1)
def _materials() -> Mapping[str, Material]:
    rows = _data()["materials"]
    return MappingProxyType({name: Material(name=name, **_row(rows[name])) for name in sorted(rows)})


@lru_cache(maxsize=1)
def _pairs() -> Mapping[tuple[str, str], Pair]:
    rows = {_key(*row["between"]): row for row in _data()["pairs"]}
    return MappingProxyType(
        {
            key: Pair(between=key, **_row({k: v for k, v in rows[key].items() if k != "between"}))
            for key in sorted(rows)
        }
    )


def _row(row: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers (objects) read, texts kept; `notes` may be left out."""
    read = {key: _number(value) if isinstance(value, dict) else value for key, value in row.items()}
    return {"notes": "", **read}


def _number(entry: Mapping[str, Any]) -> Number:
    low, high = entry.get("range", (entry["value"], entry["value"]))
    return Number(
        value=float(entry["value"]),
        source=entry["sources"][0],
        sources=tuple(_citation(name) for name in entry["sources"]),
        low=float(low),
        high=float(high),
        conditions=entry.get("conditions", ""),
    )


def _citation(name: str) -> str:
    source = _data()["sources"][name]
    mark = "" if source["checked"] == "read" else f" [{source['checked']}]"
    return f"{source['citation']}{mark}"
