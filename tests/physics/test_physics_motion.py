"""Bodies that are moved: shaking tables, lifts, turntables, moving pivots; and conveyor belts."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import body
from scipy.optimize import brentq
from workbench import SCHEMES, bench, moved

G = 9.81
ORDERS = dict(zip(SCHEMES, [1, 1, 2, 2, 2, 4], strict=True))
SOME = ["semi_implicit_euler", "velocity_verlet", "rk4"]


def flat(name="table", size=(4, 4, 0.2), **fields):
    """A fixed slab whose top is at z = 0."""
    return body(name, f"type: box, size: {list(size)}", fixed=True, position=(0, 0, -size[2] / 2), **fields)


def block(**fields):
    return body(
        "block", "type: box, size: [0.2, 0.2, 0.1]", mass=2.0, **({"position": (0, 0, 0.05)} | fields)
    )


SINE = {"type": "sine", "frequency": 1.0}


# shaking table


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_block_sticks_to_a_table_that_shakes_gently(scheme):
    """a omega^2 = 3.9 m/s^2 < mu g = 4.9: it stays where it stands on the table for 3 s."""
    table = flat(motion={"translation": (0.1, 0, 0), "profile": SINE})
    world = bench(table + block(velocity=(0.2 * np.pi, 0, 0)), {}, scheme=scheme, mu=0.5)
    gaps = []
    for _ in range(300):
        world.run(0.01)
        gaps.append(world.get("position", "block")[0] - world.get("position", "table")[0])
    # Explicit Euler moves a step with the speed of its start: v dt at most.
    assert np.ptp(gaps) < (0.2 * np.pi * 1.01e-3 if scheme == "explicit_euler" else 1e-5)
    assert abs(world.books()["residual"]) < 1e-3


@pytest.mark.parametrize("scheme", ["velocity_verlet", "rk4"])
def test_a_block_slides_on_a_table_that_shakes_hard(scheme):
    """Table 0.1 m sin(2 pi 2 Hz t), mu g = 1.962 m/s^2 of 15.8: it slides all the time, at v = -+ mu g,
    turning where its speed meets the table's. The turning instants are found from the closed form of the
    table's speed.
    """
    mu, omega, way = 0.2, 4 * np.pi, 0.1
    table = flat(motion={"translation": (way, 0, 0), "profile": {"type": "sine", "frequency": 2.0}})
    world = bench(table + block(), {}, scheme=scheme, mu=mu).run(0.2)
    # It is slower than the table first, and gains mu g until both are as fast.
    meet = brentq(lambda t: mu * G * t - way * omega * np.cos(omega * t), 0.0, 0.25)
    speed = mu * G * (meet - (0.2 - meet))
    place = 0.5 * mu * G * meet**2 + mu * G * meet * (0.2 - meet) - 0.5 * mu * G * (0.2 - meet) ** 2
    # The turn falls inside a step: 2 mu g dt.
    assert world.get("velocity", "block")[0] == pytest.approx(speed, abs=2 * mu * G * 1e-3)
    assert world.get("position", "block")[0] == pytest.approx(place, abs=3e-4)
    assert abs(world.books()["residual"]) < 1e-3 * world.books()["lost_friction"]


# lift


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("kind", ["position", "velocity"])
def test_apparent_weight_in_a_lift(scheme, kind):
    """It starts with 2 m/s^2: N = m (g + a). As a position a t^2 / 2, and as a velocity a t."""
    a = 2.0
    profile = {"type": "expression", "value": '"t^2 / 2"' if kind == "position" else "t"}
    key = "translation" if kind == "position" else "velocity"
    floor = flat("floor", motion={key: (0, 0, a), "profile": profile})
    world = bench(floor + block(), {}, scheme=scheme).run(0.5)
    weight = np.mean([world.step().world.contacts()["normal_impulse"].sum() for _ in range(10)]) / 1e-3
    assert weight == pytest.approx(2.0 * (G + a), rel=1e-6)
    assert world.get("velocity", "block")[2] == pytest.approx(a * 0.51, abs=2.1e-3)
    height = world.get("position", "block")[2] - 0.05 - world.get("position", "floor")[2] - 0.1
    assert abs(height) < 1e-5
    books, rise = world.books(), a * 0.51**2 / 2
    lifted = 2.0 * G * rise + 0.5 * 2.0 * (a * 0.51) ** 2
    assert books["work_motors"] == pytest.approx(lifted, rel=5e-3)
    assert abs(books["residual"]) < 5e-3 * lifted


# turntable


@pytest.mark.parametrize("scheme", SOME)
def test_a_block_slides_off_a_turntable_that_speeds_up(scheme):
    """omega = t / 4: it slides where r sqrt(alpha^2 + omega^4) > mu g; r is its own. The need then
    grows at the rate j = 2 r omega alpha and the slip as j t^2 / 2: a slip s is seen at sqrt(2 s j) above.
    """
    mu, alpha = 0.4, 0.25
    speed_up = {"type": "expression", "value": f'"{alpha} * t"'}
    disc = flat(motion={"angular_velocity": (0, 0, 1), "profile": speed_up})
    world = bench(disc + block(position=(0.8, 0, 0.05)), {}, scheme=scheme, mu=mu, timestep=2e-3)
    for _ in range(500):
        world.run(0.02)
        place, omega = world.get("position", "block"), world.get("angular_velocity", "table")
        slip = np.linalg.norm((world.get("velocity", "block") - np.cross(omega, place))[:2])
        if slip > 4e-3:
            break
    needed = np.linalg.norm(place[:2]) * np.hypot(alpha, omega[2] ** 2)
    growth = 2 * np.linalg.norm(place[:2]) * omega[2] * alpha
    # Verlet and RK4 0.1 %; semi-implicit Euler's velocity lags by half a step, which looks like slip: 1.5 %.
    assert needed == pytest.approx(mu * G + np.sqrt(2 * 4e-3 * growth), rel=0.02)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_joint_bears_the_apparent_weight_in_a_lift(scheme):
    """A load bolted to a lift z = A sin(2 pi f t): the bolt pulls the lift down with m (g + z'')."""
    amplitude, frequency, mass, time = 0.5, 1.0, 2.0, 0.6
    shaft = {"translation": (0, 0, amplitude), "profile": {"type": "sine", "frequency": frequency}}
    lift = body("lift", "type: box, size: [1, 1, 0.1]", fixed=True, collides=False, motion=shaft)
    load = body("load", "type: sphere, radius: 0.1", mass=mass, collides=False, position=(0, 0, -1))
    bolt = {"type": "fixed", "between": ["lift", "load"], "anchor": (0, 0, -0.5)}
    world = bench(lift + load, {"bolt": bolt}, scheme=scheme).run(time)
    omega = 2 * np.pi * frequency
    weight = mass * (G - amplitude * omega**2 * np.sin(omega * time))
    assert world.joint("bolt")["force"] == pytest.approx([0, 0, -weight], abs=1e-9)


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
def test_a_block_that_sticks_to_a_turntable_goes_round_with_it(scheme):
    """omega^2 r = 0.9 mu g for 5 s: it does not creep outwards. Measured at 1 ms: 5e-7 m, 2e-5 rad of
    10.5 ahead; at 2 ms 2.7e-6 m.
    """
    omega, r = 2.1, 0.8
    disc = flat(motion={"angular_velocity": (0, 0, omega)})
    start = block(position=(r, 0, 0.05), velocity=(0, omega * r, 0), angular_velocity=(0, 0, omega))
    world = bench(disc + start, {}, scheme=scheme, mu=0.4, timestep=1e-3).run(5.0)
    place = world.get("position", "block")
    assert np.hypot(place[0], place[1]) == pytest.approx(r, abs=2e-6)
    assert np.arctan2(place[1], place[0]) == pytest.approx(
        (omega * 5.0 + np.pi) % (2 * np.pi) - np.pi, abs=4e-5
    )


def test_a_block_flies_off_a_turntable_that_is_too_fast():
    """omega^2 r = 4.4 m/s^2 is more than mu g = 3.9, though it turned with the disc at the start."""
    omega = 2.35
    disc = flat(motion={"angular_velocity": (0, 0, omega)})
    start = block(position=(0.8, 0, 0.05), velocity=(0, 0.8 * omega, 0), angular_velocity=(0, 0, omega))
    world = bench(disc + start, {}, scheme="velocity_verlet", mu=0.4).run(2.0)
    assert np.linalg.norm(world.get("position", "block")[:2]) > 0.9
    assert abs(world.books()["residual"]) < 1e-6


# moving pivot


TILT = 0.3


def pivot_pendulum(scheme, timestep, motion):
    """A ball on a rod of 0.5 m, tilted, at the speed with which its pivot starts."""
    pivot = body("pivot", "type: sphere, radius: 0.02", fixed=True, collides=False, motion=motion)
    place = 0.5 * np.array([np.sin(TILT), 0, -np.cos(TILT)])
    speed = (0.2 * np.pi, 0, 0)
    ball = body(
        "ball", "type: sphere, radius: 0.05", mass=1.0, position=place, velocity=speed, collides=False
    )
    rod = {"type": "distance", "between": ("pivot", "ball")}
    return bench(pivot + ball, {"rod": rod}, scheme=scheme, timestep=timestep)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("kind", ["position", "velocity"])
def test_order_of_a_pendulum_on_a_moving_pivot(scheme, kind):
    """L a'' = -g sin a - X'' cos a with X = 0.1 sin(2 pi t); the order of each scheme within 0.1."""
    if kind == "position":
        motion = {"translation": (0.1, 0, 0), "profile": SINE}
    else:
        cosine = {"type": "expression", "value": '"cos(2*pi*t)"'}
        motion = {"velocity": (0.2 * np.pi, 0, 0), "profile": cosine}

    def rates(t, y):
        pull = -0.1 * (2 * np.pi) ** 2 * np.sin(2 * np.pi * t)
        return [y[1], -(G * np.sin(y[0]) + pull * np.cos(y[0])) / 0.5]

    angle, _ = moved(rates, [TILT, 0], 0.8)[0]
    errors = []
    steps = (4e-3, 2e-3, 1e-3) if scheme != "rk4" else (10e-3, 5e-3, 2.5e-3)
    for h in steps:
        world = pivot_pendulum(scheme, h, motion).run(0.8)
        way = world.get("position", "ball") - world.get("position", "pivot")
        errors.append(np.arctan2(way[0], -way[2]) - angle)
    orders = np.log2(np.abs(np.array(errors[:-1]) / errors[1:]))
    assert orders[-1] == pytest.approx(ORDERS[scheme], abs=0.1)


def test_kapitza_holds_a_pendulum_upright():
    """Shaken up and down with (a omega)^2 > 2 g L it stands on its head (Kapitza 1951), 9.9 > 3.9 here; the
    way there is that of L a'' = (g + Z'') sin a.
    """
    length, tilt, amplitude, omega = 0.2, 0.1, 0.02, 50 * np.pi
    motion = {"translation": (0, 0, amplitude), "profile": {"type": "sine", "frequency": 25.0}}
    pivot = body("pivot", "type: sphere, radius: 0.02", fixed=True, collides=False, motion=motion)
    ball = body(
        "ball",
        "type: sphere, radius: 0.05",
        mass=1.0,
        position=(length * np.sin(tilt), 0, length * np.cos(tilt)),
        velocity=(0, 0, amplitude * omega),
        collides=False,
    )
    rod = {"type": "distance", "between": ("pivot", "ball")}
    world = bench(pivot + ball, {"rod": rod}, scheme="rk4")

    def rates(t, y):
        return [y[1], (G - amplitude * omega**2 * np.sin(omega * t)) / length * np.sin(y[0])]

    times = 0.1 * np.arange(1, 21)
    for angle, _ in moved(rates, [tilt, 0.0], times):
        world.run(0.1)
        way = world.get("position", "ball") - world.get("position", "pivot")
        assert np.arctan2(way[0], way[2]) == pytest.approx(angle, abs=1e-4)
        assert way[2] > 0.19


@pytest.mark.parametrize("kind", ["position", "velocity"])
def test_a_crank_turns_as_told(kind):
    """A rotation about the body's origin as a table of angles, and as a speed; the hinge on its rim is
    where it is told.
    """
    if kind == "position":
        motion = {"rotation": {"axis": (0, 0, 1), "angle": 3.0}, "profile": {"type": "ramp", "over": 2.0}}
    else:
        motion = {"angular_velocity": (0, 0, 1.5), "until": 2.0}
    crank = body(
        "crank", "type: cylinder, radius: 0.3, height: 0.05", fixed=True, collides=False, motion=motion
    )
    ball = body("ball", "type: sphere, radius: 0.05", mass=1.0, position=(0.3, 0, -0.4), collides=False)
    joint = {"type": "ball", "between": ("crank", "ball"), "anchor": (0.3, 0, 0)}
    world = bench(crank + ball, {"pin": joint}, scheme="rk4").run(1.5)
    q = world.get("orientation", "crank")
    assert 2 * np.arctan2(q[3], q[0]) == pytest.approx(2.25, abs=1e-13)
    assert world.get("angular_velocity", "crank") == pytest.approx([0, 0, 1.5], abs=1e-13)
    assert world.joint("pin")["violation"] < 1e-12
    world.run(1.0)
    q = world.get("orientation", "crank")
    assert 2 * np.arctan2(q[3], q[0]) == pytest.approx(3.0, abs=1e-13)
    assert np.linalg.norm(world.get("angular_velocity", "crank")) == 0
    assert world.joint("pin")["violation"] < 1e-12


# conveyor


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("heading", [0.0, 0.7])
def test_a_conveyor_drags_a_block_along(scheme, heading):
    """It slips for v / (mu g) = 0.51 s and v^2 / (2 mu g), then rides. The belt does m v^2: half is heat,
    half motion.
    """
    speed, mu, mass = 1.5, 0.3, 2.0
    way = np.array([np.cos(heading), np.sin(heading), 0])
    world = bench(flat("belt", surface_velocity=speed * way) + block(), {}, scheme=scheme, mu=mu)
    slips = speed / (mu * G)
    world.run(0.4)
    assert world.get("velocity", "block") @ way == pytest.approx(mu * G * 0.4, rel=1e-6)
    world.run(0.1)
    times, speeds = [], []
    for k in range(20):
        speeds.append(world.step().get("velocity", "block") @ way)
        times.append(0.5 + 1e-3 * (k + 1))
    arrived = times[next(k for k, v in enumerate(speeds) if abs(v - speed) < 1e-6)]
    assert arrived == pytest.approx(slips, abs=1.01e-3)
    world.run(0.48)
    assert world.get("velocity", "block") == pytest.approx(speed * way, abs=1e-7)
    place = speed * 1.0 - speed**2 / (2 * mu * G)
    assert world.get("position", "block") @ way == pytest.approx(place, abs=speed * 1e-3 / 2 * 1.01 + 1e-5)
    books = world.books()
    assert books["work_motors"] == pytest.approx(mass * speed**2, rel=1e-6)
    assert books["lost_friction"] == pytest.approx(0.5 * mass * speed**2, rel=1e-6)
    assert abs(books["residual"]) < 1e-8
