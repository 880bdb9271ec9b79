"""Two routes to the same number: what the trajectory file says of contacts against what it says of motion."""

from __future__ import annotations

import numpy as np
import pytest

import physsim
from physsim.scene.loader import load_scene_text

SCENE = """
physsim: 1
simulation: {duration: 0.8 s, timestep: 1 ms}
materials: {stuff: {density: 1000, restitution: 0.4, static_friction: 0.5, kinetic_friction: 0.4}}
bodies:
  floor: {fixed: true, shape: {type: halfspace}, material: stuff}
  a: {shape: {type: box, size: [0.2, 0.3, 0.1]}, material: stuff, position: [0, 0, 0.3], velocity: [1, 0, 0],
      orientation: {euler_xyz: [0.4, 0.3, 0.1]}, angular_velocity: [2, 1, 0]}
  b: {shape: {type: sphere, radius: 0.1}, material: stuff, position: [0.05, 0, 0.6],
      angular_velocity: [0, 0, 9]}
record: {every: 1 ms}
"""


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory):
    path = tmp_path_factory.mktemp("records") / "out.h5"
    with physsim.run(load_scene_text(SCENE), output=path) as trajectory:
        yield trajectory


@pytest.mark.parametrize("name", ["a", "b"])
def test_recorded_impulses_change_the_momentum(trajectory, name):
    """m (v_k - v_k-1) = m g dt + the impulses of frame k on the body, impacts among them, in every frame."""
    track = trajectory.body(name)
    change = track.mass * np.diff(track.velocity[:], axis=0)
    gravity = track.mass * np.array([0, 0, -9.81e-3])
    largest = np.abs(change).max()
    assert largest > 1.0
    for k in range(1, trajectory.frames):
        rows = trajectory.contacts(k)
        sign = (rows["body_a"] == name).astype(float) - (rows["body_b"] == name)
        # measured 1e-15
        assert change[k - 1] == pytest.approx(sign @ rows["impulse"] + gravity, abs=1e-11 * largest)


def test_recorded_momentum_is_that_of_the_recorded_motion(trajectory):
    p = sum(trajectory.body(n).mass * trajectory.body(n).velocity[:] for n in "ab")
    assert trajectory.momentum["linear"] == pytest.approx(p, abs=1e-12 * np.abs(p).max())


def test_recorded_energy_is_that_of_the_recorded_motion(trajectory):
    """m v^2 / 2 and m g z from velocity and position."""
    bodies = [trajectory.body(n) for n in "ab"]
    kinetic = sum(0.5 * b.mass * (b.velocity[:] ** 2).sum(axis=1) for b in bodies)
    height = sum(b.mass * 9.81 * b.position[:][:, 2] for b in bodies)
    assert trajectory.energy["kinetic_translational"] == pytest.approx(kinetic, rel=1e-12, abs=1e-12)
    assert trajectory.energy["gravitational"] == pytest.approx(height, rel=1e-12)


def test_friction_never_exceeds_its_cone(trajectory):
    """|J_t| <= mu_s J_n in every contact of every frame."""
    rows = trajectory.contacts()
    tangential = np.linalg.norm(rows["tangential_impulse"], axis=1)
    assert (tangential <= 0.5 * rows["normal_impulse"] + 1e-9).all()
    assert (rows["normal_impulse"] >= 0).all()


def test_sliding_friction_takes_energy(trajectory):
    """In sliding contacts friction opposes the slip, but where a second impact in the step turned it."""
    rows = trajectory.contacts()
    slides = (rows["sliding"] != 0) & (rows["normal_impulse"] > 1e-3)
    assert slides.sum() > 10
    power = (rows["tangential_impulse"] * rows["relative_velocity_after"]).sum(axis=1)[slides]
    # measured 9e-6 of 3.6
    assert power.max() < 1e-4 * np.abs(power).max()


def test_one_impact_in_the_events_is_one_restitution(trajectory):
    """Every impact leaves with at most e of the speed it came with, and none pulls."""
    events = trajectory.events
    assert len(events["time"]) > 3
    assert (events["impulse"] > 0).all()
    assert (events["speed_before"] > 0).all()
    assert np.all(np.diff(events["time"]) > -1e-3)
