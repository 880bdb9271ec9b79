"""Every kind of joint against a closed form, or against an independent integration of the motion in as few
coordinates as the joint leaves: motion, coordinates, reaction force and torque.
"""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import body, rotation
from workbench import bench, moved

G = 9.81
DOWN = np.array([0, 0, -G])
SIZE = np.array([0.5, 0.3, 0.2])
MASS = 2.0


def of_box(mass, size):
    """Moments of a box about its centre [kg m2]."""
    x, y, z = np.square(size)
    return mass / 12 * np.array([y + z, x + z, x + y])


MOMENTS = of_box(MASS, SIZE)


def turn(axis, angle):
    """Rotation matrix (Rodrigues)."""
    x, y, z = axis / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def about(point, mass, moments):
    """Inertia about a point that lies `point` from the centre [kg m2] (Steiner)."""
    return np.diag(moments) + mass * (point @ point * np.eye(3) - np.outer(point, point))


def box(name="box", **fields):
    return body(name, f"type: box, size: {SIZE.tolist()}", mass=MASS, collides=False, **fields)


# distance


def test_distance_is_a_spherical_pendulum():
    """theta'' = sin cos phi'^2 - (g/L) sin, phi'' = -2 theta' phi' cot; tension m (g cos + v^2/L).
    Landau & Lifshitz, Mechanics, sec. 14, problem 1. Measured: 8e-12 m, tension 2e-10 N.
    """
    length, mass, spin = 0.8, 1.5, 2.0
    tilt = 1.1
    place = length * np.array([np.sin(tilt), 0, -np.cos(tilt)])
    ball = body(
        "ball",
        "type: sphere, radius: 0.1",
        mass=mass,
        position=place,
        velocity=(0, length * np.sin(tilt) * spin, 0),
        collides=False,
    )
    rod = {"type": "distance", "between": ("world", "ball"), "length": length}
    found = bench(ball, {"rod": rod}, scheme="rk4").run(3.0)

    def rates(_, y):
        a, _, da, db = y
        return [da, db, np.sin(a) * np.cos(a) * db**2 - G / length * np.sin(a), -2 * da * db / np.tan(a)]

    a, b, da, db = moved(rates, [tilt, 0, 0, spin], 3.0)[0]
    where = length * np.array([np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), -np.cos(a)])
    assert found.get("position", "ball") == pytest.approx(where, abs=1e-10)
    speed_squared = length**2 * (da**2 + (np.sin(a) * db) ** 2)
    pull = mass * (G * np.cos(a) + speed_squared / length)
    rod = found.joint("rod")
    assert rod["force"] == pytest.approx(pull * where / length, abs=1e-9)
    assert np.linalg.norm(rod["torque"]) < 1e-12
    assert rod["violation"] < 1e-12
    assert abs(found.books()["residual"]) < 1e-9


@pytest.mark.parametrize("scheme", ["semi_implicit_euler", "velocity_verlet", "rk4"])
def test_pull_of_a_pendulum_at_its_lowest_point(scheme):
    """m (g + v^2 / L), 3 m g when let go level (Huygens 1673). The instant of the lowest point falls
    between steps: the largest pull is off by (g/L) dt^2 of it, 1e-5.
    """
    length, mass = 1.0, 2.0
    ball = body("ball", "type: sphere, radius: 0.05", mass=mass, position=(length, 0, 0), collides=False)
    swing = bench(ball, {"rod": {"type": "distance", "between": ("world", "ball")}}, scheme=scheme).run(0.5)
    pulls, speeds = [], []
    for _ in range(200):
        pulls.append(np.linalg.norm(swing.step().joint("rod")["force"]))
        speeds.append(np.linalg.norm(swing.get("velocity", "ball")))
    lowest = int(np.argmax(pulls))
    assert 5 < lowest < 195
    assert pulls[lowest] == pytest.approx(mass * (G + speeds[lowest] ** 2 / length), rel=1e-4)
    assert pulls[lowest] == pytest.approx(3 * mass * G, rel=1e-4)


# ball


def spinning_rates(inertia, arm, mass):
    """Euler's equations about a fixed point, body axes: y = (quaternion, omega)."""

    def rates(_, y):
        q, w = y[:4], y[4:]
        r = rotation(q / np.linalg.norm(q))
        torque = np.cross(arm, mass * r.T @ DOWN)
        a, b, c, d = q
        x, y_, z = w
        dq = 0.5 * np.array(
            [-b * x - c * y_ - d * z, a * x + c * z - d * y_, a * y_ - b * z + d * x, a * z + b * y_ - c * x]
        )
        return np.concatenate([dq, np.linalg.solve(inertia, torque - np.cross(w, inertia @ w))])

    return rates


