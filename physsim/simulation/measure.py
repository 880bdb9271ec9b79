"""From the engine's state to the rows of the trajectory file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from physsim.recording.orientation import rotated

if TYPE_CHECKING:
    from physsim.model import Model

Floats = NDArray[np.float64]
Rows = dict[str, Any]

_AS_THE_ENGINE_SAYS = (
    "body_a",
    "body_b",
    "position",
    "normal",
    "depth",
    "normal_impulse",
    "tangential_impulse",
    "sliding",
)

_OF_THE_SOLVER = ("residual", "iterations", "contact_count", "fallbacks")


class Measure:
    """Turns what a world hands out into rows by dataset path; knows what of the model that takes."""

    def __init__(self, model: Model) -> None:
        self._center = np.asarray(model.center_of_mass)
        self._timestep = float(model.spec.simulation.timestep)
        self._pair_rows = pair_rows(len(model.material_names))
        self._energy = bool(model.spec.record.energy)
        recorded = model.spec.record.joints
        self._joints = len(model.mechanics.joints.names) if recorded else 0
        self._springs = len(model.mechanics.springs.names) if recorded else 0

    def frame(self, world: Any) -> Rows:
        """One row of every dataset over time but `time` and `step`.

        The engine's joints are those of the scene and then the stops of springs, which are not recorded.
        """
        state, solver = world.state(), world.solver()
        rows: Rows = {
            "position": origins(state["position"], state["orientation"], self._center),
            "orientation": state["orientation"],
            "velocity": state["velocity"],
            "angular_velocity": state["angular_velocity"],
            **{f"solver/{name}": solver[name] for name in _OF_THE_SOLVER},
            **self.momentum(world),
        }
        if self._energy:
            rows |= {f"energy/{name}": value for name, value in world.energies().items()}
        if self._joints:
            rows |= {f"joints/{name}": row[: self._joints] for name, row in world.joints().items()}
        if self._springs:
            rows |= {f"springs/{name}": row for name, row in world.springs().items()}
        return rows

    def contacts(self, world: Any) -> Rows:
        """The contact points of the last step, one row each.

        Impulse j on A = normal and tangential part together; force = j / timestep, its mean over the step.
        """
        found = world.contacts()
        impulse = found["normal_impulse"][:, None] * found["normal"] + found["tangential_impulse"]
        return {
            **{f"contacts/{name}": found[name] for name in _AS_THE_ENGINE_SAYS},
            "contacts/impulse": impulse,
            "contacts/force": impulse / self._timestep,
            "contacts/relative_velocity_before": found["velocity_before"],
            "contacts/relative_velocity_after": found["velocity_after"],
            "contacts/pair": self._pair_rows[found["material_a"], found["material_b"]],
        }

    @staticmethod
    def events(world: Any) -> Rows:
        """Impacts since the last call, one row each."""
        return {f"events/{name}": rows for name, rows in world.events().items()}

    @staticmethod
    def momentum(world: Any) -> Rows:
        """P = sum m v and, about the world's origin, L = sum (m x × v + L_body), over moving bodies.

        Goldstein, Classical Mechanics, 3rd ed., eqs. 1.26 and 1.28.
        """
        return {f"momentum/{name}": value for name, value in world.momentum().items()}


def origins(center: Floats, orientation: Floats, offset: Floats) -> Floats:
    """Body origins (N, 3) from centres of mass (N, 3), quaternions (N, 4) and offsets in body axes: x -
    R(q) c.
    """
    found = np.array(center)
    apart = np.flatnonzero(offset.any(axis=1))
    if len(apart):
        found[apart] -= rotated(orientation[apart], offset[apart])
    return found


def pair_rows(materials: int) -> NDArray[np.int32]:
    """Row of /pairs for each ordered pair of materials, (M, M): (0, 0), (0, 1), ..., (1, 1), (1, 2), ..."""
    rows = np.zeros((materials, materials), np.int32)
    first, second = np.triu_indices(materials)
    rows[first, second] = rows[second, first] = np.arange(len(first))
    return rows
