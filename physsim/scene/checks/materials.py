"""Materials and pairs: names that exist, no pair twice, friction that makes sense."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.draft import Draft
from physsim.scene.materials_known import known_materials
from physsim.scene.spec.materials import MaterialSpec, PairSpec
from physsim.scene.suggest import did_you_mean

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `materials` and `pairs`."""
    for name, material in draft.materials.items():
        if material is not None:
            yield from _friction(("materials", name), material)
    yield from _pairs(draft)


def unknown_material(path: Path, name: str, draft: Draft) -> Iterator[Problem]:
    """A problem when there is no material of that name."""
    known = known_materials(draft.materials)
    if name not in known:
        yield Problem(path, f"there is no material '{name}'", hint=did_you_mean(name, known))


def _friction(path: Path, given: MaterialSpec | PairSpec) -> Iterator[Problem]:
    """Amontons-Coulomb: what rests never slides more easily than what moves."""
    rest, sliding = given.static_friction, given.kinetic_friction
    if rest is not None and sliding is not None and rest < sliding:
        yield Problem(
            (*path, "kinetic_friction"), f"must not exceed static_friction ({rest:g})", f"{sliding:g}"
        )


def _pairs(draft: Draft) -> Iterator[Problem]:
    first: dict[tuple[str, ...], int] = {}
    for i, pair in enumerate(draft.pairs):
        if pair is None:
            continue
        yield from _pair(("pairs", i), pair, draft)
        key = tuple(sorted(pair.between))
        if key in first:
            yield Problem(
                ("pairs", i, "between"), f"{' and '.join(key)} are a pair already, in pairs[{first[key]}]"
            )
        first.setdefault(key, i)


def _pair(path: Path, pair: PairSpec, draft: Draft) -> Iterator[Problem]:
    for k, name in enumerate(pair.between):
        yield from unknown_material((*path, "between", k), name, draft)
    yield from _friction(path, pair)
    coefficients = (pair.restitution, pair.static_friction, pair.kinetic_friction)
    turning = (pair.rolling_friction, pair.spinning_friction)
    if all(number is None for number in coefficients) and not any(turning):
        yield Problem(path, "says nothing: give restitution or a friction")
