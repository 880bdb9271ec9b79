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
    4: (8e-3, 4e-3, 2e-3),
}
"""Timesteps [s] by order: small enough for the leading term of the error, large enough to stand above
rounding.
"""


JOINTED: Mapping[int, tuple[float, ...]] = {**MILLISECONDS, 4: (4e-3, 2e-3, 1e-3)}
"""The same for pendulums, where the next term of RK4's error is larger."""


def by_integrator(
    name: str,
    scene: str,
    check: Callable[[float, int], Check],
    within: tuple[float, float, float, float],
    *,
    timesteps: Mapping[int, tuple[float, ...]] = MILLISECONDS,
) -> tuple[Case, ...]:
    """One case per integrator, each refined.

    check: makes the comparison from a greatest error and an order. within: the greatest error at the smallest
    timestep of explicit Euler, of semi-implicit Euler, of the three rules of second order, and of RK4.
    """
    euler, symplectic_euler, second, fourth = within
    limits = (euler, symplectic_euler, second, second, second, fourth)
    return tuple(
        Case(
            f"{name}.{integrator}",
            scene,
            (check(limit, order),),
            {"simulation.integrator": integrator},
            timesteps[order],
        )
        for (integrator, order), limit in zip(ORDERS.items(), limits, strict=True)
    )
