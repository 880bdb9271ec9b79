"""Section 8: constraint forces and joints."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import JOINTED, by_integrator
from physsim.analysis.verify.sections.double_pendulum import places
from physsim.analysis.verify.sections.pendulum import swing_angle, swing_period, swing_speed_squared
from physsim.recording import Trajectory


def nothing(_: Values, t: Array) -> Array:
    """0 at all times."""
    return np.zeros_like(t)


def pendulum_angle(p: Values, t: Array) -> Array:
    """From the lowest point [rad]."""
    return swing_angle(np.sqrt(p["g"] / p["L"]), p["start"], t)


def tension(p: Values, t: Array) -> Array:
    """m (g cos(angle) + v^2 / L) [N] (Huygens 1673, De vi centrifuga, prop. 17: 3 m g at the lowest
    point).
    """
    angle = pendulum_angle(p, t)
    turning = swing_speed_squared(np.sqrt(p["g"] / p["L"]), p["start"], angle)
    return p["m"] * (p["g"] * np.cos(angle) + p["L"] * turning)


def period(p: Values, _: Array) -> Array:
    """4 K(sin(start / 2)) sqrt(L / g) [s]."""
    return np.array([swing_period(np.sqrt(p["g"] / p["L"]), p["start"])])


def measured_angle(run: Trajectory) -> Array:
    """(T): of the ball from the lowest point [rad]."""
    x, _, z = run.body("ball").position[:].T
    return np.asarray(np.arctan2(x, -z))


def measured_period(run: Trajectory) -> Array:
    """(1): time of one swing [s]."""
    return np.array([measure.period(measured_angle(run), run.time)])


def both_balls(run: Trajectory) -> Array:
    """(T, 4): x and z of the upper and of the lower ball [m]."""
    return np.column_stack([run.body(name).position[:][:, [0, 2]] for name in ("upper", "lower")])


def position_error(p: Values, t: Array) -> Array:
    """C_n = (1 - beta)^n C_0 (Baumgarte, Comput. Meth. Appl. Mech. Eng. 1 (1972) 1, in steps) [m]."""
    return p["C0"] * (1 - p["beta"]) ** np.round(t / p["timestep"])


def energy_from_nowhere(p: Values, t: Array) -> Array:
    """m_eff (beta C_(n-1) / dt)^2 / 2 with m_eff = m / 2 once the first step is done [J]."""
    before = position_error(p, t - p["timestep"])
    return np.where(t > 0, p["m"] / 4 * (p["beta"] * before / p["timestep"]) ** 2, 0.0)


def _angle(within: float, order: int) -> Check:
    return Check("θ(t)", "rad", measured_angle, pendulum_angle, within, order)


def _places(within: float, order: int) -> Check:
    return Check("x, z of both", "m", both_balls, places, within, order)


PENDULUM = Formula(
    name="pendulum",
    section=8,
    title="Distance constraint: the pendulum",
    equation="C = |x_A − x_B| − L = 0;  T = 4 K(sin(θ₀/2)) √(L/g);  F = m (g cos θ + v²/L)",
    source="Huygens 1673; Jacobi 1829; Whittaker, Analytical Dynamics, 4th ed., art. 44",
    says="A ball on a rod is let go at 90 degrees; with every integrator. The rod's pull is its "
    "reaction force.",
    cases=(
        *by_integrator(
            "pendulum",
            "pendulum",
            _angle,
            (6e-2, 1.1e-3, 1e-4, 5e-11),  # measured 3.8e-2, 7.1e-4, 6.6e-5, 3.4e-11
            timesteps=JOINTED,
        ),
        Case(
            "pendulum.rod",
            "pendulum",
            (
                # reaction of a frame at its own instant; measured 3.5e-11
                Check("pull of the rod", "N", "joints.rod.reaction", tension, 1e-10),
                # measured 1.5e-13
                Check("length error", "m", "joints.rod.violation", nothing, 1e-10, None, False),
            ),
        ),
        Case(
            "pendulum.period",
            "pendulum",
            (Check("period", "s", measured_period, period, 1e-9),),  # measured 9.5e-11
            {"record.every": "16 ms"},
        ),
    ),
)
DOUBLE_PENDULUM = Formula(
    name="double_pendulum",
    section=8,
    title="Two constraints together: the double pendulum",
    equation="λ = −(J M⁻¹ Jᵀ)⁻¹ (J M⁻¹ F + J' v)",
    source="Lagrange 1788; Landau & Lifshitz, Mechanics, 3rd ed., sec. 5, problem 1",
    says="Two balls on two rods against Lagrange's equations for the two angles, integrated to 1e-13.",
    cases=(
        *by_integrator(
            "double_pendulum",
            "double_pendulum",
            _places,
            (2.2e-2, 1.5e-3, 9e-5, 2.2e-10),  # measured 1.5e-2, 9.6e-4, 6.0e-5, 1.4e-10
            timesteps=JOINTED,
        ),
        Case(
            "double_pendulum.five_seconds",
            "double_pendulum",
            (
                Check("x, z of both", "m", both_balls, places, 1e-8, None, False),
                Check("length error", "m", "joints.rod_2.violation", nothing, 1e-10, None, False),
            ),
            {"simulation.duration": "5 s", "record.every": "10 ms"},
        ),
    ),
)
STABILISATION = Formula(
    name="stabilization",
    section=8,
    title="Baumgarte and split impulse",
    equation="λ = −(Ċ + β/dt C)/K;  C_n = (1 − β)ⁿ C₀",
    source="Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1; Catto, GDC 2006 and 2009",
    says="Two balls at rest on a rod that is too short. Both ways take the error back by β a step; "
    "Baumgarte makes kinetic energy of it (of 10 cm, at 1 ms and β = 0.2, 100 J), split impulse none.",
    cases=(
        Case(
            "stabilization.baumgarte",
            "stretched_rod",
            (
                Check("C(t)", "m", "joints.rod.violation", position_error, 1e-12),
                Check("kinetic energy", "J", "energy.kinetic", energy_from_nowhere, 1e-12),
            ),
            {"simulation.stabilization": "baumgarte"},
        ),
        Case(
            "stabilization.split_impulse",
            "stretched_rod",
            (
                Check("C(t)", "m", "joints.rod.violation", position_error, 1e-12),
                Check("kinetic energy", "J", "energy.kinetic", nothing, 1e-20, None, False),
            ),
        ),
    ),
)
BALL = Formula(
    name="ball_joint",
    section=8,
    title="Ball-and-socket joint",
    equation="x_A + r_A = x_B + r_B  (3 translations)",
    source="Goldstein, sec. 1.3; the motion as for the heavy top, eq. 5.77",
    says="A top on its tip: the tip stays, and the socket carries its weight and turns it round.",
    cases=(
        Case(
            "ball_joint",
            "heavy_top",
            (
                Check("tip", "m", "joints.tip.violation", nothing, 1e-10, None, False),
                Check(
                    "force",
                    "N",
                    "joints.tip.reaction",
                    lambda p, t: np.full_like(
                        t, p["m"] * np.hypot(p["g"], p["W"] ** 2 * p["l"] * np.sin(p["tilt"]))
                    ),
                    1e-8,
                ),
            ),
        ),
    ),
)
HINGE = Formula(
    name="hinge",
    section=8,
    title="Hinge",
    equation="3 translations and 2 rotations;  F = m √(g² + ω⁴ d²),  M = m g d",
    source="Meriam & Kraige, Dynamics, 7th ed., sec. 6/4",
    says="An arm sweeps round on an upright hinge: it holds the weight, pulls inwards and carries the "
    "bending moment.",
    cases=(
        Case(
            "hinge",
            "hinged_arm",
            (
                Check("angle", "rad", "joints.post.coordinate", lambda p, t: p["w"] * t, 1e-11),
                Check(
                    "force",
                    "N",
                    "joints.post.reaction",
                    lambda p, t: np.full_like(t, p["m"] * np.hypot(p["g"], p["w"] ** 2 * p["d"])),
                    1e-8,
                ),
                Check(
                    "moment",
                    "N m",
                    measure.length("joints.post.torque"),
                    lambda p, t: np.full_like(t, p["m"] * p["g"] * p["d"]),
                    1e-8,
                ),
            ),
        ),
    ),
)
SLIDER = Formula(
    name="slider",
    section=8,
    title="Slider (prismatic joint)",
    equation="2 translations and 3 rotations;  s = g sin θ t²/2,  F = m g cos θ",
    source="Galilei 1638; Meriam & Kraige, Dynamics, 7th ed., sec. 3/4",
    says="A block on a smooth rail at 35 degrees.",
    cases=(
        Case(
            "slider",
            "slider",
            (
                Check(
                    "travel",
                    "m",
                    "joints.rail.coordinate",
                    lambda p, t: p["g"] * np.sin(p["slope"]) * t**2 / 2,
                    1e-10,
                ),
                Check(
                    "force",
                    "N",
                    "joints.rail.reaction",
                    lambda p, t: np.full_like(t, p["m"] * p["g"] * np.cos(p["slope"])),
                    1e-9,
                ),
            ),
        ),
    ),
)
FIXED = Formula(
    name="fixed_joint",
    section=8,
    title="Fixed joint (weld)",
    equation="all 6;  F = m ω² d;  F = m g,  M = m g d",
    source="Meriam & Kraige, Statics, 7th ed., sec. 3/4",
    says="Two welded boxes spin about their centre, and a third one sticks out of a wall.",
    cases=(
        Case(
            "fixed_joint",
            "weld",
            (
                Check(
                    "pull of the weld",
                    "N",
                    "joints.weld.reaction",
                    lambda p, t: np.full_like(t, p["m"] * p["w"] ** 2 * p["d"]),
                    1e-8,
                ),
                Check(
                    "force at the wall",
                    "N",
                    "joints.wall.reaction",
                    lambda p, t: np.full_like(t, p["m"] * p["g"]),
                    1e-9,
                ),
                Check(
                    "moment at the wall",
                    "N m",
                    measure.length("joints.wall.torque"),
                    lambda p, t: np.full_like(t, p["m"] * p["g"] * p["d"]),
                    1e-9,
                ),
            ),
        ),
    ),
)
CONE = Formula(
    name="cone_joint",
    section=8,
    title="Cone joint (angular limit)",
    equation="angle ≤ max_angle;  M = m g d sin(max_angle)",
    source="Meriam & Kraige, Statics, 7th ed., sec. 3/4",
    says="An arm falls sideways until the cone ends, and leans there.",
    cases=(
        Case(
            "cone_joint",
            "cone_limit",
            (
                Check(
                    "tilt at the end",
                    "rad",
                    lambda run: np.arccos(measure.axis("arm")(run)[-1:, 2]),
                    lambda p, t: np.array([p["limit"]]),
                    1e-7,
                ),
                Check(
                    "moment at the end",
                    "N m",
                    lambda run: measure.length("joints.shoulder.torque")(run)[-1:],
                    lambda p, t: np.array([p["m"] * p["g"] * p["d"] * np.sin(p["limit"])]),
                    1e-6,
                ),
            ),
        ),
    ),
)
SECTION = (PENDULUM, DOUBLE_PENDULUM, STABILISATION, BALL, HINGE, SLIDER, FIXED, CONE)
