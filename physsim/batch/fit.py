"""The search for values that match the data best, by scipy's optimisers."""

# ruff: noqa: PLC0415  scipy.optimize is slow to import

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from physsim.batch.fit_data import Floats
from physsim.batch.fit_load import Fit
from physsim.batch.fit_residuals import Report, Residuals
from physsim.batch.fit_result import End, Found, judged

_RHO: dict[str, Callable[[Floats], Floats]] = {
    "linear": lambda z: z,
    "soft_l1": lambda z: 2 * (np.sqrt(1 + z) - 1),
    "huber": lambda z: np.where(z <= 1, z, 2 * np.sqrt(z) - 1),
    "cauchy": np.log1p,
}


def search(fit: Fit, report: Report | None = None) -> Found:
    """Finds the values that match the data best.

    Raises SceneError, RunFailed when the scene cannot be simulated with the values that the search starts
    from, Interrupted on Ctrl-C.
    """
    residuals = Residuals(fit, report)
    residuals.simulate(residuals.values(residuals.start))
    found = min(
        (_descend(residuals, fit, point) for point in _starts(residuals, fit)), key=lambda one: one.cost
    )
    return judged(residuals, fit, found)


def _starts(residuals: Residuals, fit: Fit) -> list[Floats]:
    """The given start, and more points of a Latin hypercube over the bounds."""
    if fit.spec.starts == 1:
        return [residuals.start]
    from scipy.stats import qmc

    cube = qmc.LatinHypercube(len(fit.free), rng=np.random.default_rng(fit.spec.seed)).random(
        fit.spec.starts - 1
    )
    return [residuals.start, *(residuals.least + cube * (residuals.most - residuals.least))]


def _descend(residuals: Residuals, fit: Fit, start: Floats) -> End:
    if fit.spec.method == "nelder_mead":
        return _nelder_mead(residuals, fit, start)
    if fit.spec.method == "differential_evolution":
        start = _best_of_all(residuals, fit)
    return _least_squares(residuals, fit, start)


def _least_squares(residuals: Residuals, fit: Fit, start: Floats) -> End:
    """Trust-region reflective; Branch, Coleman and Li (1999)."""
    from scipy.optimize import least_squares

    inside = _inside(residuals, start)
    per_point = 1 + 2 * len(start)
    done = least_squares(
        residuals,
        inside,
        jac=residuals.jacobian,
        bounds=(residuals.least, residuals.most),
        x_scale=residuals.steps(inside) / fit.spec.step,
        loss=fit.spec.loss,
        max_nfev=max(1, fit.spec.evaluations // (per_point * fit.spec.starts)),
    )
    return End(done.x, float(done.cost), bool(done.success), str(done.message))


def _nelder_mead(residuals: Residuals, fit: Fit, start: Floats) -> End:
    """The simplex of Nelder and Mead (1965), for what has no derivatives."""
    from scipy.optimize import minimize

    done = minimize(
        lambda u: cost_of(residuals(u), fit.spec.loss),
        _inside(residuals, start),
        method="Nelder-Mead",
        bounds=list(zip(residuals.least, residuals.most, strict=True)),
        options={"maxfev": max(1, fit.spec.evaluations // fit.spec.starts), "xatol": 1e-8, "fatol": 1e-8},
    )
    return End(done.x, float(done.fun), bool(done.success), str(done.message))


def _best_of_all(residuals: Residuals, fit: Fit) -> Floats:
    """Storn and Price (1997)."""
    from scipy.optimize import differential_evolution

    size = 10 * len(fit.free)
    done = differential_evolution(
        lambda u: cost_of(residuals(u), fit.spec.loss),
        list(zip(residuals.least, residuals.most, strict=True)),
        rng=np.random.default_rng(fit.spec.seed),
        popsize=10,
        maxiter=max(1, min(50, fit.spec.evaluations // size)),
        tol=1e-3,
        polish=False,
        x0=residuals.start,
    )
    return np.asarray(done.x, np.float64)


def cost_of(r: Floats, loss: str) -> float:
    """Half the sum of rho(r^2), as scipy's least_squares counts it."""
    return 0.5 * float(np.sum(_RHO[loss](r**2)))


def _inside(residuals: Residuals, u: Floats) -> Floats:
    """The point, moved off the bounds by a step of the derivatives."""
    step = residuals.steps(u)
    return np.asarray(np.clip(u, residuals.least + step, residuals.most - step), np.float64)
