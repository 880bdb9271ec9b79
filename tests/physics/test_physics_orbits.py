"""Pairwise gravitation: Kepler's ellipses, a fixed sun, three bodies at the corners of a triangle."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from laboratory import ORDERS, VERLET, Lab, measured, mechanics, samples

SYMPLECTIC = ("semi_implicit_euler", *VERLET)
G, SUN, PLANET = 2.0, 3.0, 1.0
AXIS, ECCENTRICITY = 1.0, 0.3
MEAN_MOTION = np.sqrt(G * (SUN + PLANET) / AXIS**3)
TIMES = 0.2 * np.arange(1, 11)
TILTED = np.array([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]])  # the plane of the orbit
SHARE = np.array([-PLANET, SUN]) / (SUN + PLANET)  # of the way from one to the other, seen from both's centre


def relative(times: Any, mean_motion: float = MEAN_MOTION) -> tuple[Any, Any]:
    """(T, 3) place and velocity of the second seen from the first: Kepler's equation E - e sin E = n t."""
    mean = mean_motion * np.atleast_1d(times)
    anomaly = mean.copy()
    for _ in range(50):
        excess = anomaly - ECCENTRICITY * np.sin(anomaly) - mean
        anomaly -= excess / (1 - ECCENTRICITY * np.cos(anomaly))
    cos, sin, minor = np.cos(anomaly), np.sin(anomaly), np.sqrt(1 - ECCENTRICITY**2)
    rate = mean_motion / (1 - ECCENTRICITY * cos)
    place = AXIS * np.column_stack([cos - ECCENTRICITY, minor * sin, 0 * cos])
    speed = AXIS * np.column_stack([-sin * rate, minor * cos * rate, 0 * cos])
    return place @ TILTED.T, speed @ TILTED.T


def pair(integrator: str, timestep: float) -> Lab:
    """Sun and planet about their common centre, from the pericentre."""
    place, speed = relative(0.0)
    bodies = {
        name: {"mass": mass, "position": share * place[0], "velocity": share * speed[0]}
        for name, mass, share in zip(("sun", "planet"), (SUN, PLANET), SHARE, strict=True)
    }
    return mechanics(bodies, gravitation=G, integrator=integrator, timestep=timestep)


def seen(scene: Lab) -> Any:
    """Places [m] and velocities / n [m] of both."""
    return np.hstack([scene.all("position"), scene.all("velocity") / MEAN_MOTION])


@cache
def kepler() -> Any:
    place, speed = relative(TIMES)
    return np.hstack([np.hstack([share * place, share * speed / MEAN_MOTION]) for share in SHARE])


@pytest.mark.parametrize("integrator", ORDERS)
def test_kepler(integrator):
    """An ellipse of eccentricity 0.3; a turn takes 2.2 s."""
    order = ORDERS[integrator]
    steps = {1: 1e-4, 2: 4e-3, 4: 5e-3}[order] / np.array([1, 2, 4])
    _, slopes = measured(lambda h: pair(integrator, h), seen, kepler(), TIMES, steps)
    assert slopes == pytest.approx([order, order], abs=0.1)


def test_kepler_under_rk4():
    """2 s in steps of 1 ms. Measured 6e-11 m, books 1e-11 J."""
    scene = pair("rk4", 1e-3)
    found = samples(scene, TIMES, seen)
    assert found == pytest.approx(kepler(), abs=1e-9)
    assert abs(scene.book("residual")) < 1e-9


def test_a_planet_about_a_sun_that_is_held():
    """A fixed body attracts by the mass that it has; n^2 a^3 = G M. Measured 3e-11 m."""
    mean_motion = np.sqrt(G * SUN / AXIS**3)
    place, speed = relative(0.0, mean_motion)
    bodies = {
        "sun": {"fixed": True, "mass": SUN},
        "planet": {"mass": PLANET, "position": place[0], "velocity": speed[0]},
    }
    scene = mechanics(bodies, gravitation=G)
    found = samples(scene, TIMES, lambda s: s.get("position", "planet"))
    assert found == pytest.approx(relative(TIMES, mean_motion)[0], abs=1e-9)


