"""Section 6: inertia tensors of shapes, measured by turning them."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np

from physsim.analysis.verify import measure
from physsim.analysis.verify.case import Array, Case, Check, Formula, Measure, Values
from physsim.analysis.verify.orders import MILLISECONDS
from physsim.analysis.verify.sections.pendulum import swing_angle, swing_period
from physsim.recording import Trajectory

Moments = Callable[[Values], tuple[float, float]]
"""I_xx across and I_zz along the axis, about the centre of mass [kg m^2]."""


def capsule(p: Values) -> tuple[float, float]:
    """A cylinder and two half spheres, each of its share of the mass.

    Of a half sphere m_h: 2/5 m_h R^2 along; across, from its own centre 3R/8 above its face, moved by H/2
    + 3R/8.
    """
    body, caps = pi * p["R"] ** 2 * p["H"], 4 / 3 * pi * p["R"] ** 3
    mc, mh = (p["m"] * part / (body + caps) for part in (body, caps))
    r, h = p["R"], p["H"]
    across = mc * (3 * r**2 + h**2) / 12 + mh * (83 / 320 * r**2 + (h / 2 + 3 / 8 * r) ** 2)
    return across, mc * r**2 / 2 + mh * 2 / 5 * r**2


# Meriam & Kraige, Dynamics, 7th ed., table D/4; about the centre of mass.
SHAPES: dict[str, Moments] = {
    "sphere": lambda p: (2 / 5 * p["m"] * p["R"] ** 2, 2 / 5 * p["m"] * p["R"] ** 2),
    "hollow_sphere": lambda p: (2 / 3 * p["m"] * p["R"] ** 2, 2 / 3 * p["m"] * p["R"] ** 2),
    "cylinder": lambda p: (p["m"] * (3 * p["R"] ** 2 + p["H"] ** 2) / 12, p["m"] * p["R"] ** 2 / 2),
    "box": lambda p: (
        p["m"] * (p["b"] ** 2 + p["c"] ** 2) / 3,
        p["m"] * (p["a"] ** 2 + p["b"] ** 2) / 3,
    ),
    "cone": lambda p: (p["m"] * (3 / 20 * p["R"] ** 2 + 3 / 80 * p["H"] ** 2), 3 / 10 * p["m"] * p["R"] ** 2),
    "rod": lambda p: (p["m"] * p["L"] ** 2 / 12, 0.0),
    "capsule": capsule,
    "ellipsoid": lambda p: (
        p["m"] * (p["b"] ** 2 + p["c"] ** 2) / 5,
        p["m"] * (p["a"] ** 2 + p["b"] ** 2) / 5,
    ),
}
TITLES = {
    "sphere": ("Solid sphere", "I = 2/5 m R²"),
    "hollow_sphere": ("Hollow sphere (thin shell)", "I = 2/3 m R²"),
    "cylinder": ("Solid cylinder", "I_xx = m (3 R² + H²)/12,  I_zz = m R²/2"),
    "box": ("Solid box (half edges a, b, c)", "I_xx = m (b² + c²)/3,  I_zz = m (a² + b²)/3"),
    "cone": ("Solid cone", "I_xx = m (3/20 R² + 3/80 H²),  I_zz = 3/10 m R²"),
    "rod": ("Thin rod", "I_xx = m L²/12,  I_zz ≈ 0"),
    "capsule": ("Capsule", "cylinder and two half spheres"),
    "ellipsoid": ("Ellipsoid (half axes a, b, c)", "I_xx = m (b² + c²)/5,  I_zz = m (a² + b²)/5"),
}
TURN_X = {"parameters.tx": "0.02 N*m", "parameters.tz": "0 N*m"}
TURN_Z = {"parameters.tx": "0 N*m", "parameters.tz": "0.02 N*m"}
TORQUE, SECONDS = 0.02, 1.0


def moment(body: str, component: int) -> Measure:
    """(1): tau t / omega at the end [kg m^2]."""

    def measured(run: Trajectory) -> Array:
        return np.array([TORQUE * SECONDS / run.body(body).angular_velocity[-1][component]])

    return measured


def roll(part: float) -> Callable[[Values, Array], Array]:
    """g sin(slope) t / (1 + part) for I = part m r^2 (Goldstein, sec. 1.4)."""
    return lambda p, t: p["g"] * np.sin(p["slope"]) * t / (1 + part)


def bar_rate(p: Values) -> float:
    """sqrt(m g d / I) with I = m (3 R^2 + H^2)/12 + m d^2 about the hinge [rad/s]."""
    own = (3 * p["R"] ** 2 + p["H"] ** 2) / 12
    return float(np.sqrt(p["g"] * p["d"] / (own + p["d"] ** 2)))


def bar_angle(p: Values, t: Array) -> Array:
    """Angle of the bar from where it is let go [rad]."""
    return p["start"] - swing_angle(bar_rate(p), p["start"], t)


def measured_period(run: Trajectory) -> Array:
    """Time of one swing of the bar [s]."""
    return np.array([measure.period(run.body("bar").position[:, 0], run.time)])


def _shape(name: str, moments: Moments) -> Formula:
    title, equation = TITLES[name]
    cases = [
        Case(
            f"inertia_{name}.across",
            "inertia_shapes",
            (Check("I_xx", "kg m²", moment(name, 0), lambda p, t: np.array([moments(p)[0]]), 1e-12),),
            TURN_X,
        )
    ]
    if name != "rod":
        cases.append(
            Case(
                f"inertia_{name}.along",
                "inertia_shapes",
                (Check("I_zz", "kg m²", moment(name, 2), lambda p, t: np.array([moments(p)[1]]), 1e-12),),
                TURN_Z,
            )
        )
    return Formula(
        f"inertia_{name}",
        6,
        title,
        equation,
        "Meriam & Kraige, Dynamics, 7th ed., table D/4",
        "The body floats in space and is turned from rest, about x or about z; its moment is τ t / ω.",
        tuple(cases),
    )


ROLLING = Formula(
    name="rolling",
    section=6,
    title="Inertia of rolling bodies",
    equation="a = g sin θ / (1 + I/(m r²))",
    source="Goldstein, Classical Mechanics, 3rd ed., sec. 1.4; Meriam & Kraige, Dynamics, sec. 6/5",
    says="A ball, a hollow ball and a cylinder roll down a slope of 10 degrees.",
    cases=tuple(
        Case(
            f"rolling.{name}",
            "rolling_shapes",
            (Check("speed", "m/s", f"bodies.{name}.velocity.x", roll(part), within),),
        )
        for name, part, within in (
            ("ball", 2 / 5, 1e-12),
            ("hollow_ball", 2 / 3, 1e-12),
            ("cylinder", 1 / 2, 1e-12),
        )
    ),
)
PARALLEL_AXIS = Formula(
    name="parallel_axis",
    section=6,
    title="Parallel-axis theorem",
    equation="I' = I + m d²",
    source="Huygens 1673, Horologium oscillatorium, part IV; Steiner 1840",
    says="Two balls, welded a distance apart, are turned; and a bar swings on a hinge near its end.",
    cases=(
        Case(
            "parallel_axis.dumbbell",
            "dumbbell",
            (
                Check(
                    "ω across",
                    "rad/s",
                    "bodies.across.angular_velocity.x",
                    lambda p, t: p["tau"] * t / (2 * p["m"] * (2 / 5 * p["R"] ** 2 + p["d"] ** 2)),
                    1e-12,
                ),
                Check(
                    "ω along",
                    "rad/s",
                    "bodies.along.angular_velocity.z",
                    lambda p, t: p["tau"] * t / (4 / 5 * p["m"] * p["R"] ** 2),
                    1e-12,
                ),
            ),
        ),
        Case(
            "parallel_axis.pendulum",
            "compound_pendulum",
            (
                Check("θ(t)", "rad", measure.turned("bar", "y"), bar_angle, 1.4e-9, 4),
                Check(
                    "period",
                    "s",
                    measured_period,
                    lambda p, t: np.array([swing_period(bar_rate(p), p["start"])]),
                    1e-7,
                ),
            ),
            {},
            MILLISECONDS[4],
        ),
    ),
)
SECTION = (*(_shape(name, moments) for name, moments in SHAPES.items()), ROLLING, PARALLEL_AXIS)
