"""Which number holds for two materials: the scene's pairs, then the library's pairs, then the mixing rule.

Each of the three numbers is looked up by itself, so a pair whose friction is known and whose restitution is
not takes only the latter from the mixing rule. A material that the scene redefines keeps the library's
pairs for the numbers it does not state; a number it does state is newer than the table and goes through the
mixing rule.

A rule needs a number of either material. Where one of them has none the other's is taken, and where neither
has one 0 is assumed (no rebound, no friction); both are said in the source, and whoever compiles the scene
warns of what was assumed. The rule `error` refuses instead.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from physsim.errors import PhyssimError
from physsim.materials import library
from physsim.materials.mixing import RULES

ASSUMED = 3
"""Rank of a number that nobody knows."""
NUMBERS = ("restitution", "static_friction", "kinetic_friction")
_SUBSTITUTE = {"static_friction": ("kinetic_friction",), "kinetic_friction": ("static_friction",)}


class MaterialLike(Protocol):
    """A material as the scene declares it; None where it says nothing."""

    @property
    def restitution(self) -> float | None: ...
    @property
    def static_friction(self) -> float | None: ...
    @property
    def kinetic_friction(self) -> float | None: ...


class PairLike(Protocol):
    """A row of the scene's `pairs`."""

    @property
    def between(self) -> Sequence[str]: ...
    @property
    def restitution(self) -> float | None: ...
    @property
    def static_friction(self) -> float | None: ...
    @property
    def kinetic_friction(self) -> float | None: ...


class MixingLike(Protocol):
    """The scene's `mixing`: a name in `RULES`, or `error`."""

    @property
    def restitution(self) -> str: ...
    @property
    def friction(self) -> str: ...


@dataclass(frozen=True)
class ResolvedNumber:
    """A coefficient and where it comes from: `scene, pairs[0]`, `library: ...` or `mixing: minimum`."""

    value: float
    source: str
    rank: int
    """0 scene's pairs, 1 library's pairs, 2 mixing rule, `ASSUMED`: of two numbers that disagree the lower
    rank stands.
    """


@dataclass(frozen=True)
class ResolvedPair:
    """The three coefficients that hold between two materials; static friction is never below kinetic."""

    between: tuple[str, str]
    restitution: ResolvedNumber
    static_friction: ResolvedNumber
    kinetic_friction: ResolvedNumber

    @property
    def assumed(self) -> tuple[str, ...]:
        """The numbers that nobody knows."""
        return tuple(name for name in NUMBERS if getattr(self, name).rank == ASSUMED)

    @property
    def hint(self) -> str:
        """The line to add to the scene for what was assumed."""
        return declare(self.between, self.assumed)

    @property
    def source(self) -> str:
        """One line: the common source, or one for each number."""
        found = [(name, getattr(self, name).source) for name in NUMBERS]
        if found[1][1] == found[2][1]:
            found = [found[0], ("friction", found[1][1])]
        if found[0][1] == found[1][1] and len(found) == 2:
            return str(found[0][1])
        return "; ".join(f"{name} {source}" for name, source in found)


class UnknownPair(PhyssimError):
    """Numbers of a pair that are in no table, under the mixing rule `error`.

    between: the two names; missing: number -> why it is not known.
    """

    exit_code = 2

    def __init__(self, between: tuple[str, str], missing: Mapping[str, str]) -> None:
        self.between = between
        self.missing = dict(missing)
        reasons = "; ".join(f"{name} {why}" for name, why in missing.items())
        super().__init__(
            f"no {' and no '.join(missing)} known between '{between[0]}' and '{between[1]}' ({reasons})"
        )

    @property
    def hint(self) -> str:
        """The line to add to the scene."""
        return declare(self.between, self.missing)


def declare(between: tuple[str, str], numbers: Iterable[str]) -> str:
    """The row of `pairs` that gives these numbers."""
    wanted = ", ".join(f"{name}: ..." for name in numbers)
    return f"declare it: pairs: [{{between: [{between[0]}, {between[1]}], {wanted}}}]"


