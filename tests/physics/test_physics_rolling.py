"""Rolling and spinning friction: torques of at most a length times the normal force.

A ball (or wheel) of I = k m R^2 that rolls on a plane: friction F on it and the torque l_r N against its
turning give m a = F and I a / R = l_r N - F R, so that it brakes with a = (l_r / R) g / (1 + k). At rest both
hold it, on a slope as long as R m g sin s <= l_r m g cos s.
"""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import FLOOR, GRAVITY, HEAD, Lab, body
from workbench import SCHEMES, bench

RADIUS, MASS = 0.1, 2.0
BALL, SHELL = "type: sphere, radius: 0.1", "type: hollow_sphere, radius: 0.1"
WHEEL = "type: cylinder, radius: 0.1, height: 0.15"
LOG = "type: capsule, radius: 0.1, height: 0.15"
ROUND = [(BALL, 2 / 5), (SHELL, 2 / 3), (WHEEL, 1 / 2)]
# How far a braking body is ahead of s = v t - a t^2 / 2, in v dt: first-order schemes take one end's speed.
AHEAD = {"explicit_euler": 0.5, "semi_implicit_euler": -0.5}


def room(
    bodies: str,
    *,
    rolling: float = 0.0,
    spinning: float = 0.0,
    mu: float = 0.5,
    e: float = 0.0,
    timestep: float = 1e-3,
    scheme: str = "semi_implicit_euler",
    impacts: str = "stepped",
) -> Lab:
    """A scene of one material, with both lengths."""
    stuff = f"stuff: {{density: 1000, restitution: {e!r}, static_friction: {mu!r}, kinetic_friction: {mu!r}}}"
    how = f"integrator: {scheme}, impacts: {impacts}, timestep:"
    head = (HEAD % (timestep, -GRAVITY, stuff)).replace("timestep:", how)
    levers = f"rolling_friction: {rolling!r}, spinning_friction: {spinning!r}"
    return Lab(head + bodies + f"pairs:\n  - {{between: [stuff, stuff], restitution: {e!r}, {levers}}}\n")


def plane(slope: float) -> tuple[str, np.ndarray]:
    """A plane tilted by `slope` [rad] about y, and its normal."""
    normal = np.array([np.sin(slope), 0.0, np.cos(slope)])
    text = (
        f"  plane: {{fixed: true, shape: {{type: halfspace, normal: {normal.tolist()}}}, material: stuff}}\n"
    )
    return text, normal


def rolling(shape: str, speed: float, heading: float = 0.0, spin: float = 0.0) -> str:
    """A body that rolls on z = 0 in this heading, and turns about z as well."""
    way = np.array([np.cos(heading), np.sin(heading), 0.0])
    c, s = np.cos(heading / 2), np.sin(heading / 2)
    lying = np.array([c, c, s, s]) / 2**0.5  # a quarter turn about x, then the heading
    omega = np.cross([0, 0, 1], way) * speed / RADIUS + [0, 0, spin]
    return body(
        "roller",
        shape,
        mass=MASS,
        position=(0, 0, RADIUS),
        orientation={"quaternion": tuple(lying if shape == WHEEL else (c, 0.0, 0.0, s))},
        velocity=speed * way,
        angular_velocity=omega,
    )


