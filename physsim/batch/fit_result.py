"""What came of a fit: estimates with their uncertainties, and the simulation beside the data."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from physsim.batch.fit_data import Floats
from physsim.batch.fit_load import Fit, Free
from physsim.batch.fit_residuals import Residuals, all_measured, sigmas_of


@dataclass(frozen=True)
class End:
    """Where one search ended: scaled values, half the sum of squares, and what the optimiser says."""

    u: Floats
    cost: float
    success: bool
    message: str


@dataclass(frozen=True)
class Estimate:
    """One value that was found, SI.

    deviation: its standard deviation; infinite when the data do not determine it. at_bound: whether it
    lies on min or max, where the deviation means little.
    """

    path: str
    value: float
    deviation: float
    unit: str
    start: float
    at_bound: bool


@dataclass(frozen=True)
class Compared:
    """A measured quantity and what the fit makes of it: times [s], values in SI, rms: root mean square
    difference; sigma: given, or estimated from the fit.
    """

    file: str
    quantity: str
    unit: str
    time: Floats
    measured: Floats
    fitted: Floats
    rms: float
    sigma: float


@dataclass(frozen=True)
class Found:
    """What came of a fit.

    correlation (P, P) of the estimates; cost: half the sum of squares of residuals in standard deviations;
    reduced: chi-squared per degree of freedom, None when sigma was not given; evaluations: simulations of all
    experiments; success, message: of the optimiser.
    """

    estimates: tuple[Estimate, ...]
    correlation: Floats
    compared: tuple[Compared, ...]
    cost: float
    reduced: float | None
    evaluations: int
    success: bool
    message: str


def judged(residuals: Residuals, fit: Fit, end: End) -> Found:
    """What the search has found, with the uncertainty of every estimate."""
    u = end.u
    values = residuals.values(u)
    series = residuals.simulate(values)
    r = residuals(u)
    freedom = max(len(r) - len(u), 1)
    given = all(one.sigma is not None for one in all_measured(fit))
    reduced = float(r @ r) / freedom
    covariance = _covariance(residuals.jacobian(u)) * (1.0 if given else reduced)
    at_bound = residuals.at_bound(u)
    deviation = np.sqrt(np.diag(covariance))
    return Found(
        tuple(_estimate(one, values[one.path], deviation[k], at_bound[k]) for k, one in enumerate(fit.free)),
        _correlation(covariance),
        tuple(_compared(fit, series, 1.0 if given else math.sqrt(reduced))),
        end.cost,
        reduced if given else None,
        residuals.evaluations,
        end.success,
        end.message,
    )


def _covariance(jacobian: Floats) -> Floats:
    """(JᵀJ)⁻¹; infinite on the diagonal for what the data do not determine.

    Press et al., Numerical Recipes, 3rd ed., section 15.6.
    """
    size = np.linalg.norm(jacobian, axis=0)
    scaled = jacobian / np.where(size > 0, size, 1.0)
    values, vectors = np.linalg.eigh(scaled.T @ scaled)
    weak = values < 1e-12 * values.max(initial=1e-300)
    inverse = (vectors / np.where(weak, np.inf, values)) @ vectors.T
    lost = (vectors[:, weak] ** 2).sum(axis=1) > 1e-6
    inverse = inverse / np.outer(np.where(size > 0, size, 1.0), np.where(size > 0, size, 1.0))
    inverse[lost, lost] = np.inf
    return np.asarray(inverse, np.float64)


def _correlation(covariance: Floats) -> Floats:
    size = np.sqrt(np.diag(covariance))
    with np.errstate(invalid="ignore"):
        found = covariance / np.outer(size, size)
    return np.asarray(np.where(np.isfinite(found), found, 0.0) + np.diag(~np.isfinite(np.diag(found)) * 1.0))


def _estimate(free: Free, value: float, deviation: float, at_bound: bool) -> Estimate:
    """The deviation of ln v is that of v divided by v."""
    spread = float(deviation) * (value if free.log else 1.0)
    return Estimate(free.path, value, spread, free.unit, free.start, at_bound)


def _compared(fit: Fit, series: list[Floats], factor: float) -> list[Compared]:
    names = [experiment.file for experiment in fit.experiments for _ in experiment.measured]
    return [
        Compared(
            name,
            one.quantity.text,
            one.quantity.kind.unit,
            one.time,
            one.values,
            values,
            float(np.sqrt(np.mean((values - one.values) ** 2))),
            sigma * factor,
        )
        for name, one, values, sigma in zip(names, all_measured(fit), series, sigmas_of(fit), strict=True)
    ]
