"""How long a timestep an oscillator stands: the bound beyond which a scheme makes it grow without end.

For x'' = -omega^2 x - 2 zeta omega x', zeta the damping ratio.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import hypot, sqrt
from types import MappingProxyType

RK4_REAL = 2.785293563405282
"""Where |1 + x + x^2/2 + x^3/6 + x^4/24| = 1 on the negative real axis (Hairer & Wanner, Solving Ordinary
Differential Equations II, section IV.2).
"""
RK4_IMAGINARY = sqrt(8)
"""The same on the imaginary axis."""
RK4_BEYOND = 4.0
"""|R| is above 1 at this distance from 0 in every direction of the left half plane."""
ROUNDING = 1e-12
_SCAN = 4000


def largest_step(integrator: str, zeta: float) -> float:
    """The largest omega dt that does not grow; 0 for explicit Euler without damping.

    zeta: damping ratio, at least 0.
    """
    return _BOUNDS.get(integrator, verlet)(zeta)


def largest_damping_step(integrator: str) -> float:
    """The largest c dt / m that does not grow, of a damper without a spring."""
    return RK4_REAL if integrator == "rk4" else 2.0


def semi_implicit_euler(zeta: float) -> float:
    """2 (sqrt(1 + zeta^2) - zeta), written without the difference.

    v' = v - dt (omega^2 x + 2 zeta omega v), x' = x + dt v' has det = 1 - 2 zeta omega dt and trace =
    1 + det - (omega dt)^2; Jury's condition 1 + trace + det > 0 reads (omega dt)^2 + 4 zeta omega dt < 4.
    """
    return 2 / (hypot(1.0, zeta) + zeta)


def verlet(zeta: float) -> float:
    """2 without damping, and with it while c dt / m = 2 zeta omega dt < 2: beyond, the rounds in which the
    half kick that ends a step looks for its velocity lead away from it. Exact where zeta <= 1/2, else on the
    safe side.
    """
    return min(2.0, 1 / zeta) if zeta > 0 else 2.0


def explicit_euler(zeta: float) -> float:
    """2 zeta while it swings (det = 1 - 2 zeta omega dt + (omega dt)^2 < 1), else 2 over the faster rate."""
    return 2 * zeta if zeta <= 1 else 2 / (zeta + sqrt(zeta * zeta - 1))


def explicit_euler_growth(omega_dt: float, zeta: float) -> float:
    """By how much the amplitude grows in one step of an oscillator that swings: sqrt(det)."""
    return sqrt(max(1 - 2 * zeta * omega_dt + omega_dt * omega_dt, 0.0))


def rk4(zeta: float) -> float:
    """The first omega dt where |R(lambda dt)| exceeds 1, lambda = omega (-zeta +- sqrt(zeta^2 - 1)), found by
    scanning; R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24.
    """
    if zeta >= 1:
        return RK4_REAL / (zeta + sqrt(zeta * zeta - 1))
    if zeta == 0:
        return RK4_IMAGINARY
    direction = complex(-zeta, sqrt(1 - zeta * zeta))
    scanned = (RK4_BEYOND * k / _SCAN for k in range(1, _SCAN + 1))
    return next(omega_dt for omega_dt in scanned if _rk4_factor(direction * omega_dt) > 1 + ROUNDING)


def _rk4_factor(z: complex) -> float:
    return abs(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))))


_BOUNDS: Mapping[str, Callable[[float], float]] = MappingProxyType(
    {"explicit_euler": explicit_euler, "semi_implicit_euler": semi_implicit_euler, "rk4": rk4}
)
"""Those of Verlet and its relatives are one."""
