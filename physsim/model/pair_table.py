"""The matrix of coefficients for the materials in use."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from physsim.materials import NUMBERS, ResolvedPair, UnknownPair, resolve_pair
from physsim.model.findings import Findings, Path
from physsim.model.no_contact import Pairs
from physsim.model.rotation import FloatArray

if TYPE_CHECKING:
    from physsim.scene.spec import SceneSpec

LEVERS = ("rolling_friction", "spinning_friction")
NEVER = "not needed: no two such bodies can touch"


@dataclass(frozen=True)
class PairTable:
    """Symmetric matrices (M, M) over the materials in use, and for each entry the row or rule it came from.

    An entry that no two bodies of the scene can ask for and that no table knows is 0 and says so in `source`.
    Rolling and spinning friction [m] are levers of the normal force; only the scene's pairs give them.
    """

    restitution: FloatArray
    static_friction: FloatArray
    kinetic_friction: FloatArray
    rolling_friction: FloatArray
    spinning_friction: FloatArray
    source: tuple[tuple[str, ...], ...]


def can_touch(
    body_materials: npt.NDArray[np.bool_], fixed: npt.NDArray[np.bool_], no_contact: Pairs
) -> npt.NDArray[np.bool_]:
    """Which materials can meet: (M, M), from who is made of what (N, M).

    Counts ordered pairs of different bodies, not both fixed, and takes off those that `no_contact` names.
    """
    has = body_materials.astype(np.float64)  # whole numbers below 2^53; integer products are not done by BLAS
    everyone, standing = has.sum(axis=0), has[fixed].sum(axis=0)
    counts = np.outer(everyone, everyone) - np.outer(standing, standing) - has[~fixed].T @ has[~fixed]
    one_moves = ~(fixed[no_contact[:, 0]] & fixed[no_contact[:, 1]])
    between = has[no_contact[one_moves, 0]].T @ has[no_contact[one_moves, 1]]
    possible: npt.NDArray[np.bool_] = counts - between - between.T > 0
    return possible


@dataclass(frozen=True)
class Complaints:
    """Where errors and warnings about materials go: `places` says where each material is used."""

    places: Mapping[str, Path]
    findings: Findings

    def unknown(self, pair: UnknownPair) -> None:
        """Note a pair without numbers at a body made of its second material."""
        self.findings.error(self.places[pair.between[1]], str(pair), hint=pair.hint)

    def assumed(self, pair: ResolvedPair) -> None:
        """Note what was assumed of a pair at a body made of its second material."""
        a, b = pair.between
        numbers = " and ".join(pair.assumed)
        message = f"no {numbers} known between '{a}' and '{b}', 0 is assumed"
        self.findings.warn(self.places[b], message, hint=pair.hint)


def pair_table(
    names: Sequence[str], needed: npt.NDArray[np.bool_], spec: SceneSpec, complaints: Complaints
) -> PairTable:
    """Every pair of `names` resolved; a pair that is `needed` (M, M) and not known is told."""
    count = len(names)
    table = {number: np.zeros((count, count)) for number in NUMBERS}
    source = [[NEVER] * count for _ in names]
    for i, j in combinations_with_replacement(range(count), 2):
        try:
            pair = resolve_pair(names[i], names[j], spec.materials, spec.pairs, spec.mixing)
        except UnknownPair as unknown:
            if needed[i, j]:
                complaints.unknown(unknown)
            continue
        if pair.assumed:
            if not needed[i, j]:
                continue
            complaints.assumed(pair)
        source[i][j] = source[j][i] = pair.source
        for number, matrix in table.items():
            matrix[i, j] = matrix[j, i] = getattr(pair, number).value
    levers = {number: _levers(number, names, spec) for number in LEVERS}
    return PairTable(**table, **levers, source=tuple(tuple(row) for row in source))


def _levers(number: str, names: Sequence[str], spec: SceneSpec) -> FloatArray:
    """(M, M) m, 0 for what the scene's pairs do not name; no library has them."""
    matrix = np.zeros((len(names), len(names)))
    places = {name: place for place, name in enumerate(names)}
    for pair in spec.pairs:
        if all(name in places for name in pair.between):
            i, j = (places[name] for name in pair.between)
            matrix[i, j] = matrix[j, i] = getattr(pair, number)
    return matrix
