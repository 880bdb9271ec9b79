"""The six integrators, their published orders, and the timesteps that show them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from physsim.analysis.verify.case import Case, Check

ORDERS: Mapping[str, int] = {
    "explicit_euler": 1,
    "semi_implicit_euler": 1,
    "verlet": 2,
    "velocity_verlet": 2,
    "leapfrog": 2,
    "rk4": 4,
}
"""Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed., I.1 and II.1."""

MILLISECONDS: Mapping[int, tuple[float, ...]] = {
    1: (2e-3, 1e-3, 0.5e-3),
    2: (8e-3, 4e-3, 2e-3),
    4: (16e-3, 8e-3, 4e-3),
}
"""Timesteps [s] by order: small enough for the leading term of the error, large enough to stand above
rounding.
"""


def by_integrator(
    name: str,
    scene: str,
    check: Callable[[float, int], Check],
    within: Mapping[str, float],
    *,
    timesteps: Mapping[int, tuple[float, ...]] = MILLISECONDS,
) -> tuple[Case, ...]:
    """One case per integrator of `within` (its greatest error), each refined.

    check: makes the comparison from a greatest error and an order.
    """
    return tuple(
        Case(
            f"{name}.{integrator}",
            scene,
            (check(limit, ORDERS[integrator]),),
            {"simulation.integrator": integrator},
            timesteps[ORDERS[integrator]],
        )
        for integrator, limit in within.items()
    )