@pytest.mark.parametrize(("shape", "k"), ROUND)
@pytest.mark.parametrize("heading", [0.0, 0.6])
@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
def test_rolling_is_braked_evenly(shape, k, heading, timestep):
    """v = v0 - a t with a = (l_r / R) g / (1 + k), straight on, without slip."""
    l_r, v0 = 0.004, 1.5
    a = l_r / RADIUS * GRAVITY / (1 + k)
    way = np.array([np.cos(heading), np.sin(heading), 0.0])
    room_ = room(FLOOR + rolling(shape, v0, heading), rolling=l_r, timestep=timestep)
    for t in (1.0, 2.0, 3.0):
        room_.run(1.0)
        v, omega = room_.get("velocity", "roller"), room_.get("angular_velocity", "roller")
        assert v == pytest.approx((v0 - a * t) * way, abs=1e-7)
        assert omega == pytest.approx(np.cross([0, 0, 1], v) / RADIUS, abs=1e-6)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_it_stops_on_time_and_stays(scheme):
    """t = v0 / a and s = v0^2 / (2 a), the first-order schemes v0 dt / 2 off; then it lies still for 20 s."""
    l_r, v0, dt = 0.02, 1.0, 1e-3
    a = l_r / RADIUS * GRAVITY / (1 + 2 / 5)
    ball = room(FLOOR + rolling(BALL, v0), rolling=l_r, timestep=dt, scheme=scheme)
    speeds = []
    while not speeds or speeds[-1] > 1e-6:
        ball.step()
        speeds.append(np.linalg.norm(ball.get("velocity", "roller")))
        assert len(speeds) < 1000
    assert len(speeds) * dt == pytest.approx(v0 / a, abs=1.01 * dt)
    place, turn = ball.get("position", "roller"), ball.get("orientation", "roller")
    assert place[0] == pytest.approx(v0**2 / (2 * a) + AHEAD.get(scheme, 0.0) * v0 * dt, abs=1e-5)
    ball.run(20.0)
    assert ball.get("position", "roller") == pytest.approx(place, abs=1e-9)
    assert ball.get("orientation", "roller") == pytest.approx(turn, abs=1e-9)


@pytest.mark.parametrize(("shape", "k"), ROUND)
@pytest.mark.parametrize("part", [0.5, 0.99, 1.01, 2.0])
def test_on_a_slope_it_holds_up_to_the_length_over_the_radius(shape, k, part):
    """It holds if tan s <= l_r / R; else a = g (sin s - (l_r / R) cos s) / (1 + k)."""
    lever = 0.05
    slope = np.arctan(part * lever)
    text, normal = plane(slope)
    turn = {"axis": (1, 0, 0), "angle": np.pi / 2}
    roller = body("roller", shape, mass=MASS, position=RADIUS * normal, orientation=turn)
    found = room(text + roller, rolling=lever * RADIUS, timestep=2e-3)
    start = found.get("position", "roller")
    if part < 1:
        found.run(60.0)
        assert np.linalg.norm(found.get("position", "roller") - start) < 1e-8
        assert np.linalg.norm(found.get("angular_velocity", "roller")) < 1e-9
    else:
        a = GRAVITY * (np.sin(slope) - lever * np.cos(slope)) / (1 + k)
        speed = np.linalg.norm(found.run(2.0).get("velocity", "roller"))
        assert speed == pytest.approx(2.0 * a, rel=1e-6)


@pytest.mark.parametrize(
    ("shape", "height", "inertia"),
    [
        (BALL, RADIUS, 2 / 5 * MASS * RADIUS**2),
        (WHEEL, 0.075, MASS * RADIUS**2 / 2),
        ("type: box, size: [0.3, 0.3, 0.1]", 0.05, MASS * 0.3**2 / 6),
    ],
)
@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "rk4"])
def test_spinning_stops_on_time(shape, height, inertia, scheme):
    """omega = omega_0 - l_s m g t / I about the vertical, whether the floor carries it in one point, four or
    eight; it ends at t = I omega_0 / (l_s m g), and the body does not wander.
    """
    l_s, omega = 0.003, 6.0
    rate = l_s * MASS * GRAVITY / inertia
    ends = omega / rate
    text = body("top", shape, mass=MASS, position=(0, 0, height), angular_velocity=(0, 0, omega))
    top = room(FLOOR + text, spinning=l_s, mu=0.0, scheme=scheme)
    half = round(ends / 2 / top.timestep)
    top.step(half)
    expected = omega - rate * half * top.timestep
    assert top.get("angular_velocity", "top") == pytest.approx([0, 0, expected], abs=1e-7)
    top.step(int(ends / top.timestep) - half)
    assert top.get("angular_velocity", "top")[2] > 0
    top.step(1)
    assert top.get("angular_velocity", "top") == pytest.approx([0, 0, 0], abs=1e-9)
    assert np.linalg.norm(top.run(5.0).get("position", "top") - [0, 0, height]) < 1e-7


