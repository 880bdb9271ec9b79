"""Asking `FclAnswers` one question at a time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from collision_shapes import Floats, Thing, engine_input

from physsim.collision import FclAnswers


class Answer(NamedTuple):
    found: bool
    normal: Floats
    depth: float
    position: Floats


class Asker:
    """FCL's answers about a list of things; A and B are given by their index in it."""

    def __init__(self, things: Sequence[Thing]) -> None:
        self.things = things
        self.answers = FclAnswers(engine_input(things))

    def __call__(self, a: int, pose_a: Floats, b: int, pose_b: Floats, margin: float = 10.0) -> Answer:
        parts = [np.array([k], dtype=np.int32) for k in (a, b, self._triangle(a), self._triangle(b))]
        found, normal, depth, position = self.answers(*parts, pose_a[None], pose_b[None], np.array([margin]))
        return Answer(bool(found[0]), normal[0], float(depth[0]), position[0])

    def _triangle(self, geom: int) -> int:
        return 0 if self.things[geom].kind == "mesh" else -1
