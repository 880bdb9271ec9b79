"""A scene that may still be wrong in places: what checks across the scene look at.

When one part of a scene is wrong in itself, the rest is checked all the same, so that every mistake is told
at once. What is wrong in itself stands as None: it is declared, but nothing is known of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from physsim.scene.body_names import BodyNames
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.expect import ExpectSpec
from physsim.scene.spec.forces import ForceSpec
from physsim.scene.spec.joints import JointSpec
from physsim.scene.spec.materials import MaterialSpec, PairSpec
from physsim.scene.spec.reading import Reading
from physsim.scene.spec.record import RecordSpec
from physsim.scene.spec.scene import Pattern, SceneSpec
from physsim.scene.spec.simulation import SimulationSpec
from physsim.scene.spec.springs import SpringSpec
from physsim.scene.spec.world import WorldSpec


@dataclass(frozen=True)
class Draft:
    """The sections of a scene; None in the place of an entry, or of a section, that is wrong in itself.

    folder: where files are looked for; None when they are not to be looked for.
    """

    folder: Path | None
    world: WorldSpec | None = None
    simulation: SimulationSpec | None = None
    record: RecordSpec | None = None
    materials: Mapping[str, MaterialSpec | None] = field(default_factory=dict)
    pairs: tuple[PairSpec | None, ...] = ()
    bodies: Mapping[str, BodySpec | None] = field(default_factory=dict)
    springs: Mapping[str, Any] = field(default_factory=dict)
    joints: Mapping[str, Any] = field(default_factory=dict)
    forces: Mapping[str, ForceSpec | None] = field(default_factory=dict)
    no_contact: tuple[tuple[str, str] | None, ...] = ()
    expect: tuple[ExpectSpec | None, ...] = ()

    @cached_property
    def body_names(self) -> BodyNames:
        """The names of all bodies."""
        return BodyNames(self.bodies)


_SINGLE: dict[str, Any] = {"world": WorldSpec, "simulation": SimulationSpec, "record": RecordSpec}
_NAMED: dict[str, Any] = {
    "materials": MaterialSpec,
    "bodies": BodySpec,
    "springs": SpringSpec,
    "joints": JointSpec,
    "forces": ForceSpec,
}
_LISTED: dict[str, Any] = {"pairs": PairSpec, "no_contact": tuple[Pattern, Pattern], "expect": ExpectSpec}


def draft_of(spec: SceneSpec, folder: Path | None) -> Draft:
    """The draft of a scene whose parts are all right in themselves."""
    return Draft(folder, **{name: getattr(spec, name) for name in (*_SINGLE, *_NAMED, *_LISTED)})


def salvaged(data: Mapping[str, Any], reading: Reading, folder: Path | None) -> Draft:
    """The draft of a scene some parts of which are wrong."""
    sections: dict[str, Any] = {}
    for name, kind in _SINGLE.items():
        sections[name] = _one(TypeAdapter(kind), data.get(name, {}), reading)
    for name, kind in _NAMED.items():
        sections[name] = _named(TypeAdapter(kind), data.get(name), reading)
    for name, kind in _LISTED.items():
        sections[name] = _listed(TypeAdapter(kind), data.get(name), reading)
    return Draft(folder, **sections)


def _one(adapter: TypeAdapter[Any], value: Any, reading: Reading) -> Any:
    try:
        return adapter.validate_python(value, context=reading)
    except ValidationError:
        return None


def _named(adapter: TypeAdapter[Any], section: Any, reading: Reading) -> dict[str, Any]:
    entries = section if isinstance(section, dict) else {}
    return {name: _one(adapter, value, reading) for name, value in entries.items()}


def _listed(adapter: TypeAdapter[Any], section: Any, reading: Reading) -> tuple[Any, ...]:
    entries = section if isinstance(section, list) else []
    return tuple(_one(adapter, value, reading) for value in entries)
