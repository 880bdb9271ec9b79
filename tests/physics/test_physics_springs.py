"""Springs and dampers against closed forms: linear and torsional, one-sided, by curves, with stops."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from laboratory import GRAVITY, ORDERS, Lab, measured, mechanics, rotation, samples
from motions import tumbling_boxes

MASS, STIFFNESS, REST = 2.0, 50.0, 1.0
OMEGA = np.sqrt(STIFFNESS / MASS)  # 5 rad/s
CRITICAL = 2 * np.sqrt(STIFFNESS * MASS)
TIMES = 0.1 * np.arange(1, 21)


def on_spring(x: float = 0.0, v: float = 0.0, *, timestep: float = 1e-3, **spring: Any) -> Lab:
    """A ball on a spring along x from the world, x from rest, by rk4."""
    ball = {"mass": MASS, "position": (REST + x, 0, 0), "velocity": (v, 0, 0)}
    tied = {"type": "linear", "between": ("world", "ball"), "rest_length": REST} | spring
    return mechanics({"ball": ball}, springs={"s": tied}, timestep=timestep)


def place(scene: Lab) -> float:
    return float(scene.get("position", "ball")[0] - REST)


def speed(scene: Lab) -> float:
    return float(scene.get("velocity", "ball")[0])


def swing(zeta: float, x: float, v: float, times: Any, omega: float = OMEGA) -> Any:
    """x(t) of x'' + 2 zeta omega x' + omega^2 x = 0: of an oscillator that is underdamped, critically damped,
    overdamped (Meriam & Kraige, Dynamics, eqs. 8/12 to 8/14).
    """
    if zeta == 1:
        return (x + (v + omega * x) * times) * np.exp(-omega * times)
    if zeta < 1:
        w, decay = omega * np.sqrt(1 - zeta**2), zeta * omega
        turn = x * np.cos(w * times) + (v + decay * x) / w * np.sin(w * times)
        return turn * np.exp(-decay * times)
    root = np.sqrt(zeta**2 - 1)
    slow, fast = omega * (root - zeta), -omega * (root + zeta)
    share = (v - fast * x) / (slow - fast)
    return share * np.exp(slow * times) + (x - share) * np.exp(fast * times)


# ------------------------------------------------------------------------------------------------ damping


@pytest.mark.parametrize("zeta", [0.0, 0.1, 0.7, 1.0, 2.5])
@pytest.mark.parametrize("way", ["damping", "damping_ratio"])
def test_damped_motion(way, zeta):
    """By coefficient and by ratio, measured 3e-11 m; what the damper took is what is missing, 1.3e-8 J
    of 3.2.
    """
    scene = on_spring(
        0.2, -1.5, stiffness=STIFFNESS, **{way: zeta if way == "damping_ratio" else zeta * CRITICAL}
    )
    start = scene.energy()
    found = samples(scene, TIMES, place)[:, 0]
    assert found == pytest.approx(swing(zeta, 0.2, -1.5, TIMES), abs=1e-10)
    assert scene.book("lost_damping") == pytest.approx(start - scene.energy(), abs=2e-8)


def test_a_critically_damped_spring_does_not_cross_rest():
    scene = on_spring(0.2, 0.0, stiffness=STIFFNESS, damping_ratio=1)
    found = samples(scene, TIMES, place)
    assert np.all(found > 0)
    assert np.all(np.diff(found, axis=0) < 0)


def test_a_damper_alone():
    """v = v0 exp(-c t / m); all of the energy goes into it."""
    scene = on_spring(0.0, 3.0, damping=4.0)
    found = samples(scene, TIMES, speed)[:, 0]
    assert found == pytest.approx(3 * np.exp(-2 * TIMES), abs=1e-11)
    assert scene.book("lost_damping") == pytest.approx(MASS / 2 * (9 - found[-1] ** 2), rel=1e-10)
    assert scene.book("spring") == 0


def test_damping_ratio_counts_both_ends_where_they_are_tied():
    """c = 2 zeta sqrt(k m) with 1/m = n . K n, K of both ends: two boxes tied off their centres, at rest as
    placed, whose ends part with some speed; the tension is c times that.
    """
    zeta, k = 0.3, 80.0
    inertia = np.array([0.03, 0.05, 0.04])
    boxes = {
        "a": {"mass": 2.0, "position": (0, 0, 0)},
        "b": {"mass": 3.0, "position": (0.2, 1.0, -0.3), "velocity": (0.3, 0.9, 0.1)},
    }
    for box in boxes.values():
        box["inertia"] = dict(zip(("xx", "yy", "zz"), inertia, strict=True))
    arms = np.array([[0.1, 0.0, 0.2], [0.0, -0.1, 0.15]])
    spring = {"type": "linear", "between": ("a", "b"), "anchors": arms, "stiffness": k, "damping_ratio": zeta}
    scene = mechanics(boxes, springs={"s": spring})
    apart = np.array(boxes["b"]["position"]) + arms[1] - arms[0]
    length = np.linalg.norm(apart)
    n = apart / length
    levers = np.cross(arms, n)
    mobility = 1 / 2.0 + 1 / 3.0 + np.sum(levers**2 / inertia)
    damping = 2 * zeta * np.sqrt(k / mobility)
    assert scene.spring("s") == pytest.approx((length, damping * (n @ boxes["b"]["velocity"])), rel=1e-14)


def test_a_spring_without_rest_length_draws_ellipses():
    """F = -k r in every direction: x cos(w t) + v sin(w t) / w. Measured 1.2e-11 m."""
    x, v = np.array([0.3, 0, 0]), np.array([0, 0.5, -0.4])
    spring = {"type": "linear", "between": ("world", "ball"), "rest_length": 0, "stiffness": STIFFNESS}
    scene = mechanics({"ball": {"mass": MASS, "position": x, "velocity": v}}, springs={"s": spring})
    found = samples(scene, TIMES, lambda s: s.get("position", "ball"))
    truth = np.outer(np.cos(OMEGA * TIMES), x) + np.outer(np.sin(OMEGA * TIMES), v) / OMEGA
    assert found == pytest.approx(truth, abs=3e-11)


def test_a_spring_that_is_passed_through_pulls_back_from_the_other_side():
    """Straight through its own anchor, where its direction turns over. Measured 6e-12 m."""
    spring = {"type": "linear", "between": ("world", "ball"), "rest_length": 0, "stiffness": STIFFNESS}
    spring["damping_ratio"] = 0.1
    scene = mechanics({"ball": {"mass": MASS, "position": (0.3, 0, 0)}}, springs={"s": spring})
    found = samples(scene, TIMES, lambda s: s.get("position", "ball")[0])[:, 0]
    assert found == pytest.approx(swing(0.1, 0.3, 0.0, TIMES), abs=1e-11)


# ------------------------------------------------------------------------------------------ several bodies


def test_two_bodies_on_a_spring():
    """The distance swings with the reduced mass, measured 3e-11 m; the centre flies straight."""
    m1, m2, k, c = 2.0, 3.0, 60.0, 1.5
    bodies = {
        "a": {"mass": m1, "velocity": (0, 1, 0)},
        "b": {"mass": m2, "position": (1.3, 0, 0), "velocity": (0, 1, 0)},
    }
    spring = {"type": "linear", "between": ("a", "b"), "rest_length": 1, "stiffness": k, "damping": c}
    scene = mechanics(bodies, springs={"s": spring})
    found = samples(scene, TIMES, lambda s: s.spring("s")[0])[:, 0]
    omega = np.sqrt(k * (1 / m1 + 1 / m2))
    zeta = c * (1 / m1 + 1 / m2) / (2 * omega)
    assert found == pytest.approx(1 + swing(zeta, 0.3, 0.0, TIMES, omega), abs=1e-9)
    centre = (m1 * scene.get("position", "a") + m2 * scene.get("position", "b")) / (m1 + m2)
    assert centre == pytest.approx([1.3 * m2 / (m1 + m2), 2, 0], abs=1e-12)


def test_modes_of_a_chain():
    """Five balls between walls on six springs: omega_j = 2 sqrt(k/m) sin(j pi / 12), shapes sin(j i pi / 6)
    (Goldstein, Classical Mechanics, sec. 12.1). Measured 5e-10 m.
    """
    n, k = 5, 40.0
    numbers = np.arange(1, n + 1)
    shapes = np.sin(np.outer(numbers, numbers) * np.pi / (n + 1))
    pulses = 2 * np.sqrt(k) * np.sin(numbers * np.pi / (2 * n + 2))
    start = np.array([0.1, -0.05, 0.2, 0.0, 0.15])
    amplitudes = np.linalg.solve(shapes.T, start)
    bodies = {f"b{i}": {"position": (i + x, 0, 0)} for i, x in zip(numbers, start, strict=True)}
    names = ["world", *bodies, "world"]
    springs = {
        f"s{i}": {
            "type": "linear",
            "between": (names[i], names[i + 1]),
            "anchors": ((0, 0, 0), ((n + 1) * (i == n), 0, 0)),
            "rest_length": 1,
            "stiffness": k,
        }
        for i in range(n + 1)
    }
    scene = mechanics(bodies, springs=springs)
    found = samples(scene, TIMES, lambda s: s.all("position")[:, 0] - numbers)
    truth = (amplitudes * np.cos(np.outer(TIMES, pulses))) @ shapes
    assert found == pytest.approx(truth, abs=1e-9)


def test_the_books_of_two_tumbling_boxes_on_a_spring_and_a_damper():
    """Measured 2e-10 of 13 J; where they go to is among the motions whose order is measured."""
    scene = tumbling_boxes("rk4", 1e-3)
    start = scene.energy()
    scene.run(2.0)
    assert abs(scene.book("residual")) < 1e-9
    assert scene.book("lost_damping") == pytest.approx(start - scene.energy(), abs=1e-9)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_ball_on_a_spring_whose_other_end_is_shaken(integrator):
    """x'' + 2 zeta w x' + w^2 x = w^2 u + 2 zeta w u' with u = U sin(W t), from rest: a steady swing of the
    complex amplitude U (w^2 + 2 i zeta w W) / (w^2 - W^2 + 2 i zeta w W), and what dies out. The books
    close with the work of what shakes it.
    """
    zeta, shaken, pulse, order = 0.2, 0.1, 2 * np.pi * 0.6, ORDERS[integrator]
    response = OMEGA**2 + 2j * zeta * OMEGA * pulse
    steady = shaken * response / (response - pulse**2) * np.exp(1j * pulse * TIMES)
    first = shaken * response / (response - pulse**2)
    truth = steady.imag + swing(zeta, -first.imag, -(1j * pulse * first).imag, TIMES)

    def shaking(timestep: float) -> Lab:
        profile = {"type": "sine", "frequency": 0.6}
        table = {"fixed": True, "motion": {"translation": (shaken, 0, 0), "profile": profile}}
        spring = {"type": "linear", "between": ("table", "ball"), "rest_length": REST, "stiffness": STIFFNESS}
        return mechanics(
            {"table": table, "ball": {"mass": MASS, "position": (REST, 0, 0)}},
            springs={"s": spring | {"damping_ratio": zeta}},
            integrator=integrator,
            timestep=timestep,
        )

    steps = {1: 1e-3, 2: 1e-2, 4: 2e-2}[order] / np.array([1, 2, 4])
    _, slopes = measured(shaking, place, truth[:, None], TIMES, steps)
    books = [shaking(step).run(2.0).book("residual") for step in steps]
    assert slopes == pytest.approx([order, order], abs=0.1)
    assert np.log2(np.array(books)[:-1] / books[1:]) == pytest.approx([order, order], abs=0.1)


# --------------------------------------------------------------------------- preload, ropes, bumpers, curves


def test_rest_length_is_that_as_placed_when_it_is_left_out():
    scene = on_spring(0.3, 0.0, stiffness=STIFFNESS)
    free = mechanics(
        {"ball": {"position": (1.3, 0, 0)}},
        springs={"s": {"type": "linear", "between": ("world", "ball"), "stiffness": 5}},
    )
    assert scene.spring("s") == pytest.approx((1.3, 0.3 * STIFFNESS))
    assert free.spring("s") == (1.3, 0)


def test_preload_shifts_the_equilibrium():
    """x swings about -F0 / k; stored: k x^2 / 2 + F0 x."""
    scene = on_spring(0.0, 0.0, stiffness=STIFFNESS, preload=5.0)
    assert scene.spring("s") == (REST, 5.0)
    found = samples(scene, TIMES, place)[:, 0]
    assert found == pytest.approx(-0.1 * (1 - np.cos(OMEGA * TIMES)), abs=1e-11)
    x = found[-1]
    assert scene.book("spring") == pytest.approx(STIFFNESS / 2 * x * x + 5 * x, abs=1e-11)
    assert abs(scene.book("residual")) < 1e-11


@pytest.mark.parametrize(("acts", "side"), [("tension", 1), ("compression", -1)])
def test_ropes_and_bumpers(acts, side):
    """Free flight at v until the spring takes hold, half a swing of pi / omega, back at v: e = 1. A rope
    holds beyond its rest length and a bumper below it. Measured 7e-8 m: steps that pass the rest length do
    not see its kink.
    """
    ahead, v = 0.25, 1.0
    scene = on_spring(-side * ahead, side * v, stiffness=STIFFNESS, acts=acts)
    assert scene.spring("s")[1] == 0
    reaches = ahead / v
    leaves = reaches + np.pi / OMEGA
    held = (reaches < TIMES) & (leaves > TIMES)
    flown = np.where(reaches > TIMES, v * TIMES - ahead, v * (leaves - TIMES))
    truth = side * np.where(held, v / OMEGA * np.sin(OMEGA * (TIMES - reaches)), flown)
    tensions: list[float] = []

    def seen(scene: Lab) -> float:
        tensions.append(scene.spring("s")[1])
        return place(scene)

    found = samples(scene, TIMES, seen)[:, 0]
    assert found == pytest.approx(truth, abs=2e-7)
    assert np.array(tensions) == pytest.approx(np.where(held, STIFFNESS * truth, 0), abs=1e-5)
    assert scene.energy() == pytest.approx(MASS / 2 * v * v, abs=1e-6)


def test_a_rope_with_a_damper_never_pushes():
    """Overdamped on its way back the sum of spring and damper would push: it is cut at zero."""
    scene = on_spring(0.1, -3.0, stiffness=STIFFNESS, damping=40.0, acts="tension")
    assert scene.spring("s") == (REST + 0.1, 0)
    assert speed(scene.run(0.3)) == pytest.approx(-3.0, abs=1e-12)
    bumper = on_spring(-0.1, 3.0, stiffness=STIFFNESS, damping=40.0, acts="compression")
    assert bumper.spring("s") == (REST - 0.1, 0)


CURVE = ((-0.2, -30.0), (0.0, 0.0), (0.1, 4.0), (0.3, 20.0))


@pytest.mark.parametrize("x", [-0.35, -0.2, -0.07, 0.0, 0.04, 0.1, 0.22, 0.5])
def test_tension_by_a_curve(x):
    """Straight lines between samples, the outer ones go on; the stored energy is the integral."""
    outer = ((-0.5, -75.0), *CURVE, (0.6, 44.0))
    stretches, tensions = np.array(outer).T
    scene = on_spring(x, 0.0, force_curve=CURVE)
    assert scene.spring("s")[1] == pytest.approx(np.interp(x, stretches, tensions), abs=1e-12)
    grid = np.union1d(np.linspace(0, x, 3), [s for s in stretches if min(0, x) <= s <= max(0, x)])
    stored = np.trapezoid(np.interp(grid, stretches, tensions), grid) * np.sign(x)
    assert scene.book("spring") == pytest.approx(stored, abs=1e-12)


def test_motion_on_a_curve_keeps_its_energy():
    """Out to the turning point where the curve has stored the kinetic energy: 0.2 J to 0.1 m, then
    4 d + 40 d^2 more.
    """
    v = 1.0
    scene = on_spring(0.0, v, force_curve=CURVE, timestep=2e-4)
    d = (-4 + np.sqrt(16 + 160 * (MASS / 2 * v * v - 0.2))) / 80
    furthest = max(place(scene.step()) for _ in range(3000))
    assert furthest == pytest.approx(0.1 + d, abs=1e-6)
    assert abs(scene.book("residual")) < 1e-6


@pytest.mark.parametrize("v", [-3.0, -0.5, 0.0, 0.5, 2.0, 5.0])
def test_damping_by_a_curve(v):
    """A shock absorber that is soft in and hard out; lines go on outside."""
    curve = ((-1.0, -2.0), (0.0, 0.0), (1.0, 10.0), (2.0, 14.0))
    scene = on_spring(0.0, v, damping_curve=curve)
    outer = ((-5.0, -10.0), *curve, (6.0, 30.0))
    assert scene.spring("s")[1] == pytest.approx(np.interp(v, *np.array(outer).T), abs=1e-12)


def test_motion_against_a_damping_curve():
    """Below 1 m/s out the curve is a damper of 10 N s/m: v0 exp(-c t / m)."""
    curve = ((-1.0, -2.0), (0.0, 0.0), (1.0, 10.0), (2.0, 14.0))
    scene = on_spring(0.0, 0.8, damping_curve=curve)
    found = samples(scene, TIMES, speed)[:, 0]
    assert found == pytest.approx(0.8 * np.exp(-5 * TIMES), abs=1e-10)
    assert scene.book("lost_damping") == pytest.approx(MASS / 2 * 0.64, rel=1e-8)


# -------------------------------------------------------------------------------------------------- stops


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("v", [1.0, -1.0])
def test_a_stop_throws_back(v, e):
    """A spring without stiffness but between lengths: free flight, -e v at the stop, which was hit at
    |limit| / v. The place is off by what the step in which it is hit moves, (1 + e) v dt at most.
    """
    scene = on_spring(
        0.0, v, damping=0.0, stiffness=0.0, preload=0.0, limits=(REST - 0.3, REST + 0.3), restitution=e
    )
    scene.run(0.5)
    assert speed(scene) == pytest.approx(-e * v, abs=1e-12)
    assert place(scene) == pytest.approx(np.sign(v) * (0.3 - e * 0.2), abs=(1 + e) * 1e-3)
    assert scene.book("lost_impact") == pytest.approx(MASS / 2 * v * v * (1 - e * e), abs=1e-12)


@pytest.mark.parametrize("integrator", ORDERS)
@pytest.mark.parametrize("way", [1, -1])
def test_a_stop_without_restitution_holds_where_it_is(way, integrator):
    """A ball comes to rest at the limit itself, and stays when it is pushed against it."""
    ball = {"mass": MASS, "position": (REST, 0, 0), "velocity": (way * 1.0, 0, 0)}
    tied = {"type": "linear", "between": ("world", "ball"), "limits": (REST - 0.30037, REST + 0.30037)}
    push = {"push": {"body": "ball", "force": (way * 5.0, 0, 0), "from": 0.5}}
    scene = mechanics(
        {"ball": ball}, springs={"s": tied | {"preload": 0.0}}, forces=push, integrator=integrator
    )
    for _ in range(5):
        scene.run(0.4)
        assert place(scene) == pytest.approx(way * 0.30037, abs=1e-12)
        assert speed(scene) == pytest.approx(0, abs=1e-12)


def test_a_ball_between_elastic_stops():
    """Thirty times to and fro: the speed stays."""
    scene = on_spring(0.0, 1.0, limits=(REST - 0.3, REST + 0.3), stiffness=0.0, restitution=1).run(18.0)
    assert abs(speed(scene)) == pytest.approx(1.0, abs=1e-12)
    assert abs(place(scene)) < 0.301


def test_a_spring_ends_at_its_stop():
    """Let go at 0.2 m: over rest at omega 0.2 m, into the stop at 0.1 m, and back with e times what was
    left.
    """
    e = 0.6
    scene = on_spring(0.2, 0.0, stiffness=STIFFNESS, limits=(REST - 0.1, 2.0), restitution=e)
    arrives = OMEGA * np.sqrt(0.2**2 - 0.1**2)
    lost = MASS / 2 * arrives**2 * (1 - e * e)
    scene.run(0.6)
    # an impact comes up to a step late: the work of the spring in a step, 0.004 J; measured 0.0016
    assert scene.book("lost_impact") == pytest.approx(lost, abs=STIFFNESS * 0.1 * arrives * 1e-3)
    assert abs(scene.book("residual")) < 1e-5


# ------------------------------------------------------------------------------------------------ torsion

INERTIA, TORSION = 0.02, 0.5  # of a wheel of 1 kg and 0.2 m [kg m2], [N m/rad]
PULSE = np.sqrt(TORSION / INERTIA)
AXLE = np.array([2.0, -1.0, 2.0]) / 3
ALONG = np.array(
    [np.cos(0.5 * np.arccos(2 / 3)), *(np.sin(0.5 * np.arccos(2 / 3)) * np.array([1, 2, 0]) / 5**0.5)]
)
WHEEL = {"shape": {"type": "cylinder", "radius": 0.2, "height": 0.1}, "orientation": {"quaternion": ALONG}}


def wound(rate: float = 0.0, **spring: Any) -> Lab:
    """A wheel on a torsional spring about its own tilted axle, turning. rk4, 1 ms."""
    shaft = {"type": "torsional", "between": ("world", "wheel"), "axis": AXLE} | spring
    return mechanics({"wheel": WHEEL | {"angular_velocity": rate * AXLE}}, springs={"shaft": shaft})


def angle(scene: Lab) -> float:
    return scene.spring("shaft")[0]


def test_the_wheel_stands_on_its_axle():
    assert rotation(ALONG)[:, 2] == pytest.approx(AXLE, abs=1e-15)


@pytest.mark.parametrize("zeta", [0.0, 0.2, 1.0, 2.0])
@pytest.mark.parametrize("way", ["damping", "damping_ratio"])
def test_damped_torsion(way, zeta):
    """I a'' + c a' + k a = 0 from a rest angle of -0.4 rad. Measured 4e-11 rad."""
    critical = 2 * np.sqrt(TORSION * INERTIA)
    damped = {way: zeta if way == "damping_ratio" else zeta * critical}
    scene = wound(2.0, stiffness=TORSION, rest_angle=-0.4, **damped)
    start = scene.energy()
    found = samples(scene, TIMES, angle)[:, 0]
    assert found + 0.4 == pytest.approx(swing(zeta, 0.4, 2.0, TIMES, PULSE), abs=1e-9)
    assert scene.book("lost_damping") == pytest.approx(start - scene.energy(), abs=2e-9)


