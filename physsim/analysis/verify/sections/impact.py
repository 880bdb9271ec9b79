"""Section 2: impulse and collision response."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.recording import Trajectory

TABLE = {
    "steel": 0.65,
    "rubber": 0.80,
    "superball": 0.925,
    "clay": 0.0,
    "glass": 0.95,
    "golf_ball": 0.68,
    "basketball": 0.725,
}
"""Restitutions of the sheet's table, by the ball of the scene; the middle of each range."""
BOUNCES = 6
MEASURABLE = 1e-6
"""Speed of a bounce [m/s] whose height, 5e-14 m, no longer counts."""


def head_on(p: Values, _: Array) -> Array:
    """[v1', v2'] after an impact along the line of centres (Landau & Lifshitz, Mechanics, sec. 17)."""
    m1, m2, v1, v2 = p["m1"], p["m2"], p["v1"], p["v2"]
    impulse = (1 + p["e"]) * (v1 - v2) * m1 * m2 / (m1 + m2)
    return np.array([v1 - impulse / m1, v2 + impulse / m2])


def off_centre_impulse(p: Values, _: Array) -> Array:
    """j = (1 + e) v / K; only the box has an arm, h, and the moment m (a^2 + c^2) / 12 about y.

    Routh, Elementary Rigid Dynamics, 7th ed., art. 182.
    """
    k = 1 / p["mA"] + 1 / p["mB"] + p["h"] ** 2 / _box_moment(p)
    return np.array([(1 + p["e"]) * p["v"] / k])


def rod_impulse(p: Values, _: Array) -> Array:
    """j of a rod that lands on one end, with the arm s = (H/2) cos(tilt) and K = 1/m + s^2/I."""
    return np.array([(1 + p["e"]) * p["v"] / (1 / p["m"] + _rod_arm(p) ** 2 / p["I"])])


def impact_times(p: Values, _: Array) -> Array:
    """t1 = sqrt(2 h / g), then 2 e^k t1 later each."""
    first = np.sqrt(2 * p["h"] / p["g"])
    flights = 2 * first * p["e"] ** np.arange(1, BOUNCES)
    return np.asarray(first + np.concatenate([[0.0], np.cumsum(flights)]))


def bouncing_height(p: Values, t: Array) -> Array:
    """Height of the ball's centre: parabolas between the impacts, rest on the floor after the last [m]."""
    first, e = np.sqrt(2 * p["h"] / p["g"]), p["e"]
    height = np.where(t < first, p["h"] - p["g"] * t**2 / 2, 0.0)
    start, speed = first, e * first * p["g"]
    while speed > MEASURABLE:
        flown = t - start
        end = 2 * speed / p["g"]
        height = np.where((flown >= 0) & (flown < end), speed * flown - p["g"] * flown**2 / 2, height)
        start, speed = start + end, e * speed
    return p["r"] + height


def apex_heights(p: Values, _: Array) -> Array:
    """h e^2, h e^4, ..."""
    return np.asarray(p["h"] * p["e"] ** (2.0 * np.arange(1, BOUNCES + 1)))


def measured_apexes(run: Trajectory) -> Array:
    """(6): z + v^2 / 2 g above the ball's radius, from the frame amid each of the first flights after an
    impact [m].
    """
    times = np.asarray(run.events["time"])[: BOUNCES + 1]
    frames = [run.frame_at(moment) for moment in (times[1:] + times[:-1]) / 2]
    ball, p = run.body("ball"), _numbers(run)
    z, v = ball.position[:][frames, 2], ball.velocity[:][frames, 2]
    return np.asarray(z - p["r"] + v**2 / (2 * p["g"]))


def squared_energy_error(run: Trajectory) -> Array:
    """Mean over the frames of (E - E_0)^2 / m^2 [J^2/kg^2]."""
    energy = run.energy["kinetic_translational"] + run.energy["gravitational"]
    return np.array([np.mean((energy - energy[0]) ** 2) / run.body("ball").mass ** 2])


def table(_: Values, __: Array) -> Array:
    """The restitutions of the sheet's table."""
    return np.array(list(TABLE.values()))


def measured_table(run: Trajectory) -> Array:
    """Rebound speed over speed of approach of each ball."""
    speeds = [run.body(ball).velocity[:][[0, -1], 2] for ball in TABLE]
    return np.array([-after / before for before, after in speeds])


def _box_moment(p: Values) -> float:
    return p["mB"] * (p["a"] ** 2 + p["c"] ** 2) / 12


def _rod_arm(p: Values) -> float:
    return float(p["H"] / 2 * np.cos(p["tilt"]))


def _numbers(run: Trajectory) -> Values:
    from physsim.analysis.verify.judge import scene_values  # noqa: PLC0415, judge knows this module

    return scene_values(run)


