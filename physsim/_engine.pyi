"""The border to the Rust engine; `engine/src/python` implements it."""

from collections.abc import Callable, Mapping, Sequence
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

def draw(picture: Mapping[str, object], threads: int = 1) -> npt.NDArray[np.uint8]: ...
def shuffled(bytes: npt.NDArray[np.uint8], size: int) -> npt.NDArray[np.uint8]: ...

class Diverged(Exception):
    """A body's state blew up; args are (index of the body, time [s])."""

class EngineError(RuntimeError):
    """The engine failed; a defect of physsim."""

class Frames:
    """Readings of frames that follow each other; `World.record` adds to them."""

    def __init__(
        self,
        *,
        bodies: Sequence[int] | None = None,
        momentum: bool = False,
        energy: bool = False,
        contacts: bool = False,
        joints: int = 0,
        springs: bool = False,
    ) -> None: ...
    def __len__(self) -> int: ...
    def take(self) -> dict[str, Any]: ...

class World:
    def __init__(self, model: Mapping[str, object]) -> None: ...
    def advance(self, steps: int, answer: _Answer | None = None) -> None: ...
    def record(
        self,
        frames: Frames,
        steps: int,
        every: int,
        last: int,
        rest_time: float,
        answer: _Answer | None = None,
    ) -> int: ...
    def keep(self, frames: Frames) -> None: ...
    def state(self) -> dict[str, Any]: ...
    def contacts(self) -> dict[str, npt.NDArray[Any]]: ...
    def events(self) -> dict[str, npt.NDArray[Any]]: ...
    def joints(self) -> dict[str, npt.NDArray[Any]]: ...
    def springs(self) -> dict[str, npt.NDArray[Any]]: ...
    def energies(self) -> dict[str, float]: ...
    def momentum(self) -> dict[str, npt.NDArray[np.float64]]: ...
    def solver(self) -> dict[str, Any]: ...
    def detect(self, margin: float, answer: _Answer | None = None) -> dict[str, npt.NDArray[Any]]: ...
    def needs_answer(self) -> bool: ...
    def save(self) -> bytes: ...
    def restore(self, bytes: bytes) -> None: ...
    def collide_pair(
        self,
        geom_a: int,
        pose_a: Sequence[float] | _Floats,
        geom_b: int,
        pose_b: Sequence[float] | _Floats,
        margin: float,
        answer: _Answer | None = None,
    ) -> dict[str, npt.NDArray[Any]]: ...
