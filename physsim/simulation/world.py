"""The engine's world of a model, with FCL beside it where it is needed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from physsim._engine import World
from physsim.errors import RunFailed

if TYPE_CHECKING:
    from physsim.model import Model


@dataclass(frozen=True)
class Simulated:
    """world: `physsim._engine.World`; answer: the FCL callback, None when the engine answers all pairs."""

    world: Any
    answer: Any


def build(model: Model) -> Simulated:
    """The world in its declared state. Raises RunFailed when the engine refuses the model."""
    arrays = model.engine_input()
    try:
        world = World(arrays)
    except ValueError as error:
        raise RunFailed(f"the engine refuses the model: {error}") from error
    return Simulated(world, _answers(arrays) if world.needs_answer() else None)


def _answers(arrays: dict[str, object]) -> Any:
    from physsim.collision import FclAnswers  # noqa: PLC0415, needs fcl, which few scenes do

    return FclAnswers(arrays)