def reaction_on_a(q, w, inertia, arm, mass):
    """-m (a - g) for the centre `arm` from the fixed point, body axes in, world axes out."""
    r = rotation(q)
    torque = np.cross(arm, mass * r.T @ DOWN)
    alpha = np.linalg.solve(inertia, torque - np.cross(w, inertia @ w))
    return -mass * (r @ (np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))) - DOWN)


@pytest.mark.parametrize("kind", ["ball", "cone"])
def test_ball_is_a_body_about_a_fixed_point(kind):
    """Euler's equations about the point with Steiner's inertia; a cone within its angle is the same.
    Measured 4e-11 m, reaction 2e-9 N.
    """
    arm = np.array([0.25, 0.1, -0.15])
    omega = np.array([1.0, 2.0, 3.0])
    block = box(position=arm, velocity=np.cross(omega, arm), angular_velocity=omega)
    joint = {"type": kind, "between": ("world", "box"), "anchor": (0, 0, 0)}
    if kind == "cone":
        joint |= {"axis": (0, 0, 1), "max_angle": 3.1}
    found = bench(block, {"pin": joint}, scheme="rk4").run(2.0)
    inertia = about(arm, MASS, MOMENTS)
    y = moved(spinning_rates(inertia, arm, MASS), [1, 0, 0, 0, *omega], 2.0)[0]
    q, w = y[:4], y[4:]
    assert found.get("position", "box") == pytest.approx(rotation(q) @ arm, abs=1e-9)
    pin = found.joint("pin")
    assert pin["force"] == pytest.approx(reaction_on_a(q, w, inertia, arm, MASS), abs=1e-7)
    assert np.linalg.norm(pin["torque"]) < 1e-10
    assert pin["violation"] < 1e-12
    assert abs(found.books()["residual"]) < 1e-8


def test_damping_of_a_ball_joint():
    """A spherical body about its centre: omega = omega0 exp(-c t / I); the loss is booked."""
    c, mass, radius = 0.05, 1.0, 0.2
    moment = 0.4 * mass * radius**2
    ball = body(
        "ball", f"type: sphere, radius: {radius}", mass=mass, angular_velocity=(3, 4, 12), collides=False
    )
    joint = {"type": "ball", "between": ("world", "ball"), "anchor": (0, 0, 0), "damping": c}
    found = bench(ball, {"pin": joint}, scheme="rk4", gravity=(0, 0, 0)).run(0.5)
    left = np.exp(-c * 0.5 / moment)
    assert found.get("angular_velocity", "ball") == pytest.approx(left * np.array([3, 4, 12]), rel=1e-10)
    assert found.books()["lost_damping"] == pytest.approx(0.5 * moment * 169 * (1 - left**2), rel=1e-9)


# hinge


def test_hinge_is_a_physical_pendulum_about_a_tilted_axis():
    """I theta'' = n . (r x m g). Reaction -m (a - g), and -(dL/dt - r x m g) about the anchor, for a box
    whose principal axes lie skew to the hinge. Measured 7e-11 rad, 2e-9 N, 4e-10 N m.
    """
    axis = np.array([0.3, 1.0, 0.2])
    n = axis / np.linalg.norm(axis)
    arm, rate = np.array([0.3, 0.05, -0.1]), 1.5
    block = box(position=arm, velocity=np.cross(rate * n, arm), angular_velocity=rate * n)
    joint = {"type": "hinge", "between": ("world", "box"), "anchor": (0, 0, 0), "axis": axis}
    found = bench(block, {"pin": joint}, scheme="rk4").run(3.0)
    inertia = about(arm, MASS, MOMENTS)

    def push(angle):
        return n @ np.cross(turn(n, angle) @ arm, MASS * DOWN) / (n @ inertia @ n)

    angle, w = moved(lambda _, y: [y[1], push(y[0])], [0, rate], 3.0)[0]
    pin = found.joint("pin")
    assert pin["coordinate"] == pytest.approx(angle, abs=1e-10)
    r, omega, alpha = turn(n, angle), w * n, push(angle) * n
    x = r @ arm
    a = np.cross(alpha, x) + np.cross(omega, np.cross(omega, x))
    spin = r @ inertia @ r.T
    growth = spin @ alpha + np.cross(omega, spin @ omega)
    assert pin["force"] == pytest.approx(-MASS * (a - DOWN), abs=1e-8)
    assert pin["torque"] == pytest.approx(-(growth - np.cross(x, MASS * DOWN)), abs=1e-8)
    assert pin["violation"] < 1e-12
    assert pin["angular_violation"] < 1e-12
    assert abs(found.books()["residual"]) < 1e-8