HEAD_ON = Formula(
    name="impact_head_on",
    section=2,
    title="Impulse along the line of centres",
    equation="j = −(1 + e) v_n / K;  v_A' = v_A + j n/m_A,  v_B' = v_B − j n/m_B",
    source="Newton 1687, corollary 6; Landau & Lifshitz, Mechanics, sec. 17",
    says="Two balls of 2 kg and 1 kg meet head on; momentum stays, and e times the speed of approach "
    "is left.",
    cases=(
        Case(
            "impact_head_on",
            "impact_head_on",
            (
                Check(
                    "speeds after",
                    "m/s",
                    lambda run: np.array([run.body(ball).velocity[-1][0] for ball in "ab"]),
                    head_on,
                    1e-12,
                ),
                Check(
                    "measured e",
                    "1",
                    measure.events("restitution_measured"),
                    lambda p, _: np.array([p["e"]]),
                    1e-12,
                ),
            ),
        ),
    ),
)
OFF_CENTRE = Formula(
    name="impact_off_centre",
    section=2,
    title="Effective mass of an off-centre impact",
    equation="K = 1/m_A + 1/m_B + ((I_A⁻¹ (r_A × n)) × r_A)·n + ((I_B⁻¹ (r_B × n)) × r_B)·n",
    source="Routh, Elementary Rigid Dynamics, 7th ed., art. 182; Baraff 1997, eq. 8-18",
    says="A ball strikes a box beside its centre, and a tilted rod lands on one end: part of the "
    "impulse goes into rotation.",
    cases=(
        Case(
            "impact_off_centre.box",
            "impact_off_centre",
            (
                Check("impulse", "N s", measure.events("impulse"), off_centre_impulse, 1e-12),
                Check(
                    "v_A after",
                    "m/s",
                    measure.at_end("bodies.ball.velocity.x"),
                    lambda p, t: p["v"] - off_centre_impulse(p, t) / p["mA"],
                    1e-12,
                ),
                Check(
                    "v_B after",
                    "m/s",
                    measure.at_end("bodies.box.velocity.x"),
                    lambda p, t: off_centre_impulse(p, t) / p["mB"],
                    1e-12,
                ),
                Check(
                    "ω_B after",
                    "rad/s",
                    measure.at_end("bodies.box.angular_velocity.y"),
                    lambda p, t: p["h"] * off_centre_impulse(p, t) / _box_moment(p),
                    1e-12,
                ),
            ),
        ),
        Case(
            "impact_off_centre.rod",
            "impact_tilted_rod",
            (
                Check(
                    "v after",
                    "m/s",
                    measure.at_end("bodies.rod.velocity.z"),
                    lambda p, t: rod_impulse(p, t) / p["m"] - p["v"],
                    1e-12,
                ),
                Check(
                    "ω after",
                    "rad/s",
                    measure.at_end("bodies.rod.angular_speed"),
                    lambda p, t: _rod_arm(p) * rod_impulse(p, t) / p["I"],
                    1e-12,
                ),
            ),
        ),
    ),
)
BOUNCE = Formula(
    name="bounce",
    section=2,
    title="Coefficient of restitution: a bouncing ball",
    equation="v' = −e v;  h_n = e²ⁿ h;  t_n = t_1 (1 + 2 (e + e² + …))",
    source="Newton 1687; Falcon et al., Eur. Phys. J. B 3 (1998) 45, eqs. 1 to 3",
    says="A ball falls from 1 m and bounces with e = 0.8; impacts are located inside their steps. With "
    "e = 1 it bounces for twenty seconds and keeps its energy.",
    cases=(
        *(
            Case(
                f"bounce.{integrator}",
                "bounce",
                (
                    Check(
                        "six impact times",
                        "s",
                        lambda run: np.asarray(run.events["time"])[:BOUNCES],
                        impact_times,
                        1e-9,
                    ),
                    # bounces quicker than a step are none: g dt^2 / 2 = 4.9e-6 m; measured 1.5e-6 m
                    Check("z(t)", "m", "bodies.ball.position.z", bouncing_height, 4.9e-6, None, False),
                    Check("six apex heights", "m", measured_apexes, apex_heights, 1e-9),
                ),
                {"simulation.integrator": integrator},
            )
            for integrator in ("verlet", "rk4")
        ),
        Case(
            "bounce.elastic",
            "elastic_bounce",
            (
                Check(
                    "mean squared energy error",
                    "J²/kg²",
                    squared_energy_error,
                    lambda p, t: np.zeros(1),
                    1e-12,
                    None,
                    False,
                ),
            ),
        ),
        Case(
            "bounce.table",
            "restitution_pairs",
            (Check("e of seven pairs", "1", measured_table, table, 1e-12),),
        ),
    ),
)
SECTION = (HEAD_ON, OFF_CENTRE, BOUNCE)
