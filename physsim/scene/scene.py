"""A scene that has been read and found valid."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from physsim.errors import Problem
from physsim.scene.files import resolve_file
from physsim.scene.place import Places
from physsim.scene.repeat import expanded
from physsim.scene.resolved import resolved_yaml
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.scene import SceneSpec


@dataclass(frozen=True)
class Scene:
    """What the user wrote.

    spec: typed, frozen, numbers are floats in SI, expressions evaluated; its fields are the language's keys.
    text: the YAML as given (before overrides); name: how messages call it; path: its file, None for text.
    folder: where files named in the scene are looked for; overrides: the changes made to the text, as told.
    warnings: what is allowed but probably not meant, placed.
    """

    spec: SceneSpec
    text: str
    name: str
    path: Path | None
    folder: Path
    overrides: tuple[str, ...] = ()
    warnings: tuple[Problem, ...] = ()
    places: Places = field(default_factory=lambda: Places(None, ""), repr=False, compare=False)

    @property
    def title(self) -> str:
        """The scene's title, or the name of its file."""
        return self.spec.title or (self.path.stem if self.path is not None else self.name)

    @cached_property
    def bodies(self) -> dict[str, BodySpec]:
        """All bodies in the order of the scene, `repeat` expanded to name[i,j,k], k running fastest."""
        return expanded(self.spec.bodies)

    def resolved_yaml(self) -> str:
        """The scene as YAML with every default filled in, in SI; reading it gives the same spec."""
        return resolved_yaml(self.spec)

    def resolve_file(self, file: str) -> Path:
        """The path of a file named in the scene. Raises FileTrouble, whose text is the reason alone."""
        return resolve_file(self.folder, file)

    def place(self, problem: Problem) -> Problem:
        """The problem with line, column and source line; copies of a body lead to its declaration."""
        return self.places.place(problem)