def test_rolling_and_spinning_do_not_mix():
    """A ball that does both is braked in each as if it did not do the other, and rolls straight on."""
    l_r, l_s, v0, omega = 0.004, 0.001, 1.0, 8.0
    a, rate = l_r / RADIUS * GRAVITY / 1.4, l_s * GRAVITY / (0.4 * RADIUS**2)
    ball = room(FLOOR + rolling(BALL, v0, spin=omega), rolling=l_r, spinning=l_s).run(1.0)
    assert ball.get("velocity", "roller") == pytest.approx([v0 - a, 0, 0], abs=1e-7)
    assert ball.get("angular_velocity", "roller")[2] == pytest.approx(omega - rate, abs=1e-6)


@pytest.mark.parametrize(("shape", "k"), [(BALL, 2 / 5), (SHELL, 2 / 3)])
def test_from_sliding_to_rolling(shape, k):
    """Slipping m dv/dt = -mu m g, I domega/dt = (mu R - l_r) m g; from v = R omega on it rolls, braked."""
    l_r, mu, v0 = 0.005, 0.2, 2.0
    text = body("ball", shape, mass=MASS, position=(0, 0, RADIUS), velocity=(v0, 0, 0))
    ball = room(FLOOR + text, rolling=l_r, mu=mu)
    gains = GRAVITY * (mu - l_r / RADIUS) / k
    rolls = v0 / (mu * GRAVITY + gains)
    assert 0.2 < rolls < 0.6
    ball.run(0.2)
    assert ball.get("velocity", "ball")[0] == pytest.approx(v0 - mu * GRAVITY * 0.2, abs=1e-9)
    assert ball.get("angular_velocity", "ball")[1] * RADIUS == pytest.approx(gains * 0.2, abs=1e-9)
    ball.run(0.8)
    brakes = l_r / RADIUS * GRAVITY / (1 + k)
    expected = v0 - mu * GRAVITY * rolls - brakes * (1.0 - rolls)
    # When rolling begins within a step, the step as a whole ends rolling.
    assert ball.get("velocity", "ball")[0] == pytest.approx(expected, abs=1e-6)
    assert ball.get("angular_velocity", "ball")[1] * RADIUS == pytest.approx(expected, abs=1e-6)


def test_a_ball_that_turns_harder_than_it_slips_slides_like_a_block():
    """l_r > mu R: friction cannot turn it. It stops after v^2 / (2 mu g)."""
    mu, v0 = 0.2, 1.0
    text = body("ball", BALL, mass=MASS, position=(0, 0, RADIUS), velocity=(v0, 0, 0))
    ball = room(FLOOR + text, rolling=0.03, mu=mu).run(0.25)
    assert np.linalg.norm(ball.get("angular_velocity", "ball")) < 1e-12
    assert ball.get("velocity", "ball")[0] == pytest.approx(v0 - mu * GRAVITY * 0.25, abs=1e-9)
    ball.run(1.0)
    assert ball.get("position", "ball")[0] == pytest.approx(v0**2 / (2 * mu * GRAVITY) - v0 * 5e-4, abs=1e-5)


@pytest.mark.parametrize(("scheme", "impacts"), [("semi_implicit_euler", "stepped"), ("rk4", "located")])
@pytest.mark.parametrize("e", [0.0, 0.6])
def test_impacts_brake_spin_by_their_normal_impulse(e, scheme, impacts):
    """From rest to rest all normal impulses are m g t, bounces or not: the spin lost is l_s m g t / I."""
    l_s, omega, t = 0.0005, 30.0, 2.0
    text = body("ball", BALL, mass=MASS, position=(0, 0, 0.3), angular_velocity=(0, 0, omega))
    ball = room(FLOOR + text, spinning=l_s, e=e, scheme=scheme, impacts=impacts).run(t)
    assert np.linalg.norm(ball.get("velocity", "ball")) < 1e-9
    expected = omega - l_s * GRAVITY * t / (0.4 * RADIUS**2)
    # measured 2e-13
    assert ball.get("angular_velocity", "ball")[2] == pytest.approx(expected, abs=1e-9)


