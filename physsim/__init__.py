"""physsim: rigid-body scenes in YAML, trajectories in HDF5, numbers that can be defended."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    # From their own modules: `run` and `sweep` are names of modules, too, and mypy takes them for those.
    from physsim.batch.sweep import sweep
    from physsim.recording import Trajectory, open_trajectory
    from physsim.scene import Scene
    from physsim.scene import load_scene as load
    from physsim.simulation.run import run

__version__ = "0.1.0"
__all__ = ["Scene", "Trajectory", "load", "open_trajectory", "run", "sweep"]

# Where each public name lives: imported at first use, so that `import physsim` stays quick.
_HOMES = {
    "Scene": ("physsim.scene", "Scene"),
    "load": ("physsim.scene", "load_scene"),
    "run": ("physsim.simulation", "run"),
    "sweep": ("physsim.batch", "sweep"),
    "Trajectory": ("physsim.recording", "Trajectory"),
    "open_trajectory": ("physsim.recording", "open_trajectory"),
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'physsim' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(importlib.import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
