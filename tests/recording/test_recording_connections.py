"""Joints and springs of a trajectory: by name, absent when there are none, and in older files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import made_up_run
import numpy as np
import pytest
import xarray

from physsim.errors import FileTrouble
from physsim.recording import NotInFile, Recorder, Target, open_trajectory
from physsim.recording import recorded as columns_of

Recorded = Callable[..., Path]
FRAMES = 9


def test_one_joint_by_name(recorded: Recorded) -> None:
    """Frame t, row n, axis k holds 1000 t + 10 n + k."""
    with open_trajectory(recorded(frames=FRAMES)) as trajectory:
        wheel = trajectory.joint("wheel")
        assert trajectory.joint_names == ("door", "wheel")
        assert wheel.force.shape == wheel.torque.shape == (FRAMES, 3)
        assert wheel.force[3].tolist() == [3010, 3011, 3012]
        assert wheel.coordinate[-1] == 8010
        assert wheel.broken[:].tolist() == [0, 1, 0, 1, 0, 1, 0, 1, 0]
        for name in ("coordinate_2", "coordinate_3", "violation", "angular_violation"):
            assert getattr(wheel, name).shape == (FRAMES,)
        assert (wheel.type, wheel.between, wheel.units) == (
            "made up",
            ("world", "ball[0,0,0]"),
            ("rad", "", ""),
        )
        assert wheel.anchors.tolist() == [[0, 0, 0], [1, 2, 3]]


def test_one_spring_by_name(recorded: Recorded) -> None:
    with open_trajectory(recorded(frames=FRAMES)) as trajectory:
        tether = trajectory.spring("tether")
        assert trajectory.spring_names == ("tether",)
        assert tether.length[2] == tether.force[2] == 2000
        assert (tether.between, tether.units) == (("world", "ball[0,0,0]"), ("m", "N"))


def test_misspelt_names_are_told_the_nearest(recorded: Recorded) -> None:
    with open_trajectory(recorded(frames=2)) as trajectory:
        with pytest.raises(NotInFile, match="has no joint 'weel'; did you mean 'wheel'"):
            trajectory.joint("weel")
        with pytest.raises(NotInFile, match="has no spring 'x'"):
            trajectory.spring("x")


def test_a_scene_without_them_has_no_such_groups(tmp_path: Path) -> None:
    path = without_connections(tmp_path / "none.h5")
    with h5py.File(path) as file:
        assert not {"joints", "springs"} & set(file)
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == 3
        assert trajectory.joint_names == trajectory.spring_names == ()
        with pytest.raises(NotInFile, match="has no joints: the scene has none"):
            trajectory.joint("door")


def without_connections(path: Path) -> Path:
    columns = columns_of(("energy", "contacts"))
    recorder = Recorder.create(Target(path), columns, made_up_run.ATTRIBUTES, made_up_run.fixed_values(3))
    for number in range(3):
        made_up_run.feed(recorder, number, 3)
    return recorder.finish("complete", "", None, 30, {})


def test_files_from_before_these_datasets_are_whole(recorded: Recorded) -> None:
    """Fallbacks, gravitation and rolling friction came later."""
    path = recorded(frames=FRAMES)
    with h5py.File(path, "r+") as file:
        del file["solver/fallbacks"], file["energy/gravitation"], file["pairs/rolling_friction"]
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == FRAMES
        assert "gravitation" not in trajectory.energy
        assert set(trajectory.solver) == {"residual", "iterations", "contact_count"}
        assert "rolling_friction" not in trajectory.pairs


def test_a_group_in_parts_is_damage(recorded: Recorded) -> None:
    path = recorded(frames=3)
    with h5py.File(path, "r+") as file:
        del file["joints/force"]
    with pytest.raises(FileTrouble, match="/joints is not whole"):
        open_trajectory(path)


def test_bodies_that_do_not_exist_are_damage(recorded: Recorded) -> None:
    path = recorded(frames=3)
    with h5py.File(path, "r+") as file:
        file["joints/body_b"][:] = 999
    with open_trajectory(path) as trajectory, pytest.raises(FileTrouble, match="damaged"):
        _ = trajectory.joint("door").between


def test_xarray_selects_joints_by_name(recorded: Recorded) -> None:
    with xarray.open_datatree(recorded(frames=FRAMES)) as tree:
        force = tree["joints"].force.sel(joint="wheel", axis="z")
        np.testing.assert_array_equal(force, 1000.0 * np.arange(FRAMES) + 12)
        assert tree["springs"].length.sel(spring="tether").dims == ("time",)
