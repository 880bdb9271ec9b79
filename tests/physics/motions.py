"""Smooth motions that have a closed form, or a theory in as few coordinates as they have."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from laboratory import GRAVITY, Lab, mechanics, rotation
from workbench import moved

DOWN = (0, 0, -GRAVITY)
TIMES = 0.2 * np.arange(1, 11)


@dataclass(frozen=True)
class Motion:
    """A scene by integrator and timestep, what is looked at, its theory (T, n) at times (T), and the longest
    timestep for each order.
    """

    make: Callable[[str, float], Lab]
    read: Callable[[Lab], Any]
    theory: Callable[[], Any]
    times: Any
    steps: dict[int, float]


# ---------------------------------------------------------------------------------------------- oscillators

MASS, STIFFNESS, REST = 2.0, 18.0, 2.0  # omega = 3 rad/s
OMEGA = np.sqrt(STIFFNESS / MASS)
START, SPEED = 0.3, 0.5


def oscillator(integrator: str, timestep: float, *, damping: float = 0.0) -> Lab:
    """A ball on a spring along x, `START` from rest with `SPEED`."""
    ball = {"mass": MASS, "position": (REST + START, 0, 0), "velocity": (SPEED, 0, 0)}
    spring = {"type": "linear", "between": ("world", "ball"), "rest_length": REST, "stiffness": STIFFNESS}
    spring["damping"] = damping
    return mechanics({"ball": ball}, springs={"s": spring}, integrator=integrator, timestep=timestep)


def stretch(scene: Lab) -> tuple[float, float]:
    """x [m] and v / omega [m]."""
    return scene.get("position", "ball")[0] - REST, scene.get("velocity", "ball")[0] / OMEGA


def damped_swing(damping: float, times: Any) -> Any:
    """x = exp(-d t) (a cos w t + b sin w t) with d = c / 2m and w^2 = k/m - d^2, and x' / omega."""
    d = damping / (2 * MASS)
    w = np.sqrt(OMEGA**2 - d**2)
    a, b = START, (SPEED + d * START) / w
    cos, sin, decay = np.cos(w * times), np.sin(w * times), np.exp(-d * times)
    rate = decay * ((w * b - d * a) * cos - (w * a + d * b) * sin)
    return np.column_stack([decay * (a * cos + b * sin), rate / OMEGA])


def coupled(integrator: str, timestep: float) -> Lab:
    """Two balls between walls on three equal springs."""
    balls = {"a": {"position": (1.2, 0, 0)}, "b": {"position": (2.0, 0, 0)}}
    ends = {"left": ("world", "a"), "middle": ("a", "b"), "right": ("b", "world")}
    anchors = {"right": ((0, 0, 0), (3, 0, 0))}
    springs = {
        name: {"type": "linear", "between": pair, "rest_length": 1, "stiffness": 4}
        | ({"anchors": anchors[name]} if name in anchors else {})
        for name, pair in ends.items()
    }
    return mechanics(balls, springs=springs, integrator=integrator, timestep=timestep)


def coupled_theory() -> Any:
    """Modes in step, omega^2 = k/m, and against each other, 3 k/m (Landau & Lifshitz, Mechanics, sec. 23)."""
    slow, fast = 0.1 * np.cos(2 * TIMES), 0.1 * np.cos(np.sqrt(12) * TIMES)
    return np.column_stack([slow + fast, slow - fast])


def torsional(integrator: str, timestep: float) -> Lab:
    """A wheel about a tilted axis, I = m R^2 / 2 = 0.02 kg m2, let go two turns from rest."""
    wheel = {"shape": {"type": "cylinder", "radius": 0.2, "height": 0.05}, "orientation": TILT}
    shaft = {"type": "torsional", "between": ("world", "wheel"), "axis": (0, 0.6, 0.8), "stiffness": 0.18}
    shaft["rest_angle"] = 4 * np.pi
    return mechanics({"wheel": wheel}, springs={"shaft": shaft}, integrator=integrator, timestep=timestep)


TILT = {"axis": (-1, 0, 0), "angle": np.arctan2(0.6, 0.8)}


def winding(scene: Lab) -> tuple[float, float]:
    """Angle [rad] and angular velocity / omega [rad]."""
    spin = scene.get("angular_velocity", "wheel") @ np.array([0, 0.6, 0.8])
    return scene.spring("shaft")[0], spin / 3


def winding_theory() -> Any:
    return 4 * np.pi * np.column_stack([1 - np.cos(3 * TIMES), np.sin(3 * TIMES)])


# ------------------------------------------------------------------------------------------------ pendulums

LONG, SHORT = (0.1, 0.06, 0.8), (0.06, 0.1, 0.7)  # the links, boxes of 2 kg and 1 kg that hang along z
TILTS, RATES = (0.9, 0.3), (0.5, -0.5)