def test_one_bounce_takes_turn_at_once():
    """Without friction of slipping a bounce with the normal impulse 2 m v takes 2 l_r m v / I of turning."""
    l_r, height, omega = 0.01, 0.05, 20.0
    text = body(
        "ball", BALL, mass=MASS, position=(0, 0, RADIUS + height), angular_velocity=(3 * omega, 4 * omega, 0)
    )
    ball = room(FLOOR + text, rolling=l_r, mu=0.0, e=1.0, timestep=1e-4)
    landing = np.sqrt(2 * height / GRAVITY)
    ball.run(round(1.5 * landing, 4))
    lost = l_r * 2 * np.sqrt(2 * GRAVITY * height) / (0.4 * RADIUS**2)
    expected = (5 * omega - lost) * np.array([0.6, 0.8, 0])
    assert ball.get("angular_velocity", "ball") == pytest.approx(expected, rel=1e-7)  # measured 6e-9


def test_the_work_is_booked_as_friction():
    ball = room(FLOOR + rolling(BALL, 1.0, spin=5.0), rolling=0.02, spinning=0.002).run(3.0)
    books = ball.world.energies()
    kinetic = 0.5 * MASS * (1 + 0.4) + 0.5 * 0.4 * MASS * RADIUS**2 * 25
    assert books["lost_friction"] == pytest.approx(kinetic, rel=1e-6)
    assert abs(books["residual"]) < 1e-9


def test_a_turntable_takes_a_ball_along():
    """On the axis of a table that turns with Omega a ball is spun up by l_s m g / I until it turns with it.
    The table's drive does Omega l_s m g t of work, of which half becomes motion.
    """
    l_s, table = 0.001, 4.0
    inertia = 0.4 * MASS * RADIUS**2
    text = (
        "  table: {fixed: true, shape: {type: halfspace}, material: stuff,\n"
        f"          motion: {{angular_velocity: [0, 0, {table}]}}}}\n"
    )
    ball = room(text + body("ball", BALL, mass=MASS, position=(0, 0, RADIUS)), spinning=l_s, mu=0.0)
    ball.run(1.0)
    gained = l_s * MASS * GRAVITY / inertia
    assert gained < table
    assert ball.get("angular_velocity", "ball")[2] == pytest.approx(gained, rel=1e-7)
    ball.run(5.0)
    assert ball.get("angular_velocity", "ball")[2] == pytest.approx(table, rel=1e-9)
    books = ball.world.energies()
    assert books["work_motors"] == pytest.approx(inertia * table**2, rel=1e-6)
    assert books["lost_friction"] == pytest.approx(inertia * table**2 / 2, rel=1e-6)
    assert abs(books["residual"]) < 1e-9


@pytest.mark.parametrize(("scheme", "impacts"), [("semi_implicit_euler", "stepped"), ("rk4", "located")])
def test_a_turntable_works_in_impacts_too(scheme, impacts):
    """The same with a ball that bounces on the axis until it turns with the table."""
    text = (
        "  table: {fixed: true, shape: {type: halfspace}, material: stuff,\n"
        "          motion: {angular_velocity: [0, 0, 4]}}\n"
    )
    text += body("ball", BALL, mass=MASS, position=(0, 0, 0.3))
    ball = room(text, spinning=0.001, mu=0.0, e=0.6, scheme=scheme, impacts=impacts).run(3.0)
    books = ball.world.energies()
    # measured 1e-12
    assert books["work_motors"] == pytest.approx(0.4 * MASS * RADIUS**2 * 4.0**2, rel=1e-9)
    assert abs(books["residual"]) < 1e-9