@pytest.mark.parametrize("way", [1, -1])
def test_torsion_over_many_turns(way):
    """At 40 rad/s against a spring of 1 rad/s: six turns and more to either side, and the angle counts them
    all. Measured 1.1e-7 rad.
    """
    scene = wound(40.0 * way, stiffness=INERTIA)
    found = samples(scene, 4 * TIMES, angle)[:, 0]
    assert np.ptp(found) > 12 * 2 * np.pi
    assert found == pytest.approx(way * 40 * np.sin(4 * TIMES), abs=2e-7)
    assert scene.book("spring") == pytest.approx(INERTIA / 2 * found[-1] ** 2, rel=1e-12)


def test_torsion_between_two_wheels():
    """The twist swings with the reduced moment; the mean spin stays. Measured 2e-11 rad."""
    small, large = INERTIA, 3 * INERTIA
    bodies = {
        "a": WHEEL | {"angular_velocity": 3 * AXLE},
        "wheel": WHEEL | {"mass": 3.0, "angular_velocity": -1 * AXLE},
    }
    shaft = {"type": "torsional", "between": ("a", "wheel"), "axis": AXLE, "stiffness": TORSION}
    shaft["damping_ratio"] = 0.1
    scene = mechanics(bodies, springs={"shaft": shaft})
    pulse = np.sqrt(TORSION * (1 / small + 1 / large))
    found = samples(scene, TIMES, angle)[:, 0]
    assert found == pytest.approx(swing(0.1, 0.0, -4.0, TIMES, pulse), abs=1e-9)
    assert scene.momentum()[1] == pytest.approx((3 * small - large) * AXLE, abs=1e-14)


