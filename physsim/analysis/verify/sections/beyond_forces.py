"""Beyond the sheet: drag, forces that follow time, prescribed motion, curves, rolling friction."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import MILLISECONDS
from physsim.recording import Trajectory


def drag_speeds(p: Values, t: Array) -> Array:
    """(T, 2): of the viscous and of the turbulent ball, downwards [m/s].

    v_t (1 - exp(-g t / v_t)) and v_t tanh(g t / v_t) (Landau & Lifshitz, Fluid Mechanics, secs. 20 and 45).
    """
    viscous = p["m"] * p["g"] / p["c"]
    turbulent = np.sqrt(2 * p["m"] * p["g"] / (p["rho"] * p["C"] * p["A"]))
    return np.column_stack(
        [viscous * -np.expm1(-p["g"] * t / viscous), turbulent * np.tanh(p["g"] * t / turbulent)]
    )


def pushed_speed(p: Values, t: Array) -> Array:
    """F0 T / m (1 - exp(-t / T)) [m/s]."""
    return np.asarray(-p["F0"] * p["T"] / p["m"] * np.expm1(-t / p["T"]))


def shaken_place(p: Values, t: Array) -> Array:
    """rest + X w^2 / (w^2 - W^2) (sin W t - W/w sin w t) (Rayleigh, Theory of Sound, sec. 46) [m]."""
    own, forced = np.sqrt(p["k"] / p["m"]), 2 * np.pi * p["f"]
    swing = np.sin(forced * t) - forced / own * np.sin(own * t)
    return np.asarray(p["rest"] + p["X"] * own**2 / (own**2 - forced**2) * swing)


def curve_energy(p: Values, x: Array) -> Array:
    """Area under the curve up to a stretch x (T) [J]."""
    beyond = np.maximum(np.abs(x) - p["a"], 0.0)
    within = np.minimum(np.abs(x), p["a"])
    return np.asarray(p["k1"] * within**2 / 2 + p["k1"] * p["a"] * beyond + p["k2"] * beyond**2 / 2)


def curve_speed(p: Values, _: Array) -> Array:
    """sqrt(2 E / m) through the middle [m/s]."""
    return np.sqrt(2 * curve_energy(p, np.array([p["x0"]])) / p["m"])


def speed_through_the_middle(run: Trajectory) -> Array:
    """(1): greatest speed, from the parabola through the greatest frame and its neighbours [m/s]."""
    speed = np.abs(run.body("mass").velocity[:, 0])
    k = int(np.argmax(speed[1:-1])) + 1
    before, at, after = speed[k - 1 : k + 2]
    return np.array([at + (before - after) ** 2 / (8 * (2 * at - before - after))])


def rolled_speed(p: Values, t: Array) -> Array:
    """v - 5/7 delta g t / r until it stands: m a r = F r and (2/5) m r^2 a / r = delta N - F r [m/s]."""
    return np.maximum(p["v"] - 5 / 7 * p["delta"] * p["g"] * t / p["r"], 0.0)


def spun_speed(p: Values, t: Array) -> Array:
    """w - delta_s g t / (2/5 r^2) until it stands [rad/s]."""
    return np.maximum(p["w"] - 5 / 2 * p["spin"] * p["g"] * t / p["r"] ** 2, 0.0)


def carried_speed(p: Values, t: Array) -> Array:
    """mu g t up to the speed of the belt [m/s]."""
    return np.minimum(p["mu"] * p["g"] * t, p["v"])


def _falling(run: Trajectory) -> Array:
    return -np.column_stack([run.body(name).velocity[:, 2] for name in ("viscous", "turbulent")])


DRAG = Formula(
    name="drag",
    section=9,
    title="Drag",
    equation="F = −c v;  F = −½ ρ C A |v| v",
    source="Stokes 1851; Newton 1687, book II; Landau & Lifshitz, Fluid Mechanics, secs. 20 and 45",
    says="Two balls fall, one through oil and one through air, towards their terminal speeds.",
    cases=(
        Case(
            "drag",
            "drag",
            (Check("speeds", "m/s", _falling, drag_speeds, 1e-12, 4),),
            {},
            MILLISECONDS[4],
        ),
    ),
)
PUSH = Formula(
    name="time_profile",
    section=9,
    title="A force that follows time",
    equation="m v = ∫ F dt",
    source="Newton 1687, lex II",
    says="A block gets a push that dies away, written in the scene as an expression of t.",
    cases=(
        Case(
            "time_profile",
            "push",
            (Check("speed", "m/s", "bodies.block.velocity.x", pushed_speed, 4e-13, 4),),
            {},
            MILLISECONDS[4],
        ),
    ),
)
SHAKEN = Formula(
    name="shaken_spring",
    section=9,
    title="Forced oscillation",
    equation="m x'' = −k (x − X sin Ωt)",
    source="Rayleigh 1877, Theory of Sound, sec. 46",
    says="A mass hangs by a spring on a table whose motion is prescribed.",
    cases=(
        Case(
            "shaken_spring",
            "shaken_spring",
            (Check("x(t)", "m", "bodies.mass.position.x", shaken_place, 1.3e-9, 4),),
            {},
            MILLISECONDS[4],
        ),
    ),
)
CURVE = Formula(
    name="force_curve",
    section=9,
    title="A spring with a curve",
    equation="m v²/2 = ∫ F dx",
    source="Landau & Lifshitz, Mechanics, sec. 11",
    says="A spring that grows stiffer beyond 5 cm, given as a table of stretch and force.",
    cases=(
        Case(
            "force_curve",
            "force_curve",
            (
                # a kink of the curve costs RK4 its order; measured 2e-6
                Check("speed through the middle", "m/s", speed_through_the_middle, curve_speed, 4e-6),
                Check(
                    "stored energy at the start",
                    "J",
                    measure.at_start("energy.spring"),
                    lambda p, t: curve_energy(p, np.array([p["x0"]])),
                    1e-12,
                ),
            ),
        ),
    ),
)
ROLLING_FRICTION = Formula(
    name="rolling_friction",
    section=9,
    title="Rolling and spinning friction",
    equation="M = δ N;  a = −5/7 δ g / r",
    source="Coulomb 1785; Johnson, Contact Mechanics, sec. 9.1",
    says="A ball rolls to rest on felt, and another one spins on the spot.",
    cases=(
        Case(
            "rolling_friction",
            "rolling_friction",
            (
                Check("rolling speed", "m/s", "bodies.rolling.velocity.x", rolled_speed, 1e-9),
                Check("spin", "rad/s", "bodies.spinning.angular_velocity.z", spun_speed, 1e-9),
            ),
        ),
    ),
)
CONVEYOR = Formula(
    name="conveyor",
    section=9,
    title="Conveyor",
    equation="a = μ_k g until v = v_belt",
    source="Coulomb 1785",
    says="A parcel is laid on a running belt.",
    cases=(
        Case(
            "conveyor",
            "conveyor",
            (Check("speed", "m/s", "bodies.parcel.velocity.x", carried_speed, 1e-9),),
        ),
    ),
)
SECTION = (DRAG, PUSH, SHAKEN, CURVE, ROLLING_FRICTION, CONVEYOR)