def test_between_bodies_the_angular_momentum_stays():
    """A ball spins on a plate that slides freely: what one loses the other gets, until they turn as one."""
    plate = body("plate", "type: box, size: [0.4, 0.4, 0.1]", mass=3.0, position=(0, 0, 0.05))
    ball = body("ball", BALL, mass=MASS, position=(0, 0, 0.2), angular_velocity=(0, 0, 9.0))
    floor = "  ice: {fixed: true, shape: {type: halfspace}, material: ice}\n"
    stuff = "stuff: {restitution: 0, static_friction: 0, kinetic_friction: 0}\n  ice: {density: 900}"
    rows = (
        "pairs:\n  - {between: [stuff, stuff], spinning_friction: 0.002}\n"
        "  - {between: [stuff, ice], restitution: 0, static_friction: 0, kinetic_friction: 0}\n"
    )
    two = Lab(HEAD % (1e-3, -GRAVITY, stuff) + floor + plate + ball + rows)
    before = two.momentum()[1]
    two.run(0.2)
    assert two.momentum()[1][2] == pytest.approx(before[2], abs=1e-13)
    assert two.get("angular_velocity", "ball")[2] > two.get("angular_velocity", "plate")[2] + 1.0
    two.run(3.0)
    assert two.momentum()[1][2] == pytest.approx(before[2], abs=1e-12)
    both = before[2] / (0.4 * MASS * RADIUS**2 + 3.0 * 0.4**2 / 6)
    for name in ("ball", "plate"):
        assert two.get("angular_velocity", name)[2] == pytest.approx(both, rel=1e-7)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_wheel_on_an_axle_brakes_its_cart(scheme):
    """A cart of mass M rests on the axle of a wheel: a = (l_r / R) g (m + M) / ((1 + k) m + M)."""
    l_r, v0, cart = 0.005, 1.0, 5.0
    text = body(
        "cart", "type: box, size: [0.05, 0.05, 0.05]", mass=cart, position=(0, 0, RADIUS), velocity=(v0, 0, 0)
    )
    axle = {"type": "hinge", "between": ["cart", "roller"], "anchor": (0, 0, RADIUS), "axis": (0, 1, 0)}
    pair = f"pairs:\n  - {{between: [stuff, stuff], rolling_friction: {l_r!r}}}\n"
    found = bench(FLOOR + rolling(BALL, v0) + text, {"axle": axle}, scheme=scheme, mu=0.5, more=pair).run(1.0)
    a = l_r / RADIUS * GRAVITY * (MASS + cart) / (1.4 * MASS + cart)
    # measured 4e-11
    assert found.get("velocity", "cart") == pytest.approx([v0 - a, 0, 0], abs=1e-8)
    assert found.get("angular_velocity", "roller")[1] * RADIUS == pytest.approx(v0 - a, abs=1e-8)
    place = found.run(4.0).get("position", "cart")
    assert found.run(5.0).get("position", "cart") == pytest.approx(place, abs=1e-9)
    assert abs(found.books()["residual"]) < 1e-9


def heap(lever: float) -> Lab:
    """Ten logs in four rows, a little apart: they fall together, and the lowest give way."""
    turn = {"axis": (1, 0, 0), "angle": np.pi / 2}
    text = ""
    for row in range(4):
        for n in range(4 - row):
            place = ((n + row / 2) * 0.205, 0.0, RADIUS + 0.005 + row * 0.185)
            text += body(f"log_{row}_{n}", LOG, mass=MASS, position=place, orientation=turn)
    return room(FLOOR + text, rolling=lever, spinning=lever, mu=0.6, timestep=2e-3)


def test_logs_in_a_heap_come_to_rest():
    """They settle, and then neither creep nor turn for 10 s. Without these torques they would roll away."""
    logs = heap(0.02).run(6.0)
    place = logs.all("position")
    logs.run(10.0)
    assert np.abs(logs.all("velocity")).max() < 1e-6
    assert np.abs(logs.all("angular_velocity")).max() < 1e-5
    assert np.abs(logs.all("position") - place).max() < 1e-6


def test_a_heap_goes_on_from_its_checkpoint():
    """The torques are remembered with the forces: same bits, through or resumed."""
    through, resumed = heap(0.02).run(0.8), heap(0.02)
    resumed.world.restore(through.world.save())
    for one in (through, resumed):
        one.run(0.4)
    for what in ("position", "velocity", "orientation", "angular_velocity"):
        assert through.all(what).tobytes() == resumed.all(what).tobytes()


def test_lengths_of_zero_change_no_bit():
    """A row that says 0 is the same as no row: no torque, and no other arithmetic."""
    text = (
        FLOOR
        + rolling(BALL, 1.0, spin=3.0)
        + body("box", "type: box, size: [0.2, 0.2, 0.2]", position=(0.5, 0, 0.1))
    )
    stuff = "stuff: {density: 1000, restitution: 0.3, static_friction: 0.5, kinetic_friction: 0.5}"
    without = Lab(HEAD % (1e-3, -GRAVITY, stuff) + text).run(1.0)
    zero = room(text, e=0.3).run(1.0)
    for what in ("position", "velocity", "orientation", "angular_velocity"):
        assert without.all(what).tobytes() == zero.all(what).tobytes()
