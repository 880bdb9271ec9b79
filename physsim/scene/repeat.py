"""`repeat`: one declared body becomes a lattice of copies."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping

from physsim.scene.spec.bodies import BodySpec

MAX_BODIES = 100_000
Index = tuple[int, int, int]


def copies(body: BodySpec) -> int:
    """How many bodies one entry stands for."""
    if body.repeat is None:
        return 1
    nx, ny, nz = body.repeat.count
    return nx * ny * nz


def copy_name(name: str, index: Index) -> str:
    """`brick[0,0,3]`."""
    return f"{name}[{index[0]},{index[1]},{index[2]}]"


def indices(body: BodySpec) -> Iterator[Index]:
    """The indices of all copies, the last running fastest."""
    assert body.repeat is not None
    nx, ny, nz = body.repeat.count
    return itertools.product(range(nx), range(ny), range(nz))


def names_of(name: str, body: BodySpec) -> Iterator[str]:
    """The names of the bodies that one entry stands for."""
    if body.repeat is None:
        return iter((name,))
    return (copy_name(name, index) for index in indices(body))


def expanded(bodies: Mapping[str, BodySpec]) -> dict[str, BodySpec]:
    """All bodies by name, in the order of the scene; copies have no `repeat` of their own."""
    result: dict[str, BodySpec] = {}
    for name, body in bodies.items():
        if body.repeat is None:
            result[name] = body
        else:
            result.update((copy_name(name, index), _copy(body, index)) for index in indices(body))
    return result


def _copy(body: BodySpec, index: Index) -> BodySpec:
    """position + index * spacing, in world axes."""
    assert body.repeat is not None
    spacing = body.repeat.spacing
    position = tuple(p + i * s for p, i, s in zip(body.position, index, spacing, strict=True))
    return body.model_copy(update={"position": position, "repeat": None})
