"""Impacts of single bodies against closed forms: heights, angles, spin."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import FLOOR, GRAVITY, body, lab

RADIUS = 0.1
BALL = f"type: sphere, radius: {RADIUS}"
MASS = 1000 * 4 / 3 * np.pi * RADIUS**3
DROP = 1.0
FALL = (2 * DROP / GRAVITY) ** 0.5


def heights(e: float, timestep: float, bounces: int) -> list[float]:
    """The top of each flight after a drop from DROP [m]."""
    ball = lab(FLOOR + body("ball", BALL, position=(0, 0, DROP + RADIUS)), timestep=timestep, e=e)
    tops, start = [], FALL
    for n in range(1, bounces + 1):
        flight = 2 * FALL * e**n
        ball.step(round((start + flight / 4) / timestep) - ball.world.state()["step"])
        flown = []
        while ball.world.state()["step"] * timestep < start + 0.75 * flight:
            flown.append(ball.step().get("position", "ball")[2] - RADIUS)
        tops.append(max(flown))
        start += flight
    return tops


@pytest.mark.parametrize("e", [0.3, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("timestep", [4e-3, 1e-3])
def test_bounce_heights(e, timestep):
    """h_n = e^(2n) h: impacts are found within the step. Tops fall between samples: up to g dt^2 / 8."""
    sampling = GRAVITY * timestep**2 / 8
    for n, top in enumerate(heights(e, timestep, 3), start=1):
        # measured at most 1.0 of this bound
        assert top == pytest.approx(e ** (2 * n) * DROP, abs=1.1 * sampling)


@pytest.mark.parametrize("timestep", [4e-3, 1e-3])
def test_a_ball_without_restitution_stays_where_it_lands(timestep):
    ball = lab(FLOOR + body("ball", BALL, position=(0, 0, DROP + RADIUS)), timestep=timestep, e=0.0).run(0.6)
    # measured 1e-8, the depth that is left as it is
    assert ball.get("position", "ball") == pytest.approx([0, 0, RADIUS], abs=2e-8)
    assert ball.get("velocity", "ball") == pytest.approx([0, 0, 0], abs=1e-12)


def test_an_elastic_ball_bounces_as_high_after_fifty_times():
    """Neither damping nor gain: measured 3e-6 m, and no sign of a trend."""
    ball = lab(FLOOR + body("ball", BALL, position=(0, 0, DROP + RADIUS)), e=1.0)
    ball.step(round(50.5 * 2 * FALL * 1000))
    flown = [ball.step().get("position", "ball")[2] - RADIUS for _ in range(1000)]
    assert max(flown) == pytest.approx(DROP, abs=1e-4)


def test_restitution_that_was_measured_is_what_was_declared():
    ball = lab(FLOOR + body("ball", BALL, position=(0, 0, DROP + RADIUS)), e=0.7).run(1.6)
    events = ball.events()
    assert len(events["time"]) == 3
    assert events["restitution_measured"] == pytest.approx([0.7] * 3, rel=1e-12)
    # the first instant, between two steps of 1 ms: semi-implicit Euler's fall is dt / 2 ahead
    assert events["time"][0] == pytest.approx(FALL - 0.5e-3, abs=1e-6)


def oblique(e: float, mu: float, speed: float, spin: float = 0.0):
    """A ball hits the floor at 3 m/s down, `speed` along x, turning about y; no gravity. v, w after."""
    ball = body(
        "ball", BALL, position=(0, 0, 2 * RADIUS), velocity=(speed, 0, -3), angular_velocity=(0, spin, 0)
    )
    hit = lab(FLOOR + ball, gravity=0.0, e=e, mu=mu).run(0.1)
    return hit.get("velocity", "ball"), hit.get("angular_velocity", "ball")


@pytest.mark.parametrize("spin", [0.0, 12.0, -30.0])
@pytest.mark.parametrize("speed", [0.5, 2.0, 8.0])
@pytest.mark.parametrize("mu", [0.0, 0.05, 0.2, 2.0])
@pytest.mark.parametrize("e", [0.0, 0.6, 1.0])
def test_oblique_impact_of_a_ball(e, mu, speed, spin):
    """J_n = (1 + e) m |v_n|; the point of contact slips at u = v - R w and the tangential impulse opposes it:
    J_t = min(mu J_n, 2/7 m u), the second where slip ends (solid ball, K_t = 7/2 / m). Measured 2e-15.
    """
    normal = (1 + e) * MASS * 3.0
    slip = speed - RADIUS * spin
    friction = min(mu * normal, 2 / 7 * MASS * abs(slip)) * np.sign(slip)
    v, w = oblique(e, mu, speed, spin)
    assert v == pytest.approx([speed - friction / MASS, 0, 3 * e], abs=1e-12)
    assert w == pytest.approx([0, spin + friction * RADIUS / (0.4 * MASS * RADIUS**2), 0], abs=1e-11)


def test_two_balls_in_line_exchange_by_their_masses():
    """v1' = (m1 - e m2) v / (m1 + m2), v2' = (1 + e) m1 v / (m1 + m2) (Landau & Lifshitz, sec. 17)."""
    for e in (0.0, 0.5, 1.0):
        for m1, m2 in ((1.0, 1.0), (1.0, 3.0), (5.0, 1.0)):
            pair = body("a", BALL, mass=m1, velocity=(2, 0, 0)) + body(
                "b", BALL, mass=m2, position=(0.5, 0, 0)
            )
            hit = lab(pair, gravity=0.0, e=e).run(0.3)
            total = m1 + m2
            assert hit.get("velocity", "a") == pytest.approx([2 * (m1 - e * m2) / total, 0, 0], abs=1e-13)
            assert hit.get("velocity", "b") == pytest.approx([2 * (1 + e) * m1 / total, 0, 0], abs=1e-13)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_box_that_lands_flat_stays_flat(e):
    """Four corners at once: no turn, e of the speed. Measured 1e-16."""
    box = body("box", "type: box, size: [0.4, 0.3, 0.2]", position=(0, 0, 0.4))
    landed = lab(FLOOR + box, e=e, mu=0.5).run(0.3)
    assert landed.get("angular_velocity", "box") == pytest.approx([0, 0, 0], abs=1e-12)
    assert landed.get("orientation", "box") == pytest.approx([1, 0, 0, 0], abs=1e-12)


@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
def test_a_rod_that_hits_with_its_end(timestep):
    """A rod of length l, level but for 30 degrees, without friction: its end has K = 1/m + d^2 / I with
    d = l/2 cos 30, I = m l^2 / 12, so J = (1 + e) v / K, v' = J / m - v, w' = d J / I.
    """
    e, length, mass, speed = 0.5, 1.0, 2.0, 1.0
    turn = {"axis": (0, 1, 0), "angle": np.pi / 3}  # the rod's axis is z
    rod = body("rod", f"type: rod, length: {length}", mass=mass, position=(0, 0, 0.5), orientation=turn)
    rod = rod.replace("orientation", f"velocity: [0, 0, {-speed}], orientation")
    hit = lab(FLOOR + rod, gravity=0.0, e=e, timestep=timestep).run(0.3)
    inertia, arm = mass * length**2 / 12, length / 2 * np.cos(np.pi / 6)
    impulse = (1 + e) * speed / (1 / mass + arm**2 / inertia)
    assert hit.get("velocity", "rod") == pytest.approx([0, 0, impulse / mass - speed], abs=1e-12)
    assert np.abs(hit.get("angular_velocity", "rod")) == pytest.approx(
        [0, impulse * arm / inertia, 0], abs=1e-11
    )
