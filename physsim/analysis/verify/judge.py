"""Trajectories against formulas: greatest error, order of convergence, and whether both are as they should
be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import yaml

from physsim.analysis.verify.case import Array, Case, Check, Values
from physsim.recording import Trajectory
from physsim.recording.quantities import over_time
from physsim.scene.quantity import parse_quantity

ORDER_TOLERANCE = 0.1
"""How far a measured order may be from the published one."""


@dataclass(frozen=True)
class Verdict:
    """One check after its runs.

    theory, measured: where they differ most, in the run with the smallest timestep. errors: of every run, as
    `Check.within` counts them; order: slope of their logarithms over those of the timesteps [s]; None for
    one run. time (T) [s], curve and law: what was compared in that last run.
    """

    case: Case
    check: Check
    theory: float
    measured: float
    timesteps: tuple[float, ...]
    errors: tuple[float, ...]
    order: float | None
    time: Array
    curve: Array
    law: Array

    @property
    def error(self) -> float:
        """Of the run with the smallest timestep."""
        return self.errors[-1]

    @property
    def passed(self) -> bool:
        """Error and order as they should be; never when something is not a number."""
        wanted = self.check.order
        in_order = wanted is None or (self.order is not None and abs(self.order - wanted) <= ORDER_TOLERANCE)
        return self.error <= self.check.within and in_order


def judge(case: Case, runs: Sequence[Trajectory]) -> list[Verdict]:
    """Every check of a case. runs: one per timestep, in the order of `case.runs()`.

    Raises NotInFile when a run did not record what a check asks for.
    """
    values = [scene_values(run) for run in runs]
    return [_judged(case, check, runs, values) for check in case.checks]


def scene_values(run: Trajectory) -> Values:
    """The scene's parameters [SI] and its timestep [s], as the file tells them."""
    scene = yaml.load(run.provenance["scene_resolved"], getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return {**scene.get("parameters", {}), "timestep": scene["simulation"]["timestep"]}


def _judged(case: Case, check: Check, runs: Sequence[Trajectory], values: Sequence[Values]) -> Verdict:
    compared = [_compared(check, run, known) for run, known in zip(runs, values, strict=True)]
    errors = tuple(_error(check, curve, law) for curve, law in compared)
    timesteps = tuple(known["timestep"] for known in values)
    curve, law = compared[-1]
    worst = np.unravel_index(np.argmax(np.abs(curve - law)), law.shape)
    return Verdict(
        case,
        check,
        float(law[worst]),
        float(curve[worst]),
        timesteps,
        errors,
        order_of(timesteps, errors),
        runs[-1].time,
        curve,
        law,
    )


def _compared(check: Check, run: Trajectory, values: Values) -> tuple[Array, Array]:
    """What came and what should have come, of one shape; NaN where the run gave more or fewer values."""
    found = check.measure
    came = over_time(run, parse_quantity(found)) if isinstance(found, str) else found(run)
    curve = np.atleast_1d(np.asarray(came, np.float64))
    law = np.atleast_1d(np.asarray(check.theory(values, run.time), np.float64))
    return curve if curve.shape == law.shape else np.full(law.shape, np.nan), law


def _error(check: Check, curve: Array, law: Array) -> float:
    """The greatest deviation; inf when a value is not finite."""
    if not np.isfinite(curve).all():
        return float("inf")
    scale = np.abs(law).max() if check.relative else 1.0
    return float(np.abs(curve - law).max() / scale)


def order_of(timesteps: Sequence[float], errors: Sequence[float]) -> float | None:
    """Slope of log(error) over log(timestep), by least squares; None for one timestep or an error of 0 or
    inf.
    """
    if len(timesteps) < 2 or not all(0 < error < np.inf for error in errors):
        return None
    return float(np.polyfit(np.log(timesteps), np.log(errors), 1)[0])
