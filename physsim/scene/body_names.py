"""The names of all bodies of a scene, copies of repeated bodies included, without listing them one by one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from physsim.scene.patterns import matches
from physsim.scene.repeat import copies, copy_name, names_of
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.names import WORLD
from physsim.scene.suggest import did_you_mean

_COPY = re.compile(r"(?P<name>.+)\[(?P<i>\d{1,6}),(?P<j>\d{1,6}),(?P<k>\d{1,6})\]\Z", re.DOTALL)


class BodyNames:
    """Which names bodies have. A body that is wrong in itself (None) is taken to have any copies."""

    def __init__(self, bodies: Mapping[str, BodySpec | None]) -> None:
        self._bodies = bodies

    @property
    def total(self) -> int:
        """Number of bodies, the wrong ones counted once."""
        return sum(1 if body is None else copies(body) for body in self._bodies.values())

    def every(self) -> Iterator[str]:
        """All names that are known."""
        for name, body in self._bodies.items():
            yield from (name,) if body is None else names_of(name, body)

    def fitting(self, pattern: str) -> Iterator[str]:
        """All names that fit a pattern, in which `*` stands for any characters."""
        return (name for name in self.every() if matches(pattern, name))

    def trouble(self, name: str, world: bool = False) -> tuple[str, str | None] | None:
        """What is wrong with a reference to a body: a message and a hint; None when there is such a body.

        world: whether the fixed body `world` may be named.
        """
        if name == WORLD:
            return None if world else ("names the world, which is no body of the scene", None)
        if name in self._bodies:
            return self._of_declared(name)
        match = _COPY.match(name)
        if match and match["name"] in self._bodies:
            return self._of_copy(match["name"], _index(match))
        known = [*self._bodies, WORLD] if world else self._bodies
        return f"there is no body '{name}'", did_you_mean(name, known)

    def is_copy(self, name: str) -> bool:
        """Whether a copy of a repeated body has this name."""
        match = _COPY.match(name)
        return match is not None and self._of_copy(match["name"], _index(match)) is None

    def is_fixed(self, name: str) -> bool:
        """Whether the body is known to be fixed; the world is."""
        body = self._bodies.get(name) or self._bodies.get(name.rpartition("[")[0])
        return name == WORLD or (body is not None and body.fixed)

    def _of_declared(self, name: str) -> tuple[str, str | None] | None:
        body = self._bodies[name]
        if body is None or body.repeat is None:
            return None
        return f"'{name}' is repeated", f'name one of its copies, such as "{copy_name(name, (0, 0, 0))}"'

    def _of_copy(self, name: str, index: tuple[int, ...]) -> tuple[str, str | None] | None:
        body = self._bodies[name]
        if body is None:
            return None
        if body.repeat is None:
            return f"'{name}' is not repeated", f"name it '{name}'"
        if all(i < n for i, n in zip(index, body.repeat.count, strict=True)):
            return None
        nx, ny, nz = body.repeat.count
        return f"'{name}' has no such copy", f"the last one is {copy_name(name, (nx - 1, ny - 1, nz - 1))}"


def _index(match: re.Match[str]) -> tuple[int, ...]:
    return tuple(int(match[axis]) for axis in "ijk")
