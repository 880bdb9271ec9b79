"""Whether one sees what moves from a direction, or whether something that stands still hides it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from physsim.view.stage import FloatArray

MOST_POINTS = 400


@dataclass(frozen=True)
class Screen:
    """A box that stands still: from corner `low` to `high` (3) [m] of a frame at `place` (3) [m] whose axes
    are the columns of `turn` (3, 3).
    """

    place: FloatArray
    turn: FloatArray
    low: FloatArray
    high: FloatArray

    def hides(self, points: FloatArray, away: FloatArray) -> FloatArray:
        """Whether the ray from each point (n, 3) along `away` (3) enters the box; not for points within it.

        Slabs: the ray is in the box while it is between all three pairs of its planes.
        """
        start, along = (points - self.place) @ self.turn, away @ self.turn
        along = np.where(np.abs(along) < 1e-12, 1e-12, along)
        one, other = (self.low - start) / along, (self.high - start) / along
        enters, leaves = np.minimum(one, other).max(axis=1), np.maximum(one, other).min(axis=1)
        return np.asarray((enters < leaves) & (enters > 0))


@dataclass(frozen=True)
class Outlook:
    """points (n, 3) [m]: where the middles of moving bodies are over the run; screens: what stands still."""

    points: FloatArray
    screens: tuple[Screen, ...]

    def hidden(self, away: FloatArray) -> float:
        """The share of the points that a camera in the direction `away` (3) does not see."""
        chosen = self.points[:: max(1, len(self.points) // MOST_POINTS)]
        if len(chosen) == 0 or not self.screens:
            return 0.0
        return float(np.any([screen.hides(chosen, away) for screen in self.screens], axis=0).mean())
