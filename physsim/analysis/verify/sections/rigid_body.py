"""Section 5: rotation of rigid bodies."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import MILLISECONDS, by_integrator
from physsim.analysis.verify.sections.free_rotation import euler_top, euler_top_attitude
from physsim.recording import Trajectory


def constant_spin(p: Values, t: Array) -> Array:
    """(T, 4): q = (cos(w t / 2), n sin(w t / 2)) (Hamilton 1844; Kuipers 1999, eq. 5.5)."""
    w = np.array([p["wx"], p["wy"], p["wz"]])
    half = np.linalg.norm(w) * t / 2
    return np.column_stack([np.cos(half), np.sin(half)[:, None] * w / np.linalg.norm(w)])


def measured_quaternion(run: Trajectory) -> Array:
    """(T, 4): with the sign that follows on from the frame before; q and -q are one attitude."""
    q = run.body("ball").orientation[:]
    same = np.einsum("ti,ti->t", q[1:], q[:-1]) >= 0
    sign = np.concatenate([[1.0], np.cumprod(np.where(same, 1.0, -1.0))])
    return np.asarray(q * sign[:, None])


def wobbling_axis(p: Values, t: Array) -> Array:
    """(T, 3): axis of a free symmetric body, turned about L at |L| / I1 (Landau & Lifshitz, sec. 33)."""
    across, along = p["m"] * (3 * p["R"] ** 2 + p["H"] ** 2) / 12, p["m"] * p["R"] ** 2 / 2
    momentum = np.array([across * p["w1"], 0.0, along * p["w3"]])
    size = np.linalg.norm(momentum)
    return turned(np.array([0.0, 0.0, 1.0]), momentum / size, size / across * t)


def precessing_axis(p: Values, t: Array) -> Array:
    """(T, 3): axis of a heavy top that goes round the vertical at W with constant tilt (Goldstein, eq.
    5.77).
    """
    start = np.array([np.sin(p["tilt"]), 0.0, np.cos(p["tilt"])])
    return turned(start, np.array([0.0, 0.0, 1.0]), p["W"] * t)


def straight_line_seen_turning(p: Values, t: Array) -> Array:
    """(T, 2): the path of the puck turned back by W t: in the axes of the turntable [m]."""
    x, y = p["x0"] + p["vx"] * t, p["y0"] + p["vy"] * t
    cos, sin = np.cos(p["W"] * t), np.sin(p["W"] * t)
    return np.column_stack([x * cos + y * sin, y * cos - x * sin])


def apparent_acceleration(p: Values, t: Array) -> Array:
    """(T - 2, 2): -2 W × x' - W × (W × x) on that path (Goldstein, eq. 4.91) [m/s^2]."""
    x = straight_line_seen_turning(p, t)
    cos, sin = np.cos(p["W"] * t), np.sin(p["W"] * t)
    inertial = np.column_stack([p["vx"] * cos + p["vy"] * sin, p["vy"] * cos - p["vx"] * sin])
    v = inertial - p["W"] * np.column_stack([-x[:, 1], x[:, 0]])
    coriolis = 2 * p["W"] * np.column_stack([v[:, 1], -v[:, 0]])
    return np.asarray((coriolis + p["W"] ** 2 * x)[1:-1])


def turned(vector: Array, axis: Array, angle: Array) -> Array:
    """(T, 3): a vector turned about a unit axis by angles (T) (Rodrigues 1840)."""
    cos, sin = np.cos(angle)[:, None], np.sin(angle)[:, None]
    return np.asarray(vector * cos + np.cross(axis, vector) * sin + axis * (axis @ vector) * (1 - cos))


def path_on_turntable(run: Trajectory) -> Array:
    """(T, 2): position of the puck in the axes of the turntable [m]."""
    axes = measure.rotations(run, "turntable")
    return np.asarray(np.einsum("tji,tj->ti", axes, run.body("puck").position[:])[:, :2])


def acceleration_on_turntable(run: Trajectory) -> Array:
    """(T - 2, 2): second differences of that path [m/s^2]."""
    path, every = path_on_turntable(run), run.time[1] - run.time[0]
    return np.asarray((path[2:] - 2 * path[1:-1] + path[:-2]) / every**2)