@pytest.mark.parametrize("between", [("world", "wheel"), ("wheel", "world")])
def test_angle_of_a_hinge_counts_turns(between):
    """50 rad/s for 10 s, 79.6 turns; of B seen from A, so that order turns the sign."""
    wheel = body(
        "wheel", "type: cylinder, radius: 0.2, height: 0.1", angular_velocity=(0, 0, 50), collides=False
    )
    joint = {"type": "hinge", "between": between, "anchor": (0, 0, 0), "axis": (0, 0, 1)}
    found = bench(wheel, {"pin": joint}, timestep=2e-3).run(10.0)
    sign = 1 if between[0] == "world" else -1
    assert found.angle("pin") == pytest.approx(sign * 500, abs=1e-9)


# slider


@pytest.mark.parametrize("between", [("world", "box"), ("box", "world")])
def test_slider_falls_along_its_axis(between):
    """s = g_n t^2 / 2; the rail takes the rest of the weight, and its moment about the anchor: on A."""
    axis = np.array([1.0, 0.5, -0.8])
    n = axis / np.linalg.norm(axis)
    place, anchor = np.array([0.2, -0.1, 0.4]), np.array([0.1, 0.3, 0.2])
    joint = {"type": "slider", "between": between, "anchor": anchor, "axis": axis}
    found = bench(box(position=place), {"rail": joint}, scheme="rk4").run(1.0)
    way = 0.5 * (DOWN @ n) * n
    assert found.get("position", "box") == pytest.approx(place + way, abs=1e-12)
    sign = 1 if between[0] == "world" else -1
    rail = found.joint("rail")
    assert rail["coordinate"] == pytest.approx(sign * (way @ n), abs=1e-12)
    carried = MASS * (DOWN - (DOWN @ n) * n)
    assert rail["force"] == pytest.approx(sign * carried, abs=1e-10)
    of_a = anchor if between[0] == "world" else anchor + way
    assert rail["torque"] == pytest.approx(sign * np.cross(place + way - of_a, carried), abs=1e-10)


def test_bead_on_a_turning_rail():
    """r'' = r phi'^2 with (I + m r^2) phi' constant; Landau & Lifshitz sec. 9. Measured 2e-13 m."""
    moment_arm = 3.0 / 12 * (1.0 + 0.01)
    arm = body("arm", "type: box, size: [1, 0.1, 0.1]", mass=3.0, angular_velocity=(0, 0, 2), collides=False)
    bead = box(position=(0.1, 0, 0), velocity=(0, 0.2, 0), angular_velocity=(0, 0, 2))
    joints = {
        "pivot": {"type": "hinge", "between": ("world", "arm"), "anchor": (0, 0, 0), "axis": (0, 0, 1)},
        "rail": {"type": "slider", "between": ("arm", "box"), "anchor": (0, 0, 0), "axis": (1, 0, 0)},
    }
    found = bench(arm + bead, joints, scheme="rk4", gravity=(0, 0, 0)).run(1.0)
    inertia = moment_arm + MOMENTS[2]
    turning = 2 * (inertia + MASS * 0.01)

    def rates(_, y):
        w = turning / (inertia + MASS * y[0] ** 2)
        return [y[1], y[0] * w**2, w]

    r, speed, angle = moved(rates, [0.1, 0, 0], 1.0)[0]
    w = turning / (inertia + MASS * r**2)
    rail = found.joint("rail")
    assert rail["coordinate"] == pytest.approx(r - 0.1, abs=1e-11)
    assert found.angle("pivot") == pytest.approx(angle, abs=1e-11)
    # The rail pushes the bead sideways with the Coriolis force and turns it as the arm turns.
    side = np.array([-np.sin(angle), np.cos(angle), 0])
    slowing = -2 * r * speed * w * MASS / (inertia + MASS * r**2)
    assert rail["force"] == pytest.approx(-MASS * (2 * speed * w + r * slowing) * side, abs=1e-9)
    assert abs(found.books()["residual"]) < 1e-10


# fixed


