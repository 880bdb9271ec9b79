"""Text -> nodes -> overrides -> typed spec -> checks -> Scene; every problem is told at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from os import PathLike
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from physsim.errors import PathPart, Problem, SceneError
from physsim.scene import nodes
from physsim.scene.checks import all_problems
from physsim.scene.draft import Draft, draft_of, salvaged
from physsim.scene.overrides import Overrides, apply_overrides, told
from physsim.scene.parameters import Parameters
from physsim.scene.place import Places
from physsim.scene.problems import MAX_TOLD, told_in_order
from physsim.scene.scene import Scene
from physsim.scene.source import read_source
from physsim.scene.spec.reading import Reading
from physsim.scene.spec.scene import SceneSpec
from physsim.scene.spec.simulation import SimulationSpec
from physsim.scene.translate import Translator
from physsim.scene.yaml_reader import read_yaml
from physsim.uncollected import uncollected

Warn = Callable[[Problem], None]


def load_scene(
    path: str | PathLike[str], overrides: Overrides | None = None, warn: Warn | None = None
) -> Scene:
    """Read a scene file.

    overrides: changes made before validation, {"simulation.duration": "2 s"} or ["simulation.duration=2 s"].
    warn: called with every warning, which the scene also keeps.
    Raises FileTrouble when the file cannot be read, SceneError with every problem when it is no valid scene.
    """
    return original(path).scene(overrides, warn)


def load_scene_text(
    text: str,
    name: str = "<scene>",
    folder: str | PathLike[str] | None = None,
    overrides: Overrides | None = None,
    warn: Warn | None = None,
) -> Scene:
    """Read a scene from text, like `load_scene`.

    folder: where the files that it names are looked for; without one they are not looked for yet.
    """
    return Original(text, name, None, None if folder is None else Path(folder)).scene(overrides, warn)


def original(path: str | PathLike[str]) -> Original:
    """A scene file, parsed but not yet judged. Raises FileTrouble when it cannot be read."""
    file = Path(path)
    return Original(read_source(file), str(path), file, file.parent)


@dataclass(frozen=True)
class Original:
    """A scene as written, parsed once, that may be read many times, each time with other changes.

    text: the YAML; name: how messages call it; path: its file, None for text; folder: where the files that it
    names are looked for, None when they are not to be looked for yet.
    """

    text: str
    name: str
    path: Path | None
    folder: Path | None

    def scene(self, overrides: Overrides | None = None, warn: Warn | None = None) -> Scene:
        """The scene with these changes; see `load_scene`. Raises SceneError."""
        return _load(self, overrides, warn)

    @cached_property
    def parsed(self) -> tuple[nodes.Mapping | None, list[Problem]]:
        """The nodes as written (not to be changed), and what was wrong in reading them."""
        return _root_of(self)

    def root(self) -> nodes.Mapping | None:
        """The nodes, a copy that may be changed; None when there is nothing to read."""
        root, _ = self.parsed
        copy = None if root is None else nodes.copied(root)
        return copy if isinstance(copy, nodes.Mapping) else None


@uncollected()
def _load(source: Original, overrides: Overrides | None, warn: Warn | None) -> Scene:
    overrides = overrides if overrides is None or isinstance(overrides, dict | str) else list(overrides)
    root, problems = source.root(), list(source.parsed[1])
    if root is None:
        raise SceneError(told_in_order(problems), source.name)
    problems += apply_overrides(root, overrides)
    places = Places(root, source.text)
    reading = Reading(_parameters(root), _joint_types(root))
    spec, found = _validated(root, reading, places, source.folder)
    problems = _once_per_place(problems, found)
    if spec is None or problems:
        raise SceneError(told_in_order(problems), source.name)
    warnings = tuple(places.place(problem) for problem in _unused(spec, reading))
    if warn is not None:
        for warning in warnings:
            warn(warning)
    return Scene(
        spec=spec,
        text=source.text,
        name=source.name,
        path=source.path,
        folder=source.folder or Path(),
        overrides=told(overrides),
        warnings=warnings,
        places=places,
    )


def _root_of(source: Original) -> tuple[nodes.Mapping | None, list[Problem]]:
    """The scene as written, and what was wrong in reading it."""
    document = read_yaml(source.text)
    root, problems = _mapping_of(document.root, list(document.problems))
    places = Places(None, source.text)
    return root, [places.with_source(problem) for problem in problems]


def _once_per_place(first: list[Problem], then: list[Problem]) -> list[Problem]:
    """What could not be read has no meaning that could be wrong too: one problem per place."""
    taken = {(problem.line, problem.column) for problem in first if problem.line is not None}
    return first + [problem for problem in then if (problem.line, problem.column) not in taken]


def _mapping_of(
    root: nodes.Node | None, problems: list[Problem]
) -> tuple[nodes.Mapping | None, list[Problem]]:
    """The root when it is a mapping; otherwise what is wrong with it."""
    if isinstance(root, nodes.Mapping):
        return root, problems
    empty = root is None or (isinstance(root, nodes.Scalar) and root.value is None)
    if root is not None or not problems:
        message = "the file is empty" if empty else "a scene must be a mapping (key: value)"
        problems = [*problems, Problem((), message, line=1, column=1)]
    return None, problems


def _parameters(root: nodes.Mapping) -> Parameters:
    entry = root.entries.get("parameters")
    given = nodes.plain(entry.node) if entry is not None else None
    return Parameters(given if isinstance(given, dict) else {})


def _joint_types(root: nodes.Mapping) -> dict[str, str]:
    entry = root.entries.get("joints")
    given = nodes.plain(entry.node) if entry is not None else None
    joints = given.items() if isinstance(given, dict) else ()
    return {name: str(joint.get("type")) for name, joint in joints if isinstance(joint, dict)}


def _validated(
    root: nodes.Mapping, reading: Reading, places: Places, folder: Path | None
) -> tuple[SceneSpec | None, list[Problem]]:
    """The spec when its parts are right in themselves, and every problem, placed."""
    data: Any = nodes.plain(root)
    empty = {path for path, _ in islice(nodes.empty_places(root), MAX_TOLD)}
    problems = [places.place(_empty(path)) for path in empty]
    spec: SceneSpec | None = None
    draft: Draft
    try:
        spec = _with_frames(SceneSpec.model_validate(data, context=reading))
        draft = draft_of(spec, folder)
    except ValidationError as error:
        found = Translator(root, data, reading, places).problems(error)
        problems += [problem for problem in found if problem.path not in empty]
        draft = salvaged(data, reading, folder)
    return spec, problems + [places.place(problem) for problem in islice(all_problems(draft), MAX_TOLD)]


def _empty(path: tuple[PathPart, ...]) -> Problem:
    """A key without a value is a value that was forgotten, or a comment: `color: #d33`."""
    hint = 'a colour starts with #, which begins a comment: put it in quotes, "#d33"'
    message = "is empty: give a value, or leave the key out"
    return Problem(path, message, hint=hint if path[-1:] == ("color",) else None)


def _with_frames(spec: SceneSpec) -> SceneSpec:
    """Without `record.every`, frames are about 10 ms apart: the nearest whole number of timesteps."""
    if "every" in spec.record.model_fields_set:
        return spec
    every = _frame_time(spec.record.every, spec.simulation)
    return spec.model_copy(update={"record": spec.record.model_copy(update={"every": every})})


def _frame_time(wanted: float, simulation: SimulationSpec) -> float:
    """A whole number of timesteps, without the dust of the last bit (0.009, not 0.009000000000000001)."""
    return float(f"{max(1, round(wanted / simulation.timestep)) * simulation.timestep:.15g}")


def _unused(spec: SceneSpec, reading: Reading) -> list[Problem]:
    """A parameter that nothing uses is often a slip in the name of another."""
    unused = [name for name in spec.parameters if name not in reading.parameters.used]
    return [
        Problem(("parameters", name), "is used nowhere in the scene", severity="warning", hint=None)
        for name in unused
    ]
