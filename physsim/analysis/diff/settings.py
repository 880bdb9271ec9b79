"""What was set differently in two runs: scene, meshes, versions."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from physsim.errors import SceneError
from physsim.recording import Trajectory
from physsim.scene.unequal import unequal


@dataclass(frozen=True)
class Setting:
    """One thing that differs; a, b: what stands in the two files, None where it is not there.

    kind: `scene`, `mesh` or `version`.
    """

    kind: str
    name: str
    a: Any
    b: Any


def differing_settings(a: Trajectory, b: Trajectory) -> list[Setting]:
    """Every difference of the resolved scenes, the meshes and the versions."""
    of_a, of_b = a.provenance, b.provenance
    return [
        *(Setting("scene", *found) for found in unequal(_scene(of_a), _scene(of_b))),
        *(Setting("mesh", *found) for found in _flat(of_a["mesh_sha256"], of_b["mesh_sha256"])),
        *(Setting("version", *found) for found in _flat(of_a["versions"], of_b["versions"])),
    ]


def _scene(provenance: dict[str, Any]) -> dict[str, Any]:
    """The resolved scene as plain values; its text as it is where this version cannot read it."""
    from physsim.scene import load_scene_text  # noqa: PLC0415, slow to import

    text = provenance["scene_resolved"]
    try:
        dumped: dict[str, Any] = load_scene_text(text).spec.model_dump(mode="json", by_alias=True)
    except SceneError:
        return {"scene_resolved": text}
    return dumped


def _flat(a: str, b: str) -> Iterator[tuple[str, Any, Any]]:
    """The keys of two JSON mappings that differ; a name may hold points, so they are not walked."""
    before, after = _mapping(a), _mapping(b)
    for key in sorted({*before, *after}):
        if before.get(key) != after.get(key):
            yield key, before.get(key), after.get(key)


def _mapping(text: str) -> dict[str, Any]:
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        return {"(cannot be read)": text}
    return found if isinstance(found, dict) else {"(cannot be read)": text}