def test_cantilever_of_two_welds():
    """Statics: the weld at the wall carries both weights and their moments, the outer one the outer
    weight's.
    """
    parts = box("inner", position=(0.25, 0, 0)) + box("outer", position=(0.75, 0, 0))
    joints = {
        "wall": {"type": "fixed", "between": ("world", "inner"), "anchor": (0, 0, 0)},
        "weld": {"type": "fixed", "between": ("outer", "inner"), "anchor": (0.5, 0, 0)},
    }
    found = bench(parts, joints).run(1.0)
    weight = MASS * DOWN
    wall, weld = found.joint("wall"), found.joint("weld")
    assert wall["force"] == pytest.approx(2 * weight, abs=1e-9)
    assert wall["torque"] == pytest.approx(np.cross([0.25 + 0.75, 0, 0], weight), abs=1e-9)
    # A is the outer box, which the inner one holds up.
    assert weld["force"] == pytest.approx(-weight, abs=1e-9)
    assert weld["torque"] == pytest.approx(-np.cross([0.25, 0, 0], weight), abs=1e-9)
    assert found.get("position", "outer") == pytest.approx([0.75, 0, 0], abs=1e-10)


def test_welded_boxes_tumble_as_one_body():
    """Euler's equations of the whole. Measured 4e-13 m."""
    offset = np.array([0.25, 0.3, 0.1])
    omega = np.array([3.0, 1.0, 2.0])
    parts = "".join(
        box(name, position=side * offset, velocity=np.cross(omega, side * offset), angular_velocity=omega)
        for name, side in (("left", -1), ("right", 1))
    )
    joints = {"weld": {"type": "fixed", "between": ("left", "right"), "anchor": (0, 0, 0.3)}}
    found = bench(parts, joints, scheme="rk4", gravity=(0, 0, 0)).run(2.0)
    inertia = 2 * about(offset, MASS, MOMENTS)
    y = moved(spinning_rates(inertia, np.zeros(3), MASS), [1, 0, 0, 0, *omega], 2.0)[0]
    r = rotation(y[:4])
    assert found.get("position", "right") == pytest.approx(r @ offset, abs=5e-9)
    assert found.get("angular_velocity", "left") == pytest.approx(r @ y[4:], abs=5e-8)
    assert max(found.worst_violation()) < 1e-12


# universal


def test_universal_pendulum():
    """R = Rz(a) Rx(b): T = (A b'^2 + (B sin^2 b + C cos^2 b) a'^2) / 2, V = -m g l cos a cos b. Measured
    1e-11 rad.
    """
    arm = np.array([0, -0.4, 0])
    omega = np.array([1.2, 0, 0.9])
    block = box(position=arm, velocity=np.cross(omega, arm), angular_velocity=omega)
    joint = {
        "type": "universal",
        "between": ("world", "box"),
        "anchor": (0, 0, 0),
        "axes": ((0, 0, 1), (1, 0, 0)),
    }
    found = bench(block, {"cross": joint}, scheme="rk4", gravity=(0, -G, 0)).run(2.0)
    A, B, C = np.diag(about(arm, MASS, MOMENTS))

    def rates(_, y):
        a, b, da, db = y
        d = B * np.sin(b) ** 2 + C * np.cos(b) ** 2
        slope = (B - C) * np.sin(2 * b)
        weight = MASS * G * 0.4
        dda = (-weight * np.sin(a) * np.cos(b) - slope * da * db) / d
        ddb = (0.5 * slope * da**2 - weight * np.cos(a) * np.sin(b)) / A
        return [da, db, dda, ddb]

    a, b, _, _ = moved(rates, [0, 0, 0.9, 1.2], 2.0)[0]
    cross = found.joint("cross")
    assert [cross["coordinate"], cross["coordinate_2"]] == pytest.approx([a, b], abs=1e-10)
    assert abs(found.books()["residual"]) < 1e-8


# cylindrical, planar, screw, gear


def test_cylindrical_slides_and_swings():
    """s'' = g_n, and a physical pendulum about the axis; neither knows of the other."""
    axis = np.array([0.0, 1.0, -0.5])
    n = axis / np.linalg.norm(axis)
    arm = np.array([0.3, 0, 0])
    joint = {"type": "cylindrical", "between": ("world", "box"), "anchor": (0, 0, 0), "axis": axis}
    found = bench(box(position=arm), {"sleeve": joint}, scheme="rk4").run(2.0)
    inertia = about(arm, MASS, MOMENTS)

    def push(angle):
        return n @ np.cross(turn(n, angle) @ arm, MASS * DOWN) / (n @ inertia @ n)

    angle, _ = moved(lambda _, y: [y[1], push(y[0])], [0, 0], 2.0)[0]
    sleeve = found.joint("sleeve")
    assert sleeve["coordinate"] == pytest.approx(0.5 * (DOWN @ n) * 4, abs=1e-10)
    assert sleeve["coordinate_2"] == pytest.approx(angle, abs=1e-10)
    assert n @ sleeve["force"] == pytest.approx(0, abs=1e-8)
    assert n @ sleeve["torque"] == pytest.approx(0, abs=1e-8)


