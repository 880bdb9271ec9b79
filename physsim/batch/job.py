"""What every worker needs, wherever it is: the scene, its meshes, what to measure, what to keep."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

import physsim
from physsim.batch.spec.axes import ListAxis
from physsim.errors import FileTrouble
from physsim.scene import nodes

if TYPE_CHECKING:
    from physsim.batch.load import Sweep

FILE_KEY = "file"


@dataclass(frozen=True)
class Job:
    """Plain values that can be sent anywhere.

    text, name: the scene; shared: changes that all runs have; metrics: specs by name; keep: as in the sweep.
    meshes: content of the mesh files by the name that the scene gives them; version: of physsim.
    """

    text: str
    name: str
    shared: dict[str, Any]
    metrics: dict[str, Any]
    keep: str
    meshes: dict[str, bytes]
    version: str

    def facts(self) -> dict[str, Any]:
        """What decides the numbers of a run but its own changes; meshes by hash."""
        return {
            "physsim": self.version,
            "scene": self.text,
            "set": self.shared,
            "metrics": {
                name: metric.model_dump(mode="json", by_alias=True) for name, metric in self.metrics.items()
            },
            "keep": self.keep,
            "mesh_sha256": {name: hashlib.sha256(data).hexdigest() for name, data in self.meshes.items()},
        }

    @property
    def digest(self) -> str:
        """SHA-256 of the facts."""
        return hashlib.sha256(json.dumps(self.facts(), sort_keys=True).encode()).hexdigest()


def job_of(sweep: Sweep) -> Job:
    """The job of a sweep. Raises FileTrouble when a mesh cannot be read."""
    return Job(
        text=sweep.base.text,
        name=sweep.base.name,
        shared=dict(sweep.spec.set),
        metrics=dict(sweep.spec.metrics),
        keep=sweep.spec.keep,
        meshes={name: _content(sweep, name) for name in sorted(set(_mesh_names(sweep)))},
        version=physsim.__version__,
    )


def unpack(meshes: dict[str, bytes], into: Path) -> Path:
    """Writes the meshes below `into` and returns the folder from which the scene finds them by its names.

    `../meshes/a.obj` needs a folder above the scene's own; absolute names are left where they are.
    """
    relative = {name: data for name, data in meshes.items() if not PurePosixPath(name).is_absolute()}
    above = max((PurePosixPath(name).parts.count("..") for name in relative), default=0)
    folder = into.joinpath(*["scene"] * (above + 1))
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in relative.items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
    return folder


def _content(sweep: Sweep, name: str) -> bytes:
    path = sweep.scene.resolve_file(name)
    try:
        return path.read_bytes()
    except OSError as error:
        raise FileTrouble(f"{path}: cannot be read: {error.strerror}") from None


def _mesh_names(sweep: Sweep) -> Iterator[str]:
    """Mesh files that the scene or a value of the sweep names, as far as they are there."""
    root = sweep.base.root()
    found = [*_files_in(nodes.plain(root) if root is not None else None), *_files_in(sweep.spec.set)]
    for path, axis in [*sweep.spec.grid.items(), *sweep.spec.zip.items()]:
        if isinstance(axis, ListAxis):
            key = path.rpartition(".")[2]
            found += [name for value in axis.values for name in _files_in({key: value})]
    return (name for name in found if _is_there(sweep, name))


def _files_in(value: Any) -> Iterator[str]:
    """Texts under a key `file`, at any depth; `set` holds paths that end in it."""
    if isinstance(value, dict):
        for key, part in value.items():
            if isinstance(part, str) and key.rpartition(".")[2] == FILE_KEY:
                yield part
            else:
                yield from _files_in(part)
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _files_in(part)


def _is_there(sweep: Sweep, name: str) -> bool:
    try:
        sweep.scene.resolve_file(name)
    except FileTrouble:
        return False
    return True
