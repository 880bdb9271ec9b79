"""Declared forces, their profiles and windows, drag, and fields, against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from laboratory import GRAVITY, ORDERS, VERLET, Lab, mechanics, samples
from workbench import moved

MASS = 2.0
PUSH = np.array([6.0, -2.0, 4.0])
ACCELERATION = PUSH / MASS
EXACT = (*VERLET, "rk4")  # on a parabola
LEAD = {"explicit_euler": -0.5, "semi_implicit_euler": 0.5}  # steps by which places are ahead of a parabola's
DOWN = (0, 0, -GRAVITY)
TIMES = 0.1 * np.arange(1, 21)


def pushed(integrator: str = "rk4", timestep: float = 1e-3, **force: Any) -> Lab:
    """A ball under one force from rest."""
    push = {"body": "ball", "force": PUSH} | force
    return mechanics(
        {"ball": {"mass": MASS}}, forces={"push": push}, integrator=integrator, timestep=timestep
    )


def place(scene: Lab) -> Any:
    return scene.get("position", "ball")


def speed(scene: Lab) -> Any:
    return scene.get("velocity", "ball")


# ----------------------------------------------------------------------------------------------- windows


@pytest.mark.parametrize("integrator", ORDERS)
@pytest.mark.parametrize(
    ("start", "end", "timestep"),
    [(0.0, 0.5, 1e-3), (0.1, 0.7, 1e-3), (0.3, 0.9, 1e-1), (0.29, 0.58, 1e-2), (0.07, 0.14, 7e-3)],
)
def test_a_force_from_and_until(integrator, start, end, timestep):
    """v = a (until - from) to rounding, and so is x, but for the half step of v by which the Eulers are
    off. Work and energy agree, but for explicit Euler, which gains m a^2 dt / 2 a second.
    """
    scene = pushed(integrator, timestep, **{"from": start, "until": end})
    steps = round(1.05 / timestep)
    scene.step(steps)
    time, gained = steps * timestep, ACCELERATION * (end - start)
    way = gained * ((end - start) / 2 + time - end + LEAD.get(integrator, 0.0) * timestep)
    assert speed(scene) == pytest.approx(gained, abs=1e-12)
    assert place(scene) == pytest.approx(way, abs=1e-12)
    ahead = MASS / 2 * ACCELERATION @ ACCELERATION * timestep * (end - start)  # of explicit Euler's energy
    gains = ahead if integrator == "explicit_euler" else 0.0
    assert scene.book("residual") == pytest.approx(gains, abs=1e-12)
    assert scene.book("work_forces") == pytest.approx(MASS / 2 * gained @ gained - gains, abs=1e-12)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_force_that_begins_and_ends_inside_steps(integrator):
    """The impulse is exact: such a step has the share of the force that it deserves. Places are off by the
    two shifts within a step, less than a dt^2 / 4 together, besides the Eulers' half step.
    """
    start, end = 0.10037, 0.50081
    for timestep in (1e-2, 1e-3):
        scene = pushed(integrator, timestep, **{"from": start, "until": end}).run(1.0)
        gained = ACCELERATION * (end - start)
        way = gained * ((end - start) / 2 + 1.0 - end + LEAD.get(integrator, 0.0) * timestep)
        assert speed(scene) == pytest.approx(gained, abs=1e-12)
        assert place(scene) == pytest.approx(way, abs=3 * timestep**2 / 4)


def test_a_push_shorter_than_a_step():
    """2 ms within a step of 10 ms, and a profile that steps in between two instants."""
    brief = pushed("rk4", 1e-2, **{"from": 0.103, "until": 0.105}).run(0.5)
    assert speed(brief) == pytest.approx(ACCELERATION * 0.002, abs=1e-13)
    late = pushed("rk4", 1e-2, profile={"type": "step", "at": 0.103}, **{"from": 0.1, "until": 0.3037}).run(
        0.5
    )
    assert speed(late) == pytest.approx(ACCELERATION * 0.1007, abs=1e-13)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_step_in_the_profile_is_an_edge(integrator):
    """Counted from `from`: on from 0.2 + 0.3 s."""
    scene = pushed(integrator, profile={"type": "step", "at": 0.3}, **{"from": 0.2}).run(1.0)
    gained = ACCELERATION * 0.5
    assert speed(scene) == pytest.approx(gained, abs=1e-12)
    assert place(scene) == pytest.approx(gained * (0.25 + LEAD.get(integrator, 0) * 1e-3), abs=1e-12)


@pytest.mark.parametrize("integrator", EXACT)
def test_ramps_and_tables_give_exact_velocities(integrator):
    """Trapezoids and Simpson's rule are exact on straight lines: t^2 / 2T on the ramp, areas under the
    table.
    """
    ramp = pushed(integrator, profile={"type": "ramp", "over": 0.8}).run(1.0)
    assert speed(ramp) == pytest.approx(ACCELERATION * 0.6, abs=1e-12)
    half = pushed(integrator, profile={"type": "ramp", "over": 0.8}).run(0.4)
    assert speed(half) == pytest.approx(ACCELERATION * 0.1, abs=1e-12)
    points = ((0.1, 1), (0.3, 3), (0.4, 0), (0.6, -2))
    table = pushed(integrator, profile={"type": "table", "samples": points}, **{"from": 0.1}).run(1.0)
    area = 0.1 * 1 + 0.2 * 2 + 0.1 * 1.5 + 0.2 * -1 + 0.3 * -2  # constant outside the samples
    assert speed(table) == pytest.approx(ACCELERATION * area, abs=1e-12)


def test_places_on_a_ramp():
    """x = a t^3 / 6 T while it rises: Runge-Kutta is exact on cubics."""
    scene = pushed("rk4", profile={"type": "ramp", "over": 0.8}).run(0.8)
    assert place(scene) == pytest.approx(ACCELERATION * 0.8**2 / 6, abs=1e-12)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_sine(integrator):
    """v = a (cos p - cos(w t + p)) / w; x from it. Of the scheme's order."""
    frequency, phase, order = 1.5, 0.4, ORDERS[integrator]
    w = 2 * np.pi * frequency
    t = 0.5 * np.arange(1, 5)
    v = (np.cos(phase) - np.cos(w * t + phase)) / w
    x = (np.cos(phase) * t - (np.sin(w * t + phase) - np.sin(phase)) / w) / w
    truth = np.column_stack([np.outer(x, ACCELERATION), np.outer(v, ACCELERATION)])
    found = []
    for timestep in {1: (1e-3, 5e-4), 2: (1e-2, 5e-3), 4: (2e-2, 1e-2)}[order]:
        profile = {"type": "sine", "frequency": frequency, "phase": phase}
        scene = pushed(integrator, timestep, profile=profile)
        found.append(np.abs(samples(scene, t, lambda s: [*place(s), *speed(s)]) - truth).max())
    assert np.log2(found[0] / found[1]) == pytest.approx(order, abs=0.1)


