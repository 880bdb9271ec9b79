"""One body of a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from physsim.recording.series import Array, Series

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
