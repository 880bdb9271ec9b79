"""Convex pieces of concave meshes: what CoACD gives, its cache, and what is said without it."""

from __future__ import annotations

import importlib.util
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from small_scenes import body, body_problem

from physsim.model import pieces, polyhedron

KEYS = "shape: {type: mesh, file: l.obj, collision: pieces}, material: steel"


@pytest.fixture
def profile(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with an L profile of volume 0.0032 and an empty cache."""
    outline = [[0, 0], [0.4, 0], [0.4, 0.1], [0.1, 0.1], [0.1, 0.4], [0, 0.4]]
    triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 5], [3, 4, 5]]
    solid = trimesh.creation.extrude_triangulation(np.array(outline), np.array(triangles), height=0.05)
    solid.export(tmp_path / "l.obj")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path


@pytest.mark.skipif(importlib.util.find_spec("coacd") is None, reason="CoACD is not installed")
def test_an_l_profile_becomes_two_boxes_and_is_remembered(
    profile: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Their volumes sum to the profile's (0.1 %, CoACD remeshes); the mass is the mesh's, not theirs."""
    model = body(KEYS, profile)
    hulls = model.geoms.hulls
    volumes = [polyhedron.solid(hull.vertices, hull.triangles()).mass for hull in hulls]
    assert len(hulls) == 2
    assert sum(volumes) == pytest.approx(0.07 * 0.05, rel=1e-3)
    assert model.mass[0] == pytest.approx(7850 * 0.07 * 0.05, rel=1e-12)
    monkeypatch.setattr(subprocess, "run", None)
    again = body(KEYS, profile)
    assert all((a.vertices == b.vertices).all() for a, b in zip(hulls, again.geoms.hulls, strict=True))


def test_without_coacd_the_extra_is_named(profile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    problem = body_problem(KEYS, profile)
    assert problem.path[-1] == "collision"
    assert "pip install coacd" in str(problem.hint)


def test_a_decomposition_that_takes_too_long_is_given_up(
    profile: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(command: list[str], **options: Any) -> None:
        raise subprocess.TimeoutExpired(command, options["timeout"])

    monkeypatch.setattr(pieces, "_require_coacd", lambda: None)
    monkeypatch.setattr(subprocess, "run", never)
    assert "in 600 s" in body_problem(KEYS, profile).message


def test_a_crash_of_coacd_is_a_problem_of_the_mesh(profile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    crashed = subprocess.CompletedProcess([], -11, b"", b"")
    monkeypatch.setattr(pieces, "_require_coacd", lambda: None)
    monkeypatch.setattr(subprocess, "run", lambda *_, **__: crashed)
    assert "CoACD failed" in body_problem(KEYS, profile).message


def test_damaged_caches_are_ignored(tmp_path: Path) -> None:
    path = tmp_path / "kept.npz"
    for content in (b"", b"PK\x03\x04 broken", b"no archive"):
        path.write_bytes(content)
        assert pieces._load(path) is None


def test_open_meshes_cannot_be_cut(profile: Path) -> None:
    mesh = trimesh.load_mesh(profile / "l.obj")
    mesh.update_faces(np.arange(len(mesh.faces)) > 0)
    mesh.export(profile / "l.obj")
    problem = body_problem(KEYS.replace("collision: pieces", "collision: pieces, inertia: hull"), profile)
    assert "cutting into pieces needs an inside" in problem.message