def test_an_expression():
    """sin(2 pi t) exp(-t) from 0.25 s on, as a formula: its integral in closed form. Measured 4e-13."""
    profile = {"type": "expression", "value": '"sin(2*pi*t) * exp(-t)"'}
    scene = pushed(profile=profile, **{"from": 0.25})
    t, w = TIMES[TIMES > 0.25] - 0.25, 2 * np.pi
    area = (w - np.exp(-t) * (w * np.cos(w * t) + np.sin(w * t))) / (1 + w * w)
    found = samples(scene, TIMES, speed)
    assert found[TIMES > 0.25] == pytest.approx(np.outer(area, ACCELERATION), abs=1e-11)
    assert np.all(found[TIMES < 0.25] == 0)


# -------------------------------------------------------------------------------------- points and axes

MOMENT = 0.02  # of a wheel of 1 kg and 0.2 m about its axis
WHEEL = {"shape": {"type": "cylinder", "radius": 0.2, "height": 0.1}}


def spin(scene: Lab) -> float:
    return float(scene.get("angular_velocity", "wheel")[2])


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_torque(integrator):
    """omega = M t / I to rounding; the angle is M t^2 / 2 I, half a step off in the Eulers."""
    scene = mechanics(
        {"wheel": WHEEL},
        forces={"turn": {"body": "wheel", "torque": (0, 0, 0.03)}},
        integrator=integrator,
        timestep=1e-3,
    ).run(1.0)
    _, *axis = q = scene.get("orientation", "wheel")
    angle = 2 * np.arctan2(axis[2], q[0])
    lag = LEAD.get(integrator, 0.0) * 1e-3
    assert spin(scene) == pytest.approx(1.5, abs=1e-12)
    # explicit Euler turns by tangents, too little by w^2 dt^2 / 12 of it: measured 7e-8
    assert angle == pytest.approx(1.5 * (0.5 + lag), abs=1e-7 if integrator == "explicit_euler" else 1e-12)


