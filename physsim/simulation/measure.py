"""From the engine's frames to the rows of the trajectory file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from physsim._engine import Frames
from physsim.recording.block import Block, joined
from physsim.recording.orientation import rotated

if TYPE_CHECKING:
    from physsim.model import Model

Floats = NDArray[np.float64]
_OF_BODIES = ("orientation", "velocity", "angular_velocity")
_IN_THE_FILE = {"velocity_before": "relative_velocity_before", "velocity_after": "relative_velocity_after"}


class Measure:
    """Keeps frames in the engine while it steps, and turns them into rows by dataset path."""

    def __init__(self, model: Model) -> None:
        record, mechanics = model.spec.record, model.mechanics
        self._center = np.asarray(model.center_of_mass)
        self._timestep = float(model.spec.simulation.timestep)
        # The engine's joints are those of the scene and then the stops of springs, which are not recorded.
        self.frames = Frames(
            momentum=True,
            energy=bool(record.energy),
            contacts=bool(record.contacts),
            joints=len(mechanics.joints.names) if record.joints else 0,
            springs=bool(record.joints and mechanics.springs.names),
        )

    def take(self, world: Any) -> Block:
        """What has been kept since the last call, and impacts up to now."""
        found, more = self.frames.take(), world.events()
        bodies, step = found.pop("bodies"), found.pop("step")
        events, contacts = found.pop("events"), found.pop("contacts", None)
        rows = {
            "time": step * self._timestep,
            "step": step,
            "position": origins_over_time(bodies["position"], bodies["orientation"], self._center),
            **{name: bodies[name] for name in _OF_BODIES},
            **{f"{group}/{name}": rows for group, some in found.items() for name, rows in some.items()},
        }
        return Block(
            rows if len(step) else {},
            contacts and {_path(name): some for name, some in contacts.items()},
            found["solver"]["contact_count"],
            {f"events/{name}": some for name, some in joined([events, more]).items()},
        )


def _path(name: str) -> str:
    """Of a column of contacts in the file."""
    return f"contacts/{_IN_THE_FILE.get(name, name)}"


def origins_over_time(center: Floats, orientation: Floats, offset: Floats) -> Floats:
    """`origins` of frames, (T, N, 3)."""
    if not offset.any():
        return center
    frames = len(center)
    found = origins(center.reshape(-1, 3), orientation.reshape(-1, 4), np.tile(offset, (frames, 1)))
    return found.reshape(center.shape)


def origins(center: Floats, orientation: Floats, offset: Floats) -> Floats:
    """Body origins (N, 3) from centres of mass (N, 3), quaternions (N, 4) and offsets in body axes: x -
    R(q) c.
    """
    found = np.array(center)
    apart = np.flatnonzero(offset.any(axis=1))
    if len(apart):
        found[apart] -= rotated(orientation[apart], offset[apart])
    return found
