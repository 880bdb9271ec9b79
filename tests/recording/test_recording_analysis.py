"""What a trajectory offers beyond its datasets: selection, resampling, what follows from its numbers.

The made-up run has known numbers in every place; formulas are held against numpy written out or against
rotations of scipy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

import physsim
from physsim.errors import SceneError
from physsim.recording import NotInFile, Trajectory, contact_choice, open_trajectory
from physsim.recording.orientation import between, rotated

SCENE = """
physsim: 1
title: A spinning box beside two bricks on the ground
simulation: {duration: 300 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  brick:
    repeat: {count: [1, 1, 2], spacing: [0, 0, 7 cm]}
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
    position: [1, 0, 35 mm]
  top:
    shape:
      type: compound
      parts:
        - {shape: {type: box, size: [2 cm, 4 cm, 6 cm]}}
        - {shape: {type: sphere, radius: 1 cm}, position: [0, 0, 5 cm]}
    material: steel
    position: [0, 0, 2]
    velocity: [1, 0, 3]
    angular_velocity: [1, 12, 3]
record: {every: 10 ms}
"""


@pytest.fixture
def made_up(recorded: Callable[..., Path]) -> Iterator[Trajectory]:
    with open_trajectory(recorded()) as trajectory:
        yield trajectory


@pytest.fixture(scope="module")
def real(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Trajectory]:
    folder = tmp_path_factory.mktemp("real")
    (folder / "scene.yaml").write_text(SCENE)
    with physsim.run(folder / "scene.yaml", output=folder / "run.h5") as trajectory:
        yield trajectory


def test_quantities_by_name(made_up: Trajectory) -> None:
    assert made_up.quantity("bodies.ball[0,0,0].position.z")[3] == 3012.0
    assert made_up.quantity("bodies.floor.position").shape == (40, 3)
    assert made_up.quantity("joints.wheel.coordinate", slice(5, 7)).tolist() == [5010.0, 6010.0]
    assert made_up.quantity("energy.total")[2] == 10.0  # five terms, each holding the frame's number
    assert made_up.find_quantity("joints.wheel.violation").kind.unit == "m"


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("bodies.floor.positon", "did you mean 'position'"),
        ("bodies.flor.position", "did you mean 'floor'"),
        ("joints.weel.force", "did you mean 'wheel'"),
        ("height", "names no quantity; allowed: one that begins with time"),
    ],
)
def test_names_that_are_none(made_up: Trajectory, name: str, told: str) -> None:
    with pytest.raises(NotInFile, match=told):
        made_up.quantity(name)


def test_bodies_by_pattern(made_up: Trajectory) -> None:
    assert made_up.bodies("ball*") == ("ball[0,0,0]", "ball[1,0,0]")
    assert made_up.bodies() == made_up.body_names
    with pytest.raises(NotInFile, match="did you mean 'floor'"):
        made_up.bodies("flor")


@pytest.mark.parametrize("frames", [slice(None), slice(3, 9), slice(-4, None), slice(9, 2, -2), slice(5, 5)])
def test_a_part_of_the_frames_is_that_part(
    real: Trajectory, frames: slice, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(contact_choice, "FRAMES_AT_ONCE", 4)
    for name in ("bodies.top.kinetic_energy", "bodies.brick[0,0,0].contact_force", "energy.kinetic", "time"):
        np.testing.assert_array_equal(real.quantity(name, frames), real.quantity(name)[frames])


def test_straight_lines_between_frames(made_up: Trajectory) -> None:
    """Frames are 10 ms apart and position is 1000 per frame."""
    found = made_up.resample("bodies.floor.position", [0.005, 0.0, 0.39, 0.1234])
    np.testing.assert_allclose(found[:, 1], [501.0, 1.0, 39001.0, 12341.0], rtol=1e-12)
    assert made_up.resample("energy.kinetic", []).shape == (0,)
    for times in ([0.4], [-1e-9]):
        with pytest.raises(ValueError, match=r"within 0 s to 0\.39 s"):
            made_up.resample("time", times)


def test_orientations_follow_the_arc(real: Trajectory) -> None:
    times = np.linspace(0.0, 0.3, 101)
    frames = Rotation.from_quat(real.body("top").orientation[:], scalar_first=True)
    wanted = Slerp(real.time, frames)(times)
    found = Rotation.from_quat(real.resample("bodies.top.orientation", times), scalar_first=True)
    assert (wanted * found.inv()).magnitude().max() < 1e-12  # measured 1e-15
    np.testing.assert_array_equal(
        real.resample("bodies.top.orientation.y", times), real.resample("bodies.top.orientation", times)[:, 2]
    )


def test_opposite_quaternions_are_one_orientation() -> None:
    q = np.array([[0.5, 0.5, 0.5, 0.5]])
    np.testing.assert_allclose(np.abs(between(q, -q, np.array([0.3]))), q, rtol=0, atol=1e-15)


def test_rotated_as_scipy_does() -> None:
    q = Rotation.random(20, random_state=1)
    vectors = np.random.default_rng(1).normal(size=(20, 3))
    np.testing.assert_allclose(
        rotated(q.as_quat(scalar_first=True), vectors), q.apply(vectors), rtol=0, atol=1e-14
    )


def test_energies_and_momenta_of_bodies_add_up_to_the_ledger(real: Trajectory) -> None:
    """Two routes: per body from the file, and the engine's sums."""
    moving = [real.body(name) for name in real.body_names]
    energy = sum(body.kinetic_energy for body in moving)
    np.testing.assert_allclose(energy, real.quantity("energy.kinetic"), rtol=1e-13)
    linear = sum(body.momentum for body in moving)
    np.testing.assert_allclose(linear, real.momentum.linear, rtol=0, atol=1e-14)
    angular = sum(np.cross(body.center, body.momentum) + body.angular_momentum for body in moving)
    np.testing.assert_allclose(angular, real.momentum.angular, rtol=0, atol=1e-13)


def test_the_center_flies_in_a_parabola(real: Trajectory) -> None:
    """The origin of the compound does not: it turns around the centre of mass."""
    top, t = real.body("top"), real.time
    assert np.abs(top.center_of_mass[2]) > 1e-4
    start = top.center[0]
    wanted = start + np.outer(t, top.velocity[0]) - np.outer(9.81 * t**2 / 2, [0, 0, 1])
    off = np.abs(top.center - wanted).max()
    assert off < 9.81 * 0.3 * 1e-3 / 2 * 1.01  # semi-implicit Euler: g t h / 2


def test_the_floor_carries_what_stands_on_it(real: Trajectory) -> None:
    bricks = [real.body(name) for name in real.bodies("brick*")]
    weight = 9.81 * sum(brick.mass for brick in bricks)
    floor = real.body("floor").contact_force
    assert floor[0].tolist() == [0, 0, 0]
    np.testing.assert_allclose(floor[1:, 2], -weight, rtol=1e-6)
    np.testing.assert_allclose(bricks[1].contact_force[1:, 2], 9.81 * bricks[1].mass, rtol=1e-6)
    np.testing.assert_allclose(real.body("top").contact_force, 0)


def test_contacts_of_two_bodies(real: Trajectory) -> None:
    lower, upper = real.bodies("brick*")
    both = real.contacts(body=lower, other=upper)
    assert {*both.body_a, *both.body_b} == {lower, upper}
    assert real.body(upper).contacts().rows == both.rows == real.body(upper).contacts(lower).rows
    assert real.contacts(5, body="floor").rows == 4
    assert real.body(lower).contacts().rows == both.rows + real.contacts(body="floor").rows
    with pytest.raises(NotInFile, match="did you mean 'floor'"):
        real.contacts(body="flor")


def test_impacts_and_rest(tmp_path: Path) -> None:
    """Two bounces with e = 0.5 and then a plastic end: see the times of flight."""
    (tmp_path / "scene.yaml").write_text(
        "physsim: 1\nsimulation: {duration: 1 s, timestep: 1 ms, bounce_speed: 0.5 m/s}\n"
        "pairs: [{between: [steel, concrete], restitution: 0.5}]\nrecord: {every: 10 ms}\n"
        "bodies:\n"
        "  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}\n"
        "  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 15 cm]}\n"
    )
    with physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5") as trajectory:
        ball = trajectory.body("ball")
        hits = ball.impacts()
        assert hits.rows == ball.impacts("floor").rows == trajectory.events.rows
        assert hits.rows >= 2
        fall = np.sqrt(2 * 0.1 / 9.81)
        np.testing.assert_allclose(hits.time[:2], [fall, 2 * fall], atol=3e-3)
        rest = ball.rest_time()
        assert rest is not None
        assert hits.time[-1] <= rest < 0.6
        assert trajectory.body("floor").rest_time() == 0.0


def test_a_body_that_moves_at_the_end_is_not_at_rest(real: Trajectory) -> None:
    assert real.body("top").rest_time() is None
    assert real.body("brick[0,0,0]").rest_time() == 0.0


def test_pandas(made_up: Trajectory) -> None:
    table = made_up.to_pandas(["bodies.floor.position", "energy.total"])
    assert list(table.columns) == [*(f"bodies.floor.position.{k}" for k in "xyz"), "energy.total"]
    assert table.index.name == "time"
    assert table.loc[0.2, "bodies.floor.position.y"] == 20001.0
    assert made_up.to_pandas().shape == (40, 3 * 13)
    assert made_up.to_pandas(["energy.total"], [0.005])["energy.total"].tolist() == [2.5]
    contacts = made_up.contacts().to_pandas()
    assert len(contacts) == made_up.contacts().rows
    assert contacts["force.y"].tolist() == contacts["frame"].tolist()
    assert set(contacts["body_a"]) == {"ball[0,0,0]"}


def test_xarray_of_some_bodies_and_frames(made_up: Trajectory) -> None:
    whole = made_up.to_xarray()
    part = made_up.to_xarray("ball*", slice(10, 20, 3))
    assert part.sizes == {"time": 4, "body": 2, "axis": 3, "axis_2": 3, "quaternion": 4}
    for name in part.variables:
        wanted = whole[name]
        wanted = wanted.isel(body=[1, 2]) if "body" in wanted.dims else wanted
        wanted = wanted.isel(time=slice(10, 20, 3)) if "time" in wanted.dims else wanted
        assert wanted.equals(part[name]), name


def test_expectations_know_what_follows(tmp_path: Path) -> None:
    """The floor carries 2 kg; contacts that are not recorded cannot be expected."""
    scene = tmp_path / "scene.yaml"
    scene.write_text(
        "physsim: 1\nsimulation: {duration: 100 ms, timestep: 1 ms}\nrecord: {contacts: true}\nbodies:\n"
        "  floor: {fixed: true, shape: {type: halfspace}, material: concrete}\n"
        "  box: {shape: {type: box, size: [1, 1, 1]}, mass: 2, material: wood, position: [0, 0, 0.5]}\n"
        "expect:\n"
        "  - {quantity: bodies.box.contact_force.z, value: 19.62 N, within: 1e-6}\n"
        "  - {quantity: bodies.box.kinetic_energy, max: 1e-12 J}\n"
    )
    physsim.run(scene, output=tmp_path / "run.h5", check=True).close()
    with pytest.raises(SceneError) as caught:
        physsim.run(scene, set={"record.contacts": False}, output=tmp_path / "none.h5")
    assert [problem.message for problem in caught.value.problems] == [
        "is not recorded: record.contacts is false"
    ]
