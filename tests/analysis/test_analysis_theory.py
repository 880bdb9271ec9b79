"""The closed forms of `physsim verify` against equations of motion, integrated here by DOP853."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from physsim.analysis.verify import measure
from physsim.analysis.verify.sections import (
    beyond_joints,
    double_pendulum,
    free_rotation,
    integration,
    pendulum,
    springs,
)

TIMES = np.linspace(0, 3, 61)
BODY = {"I1": 0.2, "I2": 0.3, "I3": 0.4, "w1": 1.5, "w3": 2.0}


def solved(rates, start, times=TIMES):
    """(n, T): the solution to 1e-12."""
    return solve_ivp(
        lambda t, y: rates(y), (times[0], times[-1]), start, "DOP853", t_eval=times, rtol=1e-12, atol=1e-13
    ).y


@pytest.mark.parametrize("zeta", [0.0, 0.1, 0.999, 1.0, 1.001, 3.0])
def test_a_damped_oscillator(zeta):
    omega, x, v = 5.0, 0.3, -0.7
    truth = solved(lambda y: [y[1], -2 * zeta * omega * y[1] - omega**2 * y[0]], [x, v])[0]
    # measured 3e-11
    assert springs.swing(omega, zeta, x, v, TIMES) == pytest.approx(truth, abs=1e-10)


@pytest.mark.parametrize("start", [0.01, 1.0, 2.5, 3.1])
def test_a_pendulum(start):
    rate = 3.0
    truth = solved(lambda y: [y[1], -(rate**2) * np.sin(y[0])], [start, 0.0])
    angle = pendulum.swing_angle(rate, start, TIMES)
    # measured 9e-12 and 1.2e-10, where it starts nearly upright
    assert angle == pytest.approx(truth[0], abs=1e-9)
    assert pendulum.swing_speed_squared(rate, start, angle) == pytest.approx(truth[1] ** 2, abs=1e-8)


def test_the_period_of_a_pendulum():
    """Small swings take 2 pi / rate, and 1 + start^2/16 times that a little further up (Bernoulli 1749)."""
    assert pendulum.swing_period(2.0, 1e-4) == pytest.approx(np.pi, rel=1e-9)
    assert pendulum.swing_period(2.0, 0.1) == pytest.approx(np.pi * (1 + 0.01 / 16 + 11e-4 / 3072), rel=1e-8)


def test_a_free_body():
    """Euler's equations, and R' = R [w]x."""
    moments = np.array([BODY["I1"], BODY["I2"], BODY["I3"]])

    def rates(state):
        w, turn = state[:3], state[3:].reshape(3, 3)
        skew = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        return np.concatenate([np.cross(moments * w, w) / moments, (turn @ skew).ravel()])

    truth = solved(rates, np.concatenate([[BODY["w1"], 0, BODY["w3"]], np.eye(3).ravel()]))
    # measured 3e-14 and 2e-12
    assert free_rotation.euler_top(BODY, TIMES) == pytest.approx(truth[:3].T, abs=1e-10)
    attitude = free_rotation.euler_top_attitude(BODY, TIMES)
    assert attitude == pytest.approx(truth[3:].T.reshape(-1, 3, 3), abs=1e-10)


def test_a_free_body_on_the_other_side_of_the_separatrix_is_refused():
    with pytest.raises(ValueError, match="M\\^2 > 2 E I2"):
        free_rotation.euler_top(BODY | {"w1": 9.0}, TIMES)


def test_a_kepler_orbit():
    p = {"a": 1.2, "e": 0.6, "n": 1.7}

    def rates(y):
        return [y[2], y[3], *(-(p["n"] ** 2) * p["a"] ** 3 * y[:2] / np.hypot(y[0], y[1]) ** 3)]

    fastest = p["n"] * p["a"] * np.sqrt((1 + p["e"]) / (1 - p["e"]))
    truth = solved(rates, [p["a"] * (1 - p["e"]), 0, 0, fastest])
    assert integration.ellipse(p, TIMES) == pytest.approx(truth[:2].T, abs=1e-9)  # measured 1.5e-11


def test_a_double_pendulum_keeps_its_energy():
    """T + V of its two masses, from the places alone: an account that does not know its equations."""
    p = {"m1": 1.0, "m2": 0.7, "L1": 0.8, "L2": 0.5, "start1": 1.2, "start2": 0.3, "g": 9.81}
    times = np.linspace(0, 2, 20_001)
    x1, z1, x2, z2 = double_pendulum.places(p, times).T
    speeds = [np.gradient(x, times, edge_order=2) ** 2 for x in (x1, z1, x2, z2)]
    kinetic = p["m1"] / 2 * (speeds[0] + speeds[1]) + p["m2"] / 2 * (speeds[2] + speeds[3])
    energy = kinetic + p["g"] * (p["m1"] * z1 + p["m2"] * z2)
    assert np.ptp(energy[2:-2]) < 1e-4 * np.ptp(kinetic)  # measured 4e-7: of the differences over 0.1 ms


@pytest.mark.parametrize("bend", [0.3, 1.2])
def test_a_universal_joint_holds_its_cross_square(bend):
    """The two arms of the cross, each turned with its shaft, stay perpendicular (Hooke's condition)."""
    p = {"w": 6.0, "bend": bend}
    first, second = p["w"] * TIMES, beyond_joints.bent_angle(p, TIMES)
    zero = np.zeros_like(TIMES)
    arm_1 = np.column_stack([zero, -np.sin(first), np.cos(first)])
    across = np.array([-np.sin(bend), np.cos(bend), 0.0])
    arm_2 = np.cos(second)[:, None] * across + np.sin(second)[:, None] * np.array([0, 0, 1.0])
    assert np.einsum("ti,ti->t", arm_1, arm_2) == pytest.approx(zero, abs=1e-13)
    assert second[-1] == pytest.approx(first[-1], abs=1.0)  # as many turns


def test_rules_on_an_oscillator_multiply_its_energy_as_the_sheet_says():
    """One step of each rule as a matrix: its determinant is 1 for the symplectic ones."""
    for name, rule in integration.RULES.items():
        columns = [rule(x, v, 4.0, 0.1) for x, v in ((1.0, 0.0), (0.0, 1.0))]
        area = np.linalg.det(np.array(columns))
        expected = {"explicit_euler": 1 + 0.04, "rk4": 1 - 0.2**6 / 72 + 0.2**8 / 576}.get(name, 1.0)
        assert area == pytest.approx(expected, abs=1e-14), name


def test_period_of_a_sine():
    time = np.linspace(0, 10, 501)
    assert measure.period(np.sin(3 * time + 1), time) == pytest.approx(2 * np.pi / 3, rel=1e-8)
    with pytest.raises(ValueError, match="zero crossings"):
        measure.period(np.ones(501), time)
