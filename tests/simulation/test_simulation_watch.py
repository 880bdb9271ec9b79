"""A run that is watched in memory holds the bits that its file would hold."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import physsim
from physsim.model import compile_scene
from physsim.recording.quantities import over_time
from physsim.scene import load_scene, load_scene_text
from physsim.scene.quantity import NAMED_FIELDS, SCENE_FIELDS, parse_quantity
from physsim.simulation import Wanted, check_expectations, watch

SCENES = Path(__file__).resolve().parents[2] / "scenes"

MACHINE = """\
physsim: 1
simulation: {duration: 300 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  lamp:
    shape: {type: compound, parts: [
      {shape: {type: box, size: [20 cm, 10 cm, 4 cm]}, material: steel},
      {shape: {type: sphere, radius: 5 cm}, material: wood, position: [5 cm, 0, 9 cm]}]}
    position: [0, 0, 10 cm]
    orientation: {axis: [1, 2, 0], angle: 20 deg}
    angular_velocity: [1, 2, 3]
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [1, 0, 1]}
  arm: {shape: {type: box, size: [4 cm, 4 cm, 30 cm]}, material: wood, position: [1, 0, 80 cm]}
joints:
  pin: {type: hinge, between: [ball, arm], anchor: [1, 0, 95 cm], axis: [0, 1, 0]}
springs:
  band: {type: linear, between: [world, ball], anchors: [[1, 0, 2], [0, 0, 0]], stiffness: 100 N/m}
record: {every: 7 ms}
expect: [{quantity: bodies.lamp.position.z, min: 0}]
"""


def every_quantity(scene) -> list:
    """Each one that a scene of these bodies, joints and springs can be asked for."""
    names = {"bodies": scene.bodies, "joints": scene.spec.joints, "springs": scene.spec.springs}
    texts = [
        f"{group}.{name}.{field}"
        for group, fields in NAMED_FIELDS.items()
        for name in names[group]
        for field in fields
        if group != "springs" or field in ("length", "force")
    ]
    texts += [f"{group}.{field}" for group, fields in SCENE_FIELDS.items() for field in fields]
    return [parse_quantity(text) for text in ("time", *texts)]


def test_every_quantity_has_the_bits_of_the_file(tmp_path: Path) -> None:
    scene = load_scene_text(MACHINE)
    quantities = every_quantity(scene)
    wanted = Wanted(tuple(quantities), events=True, contacts=True)
    watched = watch(scene, compile_scene(scene), wanted)
    with physsim.run(scene, output=tmp_path / "run.h5") as trajectory:
        assert watched.status == trajectory.status
        assert watched.status_detail == trajectory.status_detail
        for quantity in quantities:
            there, here = (over_time(source, quantity) for source in (trajectory, watched.as_trajectory()))
            np.testing.assert_array_equal(here, there, err_msg=quantity.text, strict=True)
        for name, column in trajectory.events.items():
            np.testing.assert_array_equal(watched.events[name], column, err_msg=name)
        assert len(trajectory.events["time"]) > 0
        there, here = (source.contact_rows(0, trajectory.frames) for source in (trajectory, watched))
        for name in ("frame", "body_a", "body_b"):
            np.testing.assert_array_equal(here[name], there[name], err_msg=name)
        assert len(there["frame"]) > 0
        assert check_expectations(watched.as_trajectory(), scene.spec.expect) == check_expectations(
            trajectory, scene.spec.expect
        )


def test_only_what_is_wanted_is_kept() -> None:
    scene = load_scene_text(MACHINE)
    watched = watch(scene, compile_scene(scene), Wanted((parse_quantity("energy.total"),)))
    assert all(path.startswith("energy/") for path in watched.columns)
    assert watched.names == ()
    assert len(watched.impacts) == len(watched.touching) == 0


def test_a_motion_that_blows_up_is_an_ending(tmp_path: Path) -> None:
    scene = load_scene_text(MACHINE, overrides={"springs.band.stiffness": 1e12})
    watched = watch(scene, compile_scene(scene), Wanted())
    assert watched.status == "failed"
    with pytest.raises(physsim.errors.RunFailed, match="blew up") as caught:
        physsim.run(scene, output=tmp_path / "run.h5")
    assert str(caught.value).startswith(watched.status_detail)


def test_rest_ends_a_watched_run_as_it_ends_a_recorded_one(tmp_path: Path) -> None:
    scene = load_scene(SCENES / "dice_roll.yaml")
    with physsim.run(scene, output=tmp_path / "run.h5") as trajectory:
        watched = watch(scene, compile_scene(scene), Wanted())
        np.testing.assert_array_equal(watched.time, trajectory.time)


@pytest.mark.parametrize(
    "text", ["bodies.lamp.position.z", "bodies.arm.kinetic_energy", "momentum.angular.x"]
)
def test_one_quantity_alone_and_its_ends_alone(text: str) -> None:
    scene = load_scene_text(MACHINE)
    model, quantity = compile_scene(scene), parse_quantity(text)
    every, ends = (watch(scene, model, Wanted((quantity,), ends_only=only)) for only in (False, True))
    all_values, end_values = (over_time(some.as_trajectory(), quantity) for some in (every, ends))
    np.testing.assert_array_equal(end_values, all_values[[0, -1]])
    np.testing.assert_array_equal(ends.time, every.time[[0, -1]])
