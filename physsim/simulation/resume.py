"""Finding what `--resume` can go on from, and refusing what would not be the same run."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import physsim
from physsim.errors import FileTrouble, SceneError
from physsim.recording import Target, Trajectory, open_trajectory
from physsim.recording.checkpoint import Checkpoint
from physsim.scene.unequal import unequal

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene

# What may differ between the run in the file and its continuation: how long it goes on, on how many threads,
# and what is asked afterwards.
FREE_TO_DIFFER = ("simulation.duration", "simulation.threads", "expect")
MOST_DIFFERENCES_TOLD = 5


@dataclass(frozen=True)
class Resumable:
    """A file with a whole checkpoint. wall_time: seconds that it took so far."""

    path: Path
    checkpoint: Checkpoint
    wall_time: float
    status: str


def find_resumable(target: Target, scene: Scene, model: Model) -> Resumable | None:
    """The working file of a killed run, or else the file itself; None when neither holds a checkpoint.

    Raises FileTrouble when a process is still writing to it, or when scene, meshes or version differ from the
    run in it, with what differs.
    """
    for path in (target.part, target.path):
        try:
            trajectory = open_trajectory(path)
        except FileTrouble:
            continue
        with trajectory:
            if trajectory.being_written:
                raise FileTrouble(f"{path}: its run is still going on")
            checkpoint = trajectory.checkpoint()
            if checkpoint is not None:
                _refuse_differences(trajectory, scene, model)
                wall_time = float(trajectory.provenance["wall_time"])
                return Resumable(path, checkpoint, wall_time, trajectory.status)
    return None


def differences(before: Any, after: Any) -> Iterator[str]:
    """`bodies.ball.position[2]: 1.0 in the file, 2.0 in the scene`, for every value that differs."""
    for path, old, new in unequal(before, after):
        if path not in FREE_TO_DIFFER:
            yield f"{path}: {_shown(old)} in the file, {_shown(new)} in the scene"


def _shown(value: Any) -> str:
    if value is None:
        return "nothing"
    text = str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _refuse_differences(trajectory: Trajectory, scene: Scene, model: Model) -> None:
    found = list(_version_differs(trajectory))
    if not found:
        found = [*_meshes_differ(trajectory, model), *differences(_spec_in(trajectory), _plain(scene.spec))]
    if found:
        more = len(found) - MOST_DIFFERENCES_TOLD
        told = "; ".join(found[:MOST_DIFFERENCES_TOLD]) + (f"; and {more} more" if more > 0 else "")
        raise FileTrouble(f"{trajectory.path}: cannot be resumed, it is another run: {told}")


def _version_differs(trajectory: Trajectory) -> Iterator[str]:
    if trajectory.physsim_version != physsim.__version__:
        yield f"physsim {trajectory.physsim_version} in the file, physsim {physsim.__version__} here"


def _meshes_differ(trajectory: Trajectory, model: Model) -> Iterator[str]:
    try:
        before = dict(json.loads(trajectory.provenance["mesh_sha256"]))
    except (ValueError, TypeError, RecursionError) as error:
        raise FileTrouble(f"{trajectory.path}: /provenance/mesh_sha256 cannot be read") from error
    for file in sorted({*before, *model.mesh_sha256}):
        if before.get(file) != model.mesh_sha256.get(file):
            yield f"the mesh {file} has changed"


def _spec_in(trajectory: Trajectory) -> dict[str, Any]:
    from physsim.scene import load_scene_text  # noqa: PLC0415, only a resume reads a scene here

    text = trajectory.provenance["scene_resolved"]
    try:
        return _plain(load_scene_text(text, name=f"{trajectory.path}: /provenance/scene_resolved").spec)
    except SceneError as error:
        raise FileTrouble(f"{trajectory.path}: the scene in it cannot be read: {error}") from error


def _plain(spec: Any) -> dict[str, Any]:
    dumped: dict[str, Any] = spec.model_dump(mode="json", by_alias=True, exclude={"expect"})
    return dumped
