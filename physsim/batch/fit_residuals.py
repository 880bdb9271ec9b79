"""Simulations with trial values, and how far they are from what was measured."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from physsim.batch.fit_data import Floats
from physsim.batch.fit_load import Experiment, Fit, Free, Measured
from physsim.errors import RunFailed
from physsim.recording.quantities import over_time
from physsim.simulation.watch import Wanted, watch

# What a residual counts, in standard deviations, where the simulation blows up.
PENALTY = 1e6
# Values this near to a bound, as a part of their range, are told to be at it.
AT_BOUND = 1e-6
Report = Callable[[int, float], None]
"""Called after each simulation of all experiments with their number so far and the best sum of squares."""


class Residuals:
    """(simulated - measured) / sigma of all data, as a function of the scaled values u.

    u is the value, or its logarithm where the fit says `scale: log`. evaluations: simulations so far.
    """

    def __init__(self, fit: Fit, report: Report | None) -> None:
        self._fit, self._report = fit, report
        self.free = fit.free
        self.evaluations = 0
        self._best = math.inf
        self._sigma = sigmas_of(fit)
        self._known: dict[bytes, Floats] = {}
        self.start, self.least, self.most = (
            np.array([_scaled(one, getattr(one, name)) for one in fit.free])
            for name in ("start", "least", "most")
        )

    def __call__(self, u: Floats) -> Floats:
        """(M), PENALTY everywhere when the run fails."""
        key = u.tobytes()
        if key not in self._known:
            self._known = {key: self._fresh(u)}
        return self._known[key]

    def _fresh(self, u: Floats) -> Floats:
        try:
            found = self.simulate(self.values(u))
        except RunFailed:
            return np.full(sum(len(one.values) for one in all_measured(self._fit)), PENALTY)
        off = [
            (values - one.values) / sigma
            for values, one, sigma in zip(found, all_measured(self._fit), self._sigma, strict=True)
        ]
        return np.clip(np.concatenate(off), -PENALTY, PENALTY)

    def jacobian(self, u: Floats) -> Floats:
        """(M, P) by differences to both sides, or as far as the bounds let them."""
        columns = []
        for k, step in enumerate(self.steps(u)):
            up, down = u.copy(), u.copy()
            up[k] = min(u[k] + step, self.most[k])
            down[k] = max(u[k] - step, self.least[k])
            columns.append((self._fresh(up) - self._fresh(down)) / (up[k] - down[k]))
        return np.stack(columns, axis=1)

    def steps(self, u: Floats) -> Floats:
        """Of the derivatives: a part of the range, or of the value where there is none."""
        span = self.most - self.least
        scale = np.where(np.isfinite(span), span, np.maximum(np.abs(u), 1e-3))
        return np.asarray(self._fit.spec.step * scale, np.float64)

    def values(self, u: Floats) -> dict[str, float]:
        """Values of the scene by path, SI."""
        return {one.path: math.exp(x) if one.log else float(x) for one, x in zip(self.free, u, strict=True)}

    def at_bound(self, u: Floats) -> list[bool]:
        """Of each value whether it lies on min or max, but for rounding."""
        near = self.steps(u) * AT_BOUND / self._fit.spec.step
        return [bool(found) for found in (u - self.least <= near) | (self.most - u <= near)]

    def simulate(self, values: dict[str, float]) -> list[Floats]:
        """What each measured quantity is in the simulation, at its times."""
        self.evaluations += 1
        found = [series for one in self._fit.experiments for series in simulated(self._fit, one, values)]
        if self._report is not None:
            off = zip(found, all_measured(self._fit), self._sigma, strict=True)
            self._best = min(self._best, sum(float((((v - m.values) / s) ** 2).sum()) for v, m, s in off))
            self._report(self.evaluations, self._best)
        return found


def simulated(fit: Fit, experiment: Experiment, values: dict[str, float]) -> list[Floats]:
    """One experiment with these values: each of its quantities at the times of the data.

    Every step is a frame; between two, straight lines. Raises SceneError, RunFailed.
    """
    from physsim.model import compile_scene  # noqa: PLC0415, slow to import

    scene = fit.base.scene({**experiment.changes, **values, "expect": []})
    record = scene.spec.record.model_copy(update={"every": scene.spec.simulation.timestep})
    scene = replace(scene, spec=scene.spec.model_copy(update={"record": record}))
    run = watch(scene, compile_scene(scene), Wanted(tuple(one.quantity for one in experiment.measured)))
    if run.status == "failed":
        raise RunFailed(f"{experiment.file}: {run.status_detail}")
    series = [
        np.asarray(over_time(run.as_trajectory(), one.quantity), np.float64) for one in experiment.measured
    ]
    return [
        np.interp(one.time, run.time, values) for one, values in zip(experiment.measured, series, strict=True)
    ]


def all_measured(fit: Fit) -> list[Measured]:
    """Every measured quantity of every experiment, in order."""
    return [one for experiment in fit.experiments for one in experiment.measured]


def sigmas_of(fit: Fit) -> list[float]:
    """Of one value of each measured quantity: as given, else a hundredth of its spread in all experiments,
    so that quantities of any unit count alike.
    """
    spread: dict[str, float] = {}
    for one in all_measured(fit):
        name = one.quantity.text
        spread[name] = max(spread.get(name, 0.0), float(np.ptp(one.values)))
    return [
        one.sigma if one.sigma is not None else 0.01 * spread[one.quantity.text] or 1.0
        for one in all_measured(fit)
    ]


def _scaled(free: Free, value: float) -> float:
    """u of a value; a bound of nothing or less has no logarithm."""
    if not free.log:
        return value
    return math.log(value) if value > 0 else -math.inf