def test_a_force_at_a_point_in_body_axes():
    """A nozzle on the rim: omega = F R t / I, angle alpha t^2 / 2, and the thrust turns along: v is a Fresnel
    integral.
    """
    from scipy.special import fresnel  # noqa: PLC0415

    thrust, radius = 0.4, 0.2
    nozzle = {"body": "wheel", "force": (0, thrust, 0), "at": (radius, 0, 0), "frame": "body"}
    scene = mechanics({"wheel": WHEEL}, forces={"nozzle": nozzle})
    alpha = thrust * radius / MOMENT
    s, c = fresnel(TIMES * np.sqrt(alpha / np.pi))
    v = thrust * np.sqrt(np.pi / alpha) * np.column_stack([-s, c])
    found = samples(scene, TIMES, lambda s: [spin(s), *s.get("velocity", "wheel")])
    assert found[:, 0] == pytest.approx(alpha * TIMES, abs=1e-11)
    assert found[:, 1:3] == pytest.approx(v, abs=1e-9)
    assert abs(scene.book("residual")) < 1e-9


def test_a_force_in_world_axes_pulls_a_body_round():
    """At a point of a wheel it makes a pendulum: I a'' = -F R sin(a)."""
    force, radius = 0.4, 0.2
    pull = {"body": "wheel", "force": (force, 0, 0), "at": (radius, 0, 0)}
    start = {"orientation": {"axis": (0, 0, 1), "angle": 1.2}}
    scene = mechanics({"wheel": WHEEL | start}, forces={"pull": pull})
    rate = force * radius / MOMENT
    truth = moved(lambda _, y: [y[1], -rate * np.sin(y[0])], [1.2, 0.0], TIMES)[:, 1]
    found = samples(scene, TIMES, spin)[:, 0]
    assert found == pytest.approx(truth, abs=1e-10)


def test_the_point_is_of_the_body_not_of_its_centre_of_mass():
    """Two balls at 0 and 0.4 m: the centre of mass is halfway, and a force at the origin has that arm."""
    balls = [{"shape": {"type": "sphere", "radius": 0.1}, "position": (0, 0, z)} for z in (0, 0.4)]
    push = {"body": "pair", "force": (2.0, 0, 0), "at": (0, 0, 0)}
    bodies = {"pair": {"shape": {"type": "compound", "parts": balls}}}
    scene = mechanics(bodies, forces={"push": push}, timestep=1e-6).step()
    turned = scene.get("angular_velocity", "pair")
    assert turned == pytest.approx([0, -0.2 * 2.0 * 1e-6 / scene.model.inertia[0][1, 1], 0], rel=1e-9)


# ------------------------------------------------------------------------------------------------- drag


def falling(**drag: Any) -> Lab:
    ball = {"ball": {"mass": MASS, "position": (0, 0, 0)}}
    return mechanics(ball, forces={"air": {"body": '"*"', "drag": drag}}, gravity=DOWN)


def test_falling_with_linear_drag():
    """v = vt (1 - exp(-t / tau)), x = vt (t - tau (1 - exp(-t / tau))), tau = m / c, vt = g tau."""
    scene, tau = falling(linear=3.0), MASS / 3.0
    found = samples(scene, TIMES, lambda s: [-place(s)[2], -speed(s)[2]])
    grown = 1 - np.exp(-TIMES / tau)
    truth = GRAVITY * tau * np.column_stack([TIMES - tau * grown, grown])
    assert found == pytest.approx(truth, abs=1e-11)
    assert abs(scene.book("residual")) < 1e-10


