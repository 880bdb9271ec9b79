"""The border to the Rust engine; `engine/src/python.rs` implements it."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

_Floats = npt.NDArray[np.float64]
_Integers = npt.NDArray[np.int32]
_Answer = Callable[
    [_Integers, _Integers, _Integers, _Integers, _Floats, _Floats, _Floats],
    tuple[npt.NDArray[np.bool_], _Floats, _Floats, _Floats],
]

__version__: str

class Diverged(Exception):
    """A body's state blew up; args are (index of the body, time [s])."""

class EngineError(RuntimeError):
    """The engine failed; a defect of physsim."""

class World:
    def __init__(self, model: Mapping[str, object]) -> None: ...
    def advance(self, steps: int, answer: _Answer | None = None) -> None: ...
    def state(self) -> dict[str, Any]: ...
    def contacts(self) -> dict[str, npt.NDArray[Any]]: ...
    def events(self) -> dict[str, npt.NDArray[Any]]: ...
    def energies(self) -> dict[str, float]: ...
    def solver(self) -> dict[str, Any]: ...
    def detect(self, margin: float, answer: _Answer | None = None) -> dict[str, npt.NDArray[Any]]: ...
    def needs_answer(self) -> bool: ...
    def save(self) -> bytes: ...
    def restore(self, bytes: bytes) -> None: ...
    def collide_pair(
        self,
        geom_a: int,
        pose_a: list[float],
        geom_b: int,
        pose_b: list[float],
        margin: float,
        answer: _Answer | None = None,
    ) -> dict[str, npt.NDArray[Any]]: ...
