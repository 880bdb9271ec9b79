"""Values of named quantities (`bodies.crate.position.z`, `energy.total`) over the frames of a trajectory."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from physsim.recording.layout import ENERGY_STATE
from physsim.recording.series import Array

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory
    from physsim.scene.quantity import Quantity

_VECTOR_OF = {"speed": "velocity", "angular_speed": "angular_velocity"}
_RECORDED_AS = {"angle": "length", "torque": "force"}


def over_time(trajectory: Trajectory, quantity: Quantity) -> Array:
    """(T) for a scalar or one component, (T, 3) or (T, 4) for a whole vector; SI.

    Raises NotInFile when the trajectory has no such body or did not record the group.
    """
    values = _GROUPS[quantity.group](trajectory, quantity)
    return values if quantity.index is None else values[:, quantity.index]


def _of_body(trajectory: Trajectory, quantity: Quantity) -> Array:
    field = _VECTOR_OF.get(quantity.field, quantity.field)
    found: Array = trajectory.series(field, trajectory.index_of(str(quantity.name)))[:]
    return found if field == quantity.field else np.asarray(np.linalg.norm(found, axis=1))


def _of_spring(trajectory: Trajectory, quantity: Quantity) -> Array:
    """Length and force stand for the angle and the torque of torsional springs."""
    field = _RECORDED_AS.get(quantity.field, quantity.field)
    found: Array = getattr(trajectory.spring(str(quantity.name)), field)[:]
    return found


def _of_joint(trajectory: Trajectory, quantity: Quantity) -> Array:
    joint = trajectory.joint(str(quantity.name))
    if quantity.field == "reaction":
        return np.asarray(np.linalg.norm(joint.force[:], axis=1))
    found: Array = getattr(joint, quantity.field)[:]
    return found


def _of_energy(trajectory: Trajectory, quantity: Quantity) -> Array:
    energy = trajectory.energy
    if quantity.field == "total":
        return np.asarray(sum(energy[name] for name in ENERGY_STATE if name in energy))
    if quantity.field == "kinetic":
        return np.asarray(energy["kinetic_translational"] + energy["kinetic_rotational"])
    return energy[quantity.field]


_GROUPS: dict[str, Callable[[Trajectory, Quantity], Array]] = {
    "time": lambda trajectory, _: trajectory.time,
    "bodies": _of_body,
    "springs": _of_spring,
    "joints": _of_joint,
    "energy": _of_energy,
    "momentum": lambda trajectory, quantity: trajectory.momentum[quantity.field],
    "contacts": lambda trajectory, _: trajectory.solver["contact_count"],
    "solver": lambda trajectory, quantity: trajectory.solver[quantity.field],
}
