"""The plane pendulum in closed form, by Jacobi's elliptic functions."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array


def swing_angle(rate: float, start: float, t: Array) -> Array:
    """Angle from the lowest point, let go at rest at `start` [rad]; rate: sqrt(g / L), or sqrt(m g d / I)
    [rad/s].

    sin(angle / 2) = k sn(K - rate t, k) with k = sin(start / 2) (Whittaker, Analytical Dynamics, 4th ed.,
    art. 44).
    """
    from scipy.special import ellipj, ellipk  # noqa: PLC0415, slow to import

    k = np.sin(start / 2)
    sn, _, _, _ = ellipj(ellipk(k**2) - rate * t, k**2)
    return np.asarray(2 * np.arcsin(k * sn))


def swing_period(rate: float, start: float) -> float:
    """4 K(sin(start / 2)) / rate [s] (Legendre 1825; Landau & Lifshitz, Mechanics, sec. 11, problem 1)."""
    from scipy.special import ellipk  # noqa: PLC0415, slow to import

    return float(4 * ellipk(np.sin(start / 2) ** 2) / rate)


def swing_speed_squared(rate: float, start: float, angle: Array) -> Array:
    """Square of the angular speed at an angle: 2 rate^2 (cos angle - cos start), from the energy
    [rad^2/s^2].
    """
    return np.asarray(2 * rate**2 * (np.cos(angle) - np.cos(start)))
