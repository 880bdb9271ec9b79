"""Bodies that overlap in the declared state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from physsim.errors import Problem
from physsim.simulation.world import Simulated, build

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene

# Deeper than this is told: 0.1 mm, or for small bodies this share of the smaller one's radius of gyration.
DEPTH = 1e-4
SHARE_OF_SIZE = 0.01


@dataclass(frozen=True)
class Overlap:
    """Two bodies that overlap: the depth [m] and the place [m] where it is greatest."""

    body_a: str
    body_b: str
    depth: float
    position: tuple[float, float, float]


def find_overlaps(model: Model) -> list[Overlap]:
    """Every pair of bodies that overlaps by more than 0.1 mm at the start, deepest first.

    Of bodies with a radius of gyration under 1 cm, more than 1 % of that. FCL is imported only when the
    scene has a pair of shapes that the engine cannot answer itself.
    """
    return overlaps_of(build(model), model)


def overlaps_of(simulated: Simulated, model: Model) -> list[Overlap]:
    """The same, of a world that has not been stepped."""
    found = simulated.world.detect(0.0, simulated.answer)
    allowed = _allowed_depths(model)
    deepest: dict[tuple[int, int], int] = {}
    for row in np.argsort(found["depth"], kind="stable"):
        a, b = sorted((int(found["body_a"][row]), int(found["body_b"][row])))
        if found["depth"][row] > min(allowed[a], allowed[b]):
            deepest[a, b] = row
    overlaps = [_overlap(model, found, pair, row) for pair, row in deepest.items()]
    return sorted(overlaps, key=lambda overlap: -overlap.depth)


def overlap_problems(scene: Scene, overlaps: list[Overlap]) -> list[Problem]:
    """The overlaps as warnings, placed at the second body of each pair."""
    return [
        scene.place(
            Problem(
                ("bodies", overlap.body_b),
                f"overlaps {overlap.body_a} by {overlap.depth:.3g} m at the start",
                hint="they will be pushed apart; leave a gap, or name the pair under no_contact",
                severity="warning",
            )
        )
        for overlap in overlaps
    ]


def _allowed_depths(model: Model) -> NDArray[np.float64]:
    """Per body, (N) m. Radius of gyration: sqrt(tr I / 2 m), as tr I = 2 sum m r²."""
    with np.errstate(invalid="ignore"):
        gyration = np.sqrt(np.trace(model.inertia, axis1=1, axis2=2) / (2 * model.mass))
    depths: NDArray[np.float64] = np.fmin(DEPTH, SHARE_OF_SIZE * gyration)
    return depths


def _overlap(model: Model, found: dict[str, Any], pair: tuple[int, int], row: int) -> Overlap:
    x, y, z = (float(value) for value in found["position"][row])
    a, b = (model.body_names[index] for index in pair)
    return Overlap(a, b, float(found["depth"][row]), (x, y, z))
