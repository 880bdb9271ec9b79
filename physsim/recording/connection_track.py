"""One joint or spring of a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from physsim.recording.safe import guarded
from physsim.recording.series import Array, Series

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory

_NO_BODY = "world"


class _Connection:
    """What joints and springs have in common."""

    _group: str
    _axis: str

    def __init__(self, trajectory: Trajectory, name: str) -> None:
        self.name = name
        self._trajectory = trajectory
        self._row = trajectory.row_of(self._axis, name)

    @property
    def type(self) -> str:
        """As in the scene: `hinge`, `linear`, ..."""
        return str(self._value("type"))

    @property
    def between(self) -> tuple[str, str]:
        """Names of body A and body B; `world` is one."""
        rows = [int(self._value(f"body_{end}")) for end in ("a", "b")]
        with guarded(self._trajectory.path):
            a, b = (self._trajectory.body_names[row] if row >= 0 else _NO_BODY for row in rows)
        return a, b

    @property
    def anchors(self) -> Array:
        """Where it is tied, each in its body's own frame, (2, 3) m."""
        return np.array([self._value(f"anchor_{end}") for end in ("a", "b")])

    def _series(self, name: str) -> Series:
        return self._trajectory.series(f"{self._group}/{name}", self._row)

    def _value(self, name: str) -> Array:
        return np.asarray(self._trajectory.values(f"{self._group}/{name}")[self._row])


class JointTrack(_Connection):
    """One joint of a trajectory: `track.force[10:20]`, `track.coordinate[-1]`, ..."""

    _group, _axis = "joints", "joint"

    @property
    def force(self) -> Series:
        """Reaction on A, world axes, (T, 3) N."""
        return self._series("force")

    @property
    def torque(self) -> Series:
        """Reaction on A about its anchor, world axes, (T, 3) N m."""
        return self._series("torque")

    @property
    def coordinate(self) -> Series:
        """Angle [rad] or travel [m] of B seen from A, (T); NaN for a joint without one."""
        return self._series("coordinate")

    @property
    def coordinate_2(self) -> Series:
        """The second coordinate, (T); NaN for a joint without one."""
        return self._series("coordinate_2")

    @property
    def coordinate_3(self) -> Series:
        """The third coordinate, (T); NaN for a joint without one."""
        return self._series("coordinate_3")

    @property
    def units(self) -> tuple[str, str, str]:
        """Units of the three coordinates: `rad`, `m`, or nothing where the joint has none."""
        first, second, third = (
            str(self._value(f"{name}_unit")) for name in ("coordinate", "coordinate_2", "coordinate_3")
        )
        return first, second, third

    @property
    def violation(self) -> Series:
        """How far apart what the joint holds together is, (T) m."""
        return self._series("violation")

    @property
    def angular_violation(self) -> Series:
        """How far turned what the joint holds parallel is, (T) rad."""
        return self._series("angular_violation")

    @property
    def broken(self) -> Series:
        """1 once the joint has broken, (T)."""
        return self._series("broken")


class SpringTrack(_Connection):
    """One spring of a trajectory: `track.length[10:20]`, `track.force[-1]`, ..."""

    _group, _axis = "springs", "spring"

    @property
    def length(self) -> Series:
        """(T) m; of a torsional spring its angle [rad]."""
        return self._series("length")

    @property
    def force(self) -> Series:
        """Tension (T) N; of a torsional spring the torque on A about its axis [N m]."""
        return self._series("force")

    @property
    def units(self) -> tuple[str, str]:
        """Units of length and force."""
        return str(self._value("length_unit")), str(self._value("force_unit"))
