"""`physsim info`: scenes and trajectories told apart by content; the numbers are those of closed forms."""

from __future__ import annotations

import json
import math
from pathlib import Path

import h5py
import pytest

SCENE = """
physsim: 1
title: A box, a ball and a floor
simulation: {duration: 100 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace}, material: concrete}
  box: {shape: {type: box, size: [1, 2, 3]}, mass: 12 kg, material: wood, position: [0, 0, 1.49]}
  ball: {shape: {type: sphere, radius: 10 cm}, material: steel, position: [5, 0, 1]}
pairs:
  - {between: [wood, concrete], restitution: 0.3, static_friction: 0.6, kinetic_friction: 0.5}
  - {between: [wood, steel], restitution: 0.4, static_friction: 0.5, kinetic_friction: 0.3}
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE)
    return path


@pytest.mark.usefixtures("scene")
class TestInfo:
    def test_bodies_have_the_masses_and_moments_of_closed_forms(self, physsim) -> None:
        floor, box, ball = json.loads(physsim("info", "scene.yaml", "--json").out)["bodies"]
        # m (b^2 + c^2) / 12 for edges a, b, c; the smallest moment first.
        assert box["principal_moments"] == pytest.approx([5, 10, 13], rel=1e-12)
        assert [[abs(part) for part in axis] for axis in box["principal_axes"]] == [
            [0, 0, 1],
            [0, 1, 0],
            [1, 0, 0],
        ]
        assert box["mass"] == 12
        assert ball["mass"] == pytest.approx(7850 * 4 / 3 * math.pi * 0.1**3, rel=0.02)
        assert ball["principal_moments"] == pytest.approx([0.4 * ball["mass"] * 0.01] * 3, rel=1e-12)
        assert (floor["mass"], floor["fixed"], floor["principal_axes"]) == (None, True, None)

    def test_pairs_name_the_row_or_rule_of_every_number(self, physsim) -> None:
        pairs = json.loads(physsim("info", "scene.yaml", "--json").out)["pairs"]
        wood = next(pair for pair in pairs if set(pair["between"]) == {"wood", "concrete"})
        assert (wood["restitution"], wood["static_friction"], wood["kinetic_friction"]) == (0.3, 0.6, 0.5)
        assert wood["source"] == "scene, pairs[0]"
        assert len(pairs) == 6

    def test_overlaps_at_the_start_are_told_with_their_depth(self, physsim) -> None:
        said = physsim("info", "scene.yaml", "--json")
        (overlap,) = json.loads(said.out)["overlaps"]
        assert overlap["between"] == ["floor", "box"]
        assert overlap["depth"] == pytest.approx(0.01, abs=1e-12)
        assert "overlap at the start" in physsim("info", "scene.yaml").out
        apart = physsim("info", "scene.yaml", "--set", "bodies.box.position=[0, 0, 1.6]")
        assert "No bodies overlap at the start." in apart.out

    def test_text_shows_everything_once(self, physsim) -> None:
        said = physsim("info", "scene.yaml")
        assert said.code == 0
        for part in (
            "A box, a ball and a floor",
            "100 steps of 0.001 s",
            "[5, 10, 13]",
            "concrete - wood",
            "density",
        ):
            assert part in said.out

    def test_a_trajectory_tells_how_far_it_came(self, physsim) -> None:
        assert physsim("run", "scene.yaml", "--quiet").code == 0
        said = physsim("info", "scene.h5")
        assert said.code == 0
        assert "complete (ran to its end at 0.1 s); 11 frames from 0 s to 0.1 s, 100 steps" in said.out
        document = json.loads(physsim("info", "scene.h5", "--json").out)
        assert document["trajectory"]["frames"] == 11
        assert [body["name"] for body in document["bodies"]] == ["floor", "box", "ball"]
        ledger = document["energy"]
        start = sum(
            ledger[name]["first"] for name in ("kinetic_translational", "kinetic_rotational", "gravitational")
        )
        masses = [document["bodies"][k]["mass"] for k in (1, 2)]
        assert start == pytest.approx(9.81 * (masses[0] * 1.49 + masses[1] * 1), rel=1e-12)
        assert "numpy" in document["provenance"]["versions"]

    def test_content_decides_not_the_name(self, physsim, tmp_path: Path) -> None:
        assert physsim("run", "scene.yaml", "-o", "odd.yaml", "--quiet").code == 0
        assert "11 frames" in physsim("info", "odd.yaml").out
        (tmp_path / "scene.h5").write_text(SCENE)
        assert "A box, a ball and a floor" in physsim("info", "scene.h5").out

    def test_set_is_for_scenes(self, physsim) -> None:
        assert physsim("run", "scene.yaml", "--quiet").code == 0
        said = physsim("info", "scene.h5", "--set", "a=1")
        assert said.code == 2
        assert "--set changes scenes" in said.err


MECHANISM = """
physsim: 1
title: A mechanism
simulation: {duration: 50 ms, timestep: 1 ms}
bodies:
  bob: {shape: {type: sphere, radius: 10 cm}, mass: 2 kg, material: steel, position: [1, 0, 2]}
  cube: {shape: {type: box, size: [0.6, 0.6, 0.6]}, mass: 2 kg, material: steel, position: [5, 0, 2]}