def test_the_energy_of_gravitation():
    """-G m1 m2 / r between the two, and the whole of an orbit -G m1 m2 / 2 a."""
    scene = pair("rk4", 1e-3).run(0.7)
    apart = np.linalg.norm(scene.get("position", "planet") - scene.get("position", "sun"))
    assert scene.book("gravitation") == pytest.approx(-G * SUN * PLANET / apart, rel=1e-14)
    assert scene.energy() == pytest.approx(-G * SUN * PLANET / (2 * AXIS), rel=1e-9)


@pytest.mark.parametrize("integrator", ORDERS)
def test_momentum_is_kept_to_rounding(integrator):
    scene = pair(integrator, 1e-3).step(2000)
    assert scene.momentum()[0] == pytest.approx(np.zeros(3), abs=1e-13)


@pytest.mark.parametrize("integrator", SYMPLECTIC)
def test_symplectic_schemes_keep_the_areal_velocity(integrator):
    """Kepler's second law holds exactly: kicks are central, drifts are straight. Measured 1e-14."""
    scene = pair(integrator, 1e-2)
    before = scene.momentum()[1]
    after = scene.step(5000).momentum()[1]
    assert after == pytest.approx(before, abs=1e-12)


@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "leapfrog"])
def test_orbits_do_not_decay(integrator):
    """1e5 steps, a thousand turns: the band of the energy error is that of the beginning."""
    scene = pair(integrator, {"semi_implicit_euler": 2e-3, "leapfrog": 2e-2}[integrator])
    start = scene.energy()
    error = np.array([scene.step(50).energy() - start for _ in range(2000)])
    first, last = error[:200], error[-200:]
    assert np.ptp(last) == pytest.approx(np.ptp(first), rel=0.02)
    assert abs(last.mean() - first.mean()) < 0.01 * np.ptp(first)


def test_explicit_euler_spirals_outwards():
    scene = pair("explicit_euler", 1e-3)
    energies = [scene.energy(), *(scene.step(250).energy() for _ in range(20))]
    assert np.all(np.diff(energies) > 0)


def test_free_fall_from_rest():
    """t = sqrt(r0^3 / 2 mu) (acos(sqrt x) + sqrt(x (1 - x))) until the distance is x r0 (Kepler's ellipse of
    eccentricity 1). Measured 7e-10 m.
    """
    mu, x = G * (SUN + PLANET), 0.25
    time = np.sqrt(1 / (2 * mu)) * (np.arccos(np.sqrt(x)) + np.sqrt(x * (1 - x)))
    bodies = {"sun": {"mass": SUN}, "planet": {"mass": PLANET, "position": (0, 1, 0)}}
    scene = mechanics(bodies, gravitation=G, timestep=time / 400).step(400)
    fallen = scene.get("position", "planet") - scene.get("position", "sun")
    assert fallen == pytest.approx([0, x, 0], abs=1e-9)


def test_three_bodies_in_a_triangle():
    """Any three masses at the corners of an equilateral triangle turn about their centre as if rigid, with
    omega^2 = G (m1 + m2 + m3) / d^3 (Lagrange 1772). Measured 2e-12 m.
    """
    masses, side = np.array([3.0, 2.0, 1.0]), 1.0
    corners = side * np.array([[0, 0, 0], [1, 0, 0], [0.5, np.sqrt(0.75), 0]])
    corners -= masses @ corners / masses.sum()
    omega = np.sqrt(G * masses.sum() / side**3)
    bodies = {
        name: {"mass": mass, "position": corner, "velocity": np.cross([0, 0, omega], corner)}
        for name, mass, corner in zip("abc", masses, corners, strict=True)
    }
    scene = mechanics(bodies, gravitation=G).run(0.5)
    cos, sin = np.cos(0.5 * omega), np.sin(0.5 * omega)
    turned = corners @ np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]])
    assert scene.all("position") == pytest.approx(turned, abs=1e-9)
