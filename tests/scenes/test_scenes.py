"""Every example scene runs to its end, does what its head says, makes no energy, and its books balance."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import physsim
from physsim.scene import load_scene
from physsim.simulation import check_expectations

FOLDER = Path(__file__).resolve().parents[2] / "scenes"
SCENES = sorted(FOLDER.glob("*.yaml"))
# Between frames the integrator itself may add this part of the energy: semi-implicit Euler turns
# free bodies with first order. Measured at most 1e-3 (the wing nut).
INTEGRATOR = 2e-3
# The books may be wrong by this part of the energy that flowed. Measured at most 5.4e-4 (the coin).
UNBALANCED = 1e-3
POTENTIALS = ("gravitational", "gravitation", "spring")
SUPPLIES = ("work_forces", "work_motors")
LOSSES = ("lost_damping", "lost_friction", "lost_impact")


def test_there_are_scenes():
    assert len(SCENES) >= 30


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_a_scene_does_what_it_says(path, tmp_path):
    scene = load_scene(path)
    warnings: list[object] = []
    with physsim.run(path, output=tmp_path / "out.h5", warn=warnings.append) as trajectory:
        assert trajectory.status == "complete"
        assert warnings == []
        results = check_expectations(trajectory, scene.spec.expect)
        assert len(results) >= 1
        assert [str(result) for result in results if not result.held] == []
        _sane(trajectory)
    with physsim.open_trajectory(tmp_path / "out.h5") as again:
        assert again.frames >= 2
        assert again.title == scene.title


def _sane(trajectory: physsim.Trajectory) -> None:
    """Finite states, unit quaternions, no energy but from what supplies it, losses that are losses, books."""
    for series in (trajectory.position, trajectory.velocity, trajectory.angular_velocity):
        assert np.isfinite(series[:]).all()
    # measured 1e-15
    assert np.abs(np.linalg.norm(trajectory.orientation[:], axis=2) - 1).max() < 1e-12
    books = {name: series[:] for name, series in trajectory.energy.items()}
    stored = kinetic(books) + sum(books[name] for name in POTENTIALS)
    made = stored - books["stabilization"] - sum(books[name] for name in SUPPLIES)
    scale = max(flow(books), np.abs(stored).max())
    assert np.diff(made).max() <= INTEGRATOR * scale
    assert made[-1] <= made[0] + INTEGRATOR * scale
    # Alone, the normal or the tangential part may work the other way where contacts are coupled.
    assert np.diff(sum(books[name] for name in LOSSES)).min() >= -INTEGRATOR * scale
    assert np.abs(books["residual"]).max() <= UNBALANCED * flow(books)


def kinetic(books: dict[str, np.ndarray]) -> np.ndarray:
    """Kinetic energy of every frame [J]."""
    return books["kinetic_translational"] + books["kinetic_rotational"]


def flow(books: dict[str, np.ndarray]) -> float:
    """The energy that went through the books of a run [J].

    That is the greatest kinetic energy and the range of every potential, work and loss. A joule that passes
    through several forms (lifted, moving, lost) counts once in each: each is a place where it may go astray.
    """
    others = (*POTENTIALS, *SUPPLIES, *LOSSES)
    return float(kinetic(books).max() + sum(np.ptp(books[name]) for name in others))


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_a_scene_tells_its_story(path):
    """A title, and a head that says what should happen."""
    text = path.read_text()
    assert load_scene(path).spec.title
    assert text.startswith("# yaml-language-server: $schema=../schemas/scene.schema.json\n")
    assert "\n# What should happen: " in text


def test_the_meshes_are_what_the_script_makes(tmp_path):
    """Same points and triangles: the script is the source, the files are its output."""
    trimesh = pytest.importorskip("trimesh")
    subprocess.run([sys.executable, FOLDER / "meshes" / "make_meshes.py", tmp_path], check=True, timeout=60)
    made = sorted(file.name for file in tmp_path.iterdir())
    assert made == sorted(f.name for f in (FOLDER / "meshes").iterdir() if f.suffix in (".obj", ".stl"))
    for name in made:
        new, old = trimesh.load(tmp_path / name), trimesh.load(FOLDER / "meshes" / name)
        assert new.is_watertight
        assert np.allclose(new.vertices, old.vertices)
        assert np.array_equal(new.faces, old.faces)


def test_the_mug_is_a_mug():
    """One handle (a surface of genus 1: Euler number 0), walls of the thickness that the script says."""
    trimesh = pytest.importorskip("trimesh")
    mug = trimesh.load(FOLDER / "meshes" / "mug.obj")
    assert mug.euler_number == 0
    wall, floor = np.pi * (40**2 - 36**2) * 90, np.pi * 36**2 * 6
    handle = np.pi * 4.5**2 * 80
    assert mug.volume == pytest.approx(wall + floor + handle, rel=0.02)
