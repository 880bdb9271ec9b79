"""Free flight: no contact, no torque. Closed forms at several timesteps, with the order of the error."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import GRAVITY, body, lab, rotation

BOX = "type: box, size: [0.1, 0.2, 0.4]"
SPIN = (0.3, 5.0, 0.2)  # nearly about the middle axis: it tumbles


def tumbling(timestep: float):
    return lab(body("box", BOX, angular_velocity=SPIN), timestep=timestep, gravity=0.0)


@pytest.mark.parametrize("timestep", [1e-2, 5e-3, 1e-3])
def test_a_parabola_lags_by_half_a_step_of_gravity(timestep):
    """v_n = v0 + n dt g exactly and x_n = x0 + v0 t + g t (t + dt) / 2: g t dt / 2 off the parabola."""
    ball = body("ball", "type: sphere, radius: 0.1", position=(0, 0, 1), velocity=(2, -1, 3))
    flown = lab(ball, timestep=timestep).run(1.0)
    x, v = flown.get("position", "ball"), flown.get("velocity", "ball")
    parabola = np.array([2, -1, 1 + 3 - GRAVITY / 2])
    # measured 3e-15, rounding of a thousand sums
    assert x - parabola == pytest.approx([0, 0, -GRAVITY * timestep / 2], abs=1e-13)
    assert v == pytest.approx([2, -1, 3 - GRAVITY], abs=1e-13)


def test_a_body_that_turns_falls_like_one_that_does_not():
    turning = lab(body("box", BOX, angular_velocity=SPIN)).run(0.5)
    quiet = lab(body("box", BOX)).run(0.5)
    assert turning.get("position", "box") == pytest.approx(quiet.get("position", "box"), abs=1e-14)


def test_angular_momentum_of_a_free_box_is_kept_to_rounding():
    """20 s, 60 turns: |L| and each component; measured 2e-15 relative."""
    flown = tumbling(1e-3)
    before = flown.momentum()[1]
    flown.run(20.0)
    after = flown.momentum()[1]
    assert np.linalg.norm(after - before) < 1e-12 * np.linalg.norm(before)


def test_the_energy_of_a_free_box_does_not_drift():
    """A symplectic rule: the error stays within a band of first order, in the 2nd as in the 20th second."""
    bands = []
    for timestep in (2e-3, 1e-3):
        flown, start = tumbling(timestep), tumbling(timestep).energy()
        early, late = [], []
        for sample in (early, late):
            for _ in range(200):
                sample.append(abs(flown.run(0.01).energy() / start - 1))
            flown.run(10.0)
        assert max(late) < 1.2 * max(early)
        bands.append(max(early))
    assert bands[1] < 3e-3
    assert bands[0] / bands[1] == pytest.approx(2, rel=0.1)


def test_the_orientation_of_a_free_box_converges_with_first_order():
    """Against Euler's equations, integrated here by RK4 in steps of 0.1 ms."""
    flown = {dt: rotation(tumbling(dt).run(2.0).get("orientation", "box")) for dt in (2e-3, 1e-3, 5e-4)}
    truth = euler_top(2.0, 20_000)
    errors = [float(np.linalg.norm(found - truth)) for found in flown.values()]
    assert errors[-1] < 0.02
    assert errors[0] / errors[1] == pytest.approx(2, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(2, rel=0.1)


def euler_top(seconds: float, steps: int) -> np.ndarray:
    """R at the end: I w' = (I w) x w in body axes and R' = R [w]x (Goldstein, eqs. 5.39 and 4.86)."""
    mass, (a, b, c) = 8.0, (0.1, 0.2, 0.4)
    moments = mass / 12 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])

    def rate(state):
        w, turn = state[0], state[1:]
        skew = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        return np.vstack([np.cross(moments * w, w) / moments, turn @ skew])

    state, dt = np.vstack([SPIN, np.eye(3)]), seconds / steps
    for _ in range(steps):
        k1 = rate(state)
        k2 = rate(state + dt / 2 * k1)
        k3 = rate(state + dt / 2 * k2)
        k4 = rate(state + dt * k3)
        state = state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return state[1:]


def test_a_ball_spins_on_for_ever():
    """All moments equal: the axis and the rate stay; one turn in 2 pi / w seconds, exactly."""
    ball = body("ball", "type: sphere, radius: 0.1", angular_velocity=(0, 0, np.pi))
    flown = lab(ball, gravity=0.0).run(1.0)
    # half a turn about z: (0, 0, 0, 1); measured 3e-14
    assert np.abs(flown.get("orientation", "ball")) == pytest.approx([0, 0, 0, 1], abs=1e-12)
