"""`physsim diff`: files that are alike, files that part, and by how much."""

from __future__ import annotations

import json
from pathlib import Path

import h5py
import numpy as np
import pytest

import physsim
from physsim.analysis.diff import compare, differing_settings
from physsim.cli.app import answer
from physsim.errors import FileTrouble
from physsim.recording import open_trajectory

FALL = """
physsim: 1
title: A ball falls, a door swings
parameters: {v: 0}
simulation: {duration: 200 ms, timestep: 1 ms}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1], velocity: ["${v}", 0, 0]}
  door: {shape: {type: box, size: [1, 0.1, 2]}, mass: 1, collides: false, position: [5, 0, 0],
         angular_velocity: [0, 0, 1]}
joints:
  hinge: {type: hinge, between: [world, door], anchor: [4.5, 0, 0], axis: [0, 0, 1]}
record: {every: 10 ms}
"""
BOX = """
physsim: 1
title: A box with many bounces, which forgets how it began
parameters: {nudge: 0}
simulation: {duration: 3 s, timestep: 1 ms}
pairs: [{between: [rubber, concrete], restitution: 0.9, static_friction: 0.5, kinetic_friction: 0.4}]
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  box: {shape: {type: box, size: [10 cm, 15 cm, 20 cm]}, material: rubber,
        position: [0, 0, "${50 cm + nudge}"], orientation: {rotation_vector: [0.3, 0.4, 0.1]},
        angular_velocity: [5, 2, 3]}
record: {every: 10 ms}
"""


def run(folder: Path, name: str, text: str = FALL, **changes: object) -> Path:
    scene = folder / "scene.yaml"
    scene.write_text(text)
    told = {key.replace("__", "."): value for key, value in changes.items()}
    physsim.run(scene, output=folder / name, set=told).close()
    return folder / name


def report(a: Path, b: Path, capsys: pytest.CaptureFixture[str], *more: str) -> tuple[int, dict[str, object]]:
    capsys.readouterr()
    code = answer(["diff", str(a), str(b), "--json", *more])
    return code, json.loads(capsys.readouterr().out)


