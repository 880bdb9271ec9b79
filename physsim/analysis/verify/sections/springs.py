"""Section 4: springs and dampers, linear and torsional."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import MILLISECONDS, by_integrator
from physsim.recording import Trajectory


def swing(omega: float, zeta: float, x: float, v: float, t: Array) -> Array:
    """x(t) of x'' + 2 zeta omega x' + omega^2 x = 0 from x and v at t = 0.

    Under-, critically and overdamped: Meriam & Kraige, Engineering Mechanics: Dynamics, 7th ed., eqs. 8/12
    to 8/14.
    """
    decay = zeta * omega
    if zeta == 1:
        return np.asarray((x + (v + omega * x) * t) * np.exp(-omega * t))
    if zeta < 1:
        rate = omega * np.sqrt(1 - zeta**2)
        way = x * np.cos(rate * t) + (v + decay * x) / rate * np.sin(rate * t)
        return np.asarray(np.exp(-decay * t) * way)
    rate = omega * np.sqrt(zeta**2 - 1)
    way = x * np.cosh(rate * t) + (v + decay * x) / rate * np.sinh(rate * t)
    return np.asarray(np.exp(-decay * t) * way)


def linear(p: Values, t: Array) -> Array:
    """Position of the mass on its spring [m]."""
    return p["rest"] + swing(np.sqrt(p["k"] / p["m"]), p["zeta"], p["x0"], p["v0"], t)


def torsional(p: Values, t: Array) -> Array:
    """Angle of the wheel from where it is let go, `start` from rest, with I = m R^2 / 2 [rad]."""
    omega = np.sqrt(p["kr"] / (p["m"] * p["R"] ** 2 / 2))
    return swing(omega, p["zeta"], p["start"], 0.0, t) - p["start"]


def distance(p: Values, t: Array) -> Array:
    """Between two bodies on a spring, with the reduced mass [m] (Landau & Lifshitz, Mechanics, sec. 13)."""
    omega = np.sqrt(p["k"] * (1 / p["m1"] + 1 / p["m2"]))
    return p["rest"] + swing(omega, p["zeta"], p["stretch"], 0.0, t)


def coupled(p: Values, t: Array) -> Array:
    """(T, 2): displacements of both masses, half the sum and half the difference of the two modes [m]."""
    in_step = np.cos(np.sqrt(p["k"] / p["m"]) * t)
    against = np.cos(np.sqrt((p["k"] + 2 * p["kc"]) / p["m"]) * t)
    return p["x0"] / 2 * np.column_stack([in_step + against, in_step - against])


def force(p: Values, t: Array) -> Array:
    """Tension k (x - rest) + c x' of the spring at the start, with c = 2 zeta sqrt(k m) [N]."""
    damping = 2 * p["zeta"] * np.sqrt(p["k"] * p["m"])
    return np.array([p["k"] * p["x0"] + damping * p["v0"]])


def measured_distance(run: Trajectory) -> Array:
    """(T): between the centres of a and b [m]."""
    return np.asarray(np.linalg.norm(run.body("b").position[:] - run.body("a").position[:], axis=1))


def measured_displacements(run: Trajectory) -> Array:
    """(T, 2): of a and b from their places at rest, a third and two thirds of the way [m]."""
    x = np.column_stack([run.body(name).position[:, 0] for name in "ab"])
    gap = x[0, 1] / 2
    return np.asarray(x - gap * np.array([1, 2]))


def measured_period(run: Trajectory) -> Array:
    """Time of one swing of the mass about 1 m [s]."""
    return np.array([measure.period(run.body("mass").position[:, 0] - 1.0, run.time)])


def _place(within: float, order: int) -> Check:
    return Check("x(t)", "m", "bodies.mass.position.x", linear, within, order)


def _angle(within: float, order: int) -> Check:
    return Check("θ(t)", "rad", measure.turned("wheel", "z"), torsional, within, order)


def _modes(within: float, order: int) -> Check:
    return Check("x₁(t), x₂(t)", "m", measured_displacements, coupled, within, order)


SPRING = Formula(
    name="spring_damper",
    section=4,
    title="Spring and damper",
    equation="F = −k Δx − c v",
    source="Hooke 1678; Meriam & Kraige, Dynamics, 7th ed., eq. 8/12",
    says="A mass on a spring and damper, pulled out and pushed, swings and dies out; with every integrator.",
    cases=(
        *by_integrator(
            "spring_damper",
            "spring",
            _place,
            (8e-4, 2e-4, 4e-6, 1.2e-10),  # measured 6.1e-4, 1.6e-4, 2.5e-6, 8.0e-11
        ),
        Case(
            "spring_damper.force",
            "spring",
            (Check("tension at the start", "N", measure.at_start("springs.spring.force"), force, 1e-12),),
        ),
    ),
)
DAMPING = Formula(
    name="damping_ratio",
    section=4,
    title="Critical damping and damping ratio",
    equation="ζ = c/(2 √(k m));  c_critical = 2 √(k m)",
    source="Meriam & Kraige, Dynamics, 7th ed., eqs. 8/12 to 8/14",
    says="The same mass with damping ratio 0.1 (it swings), 1 (back soonest) and 2 (it creeps back).",
    cases=tuple(
        Case(
            f"damping_ratio.{name}",
            "spring",
            (_place(within, 4),),
            {"parameters.zeta": zeta},
            MILLISECONDS[4],
        )
        for name, zeta, within in (("under", 0.1, 1.2e-10), ("critical", 1, 6e-11), ("over", 2, 5e-10))
    ),
)
FREQUENCY = Formula(
    name="natural_frequency",
    section=4,
    title="Natural frequency",
    equation="ω_n = √(k/m);  f_n = ω_n/(2π)",
    source="Meriam & Kraige, Dynamics, 7th ed., eq. 8/4",
    says="Without a damper the mass swings with ω_n; two bodies with the reduced mass; two coupled "
    "ones in two modes.",
    cases=(
        Case(
            "natural_frequency.period",
            "spring",
            (
                Check(
                    "period",
                    "s",
                    measured_period,
                    lambda p, t: 2 * np.pi * np.sqrt(p["m"] / p["k"]) * np.ones(1),
                    1e-9,
                ),
            ),
            {
                "parameters.zeta": 0,
                "simulation.duration": "8 s",
                "simulation.timestep": "2 ms",
                "record.every": "4 ms",
            },
        ),
        Case(
            "natural_frequency.two_bodies",
            "two_bodies_on_a_spring",
            (Check("distance", "m", measured_distance, distance, 3e-10, 4),),
            {},
            MILLISECONDS[4],
        ),
        *by_integrator(
            "natural_frequency.coupled",
            "coupled_springs",
            _modes,
            (3e-2, 3e-3, 1.2e-4, 5e-9),  # measured 2.0e-2, 1.8e-3, 7.9e-5, 3.6e-9
        ),
    ),
)
TORSION = Formula(
    name="torsional_spring",
    section=4,
    title="Torsional spring and damper",
    equation="τ = −k_r Δθ − c_r ω;  ζ = c_r/(2 √(k_r I))",
    source="Meriam & Kraige, Dynamics, 7th ed., sec. 8/4",
    says="A flywheel is let go half a turn from rest.",
    cases=by_integrator(
        "torsional_spring",
        "torsion_spring",
        _angle,
        (6e-3, 1.2e-3, 3e-5, 1.6e-9),  # measured 3.9e-3, 8.5e-4, 1.7e-5, 1.1e-9
    ),
)
SECTION = (SPRING, DAMPING, FREQUENCY, TORSION)