def test_torsion_between_tumbling_bodies_keeps_energy_and_angular_momentum():
    """Also where the axes come apart: the torque is the gradient of the energy. Measured 5e-12 J, 2e-16."""
    spin = {"a": (0.5, 0.3, 1.0), "b": (-0.4, 0.6, -2.0)}
    moments = {"a": {"xx": 0.03, "yy": 0.05, "zz": 0.04}, "b": {"xx": 0.02, "yy": 0.012, "zz": 0.025}}
    bodies = {name: {"inertia": moments[name], "angular_velocity": spin[name]} for name in "ab"}
    shaft = {"type": "torsional", "between": ("a", "b"), "axis": (0, 0.6, 0.8), "stiffness": 0.5}
    scene = mechanics(bodies, springs={"shaft": shaft})
    before = scene.momentum()[1]
    scene.run(3.0)
    assert scene.momentum()[1] == pytest.approx(before, abs=1e-14)
    assert abs(scene.book("residual")) < 2e-11


def test_torque_by_preload_and_curves():
    """At rest angle 0 with 0.3 N m; by straight lines, which go on outside."""
    assert wound(0.0, preload=0.3).spring("shaft") == (0.0, 0.3)
    curve = ((-1.0, -2.0), (0.0, 0.0), (1.0, 0.5))
    assert wound(0.0, torque_curve=curve, rest_angle=-3.0).spring("shaft")[1] == pytest.approx(1.5)
    assert wound(0.0, torque_curve=curve, rest_angle=2.0).spring("shaft")[1] == pytest.approx(-4.0)
    assert wound(2.5, damping_curve=curve).spring("shaft")[1] == pytest.approx(1.25)


