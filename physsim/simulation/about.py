"""What a trajectory file says about its run that does not change with time."""

from __future__ import annotations

import datetime
import importlib.metadata
import json
import platform
import shlex
import sys
from functools import cache
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

import numpy as np

import physsim

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene

_COEFFICIENTS = (
    "restitution",
    "static_friction",
    "kinetic_friction",
    "rolling_friction",
    "spinning_friction",
)
PACKAGES = ("numpy", "h5py", "pydantic", "PyYAML", "trimesh", "scipy", "python-fcl", "coacd")


def root_attributes(scene: Scene) -> dict[str, Any]:
    return {
        "physsim_version": physsim.__version__,
        "title": scene.title,
        "seed": np.int64(scene.spec.simulation.seed),
    }


def fixed_values(scene: Scene, model: Model) -> dict[str, Any]:
    """Values of the datasets that do not grow, by path."""
    names = np.array(model.material_names, dtype=object)
    return {
        "body": list(model.body_names),
        "mass": model.mass,
        "inertia": model.inertia,
        "center_of_mass": model.center_of_mass,
        "material": list(names[model.body_material]),
        "fixed": np.asarray(model.fixed, np.int8),
        **_geometry(model),
        **_joints(model),
        **_springs(model),
        **_pairs(model),
        **_provenance(scene, model),
    }


def now() -> str:
    """Clock time in UTC, ISO 8601."""
    return datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")


def _geometry(model: Model) -> dict[str, Any]:
    looks = model.looks
    rows = ("body", "kind", "parameters", "position", "orientation", "material", "color")
    marks = ("shown", "collides", "surface")
    return {
        **{f"geometry/{name}": getattr(looks, name) for name in (*rows, *marks)},
        **_stacked("vertex", "vertices", [surface.vertices for surface in looks.surfaces]),
        **_stacked("triangle", "triangles", [surface.triangles for surface in looks.surfaces]),
    }


def _stacked(word: str, name: str, parts: list[Any]) -> dict[str, Any]:
    """Arrays of three columns in one, and where each begins."""
    return {
        f"geometry/{word}_offset": np.cumsum([0, *(len(part) for part in parts)]),
        f"geometry/{name}": np.concatenate([np.zeros((0, 3)), *parts]),
    }


def _joints(model: Model) -> dict[str, Any]:
    """Of the joints that have a name: the stops of springs are left out."""
    from physsim.model.joints import COORDINATE_UNITS  # noqa: PLC0415, slow to import

    table = model.mechanics.joints
    count = len(table.names)
    units = [COORDINATE_UNITS.get(row.kind, ()) for row in table.rows[:count]]
    named = {
        f"joints/{name}_unit": [some[k] if k < len(some) else "" for some in units]
        for k, name in enumerate(("coordinate", "coordinate_2", "coordinate_3"))
    }
    return {**_who("joints", "joint", table, count), **named}


def _springs(model: Model) -> dict[str, Any]:
    table = model.mechanics.springs
    units = [("m", "N") if kind == "linear" else ("rad", "N m") for kind in table.types]
    return {
        **_who("springs", "spring", table, len(table.names)),
        "springs/length_unit": [length for length, _ in units],
        "springs/force_unit": [force for _, force in units],
    }


def _who(group: str, axis: str, table: Any, count: int) -> dict[str, Any]:
    """Of the first `count` rows of a table."""
    bodies, anchors = table.bodies[:count], table.anchors[:count]
    ends = ("a", "b")
    return {
        f"{group}/{axis}": list(table.names),
        f"{group}/type": list(table.types),
        f"{group}/axis_a": table.axes[:count],
        **{f"{group}/body_{end}": bodies[:, k] for k, end in enumerate(ends)},
        **{f"{group}/anchor_{end}": anchors[:, k] for k, end in enumerate(ends)},
    }


def _pairs(model: Model) -> dict[str, Any]:
    names, pairs = model.material_names, model.pairs
    rows = list(combinations_with_replacement(range(len(names)), 2))
    return {
        "pairs/pair": [f"{names[a]}, {names[b]}" for a, b in rows],
        "pairs/material_a": [names[a] for a, _ in rows],
        "pairs/material_b": [names[b] for _, b in rows],
        **{f"pairs/{name}": [getattr(pairs, name)[a, b] for a, b in rows] for name in _COEFFICIENTS},
        "pairs/source": [pairs.source[a][b] for a, b in rows],
    }


def _provenance(scene: Scene, model: Model) -> dict[str, Any]:
    return {
        "provenance/scene": scene.text,
        "provenance/scene_resolved": scene.resolved_yaml(),
        "provenance/mesh_sha256": json.dumps(dict(model.mesh_sha256), sort_keys=True),
        "provenance/versions": json.dumps(versions()),
        "provenance/host": f"{platform.node()}, {platform.platform()}",
        "provenance/command": shlex.join(sys.argv),
        "provenance/started": now(),
        "provenance/finished": "",
        "provenance/wall_time": 0.0,
    }


@cache
def versions() -> dict[str, str]:
    """Of physsim and of what it stands on, by name."""
    found = {"physsim": physsim.__version__, "python": platform.python_version()}
    for name in PACKAGES:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found
