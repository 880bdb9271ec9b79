"""The six integrators on smooth motion: their recurrences, their order, and what they do to the energy."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from laboratory import GRAVITY, ORDERS, VERLET, Lab, measured, mechanics, samples
from motions import (
    DOWN,
    MASS,
    MOTIONS,
    OMEGA,
    STIFFNESS,
    both,
    damped_swing,
    double_pendulum,
    double_pendulum_theory,
    oscillator,
    pendulum,
    pendulum_theory,
    stretch,
    swing,
)

from physsim.model.stability import largest_step


@cache
def theory_of(name: str) -> Any:
    return MOTIONS[name].theory()


@pytest.mark.parametrize("integrator", ORDERS)
@pytest.mark.parametrize("name", MOTIONS)
def test_order(name, integrator):
    """Over 2 s at ten instants, at three timesteps."""
    motion, order = MOTIONS[name], ORDERS[integrator]
    steps = motion.steps[order] / np.array([1, 2, 4])
    _, slopes = measured(
        lambda h: motion.make(integrator, h), motion.read, theory_of(name), motion.times, steps
    )
    assert slopes == pytest.approx([order, order], abs=0.1)


@pytest.mark.parametrize(
    ("make", "read", "theory"),
    [(pendulum, swing, pendulum_theory), (double_pendulum, both, double_pendulum_theory)],
    ids=["pendulum", "double pendulum"],
)
def test_rk4_with_joints_is_as_accurate_as_with_angles(make, read, theory):
    """5 s in steps of 1 ms. Measured 1.2e-10 and 5.3e-9 (in angles and rates of Lagrange's equations the
    same scheme is off by 4e-9), joints held to 4e-13 m.
    """
    times = np.arange(1.0, 6.0)
    scene = make("rk4", 1e-3)
    error = np.abs(samples(scene, times, read) - theory(times)).max()
    joints = scene.world.joints()
    assert error < 1e-8
    assert joints["violation"].max() < 1e-10
    assert joints["angular_violation"].max() < 1e-10


# ----------------------------------------------------------------------------------- the sheet's recurrences

DRAGS = (0.0, 0.9)
H, STEPS = 0.02, 500


def tethered(integrator: str, drag: float) -> Lab:
    """A ball that swings and bounces in the plane on a spring under gravity, in a viscous medium or
    without.
    """
    ball = {"mass": MASS, "position": (1.5, 0, 0), "velocity": (0, 0, 2)}
    spring = {"type": "linear", "between": ("world", "ball"), "rest_length": 1, "stiffness": STIFFNESS}
    medium = {"air": {"body": "ball", "drag": {"linear": drag}}} if drag else None
    return mechanics(
        {"ball": ball},
        springs={"s": spring},
        forces=medium,
        integrator=integrator,
        timestep=H,
        gravity=DOWN,
    )


def pull(x: Any) -> Any:
    """Acceleration by the spring and gravity."""
    return -STIFFNESS / MASS * (1 - 1 / np.linalg.norm(x)) * x + np.array(DOWN)


def explicit_euler(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """v += a dt and x += v dt, both from the start of the step."""
    for _ in range(STEPS):
        x, v = x + v * H, v + (pull(x) - c * v) * H
    return x, v


def semi_implicit_euler(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """v += a dt, x += v dt with the new velocity."""
    for _ in range(STEPS):
        v = v + (pull(x) - c * v) * H
        x = x + v * H
    return x, v


def verlet(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """x(t + dt) = 2 x(t) - x(t - dt) + a dt^2, where a takes v(t) = (x(t + dt) - x(t - dt)) / 2 dt. It
    starts with x(dt) = x + v dt + a dt^2 / 2.
    """
    before, now = x, x + v * H + (pull(x) - c * v) * H**2 / 2
    for _ in range(STEPS):
        after = (2 * now - (1 - c * H / 2) * before + pull(now) * H**2) / (1 + c * H / 2)
        before, now, last = now, after, before
    return before, (now - last) / (2 * H)


def velocity_verlet(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """x += v dt + a dt^2 / 2, v += (a + a') dt / 2, where a' takes the new velocity."""
    for _ in range(STEPS):
        a = pull(x) - c * v
        x = x + v * H + a * H**2 / 2
        v = (v + (a + pull(x)) * H / 2) / (1 + c * H / 2)
    return x, v


def leapfrog(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """v(t + dt/2) = v(t - dt/2) + a dt, x += v(t + dt/2) dt, where a takes the mean of both as v(t)."""
    half = v + (pull(x) - c * v) * H / 2
    for _ in range(STEPS):
        x = x + half * H
        before = half
        half = ((1 - c * H / 2) * before + pull(x) * H) / (1 + c * H / 2)
    return x, (before + half) / 2


def rk4(x: Any, v: Any, c: float) -> tuple[Any, Any]:
    """Kutta's classical scheme."""
    y = np.array([x, v])
    for _ in range(STEPS):
        k1 = rate(y, c)
        k2 = rate(y + H / 2 * k1, c)
        k3 = rate(y + H / 2 * k2, c)
        k4 = rate(y + H * k3, c)
        y = y + H / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return y[0], y[1]


def rate(y: Any, c: float) -> Any:
    return np.array([y[1], pull(y[0]) - c * y[1]])


@pytest.mark.parametrize("drag", DRAGS)
@pytest.mark.parametrize(
    "recurrence", [explicit_euler, semi_implicit_euler, verlet, velocity_verlet, leapfrog, rk4]
)
def test_every_scheme_is_its_recurrence(recurrence, drag):
    """500 long steps of a motion that is neither linear nor on a line, without and with drag. Measured
    2e-13.
    """
    scene = tethered(recurrence.__name__, drag).step(STEPS)
    x, v = recurrence(np.array([1.5, 0, 0]), np.array([0, 0, 2.0]), drag / MASS)
    assert scene.get("position", "ball") == pytest.approx(x, abs=1e-12)
    assert scene.get("velocity", "ball") == pytest.approx(v, abs=1e-12)


@pytest.mark.parametrize("name", MOTIONS)
def test_the_verlet_family_is_one_map(name):
    """Brought to whole steps the three are the same, to the last bit, also with joints and dampers."""
    states = [MOTIONS[name].make(integrator, 1e-2).step(200).world.state() for integrator in VERLET]
    for key in ("position", "orientation", "velocity", "angular_velocity"):
        assert np.array_equal(states[0][key], states[1][key])
        assert np.array_equal(states[0][key], states[2][key])


@pytest.mark.parametrize("timestep", [1e-1, 1e-2, 1e-3])
@pytest.mark.parametrize("integrator", ORDERS)
def test_a_free_parabola(integrator, timestep):
    """Exact for the Verlet family and Runge-Kutta; the Eulers are half a step of gravity to either side. A
    body that tumbles falls the same.
    """
    box = {
        "shape": {"type": "box", "size": (0.1, 0.2, 0.4)},
        "position": (0, 0, 1),
        "velocity": (2, -1, 3),
        "angular_velocity": (0.3, 5, 0.2),
    }
    flown = mechanics({"box": box}, integrator=integrator, timestep=timestep, gravity=DOWN).run(2.0)
    late = {"explicit_euler": GRAVITY * timestep, "semi_implicit_euler": -GRAVITY * timestep}
    parabola = [4, -2, 1 + 6 - 2 * GRAVITY + late.get(integrator, 0.0)]
    # measured 1.4e-12 at 1 ms and 2e-14 at 0.1 s: rounding of the sums
    assert flown.get("position", "box") == pytest.approx(parabola, abs=3e-12)
    assert flown.get("velocity", "box") == pytest.approx([2, -1, 3 - 2 * GRAVITY], abs=3e-12)


# --------------------------------------------------------------------------------------------------- energy


@pytest.mark.parametrize(
    ("make", "integrator", "timestep"),
    [
        (oscillator, "semi_implicit_euler", 0.05),
        (oscillator, "leapfrog", 0.05),
        (pendulum, "semi_implicit_euler", 5e-3),
        (pendulum, "leapfrog", 5e-3),
        (double_pendulum, "leapfrog", 2e-3),
    ],
    ids=lambda value: getattr(value, "__name__", str(value)),
)
def test_symplectic_schemes_do_not_drift(make, integrator, timestep):
    """1e5 steps: the energy errors of the last tenth fill the same band as those of the first, and their
    means agree to 1 % of it.
    """
    scene = make(integrator, timestep)
    start = scene.energy()
    error = np.array([scene.step(50).energy() - start for _ in range(2000)])
    first, last = error[:200], error[-200:]
    band = np.ptp(first)
    assert np.ptp(last) == pytest.approx(band, rel=0.1)
    assert abs(last.mean() - first.mean()) < 0.01 * band


def test_explicit_euler_gains_energy_by_the_book():
    """A factor of 1 + (omega dt)^2 every step."""
    scene, timestep = oscillator("explicit_euler", 1e-3), 1e-3
    start = scene.energy()
    grown = start * (1 + (OMEGA * timestep) ** 2) ** 100_000
    assert scene.step(100_000).energy() == pytest.approx(grown, rel=1e-9)
    assert scene.book("residual") == pytest.approx(grown - start, rel=1e-9)


def test_explicit_euler_gains_energy_on_a_pendulum_with_a_joint():
    scene = pendulum("explicit_euler", 1e-3)
    energies = [scene.energy(), *(scene.step(500).energy() for _ in range(10))]
    assert np.all(np.diff(energies) > 0)


def test_rk4_loses_energy_by_the_book():
    """|R(i z)|^2 = 1 - z^6 / 72 + z^8 / 576 every step, z = omega dt (Hairer & Wanner, Solving ODEs II,
    IV.2).
    """
    scene, z = oscillator("rk4", 0.05), OMEGA * 0.05
    left = scene.energy() * (1 - z**6 / 72 + z**8 / 576) ** 20_000
    assert scene.step(20_000).energy() == pytest.approx(left, rel=1e-9)


def test_what_symplectic_schemes_keep_exactly():
    """On an oscillator semi-implicit Euler keeps v^2 + w^2 x^2 - w^2 dt x v, and velocity Verlet
    v^2 / (1 - (w dt / 2)^2) + w^2 x^2 (Hairer, Lubich & Wanner, Geometric Numerical Integration, chapter IX).
    Measured 1.3e-13 over 1e5 steps.
    """
    h = 0.05
    kept = {
        "semi_implicit_euler": lambda x, v: v * v + x * x - OMEGA * h * x * v,
        "velocity_verlet": lambda x, v: v * v / (1 - (OMEGA * h / 2) ** 2) + x * x,
    }
    for integrator, invariant in kept.items():
        scene = oscillator(integrator, h)
        start = invariant(*stretch(scene))
        found = [invariant(*stretch(scene.step(997))) for _ in range(100)]
        assert found == pytest.approx([start] * 100, rel=1e-10)


@pytest.mark.parametrize("integrator", ORDERS)
def test_the_books_of_a_damped_oscillator_close(integrator):
    """Lost in the damper: what the closed form says is gone. The residual falls with the scheme's order."""
    order = ORDERS[integrator]
    residuals = []
    for step in MOTIONS["damped oscillator"].steps[order] / np.array([2, 4]):
        scene = oscillator(integrator, step, damping=2.4)
        start = scene.energy()
        scene.run(2.0)
        residuals.append(scene.book("residual"))
        assert scene.energy() + scene.book("lost_damping") == pytest.approx(start + residuals[-1], abs=1e-12)
    x, v = damped_swing(2.4, np.array([2.0]))[0]
    gone = start - STIFFNESS / 2 * (x * x + v * v)
    assert residuals[0] / residuals[1] == pytest.approx(2**order, rel=0.1)
    # measured at most 0.93 of the residual
    assert scene.book("lost_damping") == pytest.approx(gone, abs=2 * abs(residuals[1]))


# ------------------------------------------------------------------------------------------------ stability


@pytest.mark.parametrize("zeta", [0.05, 0.5])
@pytest.mark.parametrize("integrator", ORDERS)
def test_oscillators_grow_beyond_the_bound_that_scenes_are_warned_of(integrator, zeta):
    """2 % below it they die out, 2 % above they grow."""
    left = []
    for part in (0.98, 1.02):
        step = part * largest_step(integrator, zeta)  # of omega = 1 rad/s
        ball = {"position": (10.001, 0, 0)}
        spring = {"type": "linear", "between": ("world", "ball"), "rest_length": 10, "stiffness": 1}
        spring["damping_ratio"] = zeta
        scene = mechanics({"ball": ball}, springs={"s": spring}, integrator=integrator, timestep=step)
        scene.step(1000)
        left.append(np.hypot(scene.get("position", "ball")[0] - 10, scene.get("velocity", "ball")[0]))
    assert left[0] < 0.00095  # of 0.001 m
    assert left[1] > 0.00105
