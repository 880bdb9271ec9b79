"""Joints and springs of a run: what is recorded against closed forms, expected, left out, and resumed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from contents import differing

import physsim
from physsim.recording import NotInFile
from physsim.recording.quantities import over_time
from physsim.scene.quantity import parse_quantity
from physsim.simulation import check_expectations, demand

Scene = Callable[..., Path]

# A pendulum on a hinge, one on a rope that is a limited distance, and a bob between two springs with stops.
WORKSHOP = """\
physsim: 1
simulation: {duration: 400 ms, timestep: 1 ms, integrator: rk4}
bodies:
  bob: {shape: {type: sphere, radius: 5 cm}, mass: 2 kg, position: [1, 0, 0], collides: false}
  buoy: {shape: {type: sphere, radius: 5 cm}, mass: 3 kg, position: [5, 0, -1], collides: false}
  block: {shape: {type: box, size: [0.2, 0.2, 0.2]}, mass: 1 kg, position: [9, 0, -1], collides: false}
springs:
  hang: {type: linear, between: [world, block], anchors: [[9, 0, 0], [0, 0, 0]], stiffness: 200,
         limits: [0.5, 3]}
  twist: {type: torsional, between: [world, block], axis: [0, 0, 1], stiffness: 0.1, rest_angle: 0.5}
joints:
  rope: {type: distance, between: [world, buoy], anchors: [[5, 0, 0], [0, 0, 0]], limits: [0, 1]}
  hinge: {type: hinge, between: [world, bob], anchor: [0, 0, 0], axis: [0, 1, 0]}
record: {every: 10 ms}
expect:
  - {quantity: joints.hinge.coordinate, at: 0 s, value: 0 deg, within: 1e-12}
  - {quantity: joints.hinge.force.z, at: 0 s, value: -0.0196 N, within: 1 mN}
  - {quantity: joints.hinge.reaction, at: 0 s, min: 0 N}
  - {quantity: joints.hinge.violation, max: 1 um}
  - {quantity: joints.rope.coordinate, value: 1 m, within: 1 um}
  - {quantity: springs.hang.length, at: 0 s, value: 1 m, within: 1e-12}
  - {quantity: springs.hang.force, at: 0 s, value: 0 N, within: 1e-9}
  - {quantity: springs.twist.angle, at: 0 s, value: 0, within: 1e-12}
  - {quantity: springs.twist.torque, at: 0 s, value: -0.05 N*m, within: 1e-12}
