"""One module per engine: how a scene of the comparison is built, stepped and read there.

Each has `SETTINGS`, named keyword arguments of which `default` is what the engine ships with, `version()`,
and a class `World(scene, timestep, threads, **setting)`. Sleeping is off in all of them. What an engine
cannot do raises `Unable`.
"""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Protocol

from benchmarks.scene import Floats

State = tuple[Floats, Floats, Floats, Floats]
PEERS = ("physsim", "box3d", "rapier", "jolt", "physx", "mujoco", "bullet")


class Unable(Exception):
    """This engine has no way to do that, or is not installed."""


class Stepping(Protocol):
    """A world under way."""

    def step(self, count: int) -> None:
        """Make `count` steps."""

    def state(self) -> State:
        """Centres of mass (N, 3), orientations (N, 4), velocities and spins (N, 3), in world axes."""


def peer(name: str) -> ModuleType:
    """The adapter of an engine; raises Unable when it is not installed."""
    try:
        return importlib.import_module(f"benchmarks.peers.{name}")
    except ImportError as error:
        raise Unable(f"not installed ({error})") from error
