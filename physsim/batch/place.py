"""Where blocks are worked on: what the places have in common."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from physsim.batch.backlog import Block
from physsim.batch.workshop import Result


@dataclass(frozen=True)
class Answer:
    """What became of a block.

    results: None when the worker was lost over it, then `reason` says how. trouble: what ends the sweep.
    files: content of trajectories that were not written where they belong, by name.
    """

    block: Block
    results: list[Result] | None = None
    reason: str = ""
    trouble: Exception | None = None
    files: dict[str, bytes] = field(default_factory=dict)


class Place(Protocol):
    """Local processes or a cluster. Answers are put into the queue that the place was made with."""

    @property
    def slots(self) -> int:
        """How many blocks it can work on at once, as far as known now."""
        ...

    def submit(self, block: Block) -> None:
        """Takes a block; returns at once."""
        ...

    def close(self) -> None:
        """Ends all work, also what is under way."""
        ...