def moment(size: Any, mass: float) -> float:
    """Of a box about its own y axis, through the centre."""
    return float(mass * (size[0] ** 2 + size[2] ** 2) / 12)


def link(
    size: Any, mass: float, top: Any, swung: tuple[float, float], speed: Any = (0, 0, 0)
) -> dict[str, Any]:
    """A box that hangs from the point `top`, which moves with `speed`; `swung`: its angle and rate."""
    angle, rate = swung
    arm = size[2] / 2
    return {
        "shape": {"type": "box", "size": size},
        "mass": mass,
        "position": np.array(top) + arm * np.array([np.sin(angle), 0, -np.cos(angle)]),
        "velocity": np.array(speed) + arm * rate * np.array([np.cos(angle), 0, np.sin(angle)]),
        "orientation": {"axis": (0, 1, 0), "angle": -angle},
        "angular_velocity": (0, -rate, 0),
    }


def pendulum(integrator: str, timestep: float, *, damping: float = 0.0) -> Lab:
    """A link on a hinge, damped or not."""
    bodies = {"upper": link(LONG, 2.0, (0, 0, 0), (TILTS[0], RATES[0]))}
    hinge = {"type": "hinge", "between": ("world", "upper"), "anchor": (0, 0, 0), "axis": (0, 1, 0)}
    hinge["damping"] = damping
    return mechanics(bodies, joints={"pin": hinge}, integrator=integrator, timestep=timestep, gravity=DOWN)


def double_pendulum(integrator: str, timestep: float) -> Lab:
    """The same link and a shorter one below it, on another hinge."""
    angle, rate = TILTS[0], RATES[0]
    elbow = LONG[2] * np.array([np.sin(angle), 0, -np.cos(angle)])
    speed = LONG[2] * rate * np.array([np.cos(angle), 0, np.sin(angle)])
    bodies = {
        "upper": link(LONG, 2.0, (0, 0, 0), (angle, rate)),
        "lower": link(SHORT, 1.0, elbow, (TILTS[1], RATES[1]), speed),
    }
    pin = {"type": "hinge", "axis": (0, 1, 0)}
    joints = {
        "shoulder": pin | {"between": ("world", "upper"), "anchor": (0, 0, 0)},
        "elbow": pin | {"between": ("upper", "lower"), "anchor": elbow},
    }
    return mechanics(bodies, joints=joints, integrator=integrator, timestep=timestep, gravity=DOWN)


def swing(scene: Lab, bodies: tuple[str, ...] = ("upper",)) -> Any:
    """Angles from the vertical [rad] by the orientation, rates [rad/s], places of the centres [m]."""
    q = [scene.get("orientation", name) for name in bodies]
    rates = [-scene.get("angular_velocity", name)[1] for name in bodies]
    places = [scene.get("position", name)[[0, 2]] for name in bodies]
    return np.hstack([[-2 * np.arctan2(a[2], a[0]) for a in q], rates, *places])


def both(scene: Lab) -> Any:
    return swing(scene, ("upper", "lower"))


def pendulum_theory(times: Any, damping: float = 0.0) -> Any:
    """I theta'' = -m g l sin(theta) - c theta'."""
    arm = LONG[2] / 2
    about = moment(LONG, 2.0) + 2.0 * arm**2

    def rates(_: float, y: Any) -> Any:
        return [y[1], -(2.0 * GRAVITY * arm * np.sin(y[0]) + damping * y[1]) / about]

    angle, rate = moved(rates, [TILTS[0], RATES[0]], times).T
    return np.column_stack([angle, rate, arm * np.sin(angle), -arm * np.cos(angle)])


def double_pendulum_theory(times: Any) -> Any:
    """Lagrange's equations of two links in the plane, in the two angles from the vertical."""
    m1, m2, length, c1, c2 = 2.0, 1.0, LONG[2], LONG[2] / 2, SHORT[2] / 2
    own = moment(LONG, m1) + m1 * c1**2 + m2 * length**2, moment(SHORT, m2) + m2 * c2**2
    shared = m2 * length * c2

    def rates(_: float, y: Any) -> Any:
        (a, b), (u, v) = y[:2], y[2:]
        across = shared * np.sin(a - b)
        load = [
            -across * v**2 - (m1 * c1 + m2 * length) * GRAVITY * np.sin(a),
            across * u**2 - m2 * c2 * GRAVITY * np.sin(b),
        ]
        mixed = shared * np.cos(a - b)
        return [u, v, *np.linalg.solve([[own[0], mixed], [mixed, own[1]]], load)]

    a, b, u, v = moved(rates, [*TILTS, *RATES], times).T
    x, z = length * np.sin(a), -length * np.cos(a)
    upper = c1 * np.sin(a), -c1 * np.cos(a)
    return np.column_stack([a, b, u, v, *upper, x + c2 * np.sin(b), z - c2 * np.cos(b)])


# -------------------------------------------------------------------------------- two boxes on a spring

