"""Sweep file -> Sweep: read and checked like a scene, every mistake told at once with its place."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any

from physsim.batch.checks import all_problems, all_warnings
from physsim.batch.design import Design, design_of
from physsim.batch.document import Document
from physsim.batch.spec import SweepSpec
from physsim.errors import Problem
from physsim.scene import Original, Scene, nodes
from physsim.scene.overrides import node_of


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
        return _sweep(Document("", "<sweep>", Path(), root), None)
    return _sweep(Document.read(Path(source), "a sweep"), Path(source))


def _sweep(document: Document, path: Path | None) -> Sweep:
    """Raises SceneError with everything that was found."""
    base = document.base()
    scene = _scene(document, base) if base is not None else None
    spec = document.spec(SweepSpec, scene)
    if spec is not None and scene is not None and base is not None:
        for problem in all_problems(spec, base, scene):
            document.tell(problem, at_key=problem.given is None)
    document.raise_what_was_found()
    assert spec is not None
    assert base is not None
    assert scene is not None
    warnings = tuple(document.places.place(problem) for problem in all_warnings(spec))
    return Sweep(spec, document.text, document.name, path, base, scene, warnings)


def _scene(document: Document, base: Original) -> Scene | None:
    """The scene that all runs start from. Raises SceneError when the scene itself is not valid."""
    changes = document.shared_changes()
    return document.changed(base, changes, {path: ("set", path) for path in changes})
