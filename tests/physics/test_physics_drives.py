"""What acts along a free coordinate: limits, motors, servos, dry friction, springs, dampers; and joints
that break.

A wheel of 0.1 kg m^2 on a hinge stands for most of it, so that torques of some tenths give times of some
seconds.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from laboratory import body
from workbench import SCHEMES, bench

G = 9.81
MOMENT = 0.1
SECOND_ORDER = [name for name in SCHEMES if "euler" not in name]


def wheel_on_a_hinge(scheme="semi_implicit_euler", spin=0.0, load=0.0, timestep=1e-3, **drive):
    wheel = body(
        "wheel",
        "type: cylinder, radius: 0.2, height: 0.1",
        mass=5.0,
        angular_velocity=(0, 0, spin),
        collides=False,
    )
    pin = {"type": "hinge", "between": ("world", "wheel"), "anchor": (0, 0, 0), "axis": (0, 0, 1), **drive}
    more = f"forces: {{load: {{body: wheel, torque: [0, 0, {load!r}]}}}}\n" if load else ""
    return bench(wheel, {"pin": pin}, scheme=scheme, timestep=timestep, more=more)


def spin_of(world):
    return world.get("angular_velocity", "wheel")[2]


def rod(**fields):
    """2 kg, 1 m, level, one end at the origin."""
    return body(
        "rod", "type: box, size: [1, 0.1, 0.1]", mass=2.0, position=(0.5, 0, 0), collides=False, **fields
    )


def rod_on_a_hinge(scheme, **drive):
    pin = {"type": "hinge", "between": ("world", "rod"), "anchor": (0, 0, 0), "axis": (0, 1, 0), **drive}
    return bench(rod(), {"pin": pin}, scheme=scheme)


# limits


@pytest.mark.parametrize("scheme", SCHEMES)
def test_limits_throw_back_with_restitution(scheme):
    """3 rad/s against +0.5 rad, then against -1 rad, e = 0.6: 3, -1.8, 1.08 to the last digits."""
    world = wheel_on_a_hinge(scheme, spin=3.0, limits=(-1.0, 0.5), restitution=0.6)
    spins, angles = [], []
    for _ in range(1200):
        spins.append(spin_of(world.step()))
        angles.append(world.angle("pin"))
    found = [spins[0], *[b for a, b in pairwise(spins) if abs(a - b) > 1e-9]]
    assert found == pytest.approx([3.0, -1.8, 1.08], rel=1e-12)
    # It turns within the step of the hit, at most 3 rad/s dt off the limit.
    assert max(angles) == pytest.approx(0.5, abs=3e-3)
    assert min(angles) == pytest.approx(-1.0, abs=3e-3)
    books = world.books()
    assert books["lost_impact"] == pytest.approx(0.5 * MOMENT * (9 - 1.08**2), rel=1e-12)
    assert abs(books["residual"]) < 1e-14


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("e", [0.0, 0.5])
def test_a_falling_rod_comes_to_rest_at_its_limit(scheme, e):
    """It carries m g (L/2) cos there. Without restitution it never passes the limit. What fell is lost in
    impacts.

    Measured: 1e-16 rad beyond (5e-13 after bounces), torque 1e-11 N m.
    """
    limit = 0.7
    world = rod_on_a_hinge(scheme, limits=(-0.1, limit), restitution=e)
    angles = []
    for _ in range(300):
        angles.append(world.run(0.01).angle("pin"))
    if e == 0:
        assert max(angles) < limit + 1e-12
    assert angles[-1] == pytest.approx(limit, abs=1e-11)
    assert np.linalg.norm(world.get("angular_velocity", "rod")) < 1e-12
    # The limit pushes the rod up and the world down: on A.
    assert world.joint("pin")["torque"] == pytest.approx([0, 2 * G * 0.5 * np.cos(limit), 0], abs=1e-9)
    fell = 2 * G * 0.5 * np.sin(limit)
    assert abs(world.books()["residual"]) < (3e-3 if scheme == "explicit_euler" else 1e-5) * fell


@pytest.mark.parametrize(
    ("scheme", "within"), [("semi_implicit_euler", 1e-12), ("velocity_verlet", 1e-12), ("rk4", 2e-6)]
)
def test_elastic_limits_take_no_energy(scheme, within):
    """e = 1: a rod jumps up to its start after each of 10 bounces. Measured 2e-14 rad, 1e-7 rad a bounce in
    RK4.
    """
    world = rod_on_a_hinge(scheme, limits=(-0.1, 0.3), restitution=1.0)
    angles = np.array([world.step().angle("pin") for _ in range(4200)])
    tops = angles[1:-1][(angles[1:-1] < angles[:-2]) & (angles[1:-1] <= angles[2:])]
    assert len(tops) == 10
    assert tops == pytest.approx(np.zeros(10), abs=within)
    assert world.books()["lost_impact"] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
@pytest.mark.parametrize("e", [0.0, 0.5])
def test_a_cone_stops_its_axis_at_the_rim(scheme, e):
    """A rod falls over inside a cone and comes to rest on its rim at 0.8 rad."""
    tilt, rim = 0.2, 0.8
    pole = body(
        "rod",
        "type: cylinder, radius: 0.05, height: 1",
        mass=2.0,
        position=(0.5 * np.sin(tilt), 0, 0.5 * np.cos(tilt)),
        orientation={"axis": (0, 1, 0), "angle": tilt},
        collides=False,
    )
    # The body's own z axis leans already: the cone's axis is where it stands upright.
    cone = {
        "type": "cone",
        "between": ("world", "rod"),
        "anchor": (0, 0, 0),
        "axis": (0, 0, 1),
        "max_angle": rim,
        "restitution": e,
    }
    world = bench(pole, {"cone": cone}, scheme=scheme)
    angles, rates = [], []
    for _ in range(2500):
        angles.append(float(world.step().joint("cone")["coordinate"]))
        rates.append(world.get("angular_velocity", "rod")[1])
    hit = int(np.argmax(np.abs(np.diff(rates))))
    # After the hit gravity has had at most one step: 12 rad/s^2 dt.
    assert rates[hit + 1] == pytest.approx(-e * rates[hit], abs=0.013)
    assert angles[-1] == pytest.approx(rim, abs=1e-11)
    assert world.joint("cone")["torque"] == pytest.approx([0, 2 * G * 0.5 * np.sin(tilt + rim), 0], abs=1e-8)
    assert world.joint("cone")["violation"] < 1e-12


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_taut_rope_is_a_pendulum(scheme):
    """A rope (limits [0, L]) swings exactly as a rod does, and does not grow.

    As a force that was constant over each step the limit let it grow by 42 mm in 5 s, and lost 5 % of the
    energy. Measured now 5e-13 m.
    """
    ball = body("ball", "type: sphere, radius: 0.05", mass=2.0, position=(0.6, 0, -0.8), collides=False)
    joint = {"type": "distance", "between": ("world", "ball")}
    rope = bench(ball, {"line": joint | {"limits": (0, 1.0)}}, scheme=scheme)
    stiff = bench(ball, {"line": joint | {"length": 1.0}}, scheme=scheme)
    longest = max(rope.run(0.05).angle("line") for _ in range(40))
    assert longest < 1 + 1e-11
    assert rope.get("position", "ball") == pytest.approx(stiff.run(2.0).get("position", "ball"), abs=1e-10)
    assert rope.joint("line")["force"] == pytest.approx(stiff.joint("line")["force"], abs=1e-9)
    assert rope.books()["residual"] == pytest.approx(stiff.books()["residual"], abs=1e-10)


def test_a_rope_goes_slack_and_is_jerked_taut():
    """Thrown up inside its length it flies freely; at the end of the rope it is thrown back with e along
    the rope.
    """
    ball = body(
        "ball",
        "type: sphere, radius: 0.05",
        mass=1.0,
        position=(0, 0, -0.5),
        velocity=(0, 0, 1),
        collides=False,
    )
    rope = {"type": "distance", "between": ("world", "ball"), "limits": (0, 1.0), "restitution": 0.4}
    world = bench(ball, {"rope": rope}, scheme="velocity_verlet")
    taut = (1 + np.sqrt(1 + 2 * G * 0.5)) / G
    before = np.floor(taut / 1e-3) * 1e-3
    world.run(round(before, 6))
    assert world.get("position", "ball")[2] == pytest.approx(-0.5 + before - G * before**2 / 2, abs=1e-12)
    assert np.linalg.norm(world.joint("rope")["force"]) == 0
    speed = -world.get("velocity", "ball")[2]
    assert world.step().get("velocity", "ball")[2] == pytest.approx(0.4 * speed, rel=1e-12)
    assert world.run(2.0).angle("rope") == pytest.approx(1.0, abs=1e-11)
    assert world.joint("rope")["force"] == pytest.approx([0, 0, -G], abs=1e-10)


def test_stops_of_a_spring():
    """A spring with hard limits: the ball rests on the long stop, which takes what the spring does not."""
    ball = body("ball", "type: sphere, radius: 0.05", mass=1.0, position=(0, 0, -0.5), collides=False)
    spring = (
        "springs:\n  line: {type: linear, between: [world, ball], rest_length: 0.5, stiffness: 10, "
        "limits: [0.4, 0.6]}\n"
    )
    world = bench(ball, {}, more=spring).run(2.0)
    assert world.get("position", "ball")[2] == pytest.approx(-0.6, abs=1e-11)
    assert world.world.springs()["force"] == pytest.approx([1.0], abs=1e-9)
    assert np.linalg.norm(world.get("velocity", "ball")) < 1e-12


# motors


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_motor_reaches_its_speed_in_time(scheme):
    """T = I omega / torque = 0.8 s, then the speed is held to the last digit; work I omega^2 / 2."""
    world = wheel_on_a_hinge(scheme, motor={"speed": 4.0, "max_torque": 0.5}).run(0.799)
    assert spin_of(world) == pytest.approx(4.0 * 0.799 / 0.8, rel=1e-12)
    assert world.joint("pin")["torque"] == pytest.approx([0, 0, -0.5], rel=1e-12)
    assert spin_of(world.run(0.002)) == pytest.approx(4.0, rel=1e-14)
    assert spin_of(world.run(1.0)) == pytest.approx(4.0, rel=1e-14)
    # x += v dt of the Euler schemes: half a step of the final speed
    assert world.angle("pin") == pytest.approx(1.6 + 4 * 1.001, abs=2.1e-3 if "euler" in scheme else 1e-11)
    books = world.books()
    assert books["work_motors"] == pytest.approx(0.5 * MOMENT * 16, rel=1e-11)
    assert abs(books["residual"]) < 1e-11


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
def test_a_motor_under_load(scheme):
    """0.3 against 0.5 N m: 2 s instead of 0.8; then the motor gives just the load, and the books say so."""
    world = wheel_on_a_hinge(scheme, load=-0.3, motor={"speed": 4.0, "max_torque": 0.5}).run(3.0)
    assert spin_of(world) == pytest.approx(4.0, rel=1e-14)
    # The motor pushes the wheel with +0.3; on A it is the opposite.
    assert world.joint("pin")["torque"] == pytest.approx([0, 0, -0.3], rel=1e-10)
    books, way = world.books(), 4.0 + 4.0
    assert books["work_motors"] == pytest.approx(0.5 * MOMENT * 16 + 0.3 * way, rel=1e-10)
    assert books["work_forces"] == pytest.approx(-0.3 * way, rel=1e-10)
    assert abs(books["residual"]) < 1e-10


def test_an_overloaded_motor_is_driven_back():
    """0.7 against 0.5 N m: -2 rad/s^2; the motor takes energy out."""
    world = wheel_on_a_hinge(load=-0.7, motor={"speed": 4.0, "max_torque": 0.5}).run(1.0)
    assert spin_of(world) == pytest.approx(-2.0, rel=1e-12)
    assert world.books()["work_motors"] == pytest.approx(-0.5 * 1.0, rel=2e-3)


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
def test_a_motor_follows_its_profile(scheme):
    """4 sin(pi t): the speed is that of the instant, the angle its integral, 2e-6 in the trapezoid of the
    second order.
    """
    sine = {"type": "sine", "frequency": 0.5}
    world = wheel_on_a_hinge(scheme, motor={"speed": 4.0, "max_torque": 50, "profile": sine}).run(0.7)
    assert spin_of(world) == pytest.approx(4 * np.sin(0.7 * np.pi), rel=1e-13)
    angle = 4 / np.pi * (1 - np.cos(0.7 * np.pi))
    assert world.angle("pin") == pytest.approx(angle, abs=2e-3 if "euler" in scheme else 3e-6)
    assert abs(world.books()["residual"]) < 1e-12


@pytest.mark.parametrize(
    ("scheme", "within"), [("semi_implicit_euler", 1e-3), ("verlet", 5e-6), ("rk4", 5e-10)]
)
def test_servo_is_a_damped_oscillator(scheme, within):
    """k = 10, c = 0.4: omega_n = 10 /s, zeta = 0.2; a step of the target to 0.5 rad."""
    world = wheel_on_a_hinge(scheme, motor={"angle": 0.5, "stiffness": 10, "damping": 0.4}).run(1.0)
    zeta, n, t = 0.2, 10.0, 1.0
    d = n * np.sqrt(1 - zeta**2)
    ring = np.cos(d * t) + zeta / np.sqrt(1 - zeta**2) * np.sin(d * t)
    assert world.angle("pin") == pytest.approx(0.5 * (1 - np.exp(-zeta * n * t) * ring), abs=within)
    books = world.books()
    kinetic = 0.5 * MOMENT * spin_of(world) ** 2
    assert books["work_motors"] == pytest.approx(kinetic, abs=0.02 if "euler" in scheme else 1e-4)


def test_a_servo_is_cut_off_at_its_strength():
    """Far from its target it gives max_torque: 0.3 N m for 0.5 s."""
    world = wheel_on_a_hinge(
        "rk4", motor={"angle": 50.0, "stiffness": 10, "damping": 0.0, "max_torque": 0.3}
    ).run(0.5)
    assert spin_of(world) == pytest.approx(1.5, rel=1e-12)


@pytest.mark.parametrize(
    ("scheme", "within"), [("semi_implicit_euler", 1e-3), ("verlet", 1e-5), ("rk4", 2e-10)]
)
def test_damping_and_spring_back(scheme, within):
    """The same oscillator about 0.1 rad from 5 rad/s; what is gone went into the damper."""
    world = wheel_on_a_hinge(scheme, spin=5.0, damping=0.4, spring={"stiffness": 10, "rest": 0.1}).run(1.0)
    zeta, n, t = 0.2, 10.0, 1.0
    d = n * np.sqrt(1 - zeta**2)
    ring = -0.1 * np.cos(d * t) + (5 - 0.1 * zeta * n) / d * np.sin(d * t)
    angle = 0.1 + np.exp(-zeta * n * t) * ring
    assert world.angle("pin") == pytest.approx(angle, abs=within)
    books = world.books()
    spring = 0.5 * 10 * (world.angle("pin") - 0.1) ** 2
    assert books["spring"] == pytest.approx(spring, rel=1e-9)
    torque = -10 * (world.angle("pin") - 0.1) - 0.4 * spin_of(world)
    assert world.joint("pin")["torque"][2] == pytest.approx(-torque, rel=1e-9)
    assert abs(books["residual"]) < 2e-4


# dry friction


@pytest.mark.parametrize("scheme", SCHEMES)
def test_dry_friction_stops_a_wheel(scheme):
    """omega I / M = 3 s and omega^2 I / (2 M) = 9 rad, then it stands. All of the energy went into
    friction.
    """
    world = wheel_on_a_hinge(scheme, spin=6.0, friction=0.2).run(2.0)
    assert spin_of(world) == pytest.approx(2.0, rel=1e-11)
    assert world.joint("pin")["torque"] == pytest.approx([0, 0, 0.2], rel=1e-11)
    assert spin_of(world.run(0.999)) == pytest.approx(2e-3, rel=1e-8)
    # Rounding may leave 1e-45 rad/s of the last step's speed for one step more.
    assert abs(spin_of(world.run(0.002))) < 1e-40
    # Half a step of the first speed in the Euler schemes.
    assert world.angle("pin") == pytest.approx(9.0, abs=3.1e-3 if "euler" in scheme else 1e-10)
    books = world.run(1.0).books()
    assert spin_of(world) == 0.0
    assert books["lost_friction"] == pytest.approx(0.5 * MOMENT * 36, rel=1e-10)
    assert abs(books["residual"]) < 1e-11


@pytest.mark.parametrize("scheme", SCHEMES)
def test_dry_friction_holds_up_to_its_threshold(scheme):
    """0.19 N m is held without creep, 0.21 makes (0.21 - 0.2) / I."""
    held = wheel_on_a_hinge(scheme, load=0.19, friction=0.2).run(5.0)
    assert abs(held.angle("pin")) < 1e-14
    assert held.joint("pin")["torque"] == pytest.approx([0, 0, 0.19], rel=1e-10)
    gone = wheel_on_a_hinge(scheme, load=0.21, friction=0.2).run(1.0)
    assert spin_of(gone) == pytest.approx(0.1, rel=1e-10)


def test_a_brake_does_not_creep_on_a_turning_arm():
    """Friction of a rail holds a bead that the turning arm throws outwards: m r omega^2 = 9 N of 10 N, for
    20 s.

    A force that is constant over each step let it creep by half of r omega^2 dt^2 a step: 45 mm.
    """
    arm = body("arm", "type: box, size: [1, 0.1, 0.1]", mass=3.0, angular_velocity=(0, 0, 3), collides=False)
    bead = body(
        "bead",
        "type: box, size: [0.1, 0.1, 0.1]",
        mass=2.0,
        position=(0.5, 0, 0),
        velocity=(0, 1.5, 0),
        angular_velocity=(0, 0, 3),
        collides=False,
    )
    joints = {
        "pivot": {"type": "hinge", "between": ("world", "arm"), "anchor": (0, 0, 0), "axis": (0, 0, 1)},
        "rail": {
            "type": "slider",
            "between": ("arm", "bead"),
            "anchor": (0, 0, 0),
            "axis": (1, 0, 0),
            "friction": 10,
        },
    }
    world = bench(arm + bead, joints, gravity=(0, 0, 0)).run(20.0)
    assert abs(world.angle("rail")) < 1e-10
    turned = world.angle("pivot")
    out = np.array([np.cos(turned), np.sin(turned), 0])
    assert world.joint("rail")["force"] == pytest.approx(9.0 * out, abs=1e-6)


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
def test_a_motor_against_dry_friction(scheme):
    """0.5 - 0.2 N m until 4 rad/s, then 0.2 N m for friction alone; each in its book."""
    world = wheel_on_a_hinge(scheme, friction=0.2, motor={"speed": 4.0, "max_torque": 0.5}).run(1.0)
    assert spin_of(world) == pytest.approx(3.0, rel=1e-12)
    assert spin_of(world.run(1.0)) == pytest.approx(4.0, rel=1e-13)
    books = world.books()
    assert books["lost_friction"] == pytest.approx(0.2 * world.angle("pin"), rel=1e-3)
    assert books["work_motors"] == pytest.approx(0.5 * MOMENT * 16 + books["lost_friction"], rel=1e-10)
    assert abs(books["residual"]) < 1e-11


# breaking


def test_a_rod_breaks_at_its_force():
    """Pulled by 100 N/s on top of its weight of 19.62 N it bears 50 N until 0.3038 s; then the ball is
    free.
    """
    ball = body("ball", "type: sphere, radius: 0.05", mass=2.0, position=(0, 0, -1), collides=False)
    rod = {"type": "distance", "between": ("world", "ball"), "break_force": 50.0}
    pull = "forces: {pull: {body: ball, force: [0, 0, -100], profile: {type: ramp, over: 1}}}\n"
    world = bench(ball, {"rod": rod}, more=pull).run(0.303)
    whole = world.joint("rod")
    assert not whole["broken"]
    assert np.linalg.norm(whole["force"]) == pytest.approx(19.62 + 30.3, rel=1e-9)
    gone = world.step().joint("rod")
    assert gone["broken"]
    assert np.linalg.norm(gone["force"]) == 0
    world.run(0.1)
    fall = G * 0.1 + 100 * (0.404**2 - 0.304**2) / 2 / 2.0
    assert world.get("velocity", "ball")[2] == pytest.approx(-fall, rel=2e-3)


@pytest.mark.parametrize("line", [{"length": 1.0}, {"limits": (0, 1.0)}])
def test_a_pendulum_breaks_where_its_pull_is_too_great(line):
    """Let go level the pull is 3 m g cos(angle from the vertical): 2 m g where the cosine is 2/3, on a rod
    as on a rope.
    """
    ball = body("ball", "type: sphere, radius: 0.05", mass=1.0, position=(1, 0, 0), collides=False)
    rod = {"type": "distance", "between": ("world", "ball"), "break_force": 2 * G}
    world = bench(ball, {"line": rod | line}, scheme="velocity_verlet")
    falls = [0.0]
    while not world.step().joint("line")["broken"]:
        falls.append(-world.get("position", "ball")[2])
    assert falls[-1] < 2 / 3 < -world.get("position", "ball")[2] + 1e-5
    speed = world.get("velocity", "ball")
    assert speed @ speed == pytest.approx(2 * G * 2 / 3, rel=1e-2)
    # Free from there on.
    fallen = world.run(0.2).get("velocity", "ball")
    assert fallen == pytest.approx(speed + np.array([0, 0, -0.2 * G]), abs=1e-12)


@pytest.mark.parametrize(("share", "breaks"), [(1 - 1e-9, True), (1 + 1e-9, False)])
def test_a_weld_breaks_at_its_torque(share, breaks):
    """A cantilever loads its weld with m g L / 2 = 9.81 N m; it breaks just below, and then falls without
    turning.
    """
    weld = {"type": "fixed", "between": ("world", "rod"), "anchor": (0, 0, 0), "break_torque": 9.81 * share}
    world = bench(rod(), {"weld": weld}, scheme="rk4").run(0.5)
    assert bool(world.joint("weld")["broken"]) == breaks
    # It breaks at the end of the first step.
    fallen = 0.5 * G * 0.499**2 if breaks else 0.0
    assert world.get("position", "rod") == pytest.approx([0.5, 0, -fallen], abs=1e-10)
    assert np.linalg.norm(world.get("angular_velocity", "rod")) < 1e-12