def test_planar_slides_down_a_slope_spinning():
    """The centre on a parabola in the plane, the spin constant; the plane carries m g cos, and the moment
    that a box turning about no principal axis asks for.
    """
    slope = 0.4
    normal = np.array([np.sin(slope), 0, np.cos(slope)])
    downhill = np.array([np.cos(slope), 0, -np.sin(slope)])
    across = np.cross(normal, downhill)
    start = 0.5 * across - 0.2 * downhill
    block = box(velocity=start, angular_velocity=2.0 * normal)
    joint = {
        "type": "planar",
        "between": ("world", "box"),
        "anchor": (0, 0, 0),
        "normal": normal,
        "axis": downhill,
    }
    found = bench(block, {"plane": joint}, scheme="rk4").run(2.0)
    plane = found.joint("plane")
    assert plane["coordinate"] == pytest.approx(-0.4 + 0.5 * G * np.sin(slope) * 4, abs=1e-11)
    assert plane["coordinate_2"] == pytest.approx(1.0, abs=1e-11)
    assert plane["coordinate_3"] == pytest.approx(4.0, abs=1e-11)
    assert plane["force"] == pytest.approx(-MASS * G * np.cos(slope) * normal, abs=1e-9)
    r = turn(normal, 4.0)
    spin = 2 * normal
    growth = np.cross(spin, r @ np.diag(MOMENTS) @ r.T @ spin)
    centre = found.get("position", "box")
    assert plane["torque"] == pytest.approx(np.cross(centre, plane["force"]) - growth, abs=1e-8)


@pytest.mark.parametrize("pitch", [0.05, -0.2])
def test_screw_under_its_weight(pitch):
    """(m + I / p^2) s'' = m g with p = pitch / 2 pi; travel = p angle. The thread carries m (g - s'')."""
    joint = {
        "type": "screw",
        "between": ("world", "box"),
        "anchor": (0, 0, 0),
        "axis": (0, 0, 1),
        "pitch": pitch,
    }
    found = bench(box(), {"thread": joint}, scheme="rk4").run(2.0)
    p = pitch / (2 * np.pi)
    fall = -MASS * G / (MASS + MOMENTS[2] / p**2)
    thread = found.joint("thread")
    assert thread["coordinate"] == pytest.approx(0.5 * fall * 4 / p, rel=1e-10)
    assert found.get("position", "box")[2] == pytest.approx(0.5 * fall * 4, rel=1e-10)
    assert thread["force"] == pytest.approx([0, 0, -MASS * (G + fall)], abs=1e-9)
    assert thread["torque"] == pytest.approx([0, 0, -MOMENTS[2] * fall / p], abs=1e-9)
    assert abs(found.books()["residual"]) < 1e-10


@pytest.mark.parametrize("ratio", [3.0, -0.5])
def test_gear_ratio_and_effective_inertia(ratio):
    """angle_2 = k angle_1: a torque on wheel 1 moves I_1 + k^2 I_2, and the teeth pass k I_2 alpha_2 on."""
    inertia = {"small": 0.5 * 1.0 * 0.01, "large": 0.5 * 4.0 * 0.09}
    wheels = body("small", "type: cylinder, radius: 0.1, height: 0.1", mass=1.0, collides=False)
    wheels += body(
        "large", "type: cylinder, radius: 0.3, height: 0.1", mass=4.0, position=(0.4, 0, 0), collides=False
    )
    pin = {"type": "hinge", "axis": (0, 0, 1)}
    joints = {
        "first": pin | {"between": ("world", "small"), "anchor": (0, 0, 0)},
        "second": pin | {"between": ("world", "large"), "anchor": (0.4, 0, 0)},
        "teeth": {"type": "gear", "joints": ("first", "second"), "ratio": ratio},
    }
    more = "forces: {drive: {body: small, torque: [0, 0, 0.2]}}\n"
    found = bench(wheels, joints, scheme="rk4", more=more).run(2.0)
    alpha = 0.2 / (inertia["small"] + ratio**2 * inertia["large"])
    assert found.angle("first") == pytest.approx(2 * alpha, rel=1e-11)
    assert found.angle("second") == pytest.approx(2 * ratio * alpha, rel=1e-11)
    # On the first wheel, which is A of the gear.
    teeth = found.joint("teeth")
    assert teeth["torque"] == pytest.approx([0, 0, -ratio * inertia["large"] * ratio * alpha], rel=1e-10)
    assert found.books()["work_forces"] == pytest.approx(0.2 * 2 * alpha, rel=1e-10)
    assert abs(found.books()["residual"]) < 1e-10
