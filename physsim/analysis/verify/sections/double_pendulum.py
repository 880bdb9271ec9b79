"""The double pendulum of two point masses, by Lagrange's equations for its two angles."""

from __future__ import annotations

from functools import cache

import numpy as np

from physsim.analysis.verify.case import Array, Values

NAMES = ("m1", "m2", "L1", "L2", "start1", "start2", "g")


def places(p: Values, t: Array) -> Array:
    """(T, 4): x and z of the upper and of the lower ball [m]."""
    first, second = angles(tuple(p[name] for name in NAMES), tuple(t))
    x1, z1 = p["L1"] * np.sin(first), -p["L1"] * np.cos(first)
    return np.column_stack([x1, z1, x1 + p["L2"] * np.sin(second), z1 - p["L2"] * np.cos(second)])


@cache
def angles(numbers: tuple[float, ...], times: tuple[float, ...]) -> Array:
    """(2, T): both angles, from DOP853 with a relative tolerance of 1e-13; kept for the next run."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415, slow to import

    p = dict(zip(NAMES, numbers, strict=True))
    start = np.array([p["start1"], p["start2"], 0.0, 0.0])
    found = solve_ivp(
        lambda _, state: rates(p, state),
        (times[0], times[-1]),
        start,
        "DOP853",
        t_eval=times,
        rtol=1e-13,
        atol=1e-14,
    )
    return np.asarray(found.y[:2], np.float64)


def rates(p: Values, state: Array) -> Array:
    """[angle1', angle2', angle1'', angle2''] (from L of Landau & Lifshitz, Mechanics, sec. 5, problem 1).

    With d = angle1 - angle2 and both rods' equations as a matrix:
    [(m1 + m2) L1, m2 L2 cos d; L1 cos d, L2] a = [-m2 L2 w2^2 sin d - (m1 + m2) g sin angle1; L1 w1^2 sin
    d - g sin angle2].
    """
    first, second, w1, w2 = state
    total, l1, l2, g = p["m1"] + p["m2"], p["L1"], p["L2"], p["g"]
    cos, sin = np.cos(first - second), np.sin(first - second)
    matrix = np.array([[total * l1, p["m2"] * l2 * cos], [l1 * cos, l2]])
    right = np.array(
        [
            -p["m2"] * l2 * w2**2 * sin - total * g * np.sin(first),
            l1 * w1**2 * sin - g * np.sin(second),
        ]
    )
    return np.concatenate([[w1, w2], np.linalg.solve(matrix, right)])
