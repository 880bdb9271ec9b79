"""Section 3: friction and contact forces."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array, Case, Check, Formula, Measure, Values
from physsim.recording import Trajectory

TABLE = {"steel": 0.57, "greased_steel": 0.09, "rubber": 0.75, "wood": 0.2, "ice": 0.02, "teflon": 0.04}
"""Kinetic friction of the sheet's table, by the block of the scene; rubber is on concrete, the others on
their like.
"""


def sliding_speed(p: Values, t: Array) -> Array:
    """g (sin slope - mu_k cos slope) t (Coulomb 1785)."""
    return np.asarray(p["g"] * (np.sin(p["slope"]) - p["mu_k"] * np.cos(p["slope"])) * t)


def standing(_: Values, t: Array) -> Array:
    """Nothing moves."""
    return np.zeros_like(t)


def creep(run: Trajectory) -> Array:
    """(T): way down the ramp since 0.1 s; before it the solver settles [m]."""
    x = run.body("crate").position[:, 0]
    settled = run.frame_at(0.1)
    return np.asarray(np.where(np.arange(len(x)) < settled, 0.0, x - x[settled]))


def stopping(p: Values, t: Array) -> Array:
    """v t - mu g t^2 / 2 until v / (mu g), then v^2 / (2 mu g)."""
    sliding = np.minimum(t, p["v"] / (p["mu"] * p["g"]))
    return p["v"] * sliding - p["mu"] * p["g"] * sliding**2 / 2


def rolling_start(p: Values, t: Array) -> Array:
    """v - mu g t while it slides, 5/7 v from 2 v / (7 mu g) on (Coriolis 1835, Théorie mathématique du jeu
    de billard).
    """
    return np.maximum(p["v"] - p["mu"] * p["g"] * t, 5 / 7 * p["v"])


def slip_lost(p: Values, _: Array) -> Array:
    """(2): j_t / m = min(mu j_n / m, 2/7 v_t) of the ball that slides through the impact and of the one
    that grips.
    """
    return np.minimum(np.array([p["low"], p["high"]]) * (1 + p["e"]) * p["vn"], 2 / 7 * p["vt"])


def of_both(field: str, component: int) -> Measure:
    """(2): a component at the end of the ball that slides and of the one that grips."""

    def measured(run: Trajectory) -> Array:
        return np.array(
            [run.series(field, run.index_of(ball))[-1][component] for ball in ("sliding", "gripping")]
        )

    return measured


def measured_table(run: Trajectory) -> Array:
    """(6): mean retardation between 0.05 s and 0.2 s, over g."""
    first, second = (run.frame_at(moment) for moment in (0.05, 0.2))
    speeds = np.array([run.body(block).velocity[:, 0] for block in TABLE])
    return np.asarray((speeds[:, first] - speeds[:, second]) / (run.time[second] - run.time[first]) / 9.81)


def friction_over_load(run: Trajectory) -> Array:
    """(T - 1): tangential over normal impulse, each summed over the contact points of a frame."""
    ratios = []
    for frame in range(1, run.frames):
        found = run.contacts(frame)
        rub = np.linalg.norm(found["tangential_impulse"].sum(axis=0))
        ratios.append(rub / found["normal_impulse"].sum())
    return np.array(ratios)


STATIC = Formula(
    name="static_friction",
    section=3,
    title="Static friction",
    equation="|f_t| ≤ μ_s |f_n|",
    source="Coulomb 1785, Théorie des machines simples",
    says="A crate on a ramp of 21.7 degrees, just below the angle of repose atan 0.4 = 21.80 degrees, "
    "stays; friction is then the load times the tangent of the slope. Just above, at 21.9 "
    "degrees, it slides away.",
    cases=(
        Case(
            "static_friction.below",
            "incline",
            (
                # the solver's own tolerance; measured 8e-9
                Check("speed", "m/s", "bodies.crate.speed", standing, 1e-6, None, False),
                # measured 4e-22
                Check("creep after 0.1 s", "m", creep, standing, 1e-15, None, False),
                Check(
                    "friction / load",
                    "1",
                    friction_over_load,
                    lambda p, t: np.full(len(t) - 1, np.tan(p["slope"])),
                    1e-6,
                ),
            ),
            {"parameters.slope": "21.7 deg"},
        ),
        Case(
            "static_friction.above",
            "incline",
            (Check("speed", "m/s", "bodies.crate.velocity.x", sliding_speed, 1e-2),),
            {"parameters.slope": "21.9 deg"},
        ),
    ),
)
KINETIC = Formula(
    name="kinetic_friction",
    section=3,
    title="Kinetic friction",
    equation="f_t = −μ_k |f_n| t;  a = g (sin θ − μ_k cos θ);  d = v²/(2 μ_k g)",
    source="Coulomb 1785; Meriam & Kraige, Engineering Mechanics: Statics, 7th ed., sec. 6/3",
    says="A crate slides down a ramp of 30 degrees; another one slides to rest on a level floor.",
    cases=(
        Case(
            "kinetic_friction.incline",
            "incline",
            (
                Check("speed", "m/s", "bodies.crate.velocity.x", sliding_speed, 1e-9),
                Check(
                    "friction / load",
                    "1",
                    friction_over_load,
                    lambda p, t: np.full(len(t) - 1, p["mu_k"]),
                    1e-9,
                ),
            ),
        ),
        Case(
            "kinetic_friction.stopping",
            "stopping",
            (Check("distance", "m", "bodies.crate.position.x", stopping, 1e-3, 1),),
            {},
            (2e-3, 1e-3, 0.5e-3),
        ),
        Case(
            "kinetic_friction.table",
            "friction_pairs",
            (
                Check(
                    "μ_k of six pairs", "1", measured_table, lambda p, t: np.array(list(TABLE.values())), 1e-9
                ),
            ),
        ),
        Case(
            "kinetic_friction.rolling",
            "sliding_to_rolling",
            (
                Check("speed", "m/s", "bodies.ball.velocity.x", rolling_start, 1e-12),
                Check(
                    "speed at the end over v0",
                    "1",
                    lambda run: run.body("ball").velocity[-1:, 0] / run.body("ball").velocity[0, 0],
                    lambda p, t: np.array([5 / 7]),
                    1e-12,
                ),
            ),
        ),
    ),
)
IMPULSE = Formula(
    name="friction_impulse",
    section=3,
    title="Friction impulse and its cone",
    equation="j_t = −v_t·t / K_t,  |j_t| ≤ μ |j_n|",
    source="Brach, Mechanical Impact Dynamics, sec. 2.2; Garwin, Am. J. Phys. 37 (1969) 88",
    says="Two balls strike a floor at a slant: on ice friction is cut off at the cone, on rubber it "
    "stops the slip.",
    cases=(
        Case(
            "friction_impulse",
            "friction_impulse",
            (
                Check(
                    "v_t after", "m/s", of_both("velocity", 0), lambda p, t: p["vt"] - slip_lost(p, t), 1e-12
                ),
                Check(
                    "ω after",
                    "rad/s",
                    of_both("angular_velocity", 1),
                    lambda p, t: 5 / 2 * slip_lost(p, t) / p["r"],
                    1e-12,
                ),
            ),
        ),
    ),
)
SECTION = (STATIC, KINETIC, IMPULSE)
