"""Bodies as they stand at the start, by name: what springs, joints and forces are tied to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.model import rotation
from physsim.model.inertia import rotated
from physsim.model.rotation import FloatArray

WORLD_NAME = "world"


@dataclass(frozen=True)
class Placed:
    """One body at the start.

    number: its row, -1 for the world; position (3,) of its origin and center (3,) of its mass, in the world
    [m]; offset (3,) of the centre of mass from the origin, body axes [m]; orientation (4,) and turn (3, 3),
    body -> world; inverse_mass [1/kg] and inverse_inertia (3, 3), world axes [1/(kg m^2)], both 0 when
    nothing moves it.
    """

    number: int
    position: FloatArray
    center: FloatArray
    offset: FloatArray
    orientation: FloatArray
    turn: FloatArray
    inverse_mass: float
    inverse_inertia: FloatArray

    def arm_of_own(self, point: Sequence[float]) -> FloatArray:
        """From the centre of mass, body axes, to a point of the body's own frame [m]."""
        return np.asarray(point, dtype=np.float64) - self.offset

    def arm_of_world(self, point: Sequence[float] | FloatArray) -> FloatArray:
        """From the centre of mass, body axes, to a point of the world [m]."""
        arm: FloatArray = self.turn.T @ (np.asarray(point, dtype=np.float64) - self.center)
        return arm

    def place(self, arm: FloatArray) -> FloatArray:
        """Where in the world the end of an arm is [m]."""
        found: FloatArray = self.center + self.turn @ arm
        return found

    def axis_of_world(self, direction: Sequence[float] | FloatArray) -> FloatArray:
        """A direction of the world in body axes."""
        turned: FloatArray = self.turn.T @ np.asarray(direction, dtype=np.float64)
        return turned

    def frame_of_world(self, frame: FloatArray) -> FloatArray:
        """A frame (quaternion, frame -> world) as frame -> body axes."""
        return rotation.product(rotation.conjugate(self.orientation), frame)

    def mobility(self, arm: FloatArray, direction: FloatArray) -> float:
        """1/m + (r x n) . I^-1 (r x n) [1/kg]: acceleration along n by a unit force along n at the arm's end.

        arm in body axes, direction n in world axes. The part of one body in the effective mass K of the
        formula sheet, section 2.
        """
        turning = np.cross(self.turn @ arm, direction)
        return float(self.inverse_mass + turning @ self.inverse_inertia @ turning)

    def turning_mobility(self, axis: FloatArray) -> float:
        """n . I^-1 n [1/(kg m^2)]: angular acceleration about n, a world axis, by a unit torque about it."""
        return float(axis @ self.inverse_inertia @ axis)


WORLD = Placed(
    number=-1,
    position=np.zeros(3),
    center=np.zeros(3),
    offset=np.zeros(3),
    orientation=np.array(rotation.IDENTITY),
    turn=np.eye(3),
    inverse_mass=0.0,
    inverse_inertia=np.zeros((3, 3)),
)


@dataclass(frozen=True)
class Stand:
    """Every body at the start, N rows: origins (N, 3) and orientations (N, 4) in the world, mass (N,),
    inertia (N, 3, 3) and centres of mass (N, 3) in body axes, and which are fixed (N,).
    """

    names: tuple[str, ...]
    fixed: npt.NDArray[np.bool_]
    mass: FloatArray
    inertia: FloatArray
    center_of_mass: FloatArray
    position: FloatArray
    orientation: FloatArray


class Placement:
    """Looks bodies up by name; `world` is one of them."""

    def __init__(self, stand: Stand) -> None:
        self._stand = stand
        self._numbers = {name: number for number, name in enumerate(stand.names)}
        self._placed: dict[str, Placed] = {WORLD_NAME: WORLD}

    @property
    def names(self) -> tuple[str, ...]:
        """Of all bodies, in their order; the world is not among them."""
        return self._stand.names

    def __getitem__(self, name: str) -> Placed:
        """The body of that name. Raises KeyError."""
        if name not in self._placed:
            self._placed[name] = self._place(self._numbers[name])
        return self._placed[name]

    def moves(self, name: str) -> bool:
        """Whether forces can move the body of that name."""
        return not self._stand.fixed[self._numbers[name]]

    def _place(self, number: int) -> Placed:
        stand = self._stand
        turn = rotation.matrix(stand.orientation[number])
        offset, fixed = stand.center_of_mass[number], stand.fixed[number]
        inverse = np.zeros((3, 3)) if fixed else np.linalg.inv(stand.inertia[number])
        return Placed(
            number=number,
            position=stand.position[number],
            center=stand.position[number] + turn @ offset,
            offset=offset,
            orientation=stand.orientation[number],
            turn=turn,
            inverse_mass=0.0 if fixed else 1.0 / float(stand.mass[number]),
            inverse_inertia=rotated(inverse, turn),
        )