springs:
  tether: {type: linear, between: [world, bob], anchors: [[1, 0, 5], [0, 0, 0]], stiffness: 50,
           damping_ratio: 0.2}
  twist: {type: torsional, between: [world, cube], axis: [0, 0, 1], stiffness: 3, damping: 0.1}
  damper: {type: linear, between: [bob, cube], damping: 4}
joints:
  axle: {type: hinge, between: [world, cube], anchor: [5, 0, 2], axis: [0, 0, 1], limits: [-90 deg, 1],
         friction: 2, damping: 0.5, spring: {stiffness: 6, rest: 0.25}, motor: {speed: 2, max_torque: 10}}
  wheel: {type: cylindrical, between: [world, bob], anchor: [1, 0, 2], axis: [0, 1, 0],
          travel: {motor: {travel: 0.5, stiffness: 70, profile: {type: ramp, over: 1}}}}
  pair: {type: gear, joints: [axle, wheel], ratio: -2}
forces:
  push: {body: bob, force: [1, 2, 3], torque: [0, 0, 1], frame: body, until: 2,
         profile: {type: sine, frequency: 1}}
  air: {body: "*", drag: {linear: 3, angular: 4, density: 1.2, area: 2, coefficient: 0.5}}
  wind: {body: cube, acceleration: [1, 0, 0], region: [[0, 0, 0], [9, 9, 9]], from: 0.5}
pairs:
  - {between: [steel, steel], rolling_friction: 1 mm}
