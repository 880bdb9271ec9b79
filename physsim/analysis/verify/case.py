"""What a case is: a scene, the changes under which it is run, and what is compared with which formula."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from physsim.recording import Trajectory

Array = NDArray[np.float64]
Values = Mapping[str, float]
"""The `parameters` of the scene in SI, and its `timestep` [s]."""
Measure = Callable[[Trajectory], Array]
"""What the run gave: one row per frame, or any other array that the theory gives too."""
Theory = Callable[[Values, Array], Array]
"""What the formula gives, from the scene's values and the times of the frames (T) [s]."""

BARE = {"expect": [], "record.energy": False, "record.contacts": False}
FOLDER = Path(__file__).resolve().parents[1] / "cases"


@dataclass(frozen=True)
class Check:
    """One comparison of a run with a formula.

    name: what is compared, in few words; unit: SI. measure: the name of a quantity (as in `expect`), or a
    function of the trajectory. within: the greatest error, as a part of the greatest theoretical value, or
    in `unit` when not `relative`; with several timesteps it holds for the smallest. order: the power of
    the timestep with which the error must fall, to 0.1; None when it is not asked for.
    """

    name: str
    unit: str
    measure: str | Measure
    theory: Theory
    within: float
    order: float | None = None
    relative: bool = True


@dataclass(frozen=True)
class Case:
    """Runs of one scene, and what is compared.

    name: FORMULA or FORMULA.VARIANT; scene: the file's name in `physsim/analysis/cases`, without `.yaml`.
    changes: values that differ from the scene as written. timesteps: [s], falling; none: the scene's own.
    """

    name: str
    scene: str
    checks: tuple[Check, ...]
    changes: Mapping[str, Any] = field(default_factory=dict)
    timesteps: tuple[float, ...] = ()

    def runs(self) -> list[dict[str, Any]]:
        """The changes of each run, one per timestep; refined runs write motions and joints only, which is
        quicker.
        """
        if not self.timesteps:
            return [dict(self.changes)]
        return [{**self.changes, **BARE, "simulation.timestep": timestep} for timestep in self.timesteps]


@dataclass(frozen=True)
class Formula:
    """A row of the formula sheet.

    name: what `--case` takes; section: of the sheet, 1 to 8, or 9 for what is not on it; title: in words;
    equation: as text; source: author, year, equation. says: what the scene shows, for the page in the docs.
    """

    name: str
    section: int
    title: str
    equation: str
    source: str
    says: str
    cases: tuple[Case, ...]

    @property
    def scenes(self) -> tuple[str, ...]:
        """The scenes of the cases, each once."""
        return tuple(dict.fromkeys(case.scene for case in self.cases))


def scene_file(scene: str) -> Path:
    """The file of a case's scene."""
    return FOLDER / f"{scene}.yaml"