def test_the_same_scene_twice(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, found = report(run(tmp_path, "a.h5"), run(tmp_path, "b.h5"), capsys)
    assert code == 0
    assert found["alike"] is True
    assert found["frames"] == 21
    assert found["settings"] == found["divergences"] == found["growth"] == []


def test_another_speed_is_found_where_it_begins(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """v differs by 0.25 m/s from the start, so x by 0.25 t; at 0.2 s that is 5 cm."""
    code, found = report(run(tmp_path, "a.h5"), run(tmp_path, "b.h5", parameters__v=0.25), capsys)
    assert code == 1
    first = found["first"]
    assert (first["quantity"], first["frame"]) == ("bodies.ball.velocity", 0)
    assert first["difference"] == pytest.approx(0.25, rel=1e-15)
    by_name = {each["quantity"]: each for each in found["divergences"]}
    assert by_name["bodies.ball.position"]["frame"] == 1
    assert by_name["bodies.ball.position"]["greatest"] == pytest.approx(0.05, rel=1e-12)
    assert by_name["bodies.ball.position"]["greatest_time"] == 0.2
    assert not any("door" in name or "hinge" in name for name in by_name)
    assert "bodies.ball.velocity[0]" in [each["name"] for each in found["settings"]]
    assert found["growth"][-1]["difference"] == pytest.approx(0.05, rel=1e-12)
    assert found["growth"][-1]["quantity"] == "bodies.ball.position"


def test_the_tolerance_is_relative_for_large_values(tmp_path: Path) -> None:
    """v differs by 0.25 of 1, p by 4.1 kg times that (and L = z p with it), E by 0.13 J of 40 J."""
    with (
        open_trajectory(run(tmp_path, "a.h5")) as a,
        open_trajectory(run(tmp_path, "b.h5", parameters__v=0.25)) as b,
    ):
        assert not compare(a, b, 0.249).alike
        loose = compare(a, b, 0.26)
        assert {each.quantity for each in loose.divergences} == {"momentum.linear", "momentum.angular"}
        assert compare(a, b, 10.0).alike


def test_frames_are_matched_by_time(tmp_path: Path) -> None:
    """Every 10 ms against every 15 ms, and half the timestep of a free flight: common times 0, 30, ... ms."""
    a, b = run(tmp_path, "a.h5"), run(tmp_path, "b.h5", record__every="15 ms", simulation__duration="300 ms")
    with open_trajectory(a) as one, open_trajectory(b) as other:
        found = compare(one, other)
        assert (found.frames, found.alike) == (7, True)
        assert found.end == pytest.approx(0.18)
        names = {setting.name: (setting.a, setting.b) for setting in differing_settings(one, other)}
        assert names == {"simulation.duration": (0.2, 0.3), "record.every": (0.01, 0.015)}


def test_no_common_times(tmp_path: Path) -> None:
    a = run(tmp_path, "a.h5")
    b = run(tmp_path, "b.h5")
    with h5py.File(b, "r+") as file:
        file["time"][:] = file["time"][:] + 0.0051
    with open_trajectory(a) as one, open_trajectory(b) as other, pytest.raises(FileTrouble, match="no frame"):
        compare(one, other)


def test_one_number_changed_is_found(tmp_path: Path) -> None:
    """The last bit of one coordinate of one frame, beyond the first block."""
    a, b = run(tmp_path, "a.h5", record__every="1 ms", simulation__duration="400 ms"), tmp_path / "b.h5"
    b.write_bytes(a.read_bytes())
    with h5py.File(b, "r+") as file:
        value = file["joints/coordinate"][321, 0]
        file["joints/coordinate"][321, 0] = np.nextafter(value, 9)
    with open_trajectory(a) as one, open_trajectory(b) as other:
        (found,) = compare(one, other).divergences
        assert (found.quantity, found.frame) == ("joints.hinge.coordinate", 321)
        assert found.difference == np.spacing(value)
        assert compare(one, other, 1e-15).alike


def test_the_sign_of_a_quaternion_is_no_difference(tmp_path: Path) -> None:
    a, b = run(tmp_path, "a.h5"), tmp_path / "b.h5"
    b.write_bytes(a.read_bytes())
    with h5py.File(b, "r+") as file:
        file["orientation"][:] = -file["orientation"][:]
    with open_trajectory(a) as one, open_trajectory(b) as other:
        assert compare(one, other).alike


def test_orientations_differ_by_their_angle(tmp_path: Path) -> None:
    a = run(tmp_path, "a.h5")
    b = run(tmp_path, "b.h5", bodies__ball={**BALL, "orientation": {"rotation_vector": [0, 0, 0.125]}})
    with open_trajectory(a) as one, open_trajectory(b) as other:
        (found,) = compare(one, other).divergences
        assert (found.quantity, found.unit) == ("bodies.ball.orientation", "rad")
        assert found.difference == pytest.approx(0.125, rel=1e-12)


BALL = {
    "shape": {"type": "sphere", "radius": "5 cm"},
    "material": "steel",
    "position": [0, 0, 1],
    "velocity": ["${v}", 0, 0],
}


def test_what_one_file_lacks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    a = run(tmp_path, "a.h5")
    b = run(tmp_path, "b.h5", FALL.replace("  ball:", "  marble:"))
    code, found = report(a, b, capsys, "--tolerance", "1e9")
    assert code == 1
    assert (found["only_a"], found["only_b"]) == (["bodies.ball"], ["bodies.marble"])


def test_a_small_difference_that_grows(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A nudge of 1e-11 m in a box that tumbles: impacts make it grow."""
    a, b = run(tmp_path, "a.h5", BOX), run(tmp_path, "b.h5", BOX, parameters__nudge="1e-11 m")
    code, found = report(a, b, capsys)
    assert code == 1
    growth = [moment["difference"] for moment in found["growth"]]
    assert growth[0] < 2e-11
    assert growth[-1] > 1e-9
    assert 0.005 < found["doubling_time"] < 1
    assert answer(["diff", str(a), str(b)]) == 1
    told = capsys.readouterr().out
    assert "first difference in frame 0" in told
    assert "while it grows it doubles every" in told
    assert report(a, b, capsys, "--tolerance", "100")[0] == 0


def test_trouble_with_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    a = run(tmp_path, "a.h5")
    assert answer(["diff", str(a), str(tmp_path / "none.h5")]) == 3
    assert "none.h5: no such file" in capsys.readouterr().err
    (tmp_path / "text.h5").write_text("not a trajectory")
    assert answer(["diff", str(tmp_path / "text.h5"), str(a)]) == 3
    assert answer(["diff", str(a)]) == 2
    assert answer(["diff", str(a), str(a), "--tolerance", "-1"]) == 2