"""


@pytest.fixture
def mechanism(tmp_path: Path) -> Path:
    path = tmp_path / "mechanism.yaml"
    path.write_text(MECHANISM)
    return path


@pytest.mark.usefixtures("mechanism")
class TestInfoOfMechanisms:
    def test_springs_tell_frequency_and_damping_of_the_formulas(self, physsim) -> None:
        """omega = sqrt(50 / 2) = 5, f = omega / 2 pi, c_crit = 2 sqrt(50 * 2) = 20; the cube's I is 0.12."""
        tether, twist, damper = json.loads(physsim("info", "mechanism.yaml", "--json").out)["springs"]
        assert tether["angular_frequency"] == pytest.approx(5, rel=1e-12)
        assert tether["frequency"] == pytest.approx(5 / (2 * math.pi), rel=1e-12)
        assert tether["critical_damping"] == pytest.approx(20, rel=1e-12)
        assert tether["damping_ratio"] == pytest.approx(0.2, rel=1e-12)
        assert tether["damping"] == pytest.approx(4, rel=1e-12)
        assert (tether["rest"], tether["placed"]) == (3, 3)
        assert twist["effective_mass"] == pytest.approx(0.12, rel=1e-12)
        assert twist["angular_frequency"] == pytest.approx(5, rel=1e-12)
        assert twist["damping_ratio"] == pytest.approx(0.1 / (2 * math.sqrt(3 * 0.12)), rel=1e-12)
        assert [damper[name] for name in ("angular_frequency", "damping_ratio", "critical_damping")] == [
            None
        ] * 3

    def test_joints_tell_what_they_take_and_what_drives_them(self, physsim) -> None:
        axle, wheel, pair = json.loads(physsim("info", "mechanism.yaml", "--json").out)["joints"]
        assert [joint["degrees_removed"] for joint in (axle, wheel, pair)] == [5, 4, 1]
        assert axle["drives"] == [
            "angle: limits -1.571 to 1 rad, dry friction 2 N m, damping 0.5 N m s/rad, "
            "spring 6 N m/rad to 0.25 rad, motor to 2 rad/s, at most 10 N m"
        ]
        assert wheel["drives"] == ["travel: servo to 0.5 m (ramp) with 70 N/m"]
        assert (pair["between"], pair["drives"]) == (["axle", "wheel"], ["angle_2 = -2 angle_1"])

    def test_forces_tell_on_what_and_when(self, physsim) -> None:
        push, air, wind = json.loads(physsim("info", "mechanism.yaml", "--json").out)["forces"]
        assert push["acts"] == "force [1, 2, 3] N in body axes, torque [0, 0, 1] N m in body axes"
        assert (push["from"], push["until"], push["profile"]) == (0, 2, "sine")
        assert air["bodies"] == ["bob", "cube"]
        assert air["acts"] == "drag 3 N s/m, drag 4 N m s/rad, drag C = 0.5 on 2 m^2 in 1.2 kg/m^3"
        assert wind["acts"] == "acceleration [1, 0, 0] m/s^2 from [0, 0, 0] to [9, 9, 9] m"

    def test_text_has_a_table_for_each(self, physsim) -> None:
        said = physsim("info", "mechanism.yaml").out
        for part in (
            "tether  linear     world - bob",
            "0.7958",
            "degrees removed",
            "servo to 0.5 m (ramp)",
            "2 bodies",
            "from 0 s until 2 s, sine",
            "rolling [m]",
        ):
            assert part in said

    def test_a_trajectory_sums_up_joints_and_springs(self, physsim) -> None:
        assert physsim("run", "mechanism.yaml", "--quiet").code == 0
        document = json.loads(physsim("info", "mechanism.h5", "--json").out)
        axle, wheel, pair = document["joints"]
        assert (axle["type"], axle["between"], axle["broken"]) == ("hinge", ["world", "cube"], False)
        assert [part["unit"] for part in wheel["coordinates"]] == ["m", "rad"]
        assert pair["coordinates"] == []
        assert axle["largest_force"] > 0.9 * 2 * 9.81
        tether, twist, _ = document["springs"]
        assert tether["first_length"] == 3
        assert tether["units"] == ["m", "N"]
        assert twist["units"] == ["rad", "N m"]
        said = physsim("info", "mechanism.h5").out
        assert "most force [N]" in said
        assert "tether  linear     world - bob" in said


def test_other_files_are_refused_politely(physsim, tmp_path: Path) -> None:
    (tmp_path / "picture.png").write_bytes(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
    (tmp_path / "empty").write_bytes(b"")
    (tmp_path / "cut.h5").write_bytes(b"\x89HDF\r\n\x1a\n" + b"\0" * 40)
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["x"] = 1.0
    for name, code in (
        ("picture.png", 3),
        ("empty", 2),
        ("cut.h5", 3),
        ("other.h5", 3),
        (".", 3),
        ("nope", 3),
    ):
        said = physsim("info", name)
        assert said.code == code, name
        assert said.out == ""
        assert name in said.err
        assert "Traceback" not in said.err
        assert "internal error" not in said.err
