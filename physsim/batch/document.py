"""A file that says what to do with a scene, on its way from text to its spec: what sweeps and fits share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from physsim.errors import FileTrouble, PathPart, Problem, SceneError
from physsim.scene import Original, Scene, nodes, original
from physsim.scene.parameters import Parameters
from physsim.scene.place import Places
from physsim.scene.problems import told_in_order
from physsim.scene.source import read_source
from physsim.scene.spec.base import Spec
from physsim.scene.spec.reading import Reading
from physsim.scene.translate import Translator
from physsim.scene.yaml_reader import read_yaml

S = TypeVar("S", bound=Spec)

LONGEST_SHOWN = 80
"""An override is shown in a problem up to so many characters."""


class Document:
    """The nodes of one file, and the problems found so far. folder: where the files that it names are."""

    def __init__(self, text: str, name: str, folder: Path, root: nodes.Mapping) -> None:
        self.text, self.name, self.folder, self.root = text, name, folder, root
        self.data: Any = nodes.plain(root)
        self.places = Places(root, text)
        self.problems: list[Problem] = []

    @classmethod
    def read(cls, path: Path, what: str) -> Document:
        """The file `path`. Raises FileTrouble when it cannot be read, SceneError when it is no mapping."""
        text = read_source(path)
        document = read_yaml(text)
        problems = [Places(None, text).with_source(problem) for problem in document.problems]
        if not isinstance(document.root, nodes.Mapping):
            problems = problems or [Problem((), f"{what} must be a mapping (key: value)", line=1, column=1)]
            raise SceneError(told_in_order(problems), str(path))
        found = cls(text, str(path), path.parent, document.root)
        found.problems = problems
        return found

    def tell(self, problem: Problem, *, at_key: bool = False) -> None:
        """Adds a problem, placed in the file."""
        self.problems.append(self.places.place(problem, at_key=at_key))

    def raise_what_was_found(self) -> None:
        if self.problems:
            raise SceneError(told_in_order(self.problems), self.name)

    def base(self) -> Original | None:
        """The scene file that `scene` names; None when there is none, which is told."""
        name = self.data.get("scene")
        if not isinstance(name, str):
            return None
        try:
            return original(self.folder / name)
        except FileTrouble as trouble:
            message = str(trouble).removeprefix(f"{self.folder / name}: ")
            self.tell(Problem(("scene",), message, given=name))
            return None

    def changed(
        self, base: Original, changes: Mapping[str, Any], places: Mapping[str, tuple[PathPart, ...]]
    ) -> Scene | None:
        """The scene with changes, or None when one of them is wrong, which is told at its place in this file.

        places: where the file says each change, by path of the scene. Raises SceneError when the scene itself
        is not valid.
        """
        try:
            return base.scene(changes)
        except SceneError as error:
            mine = [_moved(problem, places) for problem in error.problems]
            if None in mine:
                raise
            self.problems += [self.places.place(problem) for problem in mine if problem is not None]
            return None

    def shared_changes(self) -> dict[str, Any]:
        """What `set` changes in the scene; nothing when it is no mapping."""
        shared = self.data.get("set")
        return shared if isinstance(shared, dict) else {}

    def spec(self, kind: type[S], scene: Scene | None) -> S | None:
        """The file as its spec; None when it is not valid, which is told. scene: knows the joints' types."""
        types = {} if scene is None else {name: joint.type for name, joint in scene.spec.joints.items()}
        reading = Reading(Parameters({}), types)
        try:
            return kind.model_validate(self.data, context=reading)
        except ValidationError as error:
            self.problems += Translator(self.root, self.data, reading, self.places).problems(error)
            return None


def _moved(problem: Problem, places: Mapping[str, tuple[PathPart, ...]]) -> Problem | None:
    """The problem of an override at the place where the file says it; None when it is the scene's own."""
    for path, place in places.items():
        start = f"--set {path}="[:LONGEST_SHOWN]
        if problem.line is None and (problem.source_line or "").startswith(start):
            return replace(problem, path=place, source_line=None)
    return None
