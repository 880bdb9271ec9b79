"""What is still to be done, handed out in blocks.

A block is as many runs as take about half a second, so that sending costs nothing beside working, and the
last blocks are small, so that all workers end together. Neither shows in the numbers.
"""

from __future__ import annotations

import math
from collections import Counter, deque
from collections.abc import Iterator

from physsim.batch.design import Run
from physsim.batch.workshop import CRASHED, Result

SECONDS_PER_BLOCK = 0.5
# A block costs whoever hands it out 1 to 2 ms (measured with Dask): many workers get longer ones.
SECONDS_PER_SLOT = 0.0025
LONGEST_BLOCK = 1000
GROWTH = 4
# A run that was alone in its worker this often when the worker died is held to be the cause.
MOST_DEATHS = 2

Block = tuple[Run, ...]


class Backlog:
    """The runs to be done. count: how many `runs` has; slots: workers that take blocks."""

    def __init__(self, runs: Iterator[Run], count: int, slots: int) -> None:
        self._runs = runs
        self._left = count
        self._slots = max(1, slots)
        self._seconds = max(SECONDS_PER_BLOCK, SECONDS_PER_SLOT * slots)
        self._suspects: deque[Run] = deque()
        self._deaths: Counter[int] = Counter()
        self._in_hand = 0
        self._size = 1
        self._seconds_per_run = 0.0

    @property
    def is_done(self) -> bool:
        """Whether nothing is left and nothing is out."""
        return not self._left and not self._suspects and not self._in_hand

    def take(self) -> Block | None:
        """The next block; None when there is none to give now."""
        if self._suspects:
            block: Block = (self._suspects.popleft(),)
        elif self._left:
            size = min(self._size, max(1, math.ceil(self._left / (2 * self._slots))))
            block = tuple(run for _, run in zip(range(size), self._runs, strict=False))
            self._left -= len(block)
        else:
            return None
        self._in_hand += 1
        return block

    def done(self, block: Block, results: list[Result]) -> None:
        """A block has come back."""
        self._in_hand -= 1
        mean = sum(result.wall_time for result in results) / len(block)
        self._seconds_per_run = (
            mean if not self._seconds_per_run else 0.7 * self._seconds_per_run + 0.3 * mean
        )
        wanted = int(self._seconds / max(self._seconds_per_run, 1e-6))
        self._size = max(1, min(wanted, GROWTH * self._size, LONGEST_BLOCK))

    def lost(self, block: Block, reason: str) -> list[Result]:
        """The worker died over a block: its runs are tried again one by one, and one that kills its worker
        again and again is given up. Returns the results of those.
        """
        self._in_hand -= 1
        if len(block) > 1:
            self._suspects.extend(block)
            return []
        (run,) = block
        self._deaths[run.number] += 1
        if self._deaths[run.number] < MOST_DEATHS:
            self._suspects.append(run)
            return []
        return [Result(run.key, CRASHED, reason)]