"""


@pytest.fixture
def trajectory(scene: Scene, tmp_path: Path) -> physsim.Trajectory:
    with physsim.run(scene(text=WORKSHOP), output=tmp_path / "run.h5") as made:
        yield made


def test_names_ends_and_anchors_are_those_of_the_scene(trajectory: physsim.Trajectory) -> None:
    assert trajectory.joint_names == ("rope", "hinge")
    assert trajectory.spring_names == ("hang", "twist")
    hinge, rope, hang = trajectory.joint("hinge"), trajectory.joint("rope"), trajectory.spring("hang")
    assert (hinge.type, hinge.between, hinge.units) == ("hinge", ("world", "bob"), ("rad", "", ""))
    assert (rope.type, rope.units) == ("distance", ("m", "", ""))
    assert hinge.anchors.tolist() == [[0, 0, 0], [-1, 0, 0]]
    assert (hang.type, hang.between, hang.units) == ("linear", ("world", "block"), ("m", "N"))
    assert hang.anchors.tolist() == [[9, 0, 0], [0, 0, 0]]
    assert trajectory.spring("twist").units == ("rad", "N m")


def test_reaction_of_a_pendulum_let_go_at_the_side(trajectory: physsim.Trajectory) -> None:
    """I = m (L^2 + 2/5 r^2): alpha = m g L / I, so at first the hinge bears m (g - alpha L); later
    m (g sin + omega^2 L) along the rod and m (g - alpha L) cos across. The force on A, the world, is down.
    Measured error 3e-14 N.
    """
    hinge, bob = trajectory.joint("hinge"), trajectory.body("bob")
    alpha = 2 * 9.81 / (2 * (1 + 0.4 * 0.05**2))
    np.testing.assert_allclose(hinge.force[0], [0, 0, -2 * (9.81 - alpha)], rtol=0, atol=1e-12)
    angle, speed = hinge.coordinate[:], bob.angular_velocity[:, 1]
    along = 2 * (9.81 * np.sin(angle) + speed**2)  # towards the anchor, on the bob
    measured = np.linalg.norm(hinge.force[:], axis=1)
    across = 2 * (9.81 - alpha) * np.cos(angle)
    np.testing.assert_allclose(measured, np.hypot(along, across), rtol=0, atol=1e-11)


def test_the_angle_is_that_of_the_body(trajectory: physsim.Trajectory) -> None:
    """About y, from x down to -z; measured: angles agree to 6e-13 rad, the anchor stays within 7e-13 m."""
    x, _, z = trajectory.body("bob").position[:].T
    hinge = trajectory.joint("hinge")
    np.testing.assert_allclose(hinge.coordinate[:], np.arctan2(-z, x), rtol=0, atol=1e-11)
    assert np.abs(hinge.violation[:]).max() < 1e-10
    assert np.isnan(hinge.coordinate_2[:]).all()
    assert not hinge.broken[:].any()


def test_a_rope_that_hangs_bears_the_weight(trajectory: physsim.Trajectory) -> None:
    """Like a contact, a limit bears nothing before the first step is done. Measured error 4e-15 N."""
    rope = trajectory.joint("rope")
    np.testing.assert_allclose(rope.coordinate[:], 1, rtol=0, atol=1e-12)
    np.testing.assert_allclose(rope.force[1:], np.tile([0, 0, -3 * 9.81], (40, 1)), rtol=0, atol=1e-9)


def test_springs_are_recorded_as_they_stand(trajectory: physsim.Trajectory) -> None:
    """x(t) = (m g / k) (1 - cos(omega t)) below the place at rest; theta'' = k (0.5 - theta) / I.

    Measured errors: 8e-11 m, 2e-8 N, 2e-12 rad, 2e-13 N m.
    """
    t = trajectory.time
    hang, twist = trajectory.spring("hang"), trajectory.spring("twist")
    stretch = 9.81 / 200 * (1 - np.cos(np.sqrt(200) * t))
    np.testing.assert_allclose(hang.length[:], 1 + stretch, rtol=0, atol=1e-9)
    np.testing.assert_allclose(hang.force[:], 200 * stretch, rtol=0, atol=1e-6)
    inertia = 0.2**2 / 6
    angle = 0.5 * (1 - np.cos(np.sqrt(0.1 / inertia) * t))
    np.testing.assert_allclose(twist.length[:], angle, rtol=0, atol=1e-10)
    np.testing.assert_allclose(twist.force[:], 0.1 * (angle - 0.5), rtol=0, atol=1e-11)


def test_expectations_of_joints_and_springs_hold(scene: Scene, trajectory: physsim.Trajectory) -> None:
    spec = physsim.load(scene(text=WORKSHOP)).spec
    results = check_expectations(trajectory, spec.expect)
    demand(results)
    assert {result.unit for result in results} == {"rad", "N", "m", "N*m"}


def test_nothing_is_recorded_that_is_not_asked_for(scene: Scene, tmp_path: Path) -> None:
    quiet = WORKSHOP.partition("expect:")[0].replace("every: 10 ms", "every: 10 ms, joints: false")
    with physsim.run(scene(text=quiet), output=tmp_path / "none.h5", duration="20 ms") as trajectory:
        assert trajectory.joint_names == trajectory.spring_names == ()
        with pytest.raises(NotInFile, match="has no joints"):
            over_time(trajectory, parse_quantity("joints.hinge.reaction"))


def test_a_resumed_run_is_the_same_bits(scene: Scene, tmp_path: Path) -> None:
    """Turns counted, joint impulses and the state of springs are part of the checkpoint."""
    path = scene(text=WORKSHOP)
    physsim.run(path, output=tmp_path / "whole.h5").close()
    physsim.run(path, output=tmp_path / "parts.h5", duration="133 ms").close()
    physsim.run(path, output=tmp_path / "parts.h5", resume=True).close()
    assert differing(tmp_path / "whole.h5", tmp_path / "parts.h5") == []
