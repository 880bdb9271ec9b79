"""Beyond the sheet: screws, gears, universal joints, motors, stops, and joints that break."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array, Case, Check, Formula, Values
from physsim.analysis.verify.orders import MILLISECONDS
from physsim.analysis.verify.sections.springs import swing
from physsim.recording import Trajectory


def wheel(p: Values) -> float:
    """m R^2 / 2 [kg m^2]."""
    return p["m"] * p["R"] ** 2 / 2


def screwed_height(p: Values, t: Array) -> Array:
    """-a t^2 / 2 with a = g / (1 + I (2 pi / pitch)^2 / m) [m]."""
    return -p["g"] / (1 + wheel(p) * (2 * np.pi / p["pitch"]) ** 2 / p["m"]) * t**2 / 2


def geared_angles(p: Values, t: Array) -> Array:
    """(T, 2): alpha_1 t^2 / 2 with alpha_1 = tau / (I1 + n^2 I2), and n times that [rad]."""
    i1, i2 = p["m1"] * p["R1"] ** 2 / 2, p["m2"] * p["R2"] ** 2 / 2
    first = p["tau"] / (i1 + p["n"] ** 2 * i2) * t**2 / 2
    return np.column_stack([first, p["n"] * first])


def bent_angle(p: Values, t: Array) -> Array:
    """tan(angle_2) = cos(bend) tan(angle_1), through all turns (Seherr-Thoss et al. 2006, eq. 1.2) [rad]."""
    first = p["w"] * t
    return np.unwrap(np.arctan2(np.cos(p["bend"]) * np.sin(first), np.cos(first)))


def motor_speed(p: Values, t: Array) -> Array:
    """tau t / I up to the motor's speed [rad/s]."""
    return np.minimum(p["tau"] * t / wheel(p), p["speed"])


def servo_angle(p: Values, t: Array) -> Array:
    """The damped oscillator about the target [rad]."""
    return p["target"] + swing(np.sqrt(p["k"] / wheel(p)), p["zeta"], -p["target"], 0.0, t)


def braked_speed(p: Values, t: Array) -> Array:
    """w0 - tau t / I until it stands [rad/s]."""
    return np.maximum(p["w0"] - p["tau"] * t / wheel(p), 0.0)


def returning_angle(p: Values, t: Array) -> Array:
    """w0 / w sin(w t) with w = sqrt(k / I) [rad]."""
    own = np.sqrt(p["k"] / wheel(p))
    return np.asarray(p["w0"] / own * np.sin(own * t))


def last_speed(p: Values, _: Array) -> Array:
    """Of the block between stops 0.2 m off the middle, at the end: e^n v after n stops [m/s]."""
    left, speed, way, sign = 1.6, p["v"], 0.2, 1.0
    while left > way / speed:
        left -= way / speed
        speed, way, sign = p["e"] * speed, 0.4, -sign
    return np.array([sign * speed])


def freed_speed(p: Values, t: Array) -> Array:
    """0 until F = hold, then the integral of F1 t / (T m) [m/s]."""
    broken = p["T"] * p["hold"] / p["F1"]
    return p["F1"] / (2 * p["m"] * p["T"]) * np.maximum(t**2 - broken**2, 0.0)


def _angles(run: Trajectory) -> Array:
    return np.column_stack([run.series("joints/coordinate")[:, k] for k in (0, 1)])


SCREW = Formula(
    name="screw",
    section=9,
    title="Screw",
    equation="z = p φ/(2π);  a = g / (1 + I (2π/p)²/m)",
    source="Meriam & Kraige, Dynamics, 7th ed., sec. 6/6",
    says="A heavy nut spins down an upright screw without friction.",
    cases=(
        Case(
            "screw",
            "screw",
            (Check("height", "m", "bodies.nut.position.z", screwed_height, 3e-9, 4),),
            {},
            (2e-3, 1e-3, 0.5e-3),
        ),
    ),
)
GEAR = Formula(
    name="gear",
    section=9,
    title="Gear ratio",
    equation="φ₂ = n φ₁;  α₁ = τ / (I₁ + n² I₂)",
    source="Meriam & Kraige, Dynamics, 7th ed., sec. 6/6",
    says="A torque turns a small wheel that drives a large one, three turns to one, the other way.",
    cases=(Case("gear", "gear", (Check("angles", "rad", _angles, geared_angles, 1e-10),)),),
)
UNIVERSAL = Formula(
    name="universal",
    section=9,
    title="Universal joint",
    equation="tan φ₂ = cos β tan φ₁",
    source="Hooke 1676; Seherr-Thoss, Schmelz and Aucktor, Universal Joints and Driveshafts, eq. 1.2",
    says="A shaft that turns evenly drives another one, bent off by 40 degrees. Bearing and joint hold more "
    "than there is freedom for: four of their nine constraints are redundant.",
    cases=(
        Case(
            "universal",
            "universal",
            (Check("angle of the driven shaft", "rad", "joints.bearing.coordinate", bent_angle, 1e-8),),
        ),
    ),
)
DRIVES = Formula(
    name="drives",
    section=9,
    title="Motor, servo, dry friction, spring and stops",
    equation="ω = τ t/I;  τ = k (φ₀ − φ) − c φ';  v' = −e v",
    source="Meriam & Kraige, Dynamics, 7th ed., secs. 3/12, 6/4 and 8/4",
    says="Five wheels: one driven to a speed, one steered to an angle, one braked, one on a spring, and one "
    "that bounces between stops.",
    cases=(
        Case(
            "drives",
            "drives",
            (
                Check("motor", "rad/s", "bodies.driven.angular_velocity.z", motor_speed, 1e-9),
                Check("dry friction", "rad/s", "bodies.rubbing.angular_velocity.z", braked_speed, 1e-9),
                Check(
                    "after three stops",
                    "m/s",
                    lambda run: run.body("bouncing").velocity[-1:, 1],
                    last_speed,
                    1e-9,
                ),
            ),
        ),
        Case(
            "drives.smooth",
            "drives",
            (
                Check("servo", "rad", "joints.servo.coordinate", servo_angle, 4e-10, 4),
                Check("spring", "rad", "joints.return.coordinate", returning_angle, 6e-9, 4),
            ),
            {},
            MILLISECONDS[4],
        ),
    ),
)
BREAKING = Formula(
    name="breaking",
    section=9,
    title="A joint that breaks",
    equation="|F| > F_break",
    source="Newton 1687, lex II",
    says="A block, welded to the wall, is pulled ever harder until the weld breaks at 12 N, after 0.6 s.",
    cases=(
        Case(
            "breaking",
            "breaking_weld",
            # it breaks at the end of a step: F dt / m = 6 mm/s late, as measured
            (Check("speed", "m/s", "bodies.block.velocity.x", freed_speed, 6.1e-3, None, False),),
        ),
    ),
)
SECTION = (SCREW, GEAR, UNIVERSAL, DRIVES, BREAKING)