MASSES = np.array([2.0, 1.0])
MOMENTS = np.array([[0.03, 0.05, 0.04], [0.02, 0.012, 0.025]])
ARMS = np.array([[0.2, 0.1, 0.0], [-0.1, 0.2, 0.1]])  # where it is tied
PLACES, SPEEDS = np.array([[0, 0, 0], [0.9, 0.2, 0]]), np.array([[0, 0.4, 0], [0, -0.3, 0.5]])
SPINS = np.array([[1.0, 2.0, -1.0], [0.5, -3.0, 1.0]])
TIE = {"stiffness": 30.0, "damping": 0.5, "rest_length": 0.4}


def tumbling_boxes(integrator: str, timestep: float) -> Lab:
    """Two free bodies with three different moments each, on a spring and damper between points of theirs."""
    bodies = {
        name: {
            "mass": MASSES[i],
            "inertia": dict(zip(("xx", "yy", "zz"), MOMENTS[i], strict=True)),
            "position": PLACES[i],
            "velocity": SPEEDS[i],
            "angular_velocity": SPINS[i],
        }
        for i, name in enumerate("ab")
    }
    tie = {"type": "linear", "between": ("a", "b"), "anchors": ARMS} | TIE
    return mechanics(bodies, springs={"tie": tie}, integrator=integrator, timestep=timestep)


def where_boxes_are(scene: Lab) -> Any:
    """Place (3) [m], velocity (3) [m/s] and R (9) of each."""
    turns = [rotation(q).ravel() for q in scene.all("orientation")]
    return np.hstack([scene.all("position"), scene.all("velocity"), turns])


def tumbling_boxes_theory() -> Any:
    """Newton's equations of both centres and Euler's in body axes; of each x, v, R and omega (18)."""
    each = [np.concatenate([PLACES[i], SPEEDS[i], np.eye(3).ravel(), SPINS[i]]) for i in range(2)]
    return moved(rates_of_boxes, np.concatenate(each), TIMES).reshape(-1, 2, 18)[:, :, :15].reshape(-1, 30)


def rates_of_boxes(_: float, y: Any) -> Any:
    parts = [(s[:3], s[3:6], s[6:15].reshape(3, 3), s[15:]) for s in y.reshape(2, 18)]
    both_ends = list(zip(parts, ARMS, strict=True))
    ends = [place + turn @ arm for (place, _, turn, _), arm in both_ends]
    speeds = [speed + turn @ np.cross(spin, arm) for (_, speed, turn, spin), arm in both_ends]
    length = np.linalg.norm(ends[1] - ends[0])
    way = (ends[1] - ends[0]) / length
    tension = TIE["stiffness"] * (length - TIE["rest_length"]) + TIE["damping"] * way @ (
        speeds[1] - speeds[0]
    )
    out = []
    for i, (_, speed, turn, spin) in enumerate(parts):
        force = turn.T @ way * (tension if i == 0 else -tension)
        torque = np.cross(ARMS[i], force) - np.cross(spin, MOMENTS[i] * spin)
        skew = np.array([[0, -spin[2], spin[1]], [spin[2], 0, -spin[0]], [-spin[1], spin[0], 0]])
        out += [speed, turn @ force / MASSES[i], (turn @ skew).ravel(), torque / MOMENTS[i]]
    return np.concatenate(out)


# ------------------------------------------------------------------------------------------------- motions

SLOW = {1: 1e-3, 2: 1e-2, 4: 4e-2}
FAST = {1: 5e-4, 2: 4e-3, 4: 1e-2}
FASTER = {1: 5e-4, 2: 4e-3, 4: 5e-3}
DAMPING = 2.4
MOTIONS = {
    "harmonic oscillator": Motion(oscillator, stretch, lambda: damped_swing(0.0, TIMES), TIMES, SLOW),
    "damped oscillator": Motion(
        lambda i, h: oscillator(i, h, damping=DAMPING),
        stretch,
        lambda: damped_swing(DAMPING, TIMES),
        TIMES,
        SLOW,
    ),
    "two balls on three springs": Motion(
        coupled,
        lambda s: (s.get("position", "a")[0] - 1, s.get("position", "b")[0] - 2),
        coupled_theory,
        TIMES,
        SLOW,
    ),
    "torsional oscillator": Motion(torsional, winding, winding_theory, TIMES, FAST),
    "pendulum": Motion(pendulum, swing, lambda: pendulum_theory(TIMES), TIMES, FAST),
    "damped pendulum": Motion(
        lambda i, h: pendulum(i, h, damping=0.5),
        swing,
        lambda: pendulum_theory(TIMES, damping=0.5),
        TIMES,
        FAST,
    ),
    "double pendulum": Motion(double_pendulum, both, lambda: double_pendulum_theory(TIMES), TIMES, FASTER),
    "two boxes on a spring": Motion(tumbling_boxes, where_boxes_are, tumbling_boxes_theory, TIMES, FASTER),
}
