"""Section 1: kinematics, Newton's laws, energy and momentum."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import by_integrator


def thrown_height(p: Values, t: Array) -> Array:
    """z0 + v0 t - g t^2 / 2."""
    return p["z0"] + p["v0"] * t - p["g"] * t**2 / 2


def thrown_speed(p: Values, t: Array) -> Array:
    """v0 - g t."""
    return p["v0"] - p["g"] * t


def kinetic_energy(p: Values, t: Array) -> Array:
    """m v^2 / 2 + omega . I omega / 2, the same at all times (König's theorem; Goldstein, eq. 1.31)."""
    a, b, c = p["a"], p["b"], p["c"]
    turning = (b**2 + c**2) * p["wx"] ** 2 + (a**2 + c**2) * p["wy"] ** 2 + (a**2 + b**2) * p["wz"] ** 2
    return np.full_like(t, p["m"] * p["v"] ** 2 / 2 + p["m"] / 24 * turning)


def angular_momentum(p: Values, t: Array) -> Array:
    """x × m v + R I_body omega_body about the world's origin, (T, 3), the same at all times (Goldstein,
    eq. 1.28).
    """
    a, b, c, m = p["a"], p["b"], p["c"], p["m"]
    moments = m / 12 * np.array([b**2 + c**2, a**2 + c**2, a**2 + b**2])
    x, y, z = moments * np.array([p["wx"], p["wy"], p["wz"]])
    cos, sin = np.cos(p["tilt"]), np.sin(p["tilt"])
    whole = np.array([x * cos - y * sin, x * sin + y * cos, z - m * p["h"] * p["v"]])
    return np.tile(whole, (len(t), 1))


def _height(within: float, order: int) -> Check:
    return Check(
        "height", "m", "bodies.ball.position.z", thrown_height, within, order if order == 1 else None
    )


FREE_FALL = Formula(
    name="free_fall",
    section=1,
    title="Constant acceleration",
    equation="v += a dt,  x += v dt;  v = v0 + a t,  x = x0 + v0 t + a t²/2",
    source="Galilei 1638; Goldstein, Classical Mechanics, 3rd ed., sec. 1.1",
    says="A ball is thrown upwards. The parabola is exact in the schemes of second order and above; "
    "the two Euler rules are off by g t dt/2.",
    cases=(
        Case(
            "free_fall.speed",
            "free_fall",
            (Check("velocity", "m/s", "bodies.ball.velocity.z", thrown_speed, 1e-12),),  # measured 3e-15
        ),
        *by_integrator(
            "free_fall",
            "free_fall",
            _height,
            # measured g t dt / 2, as it must be, of the two Euler rules, and 2e-14 of the others
            (1.1e-3, 1.1e-3, 1e-12, 1e-12),
        ),
    ),
)
FORCE = Formula(
    name="force",
    section=1,
    title="Newton's second law",
    equation="F = m a",
    source="Newton 1687, lex II",
    says="A crate in space is pushed through its centre with a constant force.",
    cases=(
        Case(
            "force",
            "force",
            (
                Check("velocity", "m/s", "bodies.crate.velocity.x", lambda p, t: p["F"] * t / p["m"], 1e-12),
                Check(
                    "position",
                    "m",
                    "bodies.crate.position.x",
                    lambda p, t: p["F"] * t**2 / (2 * p["m"]),
                    1e-12,
                ),
            ),
        ),
    ),
)
TORQUE = Formula(
    name="torque",
    section=1,
    title="Newton's second law for rotation",
    equation="τ = I α",
    source="Euler 1758; Goldstein, eq. 5.39",
    says="A crate in space is turned by a constant torque about a principal axis, with I = m (b² + c²)/12.",
    cases=(
        Case(
            "torque",
            "torque",
            (
                Check(
                    "angular velocity",
                    "rad/s",
                    "bodies.crate.angular_velocity.x",
                    lambda p, t: 12 * p["tau"] * t / (p["m"] * (p["b"] ** 2 + p["c"] ** 2)),
                    1e-12,
                ),
            ),
        ),
    ),
)
ENERGY_AND_MOMENTUM = Formula(
    name="energy_and_momentum",
    section=1,
    title="Kinetic energy and momentum",
    equation="KE = m v²/2 + ω·I ω/2;  p = m v;  L = I ω",
    source="König 1751; Goldstein, eqs. 1.28 and 1.31",
    says="A tilted box flies past the origin and tumbles. Momenta stay to rounding; the energy of its "
    "rotation within the band of the integrator, here RK4.",
    cases=(
        Case(
            "energy_and_momentum",
            "energy_and_momentum",
            (
                Check("kinetic energy", "J", "energy.kinetic", kinetic_energy, 1e-12),
                Check(
                    "linear momentum",
                    "kg m/s",
                    "momentum.linear.x",
                    lambda p, t: p["m"] * p["v"] + 0 * t,
                    1e-12,
                ),
                Check("angular momentum", "kg m²/s", "momentum.angular", angular_momentum, 1e-12),
            ),
            {"simulation.integrator": "rk4"},
        ),
    ),
)
SECTION = (FREE_FALL, FORCE, TORQUE, ENERGY_AND_MOMENTUM)
