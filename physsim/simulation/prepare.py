"""What is known before the first step: the scene, its model, when frames are due, and where they go."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from physsim.errors import FileTrouble, Problem
from physsim.recording import Target
from physsim.simulation.loop import Schedule

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene

Warn = Callable[[Problem], None]
Changes = Mapping[str, Any] | list[str] | None


@dataclass(frozen=True)
class Prepared:
    """Everything that is known before the first step."""

    scene: Scene
    model: Model
    schedule: Schedule
    target: Target
    warn: Warn


def prepare(
    scene: str | Path | Scene,
    changes: Changes,
    duration: float | str | None,
    output: str | Path | None,
    warn: Warn | None,
) -> Prepared:
    """The scene loaded and compiled; warnings go to `warn`.

    Raises SceneError when the scene is not valid, TypeError for changes to a scene that is loaded already.
    """
    from physsim.model import compile_scene  # noqa: PLC0415, slow to import

    told = warn or _ignore
    loaded = _loaded(scene, changes, duration, told)
    model = compile_scene(loaded)
    for problem in model.warnings:
        told(problem)
    target = Target(Path(output) if output is not None else _default_output(loaded))
    return Prepared(loaded, model, schedule_of(loaded), target, told)


def _loaded(
    scene: str | Path | Scene,
    changes: Changes,
    duration: float | str | None,
    warn: Warn,
) -> Scene:
    from physsim.scene import Scene, load_scene  # noqa: PLC0415, slow to import

    if not isinstance(scene, Scene):
        return load_scene(scene, _with_duration(changes, duration), warn)
    if changes or duration is not None:
        raise TypeError("`set` and `duration` change scene files; load the scene with these overrides")
    return scene


def _with_duration(changes: Changes, duration: float | str | None) -> Changes:
    if duration is None:
        return changes
    if isinstance(changes, list):
        return [*changes, f"simulation.duration={duration}"]
    return {**(changes or {}), "simulation.duration": duration}


def _ignore(problem: Problem) -> None:
    """Where nobody listens to warnings."""


def _default_output(scene: Scene) -> Path:
    if scene.path is None:
        raise FileTrouble(
            f"{scene.name}: was not read from a file, so `output` must name the trajectory file"
        )
    return Path(scene.path.stem + ".h5")


def schedule_of(scene: Scene) -> Schedule:
    """When frames are due, and how many steps there are."""
    simulation = scene.spec.simulation
    return Schedule(
        timestep=simulation.timestep,
        steps_per_frame=scene.spec.steps_per_frame,
        steps=simulation.steps,
        until_rest=simulation.until == "at_rest",
    )