def test_a_preloaded_torsional_spring_starts_to_turn_back():
    """a = -T0/k (1 - cos(w t))."""
    scene = wound(0.0, preload=0.3, stiffness=TORSION)
    found = samples(scene, TIMES, angle)[:, 0]
    assert found == pytest.approx(-0.6 * (1 - np.cos(PULSE * TIMES)), abs=1e-9)


# ------------------------------------------------------------------------------------------------- ledgers


@pytest.mark.parametrize("integrator", ORDERS)
def test_the_books_of_a_rope_with_a_damper_close(integrator):
    """A heavy ball falls into a damped rope: the residual is the scheme's own error and shrinks with the
    step, at least in proportion (the rope's kink costs the higher orders).
    """
    residuals = []
    for timestep in (1e-3, 2.5e-4):
        ball = {"mass": MASS, "position": (0, 0, -0.2)}
        rope = {
            "type": "linear",
            "between": ("world", "ball"),
            "rest_length": 0.5,
            "stiffness": 400,
            "damping": 8,
        }
        scene = mechanics(
            {"ball": ball},
            springs={"rope": rope | {"acts": "tension"}},
            integrator=integrator,
            timestep=timestep,
            gravity=(0, 0, -GRAVITY),
        ).run(2.0)
        residuals.append(scene.book("residual"))
    assert abs(residuals[1]) < abs(residuals[0]) / 3.5