def test_falling_with_quadratic_drag():
    """v = vt tanh(g t / vt), x = vt^2 / g ln cosh(g t / vt), vt = sqrt(2 m g / rho C A)."""
    rho, area, coefficient = 1.2, 2.0, 0.9
    scene = falling(density=rho, area=area, coefficient=coefficient)
    terminal = np.sqrt(2 * MASS * GRAVITY / (rho * coefficient * area))
    found = samples(scene, TIMES, lambda s: [-place(s)[2], -speed(s)[2]])
    z = GRAVITY * TIMES / terminal
    truth = np.column_stack([terminal**2 / GRAVITY * np.log(np.cosh(z)), terminal * np.tanh(z)])
    assert found == pytest.approx(truth, abs=1e-11)
    assert abs(scene.book("residual")) < 1e-10
    assert -speed(scene.run(8.0))[2] == pytest.approx(terminal, rel=1e-12)


@pytest.mark.parametrize("integrator", ORDERS)
def test_every_integrator_falls_at_the_terminal_speed(integrator):
    """A balance of forces is a balance in every scheme."""
    air = {"body": "ball", "drag": {"linear": 1.0, "density": 1.2, "area": 2.0, "coefficient": 0.9}}
    scene = mechanics(
        {"ball": {"mass": MASS}}, forces={"air": air}, integrator=integrator, timestep=1e-2, gravity=DOWN
    )
    b = 0.5 * 1.2 * 2.0 * 0.9
    terminal = (-1.0 + np.sqrt(1 + 4 * b * MASS * GRAVITY)) / (2 * b)
    assert -speed(scene.run(20.0))[2] == pytest.approx(terminal, rel=1e-12)


def test_coasting_with_linear_and_quadratic_drag():
    """v' = -(p v + q v^2): v = p v0 e / (p + q v0 (1 - e)), e = exp(-p t), along any line; all energy lost is
    drag's.
    """
    linear, quadratic, v0 = 1.0, 0.5 * 1.2 * 2.0 * 0.9, np.array([3.0, -4.0, 12.0])
    air = {"body": "ball", "drag": {"linear": linear, "density": 1.2, "area": 2.0, "coefficient": 0.9}}
    scene = mechanics({"ball": {"mass": MASS, "velocity": v0}}, forces={"air": air})
    p, q, left = linear / MASS, quadratic / MASS * np.linalg.norm(v0), np.exp(-linear / MASS * TIMES)
    truth = np.outer(p * left / (p + q * (1 - left)), v0)
    found = samples(scene, TIMES, speed)
    lost = MASS / 2 * (v0 @ v0 - found[-1] @ found[-1])
    # measured 1.3e-10 m/s, and 2.8e-8 of 169 J
    assert found == pytest.approx(truth, abs=3e-10)
    assert scene.book("lost_damping") == pytest.approx(lost, abs=5e-8)


def test_angular_drag():
    """I omega' = -c omega."""
    air = {"body": "wheel", "drag": {"angular": 0.01}}
    scene = mechanics({"wheel": WHEEL | {"angular_velocity": (0, 0, 8)}}, forces={"air": air})
    found = samples(scene, TIMES, spin)[:, 0]
    assert found == pytest.approx(8 * np.exp(-0.01 / MOMENT * TIMES), abs=1e-11)


def test_drag_by_a_pattern_acts_on_those_that_it_names():
    bodies = {name: {"velocity": (1, 0, 0)} for name in ("red_1", "red_2", "blue")}
    scene = mechanics(bodies, forces={"air": {"body": '"red*"', "drag": {"linear": 2.0}}}).run(0.5)
    v = [scene.get("velocity", name)[0] for name in bodies]
    assert v == pytest.approx([np.exp(-1), np.exp(-1), 1], abs=1e-12)


# ------------------------------------------------------------------------------------------------ fields


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_field_everywhere_is_gravity(integrator):
    """To the last bit of the motion; its work is that of a force instead of a potential."""
    thrown = {"ball": {"mass": MASS, "velocity": (1, 2, 3)}}
    field = {"wind": {"body": "ball", "acceleration": DOWN}}
    one = mechanics(thrown, gravity=DOWN, integrator=integrator).run(1.0)
    other = mechanics(thrown, forces=field, integrator=integrator).run(1.0)
    assert np.array_equal(place(one), place(other))
    assert np.array_equal(speed(one), speed(other))
    fallen = MASS * GRAVITY * -place(one)[2]
    if integrator in EXACT:
        assert other.book("work_forces") == pytest.approx(fallen, abs=1e-11)
        assert other.book("residual") == pytest.approx(0, abs=1e-11)


