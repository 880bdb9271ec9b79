"""Bodies that turn: free against Jacobi's elliptic functions, heavy tops against their Euler angles."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from laboratory import GRAVITY, ORDERS, VERLET, Lab, measured, mechanics, rotation, samples
from workbench import moved

TIMES = 0.2 * np.arange(1, 11)


def turned(scene: Lab, name: str = "body") -> Any:
    """R (9) and the angular velocity [rad/s] in world axes, in tens."""
    return np.append(rotation(scene.get("orientation", name)), scene.get("angular_velocity", name) / 10)


def about_x(angle: float) -> Any:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, cos, -sin], [0, sin, cos]])


def about_z(angle: float) -> Any:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])


def quaternion(axis: Any, angle: float) -> Any:
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * np.array(axis) / np.linalg.norm(axis))])


# ----------------------------------------------------------------------------------------- free of torque

MOMENTS = np.array([1.0, 1.8, 2.4])
OMEGA = np.array([2.0, 0.0, 1.8])  # in principal axes at the start
PRINCIPAL = rotation(quaternion((1, -2, 0.5), 0.9))  # principal axes in the body
PLACED = quaternion((0.3, 1, -0.4), 1.3)


def free_body(integrator: str, timestep: float) -> Lab:
    """A body with three different moments about axes that are not its own, in any orientation."""
    inertia = PRINCIPAL @ np.diag(MOMENTS) @ PRINCIPAL.T
    names = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    body = {
        "mass": 5.0,
        "inertia": {name: inertia[place] for name, place in names.items()},
        "orientation": {"quaternion": PLACED},
        "angular_velocity": rotation(PLACED) @ PRINCIPAL @ OMEGA,
    }
    return mechanics({"body": body}, integrator=integrator, timestep=timestep)


@cache
def jacobi() -> Any:
    """R and omega at TIMES. omega from Jacobi's functions (Landau & Lifshitz, Mechanics, eqs. 37.8 to
    37.10, for M^2 > 2 E I2), two Euler angles from it (37.14), the third from phi' = M (I1 o1^2 + I2 o2^2)
    / (I1^2 o1^2 + I2^2 o2^2) (37.16).
    """
    from scipy.special import ellipj  # noqa: PLC0415

    (a, b, c), energy = MOMENTS, MOMENTS @ OMEGA**2  # twice the energy
    squared = np.sum((MOMENTS * OMEGA) ** 2)
    assert squared > energy * b
    total = np.sqrt(squared)
    size = np.sqrt(
        [
            (energy * c - squared) / (a * (c - a)),
            (energy * c - squared) / (b * (c - b)),
            (squared - energy * a) / (c * (c - a)),
        ]
    )
    pace = np.sqrt((c - b) * (squared - energy * a) / (a * b * c))
    parameter = (b - a) * (energy * c - squared) / ((c - b) * (squared - energy * a))

    def omega(t: float) -> Any:
        sn, cn, dn, _ = ellipj(pace * t, parameter)
        return size * np.array([cn, sn, dn])

    def drift(t: float) -> Any:
        o = omega(t)[:2]
        return total * np.sum(MOMENTS[:2] * o**2) / np.sum((MOMENTS[:2] * o) ** 2)

    def frame(t: float, phi: float) -> Any:
        """Principal axes as seen along M."""
        m = MOMENTS * omega(t) / total
        return about_z(phi) @ about_x(np.arccos(m[2])) @ about_z(np.arctan2(m[0], m[1]))

    assert omega(0.0) == pytest.approx(OMEGA, abs=1e-14)
    start = rotation(PLACED) @ PRINCIPAL @ frame(0.0, 0.0).T
    found = []
    for t, (phi,) in zip(TIMES, moved(lambda t, _: [drift(t)], [0.0], TIMES), strict=True):
        axes = start @ frame(t, phi)
        found.append(np.append(axes @ PRINCIPAL.T, axes @ omega(t) / 10))
    return np.array(found)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_free_body_follows_jacobi(integrator):
    order = ORDERS[integrator]
    steps = {1: 5e-4, 2: 1e-2, 4: 2e-2}[order] / np.array([1, 2, 4])
    _, slopes = measured(lambda h: free_body(integrator, h), turned, jacobi(), TIMES, steps)
    assert slopes == pytest.approx([order, order], abs=0.1)


@pytest.mark.parametrize("integrator", ORDERS)
def test_a_free_body_keeps_its_angular_momentum(integrator):
    """Also explicit Euler: the angular momentum is what torque changes. Measured 9e-16."""
    scene = free_body(integrator, 1e-2)
    before = scene.momentum()[1]
    after = scene.step(1000).momentum()[1]
    assert np.linalg.norm(after - before) < 1e-14 * np.linalg.norm(before)


@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "leapfrog"])
def test_the_energy_of_a_free_body_does_not_drift(integrator):
    """1e5 steps; the band of the last tenth is that of the first."""
    scene = free_body(integrator, 2e-2)
    start = scene.energy()
    error = np.array([scene.step(50).energy() - start for _ in range(2000)])
    first, last = error[:200], error[-200:]
    assert np.ptp(last) == pytest.approx(np.ptp(first), rel=0.02)
    assert abs(last.mean() - first.mean()) < 0.01 * np.ptp(first)


# --------------------------------------------------------------------------------------------- heavy tops

ARM, WEIGHT = 0.1, 2.0 * GRAVITY  # from the tip to the centre of mass [m], [N]
ACROSS, ALONG = 0.05, 0.06  # moments about the centre of mass
TILT, NUTATION, PRECESSION, SPIN = 0.7, 0.4, 1.0, 14.0  # theta, theta', phi', and omega along the axis


def top(**fields: Any) -> dict[str, Any]:
    """A body whose axis leans over by TILT about x and moves as the Euler angles say."""
    omega = [NUTATION, 0, PRECESSION] + (SPIN - PRECESSION * np.cos(TILT)) * axis(TILT)
    return {
        "mass": 2.0,
        "inertia": {"xx": ACROSS, "yy": ACROSS, "zz": ALONG},
        "orientation": {"axis": (1, 0, 0), "angle": TILT},
        "angular_velocity": omega,
    } | fields


def axis(tilt: float) -> Any:
    return np.array([0, -np.sin(tilt), np.cos(tilt)])


def euler_angles(moment: float, times: Any) -> Any:
    """R and omega of a symmetric top with the moment across about the point that torque counts from:
    Lagrange's equations with both cyclic momenta kept (Goldstein, Classical Mechanics, sec. 5.7), U = m g l
    cos(theta).
    """
    p_psi = ALONG * SPIN
    p_phi = moment * np.sin(TILT) ** 2 * PRECESSION + p_psi * np.cos(TILT)

    def going_round(theta: float) -> Any:
        return (p_phi - p_psi * np.cos(theta)) / (moment * np.sin(theta) ** 2)

    def rates(_: float, y: Any) -> Any:
        theta, speed = y[:2]
        phi = going_round(theta)
        lift = moment * phi**2 * np.cos(theta) - p_psi * phi + WEIGHT * ARM
        return [speed, lift * np.sin(theta) / moment, phi, SPIN - phi * np.cos(theta)]

    found = []
    for theta, speed, phi, psi in moved(rates, [TILT, NUTATION, 0, 0], times):
        turn = about_z(phi) @ about_x(theta)
        omega = turn @ [speed, 0, 0] + [0, 0, going_round(theta)]
        omega += (SPIN - going_round(theta) * np.cos(theta)) * turn[:, 2]
        found.append(np.append(turn @ about_z(psi), omega / 10))
    return np.array(found)


def heavy_top(integrator: str, timestep: float) -> Lab:
    """On its tip, a ball joint."""
    body = top(position=ARM * axis(TILT))
    body["velocity"] = np.cross(body["angular_velocity"], body["position"])
    tip = {"type": "ball", "between": ("world", "body"), "anchor": (0, 0, 0)}
    return mechanics(
        {"body": body},
        joints={"tip": tip},
        integrator=integrator,
        timestep=timestep,
        gravity=(0, 0, -GRAVITY),
    )


def carried_top(integrator: str, timestep: float) -> Lab:
    """Free, with a force that stays in the world at a point of its axis: it turns like a heavy top about its
    centre, which falls on a parabola.
    """
    push = {"body": "body", "force": (0, 0, -WEIGHT), "at": (0, 0, ARM)}
    return mechanics({"body": top()}, forces={"push": push}, integrator=integrator, timestep=timestep)


TOPS = {"on its tip": (heavy_top, ACROSS + 2.0 * ARM**2), "free": (carried_top, ACROSS)}


@cache
def theory_of(name: str) -> Any:
    return euler_angles(TOPS[name][1], TIMES)


@pytest.mark.parametrize("integrator", ORDERS)
@pytest.mark.parametrize("name", TOPS)
def test_a_heavy_top_follows_its_euler_angles(name, integrator):
    order, make = ORDERS[integrator], TOPS[name][0]
    steps = {1: 2e-4, 2: 4e-3, 4: 4e-3}[order] / np.array([1, 2, 4])
    _, slopes = measured(lambda h: make(integrator, h), turned, theory_of(name), TIMES, steps)
    assert slopes == pytest.approx([order, order], abs=0.1)


def test_a_heavy_top_under_rk4_is_as_accurate_as_its_angles():
    """5 s in steps of 1 ms. Measured 1e-9, the joint held to 4e-13 m."""
    times = np.arange(1.0, 6.0)
    scene = heavy_top("rk4", 1e-3)
    found = samples(scene, times, turned)
    tip = scene.joint("tip")
    assert found == pytest.approx(euler_angles(TOPS["on its tip"][1], times), abs=1e-8)
    assert tip["violation"] < 1e-10


@pytest.mark.parametrize("integrator", ["rk4", *VERLET])
def test_a_force_at_a_point_moves_the_centre_on_a_parabola(integrator):
    scene = carried_top(integrator, 1e-2).run(1.0)
    assert scene.get("position", "body") == pytest.approx([0, 0, -GRAVITY / 2], abs=1e-13)


def test_kovalevskayas_integral():
    """I1 = I2 = 2 I3 about the support, the centre of mass off the axis: |(o1 + i o2)^2 - c (g1 + i g2)|^2 is
    kept with c = m g l / I3, g the upward vertical in body axes (Kovalevskaya 1889). Measured 6e-11.
    """
    mass, arm, across = 1.0, 0.2, 0.2
    about_centre = {"xx": across, "yy": across - mass * arm**2, "zz": across / 2 - mass * arm**2}
    omega = np.array([2.0, -1.0, 3.0])
    body = {"inertia": about_centre, "position": (arm, 0, 0), "angular_velocity": omega}
    body["velocity"] = np.cross(omega, (arm, 0, 0))
    pivot = {"type": "ball", "between": ("world", "body"), "anchor": (0, 0, 0)}
    scene = mechanics({"body": body}, joints={"pivot": pivot}, gravity=(0, 0, -GRAVITY))

    def integral() -> float:
        turn = rotation(scene.get("orientation", "body"))
        o, g = turn.T @ scene.get("angular_velocity", "body"), turn[2]
        pulled = mass * GRAVITY * arm / (across / 2) * complex(g[0], g[1])
        return float(abs(complex(o[0], o[1]) ** 2 - pulled) ** 2)

    start = integral()
    found = []
    for _ in range(10):
        scene.run(0.5)
        found.append(integral())
    assert found == pytest.approx([start] * 10, rel=1e-9)
