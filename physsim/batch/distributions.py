"""Points of a design and the values that they stand for.

Every method gives points u in the unit cube; each coordinate becomes a value by the inverse of its
distribution function (Devroye, "Non-Uniform Random Variate Generation" (1986), section II.2), so that a
Latin hypercube and Sobol points keep their structure. The values are computed once, where the sweep starts,
and sent out as numbers: no worker draws anything.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from physsim.batch.spec.axes import LogNormal, LogUniform, Normal, Uniform

Floats = NDArray[np.float64]
# The distribution functions of a normal are infinite at 0 and 1.
LEAST = 2.0**-53


def points(method: str, count: int, dimensions: int, seed: list[int]) -> Floats:
    """(count, dimensions) points in the open unit cube; the same for the same seed.

    random: PCG64; latin_hypercube: McKay, Beckman & Conover (1979); sobol: Owen-scrambled Sobol points
    (Joe & Kuo 2008; Owen 1998), the two latter by scipy.stats.qmc.
    """
    generator = np.random.default_rng(seed)
    if method == "random":
        found = generator.random((count, dimensions))
    else:
        found = _low_discrepancy(method, count, dimensions, generator)
    return np.clip(found, LEAST, 1 - LEAST)


def _low_discrepancy(method: str, count: int, dimensions: int, generator: np.random.Generator) -> Floats:
    import warnings  # noqa: PLC0415

    from scipy.stats import qmc  # noqa: PLC0415, takes a second to import

    engine = (qmc.Sobol if method == "sobol" else qmc.LatinHypercube)(dimensions, rng=generator)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # a count that is no power of 2 is told by the checks
        return np.asarray(engine.random(count), np.float64)


def values_at(distribution: Any, u: Floats) -> Floats:
    """The values [SI] below which a share `u` of the distribution lies."""
    return _INVERSES[type(distribution)](distribution, u)


def _uniform(of: Uniform, u: Floats) -> Floats:
    return np.asarray(of.start.value + (of.stop.value - of.start.value) * u)


def _log_uniform(of: LogUniform, u: Floats) -> Floats:
    return np.asarray(of.start.value * (of.stop.value / of.start.value) ** u)


def _normal(of: Normal, u: Floats) -> Floats:
    low, high = (
        end if value is None else (value.value - of.mean.value) / of.deviation.value
        for end, value in ((-np.inf, of.start), (np.inf, of.stop))
    )
    found = of.mean.value + of.deviation.value * standard_normal(u, low, high)
    return _inside(found, of)


def _log_normal(of: LogNormal, u: Floats) -> Floats:
    width = np.log(of.factor)
    low, high = (
        end if value is None else float(np.log(value.value / of.median.value) / width)
        for end, value in ((-np.inf, of.start), (np.inf, of.stop))
    )
    return _inside(of.median.value * np.exp(width * standard_normal(u, low, high)), of)


def standard_normal(u: Floats, low: float, high: float) -> Floats:
    """Inverse of the standard normal cut off at low and high: z = P⁻¹((1 - u) P(low) + u P(high)).

    In logarithms, because P is 0 to the last bit from -38 on; in the upper tail, where it is 1 to the last
    bit, the mirror image is taken.
    """
    from scipy.special import log_ndtr, ndtri_exp  # noqa: PLC0415, slow to import

    if low > 0:
        return -standard_normal(1 - u, -high, -low)
    share = np.logaddexp(np.log1p(-u) + log_ndtr(low), np.log(u) + log_ndtr(high))
    return np.asarray(ndtri_exp(share), np.float64)


def _inside(values: Floats, of: Normal | LogNormal) -> Floats:
    """Rounding must not carry a value across an end."""
    low = -np.inf if of.start is None else of.start.value
    high = np.inf if of.stop is None else of.stop.value
    return np.clip(values, low, high)


_INVERSES: dict[type, Callable[[Any, Floats], Floats]] = {
    Uniform: _uniform,
    LogUniform: _log_uniform,
    Normal: _normal,
    LogNormal: _log_normal,
}
