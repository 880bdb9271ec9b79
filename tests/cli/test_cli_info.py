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
