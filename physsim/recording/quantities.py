"""Values of named quantities (`bodies.crate.position.z`, `energy.total`) over the frames of a trajectory."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from physsim.recording import body_dynamics, contact_choice
from physsim.recording.layout import ENERGY_STATE
from physsim.recording.series import Array

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory
    from physsim.scene.quantity import Quantity

_VECTOR_OF = {"speed": "velocity", "angular_speed": "angular_velocity"}
_RECORDED_AS = {"angle": "length", "torque": "force"}
_FOLLOWS = {
    "kinetic_energy": body_dynamics.kinetic_energy,
    "momentum": body_dynamics.momentum,
    "angular_momentum": body_dynamics.angular_momentum,
}
_SUMS = {"total": ENERGY_STATE, "kinetic": ("kinetic_translational", "kinetic_rotational")}


def over_time(trajectory: Trajectory, quantity: Quantity, frames: slice = slice(None)) -> Array:
    """(T) for a scalar or one component, (T, 3) or (T, 4) for a whole vector; SI.

    frames: which of them; only these are read. Raises NotInFile when the trajectory has no such body or did
    not record the group.
    """
    values = _GROUPS[quantity.group](trajectory, quantity, frames)
    return values if quantity.index is None else values[:, quantity.index]


def _of_body(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    name = str(quantity.name)
    if quantity.field == "contact_force":
        return contact_choice.force_on(trajectory, name, frames)
    if quantity.field in _FOLLOWS:
        return _FOLLOWS[quantity.field](trajectory.body(name), frames)
    field = _VECTOR_OF.get(quantity.field, quantity.field)
    found: Array = trajectory.series(field, trajectory.index_of(name))[frames]
    return found if field == quantity.field else np.asarray(np.linalg.norm(found, axis=1))


def _of_spring(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    """Length and force stand for the angle and the torque of torsional springs."""
    field = _RECORDED_AS.get(quantity.field, quantity.field)
    found: Array = getattr(trajectory.spring(str(quantity.name)), field)[frames]
    return found


def _of_joint(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    joint = trajectory.joint(str(quantity.name))
    if quantity.field == "reaction":
        return np.asarray(np.linalg.norm(joint.force[frames], axis=1))
    found: Array = getattr(joint, quantity.field)[frames]
    return found


def _of_energy(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    """A term that an older file lacks is left out of a sum."""
    there = {column.name for column in trajectory.columns_in("energy")}
    terms = [term for term in _SUMS.get(quantity.field, ()) if term in there] or [quantity.field]
    return np.asarray(sum(trajectory.series(f"energy/{term}")[frames] for term in terms))


def _of_momentum(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    found: Array = trajectory.series(f"momentum/{quantity.field}")[frames]
    return found


def _of_solver(trajectory: Trajectory, quantity: Quantity, frames: slice) -> Array:
    field = "contact_count" if quantity.group == "contacts" else quantity.field
    found: Array = trajectory.series(f"solver/{field}")[frames]
    return found


_GROUPS: dict[str, Callable[[Trajectory, Quantity, slice], Array]] = {
    "time": lambda trajectory, _, frames: trajectory.time[frames],
    "bodies": _of_body,
    "springs": _of_spring,
    "joints": _of_joint,
    "energy": _of_energy,
    "momentum": _of_momentum,
    "contacts": _of_solver,
    "solver": _of_solver,
}
