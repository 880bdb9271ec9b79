"""One body of a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from physsim.recording import body_dynamics, contact_choice
from physsim.recording.series import Array, Series, Table

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory


class BodyTrack:
    """One body of a trajectory: `track.position[10:20]`, `track.mass`, ..."""

    def __init__(self, trajectory: Trajectory, name: str) -> None:
        self.name = name
        self._trajectory = trajectory
        self._index = trajectory.index_of(name)

    @property
    def position(self) -> Series:
        """Of the body's own origin, (T, 3) m."""
        return self._trajectory.series("position", self._index)

    @property
    def orientation(self) -> Series:
        """Unit quaternion (w, x, y, z), body to world, (T, 4)."""
        return self._trajectory.series("orientation", self._index)

    @property
    def velocity(self) -> Series:
        """Of the centre of mass, (T, 3) m/s."""
        return self._trajectory.series("velocity", self._index)

    @property
    def angular_velocity(self) -> Series:
        """World axes, (T, 3) rad/s."""
        return self._trajectory.series("angular_velocity", self._index)

    @property
    def mass(self) -> float:
        """kg; infinite for a half-space."""
        return float(self._trajectory.values("mass")[self._index])

    @property
    def inertia(self) -> Array:
        """About the centre of mass, body axes, (3, 3) kg m2."""
        return np.asarray(self._trajectory.values("inertia")[self._index])

    @property
    def center_of_mass(self) -> Array:
        """From the body's origin, body axes, (3) m."""
        return np.asarray(self._trajectory.values("center_of_mass")[self._index])

    @property
    def material(self) -> str:
        return str(self._trajectory.values("material")[self._index])

    @property
    def fixed(self) -> bool:
        return bool(self._trajectory.values("fixed")[self._index])

    @property
    def kinetic_energy(self) -> Array:
        """Of translation and rotation, (T) J; 0 for a fixed body."""
        return body_dynamics.kinetic_energy(self)

    @property
    def momentum(self) -> Array:
        """m v, (T, 3) kg m/s; 0 for a fixed body."""
        return body_dynamics.momentum(self)

    @property
    def angular_momentum(self) -> Array:
        """About the body's own centre of mass, world axes, (T, 3) kg m2/s; 0 for a fixed body."""
        return body_dynamics.angular_momentum(self)

    @property
    def center(self) -> Array:
        """Where the centre of mass is, (T, 3) m."""
        return body_dynamics.center(self)

    @property
    def contact_force(self) -> Array:
        """Sum of the contact forces on it, in the step that ends at each frame, (T, 3) N.

        Raises NotInFile when contacts were not recorded.
        """
        return contact_choice.force_on(self._trajectory, self.name, slice(None))

    def contacts(self, other: str | None = None) -> Table:
        """The contact points that it takes part in, in all frames; with `other`, those of the two."""
        return self._trajectory.contacts(body=self.name, other=other)

    def impacts(self, other: str | None = None) -> Table:
        """The impacts that it takes part in, in the order of time; with `other`, those of the two."""
        return contact_choice.between(self._trajectory.events, self.name, other)

    def rest_time(self, speed: float = 1e-3, angular_speed: float = 1e-2) -> float | None:
        """The time [s] of the first frame from which it stays this slow [m/s], [rad/s] to the end; None when
        it moves in the last frame.
        """
        frame = body_dynamics.rest_frame(self, speed, angular_speed)
        return None if frame is None else float(self._trajectory.time[frame])
