"""`info --picture`: a scene before it runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from physsim.cli.app import answer

Image = pytest.importorskip("PIL.Image")

SCENE = """
physsim: 1
title: Two crates
simulation: {{duration: 1 s, timestep: 1 ms}}
bodies:
  floor: {{fixed: true, shape: {{type: halfspace, normal: [0, 0, 1]}}, material: concrete}}
  lower: {{shape: {{type: box, size: [1, 1, 0.5]}}, material: wood, position: [0, 0, 0.25]}}
  upper: {{shape: {{type: box, size: [1, 1, 0.5]}}, material: wood, position: [0, 0, {height}]}}
joints:
  hinge: {{type: hinge, between: [lower, upper], anchor: [0.5, 0, 0.5], axis: [0, 1, 0], collide: true}}
springs:
  spring: {{type: linear, between: [world, upper], anchors: [[0, 0, 2], [0, 0, 0.25]], stiffness: 10 N/m}}
"""
ALARM = np.array([190, 18, 18])


def drawn(folder: Path, height: float, *more: str) -> np.ndarray:
    """The pixels of the picture of the scene with the upper crate at that height."""
    scene = folder / "two.yaml"
    scene.write_text(SCENE.format(height=height))
    assert answer(["info", str(scene), "--picture", str(folder / "two.png"), "--force", *more]) == 0
    return np.asarray(Image.open(folder / "two.png").convert("RGB")).astype(int)


def count(pixels: np.ndarray, colour: np.ndarray, tolerance: int) -> int:
    return int((np.abs(pixels - colour).max(axis=2) <= tolerance).sum())


def test_overlaps_are_marked(tmp_path: Path) -> None:
    assert count(drawn(tmp_path, 0.75), ALARM, 8) == 0
    assert count(drawn(tmp_path, 0.65), ALARM, 8) > 100


def test_joints_are_in_the_picture(tmp_path: Path) -> None:
    """A pin in the joints' colour, also where a crate hides it."""
    pixels = drawn(tmp_path, 0.75, "--size", "800x600")
    assert pixels.shape == (600, 800, 3)
    reddish_violet = (pixels[..., 0] > pixels[..., 1] + 60) & (pixels[..., 2] > pixels[..., 1] + 30)
    assert reddish_violet.sum() > 100


def test_the_picture_has_the_name_of_the_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("two.yaml").write_text(SCENE.format(height=0.75))
    assert answer(["info", "two.yaml", "--picture"]) == 0
    said = capsys.readouterr()
    assert said.err.startswith("two.png: the scene, drawn\n")
    assert "overlap" in said.out
    with Image.open("two.png") as picture:
        assert picture.size == (1280, 800)
    assert answer(["info", "two.yaml", "--picture"]) == 3
    assert "exists already" in capsys.readouterr().err


def test_a_trajectory_is_not_drawn_by_info(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "two.yaml"
    scene.write_text(SCENE.format(height=0.75))
    assert answer(["run", str(scene), "-o", str(tmp_path / "two.h5"), "--duration", "2 ms", "--quiet"]) == 0
    assert answer(["info", str(tmp_path / "two.h5"), "--picture"]) == 2
    assert "physsim export --to png" in capsys.readouterr().err


def test_names_of_one_place_stand_below_each_other(tmp_path: Path) -> None:
    """Three bodies with one centre: three lines of writing, not one."""
    bodies = "".join(
        f"  body_{k}: {{{{shape: {{{{type: sphere, radius: {k + 1}}}}}, mass: 1 kg, collides: false}}}}\n"
        for k in range(3)
    )
    scene = "physsim: 1\nsimulation: {{duration: 1 s, timestep: 1 ms}}\nbodies:\n" + bodies
    (tmp_path / "three.yaml").write_text(scene.format())
    target = tmp_path / "three.png"
    assert answer(["info", str(tmp_path / "three.yaml"), "--picture", str(target), "--size", "400x400"]) == 0
    pixels = np.asarray(Image.open(target).convert("RGB")).astype(int)
    written = np.nonzero((pixels[150:350, 210:300].max(axis=2) < 60).any(axis=1))[0]
    assert np.ptp(written) > 18  # one line is 10 high