def test_a_field_with_a_window_and_a_profile():
    """Heavy and light fall alike: v = a T / 2 by the end of a ramp over the window."""
    bodies = {"light": {"mass": 0.1}, "heavy": {"mass": 10.0, "position": (0, 1, 0)}}
    field = {"body": '"*"', "acceleration": (2, 0, 0), "from": 0.2, "until": 0.6}
    scene = mechanics(bodies, forces={"f": field | {"profile": {"type": "ramp", "over": 0.4}}}).run(1.0)
    assert scene.all("velocity") == pytest.approx(np.array([[0.4, 0, 0]] * 2), abs=1e-12)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_body_that_flies_through_a_field(integrator):
    """Across a region of 1 m at 2 m/s: a / 2 gained sideways, to what one step gives."""
    field = {"body": "ball", "acceleration": (0, 3, 0), "region": ((0.5, -9, -9), (1.5, 9, 9))}
    gained = []
    for timestep in (1e-2, 1e-3):
        ball = {"ball": {"mass": MASS, "velocity": (2, 0, 0)}}
        scene = mechanics(ball, forces={"f": field}, integrator=integrator, timestep=timestep).run(1.0)
        gained.append(speed(scene)[1])
        assert gained[0] == pytest.approx(1.5, abs=3e-2 + 1e-12)
    assert gained[1] == pytest.approx(1.5, abs=3e-3 + 1e-12)


def test_a_body_outside_the_region_feels_nothing():
    field = {"body": "ball", "acceleration": (0, 3, 0), "region": ((0.5, -9, -9), (1.5, 9, 9))}
    for x in (0.4999, 1.5001):
        scene = mechanics({"ball": {"position": (x, 0, 0)}}, forces={"f": field}).run(0.1)
        assert np.all(speed(scene) == 0)
    scene = mechanics({"ball": {"position": (1.0, 0, 0)}}, forces={"f": field}).run(0.1)
    assert speed(scene) == pytest.approx([0, 0.3, 0], abs=1e-14)


# ------------------------------------------------------------------------------------- prescribed motion


def moving(integrator: str, motion: dict[str, Any]) -> Lab:
    table = {"fixed": True, "position": (1, 0, 0), "motion": motion}
    return mechanics({"table": table, "ball": {"position": (5, 5, 5)}}, integrator=integrator)


def pose(scene: Lab) -> Any:
    names = ("position", "orientation", "velocity", "angular_velocity")
    return np.hstack([scene.get(name, "table") for name in names])


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_shaken_table_is_where_it_belongs(integrator):
    """Translation and rotation times sin(2 pi f t), in every integrator. Measured 3e-15."""
    turn = {"axis": (0, 0, 1), "angle": 0.5}
    motion = {"translation": (0.2, 0, -0.1), "rotation": turn, "profile": {"type": "sine", "frequency": 0.7}}
    found = samples(moving(integrator, motion), TIMES, pose)
    w = 2 * np.pi * 0.7
    course, rate, zero = np.sin(w * TIMES), w * np.cos(w * TIMES), np.zeros_like(TIMES)
    places = np.array([1, 0, 0]) + np.outer(course, (0.2, 0, -0.1))
    turned = np.column_stack([np.cos(course / 4), zero, zero, np.sin(course / 4)])
    truth = [places, turned, np.outer(rate, (0.2, 0, -0.1)), np.outer(rate, (0, 0, 0.5))]
    assert found == pytest.approx(np.hstack(truth), abs=1e-13)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_table_that_is_given_its_velocity(integrator):
    """It comes up to speed along a ramp from 0.3 to 0.8 s and stands still from 1.4 s on. Measured 4e-16."""
    motion = {"velocity": (0.4, 0, 0), "angular_velocity": (0, 0, 2), "from": 0.3, "until": 1.4}
    found = samples(moving(integrator, motion | {"profile": {"type": "ramp", "over": 0.5}}), TIMES, pose)
    since = np.clip(TIMES - 0.3, 0, 1.1)
    course = np.where(since < 0.5, since**2, since - 0.25)
    assert found[:, 0] == pytest.approx(1 + 0.4 * course, abs=1e-13)
    assert 2 * np.arctan2(found[:, 6], found[:, 3]) == pytest.approx(2 * course, abs=1e-13)