def resolve_pair(
    a: str,
    b: str,
    scene_materials: Mapping[str, MaterialLike],
    scene_pairs: Sequence[PairLike],
    mixing: MixingLike,
) -> ResolvedPair:
    """The coefficients between materials `a` and `b`, which may be the same.

    Raises UnknownPair when a number is in no table and its mixing rule is `error`. Of the two coefficients of
    friction one is enough. Where static and kinetic friction come from different places and disagree (static
    below kinetic), the one from the better place stands and the other is set equal to it.
    """
    rules = {
        "restitution": mixing.restitution,
        "static_friction": mixing.friction,
        "kinetic_friction": mixing.friction,
    }
    found: dict[str, ResolvedNumber] = {}
    missing: dict[str, str] = {}
    for name in NUMBERS:
        number = (
            _from_scene(name, a, b, scene_pairs)
            or _from_library(name, a, b, scene_materials)
            or _mixed(name, a, b, scene_materials, rules[name])
        )
        if isinstance(number, ResolvedNumber):
            found[name] = number
        else:
            missing[name] = number
    _complete_friction(found, missing)
    refused = {name: why for name, why in missing.items() if rules[name] == "error"}
    if refused:
        raise UnknownPair((a, b), refused)
    for name, why in missing.items():
        found[name] = ResolvedNumber(0.0, f"assumed 0: {why}", ASSUMED)
    static, kinetic = _ordered(found["static_friction"], found["kinetic_friction"])
    return ResolvedPair((a, b), found["restitution"], static, kinetic)


def _complete_friction(found: dict[str, ResolvedNumber], missing: dict[str, str]) -> None:
    """Many tables give one coefficient only: it then serves at rest and in motion."""
    for name, (other,) in _SUBSTITUTE.items():
        if name in missing and other in found:
            del missing[name]
            known = found[other]
            found[name] = ResolvedNumber(known.value, f"{known.source} (value of {other})", known.rank)


def _from_scene(name: str, a: str, b: str, scene_pairs: Sequence[PairLike]) -> ResolvedNumber | None:
    for index, row in enumerate(scene_pairs):
        value: float | None = getattr(row, name)
        if value is not None and {a, b} == set(row.between):
            return ResolvedNumber(value, f"scene, pairs[{index}]", 0)
    return None


def _from_library(
    name: str, a: str, b: str, scene_materials: Mapping[str, MaterialLike]
) -> ResolvedNumber | None:
    row = library.pair(a, b)
    known: library.Number | None = getattr(row, name) if row is not None else None
    if known is None or any(_stated(name, material, scene_materials) is not None for material in (a, b)):
        return None
    return ResolvedNumber(known.value, f"library: {known.source}", 1)


def _stated(name: str, material: str, scene_materials: Mapping[str, MaterialLike]) -> float | None:
    """What the scene itself says of the material."""
    declared = scene_materials.get(material)
    value: float | None = getattr(declared, name) if declared is not None else None
    return value


def _single(name: str, material: str, scene_materials: Mapping[str, MaterialLike]) -> float | None:
    """The material's own number: the scene's before the library's, and of two frictions one is enough."""
    for number in (name, *_SUBSTITUTE.get(name, ())):
        stated = _stated(number, material, scene_materials)
        if stated is not None:
            return stated
        if material in library.material_names():
            known: library.Number | None = getattr(library.material(material), number)
            if known is not None:
                return known.value
    return None


def _mixed(
    name: str, a: str, b: str, scene_materials: Mapping[str, MaterialLike], rule: str
) -> ResolvedNumber | str:
    """The mixed number, or why there is none."""
    if rule == "error":
        return "is in no table, and mixing is 'error'"
    values = {material: _single(name, material, scene_materials) for material in (a, b)}
    unknown = " and ".join(f"'{material}'" for material, value in values.items() if value is None)
    known = [(material, value) for material, value in values.items() if value is not None]
    if not known:
        return f"is not given for {unknown}"
    if unknown:
        return ResolvedNumber(known[0][1], f"mixing: only '{known[0][0]}' has a number", 2)
    first, second = known[0][1], known[-1][1]
    return ResolvedNumber(RULES[rule](first, second), f"mixing: {rule}", 2)


def _ordered(static: ResolvedNumber, kinetic: ResolvedNumber) -> tuple[ResolvedNumber, ResolvedNumber]:
    """Static friction at least kinetic: |f| <= mu_s N while sticking would else jump up at the onset of
    sliding.
    """
    if static.value >= kinetic.value:
        return static, kinetic
    if static.rank <= kinetic.rank:
        return static, ResolvedNumber(
            static.value, f"{kinetic.source}, lowered to static_friction", kinetic.rank
        )
    return ResolvedNumber(kinetic.value, f"{static.source}, raised to kinetic_friction", static.rank), kinetic