def _attitude(within: float, order: int) -> Check:
    return Check("R(t)", "1", lambda run: measure.rotations(run, "body"), euler_top_attitude, within, order)


def _top(within: float, order: int) -> Check:
    return Check("axis(t)", "1", measure.axis("top"), precessing_axis, within, order)


QUATERNION = Formula(
    name="quaternion",
    section=5,
    title="Orientation as a quaternion",
    equation="dq/dt = ½ [0, ω] ⊗ q;  |q| = 1",
    source="Hamilton 1844; Kuipers, Quaternions and Rotation Sequences, eq. 5.5",
    says="A ball spins about a slanting axis: q turns in its plane at half the rate, and keeps its length.",
    cases=(
        Case(
            "quaternion",
            "fixed_axis",
            (
                Check("q(t)", "1", measured_quaternion, constant_spin, 1e-12),
                Check(
                    "|q|",
                    "1",
                    lambda run: np.linalg.norm(run.body("ball").orientation[:], axis=1),
                    lambda p, t: np.ones_like(t),
                    1e-15,
                ),
            ),
        ),
    ),
)
FREE_BODY = Formula(
    name="free_rotation",
    section=5,
    title="Torque-free rotation",
    equation="dL/dt = 0;  ω = I_world⁻¹ L;  I_world = R I_body Rᵀ",
    source="Jacobi 1850; Landau & Lifshitz, Mechanics, sec. 37, eqs. 37.10 to 37.20",
    says="A body with three different moments tumbles. Its attitude follows Jacobi's elliptic functions.",
    cases=(
        *by_integrator(
            "free_rotation",
            "free_body",
            _attitude,
            (5e-3, 9e-4, 5e-6, 3e-11),  # measured 3.3e-3, 6.0e-4, 3.2e-6, 1.7e-11
        ),
        Case(
            "free_rotation.spin",
            "free_body",
            (Check("ω(t), body axes", "rad/s", measure.spin("body"), euler_top, 3e-11, 4),),
            {},
            MILLISECONDS[4],
        ),
    ),
)
SYMMETRIC = Formula(
    name="wobbling_plate",
    section=5,
    title="Free precession of a symmetric body",
    equation="Ω = |L| / I₁",
    source="Euler 1758; Landau & Lifshitz, Mechanics, sec. 33, eq. 33.5",
    says="A plate, thrown spinning and tilted: its axis goes round L, nearly twice as fast as the "
    "plate spins.",
    cases=(
        Case(
            "wobbling_plate",
            "free_symmetric_body",
            (Check("axis(t)", "1", measure.axis("plate"), wobbling_axis, 5e-8, 4),),
            {},
            MILLISECONDS[4],
        ),
    ),
)
HEAVY_TOP = Formula(
    name="heavy_top",
    section=5,
    title="Rotation under a torque: the heavy top",
    equation="dL/dt = τ;  m g l = I₃ ω₃ Ω − I₁ Ω² cos θ",
    source="Lagrange 1788; Goldstein, Classical Mechanics, 3rd ed., eq. 5.77",
    says="A top on its tip with just the spin at which it goes round steadily, at 6 rad/s and 30 degrees.",
    cases=by_integrator(
        "heavy_top",
        "heavy_top",
        _top,
        (0.14, 6e-3, 1.1e-3, 3.6e-7),  # measured 9.5e-2, 4.2e-3, 7.7e-4, 2.5e-7
    ),
)
ROTATING_FRAME = Formula(
    name="rotating_frame",
    section=5,
    title="Coriolis and centrifugal acceleration",
    equation="a' = −2 ω × v' − ω × (ω × r)",
    source="Coriolis 1835; Goldstein, eq. 4.91",
    says="A puck glides straight over a spinning turntable. The engine works in an inertial frame; "
    "seen from the turntable the puck has just the apparent accelerations.",
    cases=(
        Case(
            "rotating_frame",
            "rotating_frame",
            (
                Check("path on the turntable", "m", path_on_turntable, straight_line_seen_turning, 1e-12),
                # of second differences over 1 ms
                Check("acceleration there", "m/s²", acceleration_on_turntable, apparent_acceleration, 1e-6),
            ),
        ),
    ),
)
SECTION = (QUATERNION, FREE_BODY, SYMMETRIC, HEAVY_TOP, ROTATING_FRAME)
