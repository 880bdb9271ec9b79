"""Sweep file -> Sweep: read and checked like a scene, every mistake told at once with its place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from physsim.batch.checks import all_problems, all_warnings
from physsim.batch.design import Design, design_of
from physsim.batch.spec import SweepSpec
from physsim.errors import FileTrouble, Problem, SceneError
from physsim.scene import Original, Scene, nodes, original
from physsim.scene.overrides import node_of
from physsim.scene.parameters import Parameters
from physsim.scene.place import Places
from physsim.scene.problems import told_in_order
from physsim.scene.source import read_source
from physsim.scene.spec.reading import Reading
from physsim.scene.translate import Translator
from physsim.scene.yaml_reader import read_yaml


@dataclass(frozen=True)
class Sweep:
    """What the user wrote, found valid.

    text: the YAML as given; name: how messages call it; path: its file, None for one made in a program.
    base: the scene as written; scene: with what `set` changes in it; warnings: placed.
    """

    spec: SweepSpec
    text: str
    name: str
    path: Path | None
    base: Original
    scene: Scene
    warnings: tuple[Problem, ...] = field(default=())

    @property
    def title(self) -> str:
        """The sweep's title, or the name of its file."""
        return self.spec.title or (self.path.stem if self.path is not None else self.name)

    @property
    def design(self) -> Design:
        """All runs."""
        return design_of(self.spec)


def load_sweep(source: str | PathLike[str] | Mapping[str, Any]) -> Sweep:
    """Read a sweep from a file, or from a dictionary with the same keys (its scene: a path from here).

    Raises FileTrouble when a file cannot be read, SceneError with every problem when the sweep, or the scene
    that it starts from, is not valid.
    """
    if isinstance(source, Mapping):
        root = node_of(source, nodes.Place(1, 1, "<sweep>"))
        assert isinstance(root, nodes.Mapping)
        return _Loader("", "<sweep>", None, root).sweep()
    path = Path(source)
    text = read_source(path)
    document = read_yaml(text)
    problems = [Places(None, text).with_source(problem) for problem in document.problems]
    if not isinstance(document.root, nodes.Mapping):
        problems = problems or [Problem((), "a sweep must be a mapping (key: value)", line=1, column=1)]
        raise SceneError(told_in_order(problems), str(source))
    return _Loader(text, str(source), path, document.root, problems).sweep()


class _Loader:
    """One sweep on its way from nodes to its spec."""

    def __init__(
        self,
        text: str,
        name: str,
        path: Path | None,
        root: nodes.Mapping,
        problems: list[Problem] | None = None,
    ) -> None:
        self.text, self.name, self.path = text, name, path
        self.folder = path.parent if path is not None else Path()
        self.root = root
        self.places = Places(root, text)
        self.problems = problems or []

    def sweep(self) -> Sweep:
        """Raises SceneError with everything that was found."""
        data: Any = nodes.plain(self.root)
        base = self._base(data)
        scene = self._scene(base, data) if base is not None else None
        spec = self._spec(data, scene)
        if spec is not None and scene is not None and base is not None:
            self.problems += [
                self.places.place(problem, at_key=problem.given is None)
                for problem in all_problems(spec, base, scene)
            ]
        self._raise_what_was_found()
        assert spec is not None
        assert base is not None
        assert scene is not None
        warnings = tuple(self.places.place(problem) for problem in all_warnings(spec))
        return Sweep(spec, self.text, self.name, self.path, base, scene, warnings)

    def _raise_what_was_found(self) -> None:
        if self.problems:
            raise SceneError(told_in_order(self.problems), self.name)

    def _base(self, data: Any) -> Original | None:
        name = data.get("scene")
        if not isinstance(name, str):
            return None
        try:
            return original(self.folder / name)
        except FileTrouble as trouble:
            message = str(trouble).removeprefix(f"{self.folder / name}: ")
            self.problems.append(self.places.place(Problem(("scene",), message, given=name)))
            return None

    def _scene(self, base: Original, data: Any) -> Scene | None:
        """The scene that all runs start from. Raises SceneError when the scene itself is not valid."""
        shared = data.get("set")
        changes = shared if isinstance(shared, dict) else {}
        try:
            return base.scene(changes)
        except SceneError as error:
            mine = list(_in_set(error, changes))
            if len(mine) < len(error.problems):
                raise
            self.problems += [self.places.place(problem) for problem in mine]
            return None

    def _spec(self, data: Any, scene: Scene | None) -> SweepSpec | None:
        types = {} if scene is None else {name: joint.type for name, joint in scene.spec.joints.items()}
        reading = Reading(Parameters({}), types)
        try:
            return SweepSpec.model_validate(data, context=reading)
        except ValidationError as error:
            self.problems += Translator(self.root, data, reading, self.places).problems(error)
            return None


def _in_set(error: SceneError, changes: Mapping[str, Any]) -> Iterator[Problem]:
    """The problems that come from `set`, at their place in the sweep."""
    for problem in error.problems:
        for path in changes:
            if problem.line is None and (problem.source_line or "").startswith(f"--set {path}="):
                yield replace(problem, path=("set", path), source_line=None)
                break
