"""The names, axes and units of the file are a promise: they are written out here a second time."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

from physsim.recording import layout

PROMISED = """
time (time) s
step (time) 1
body (body) 1
axis (axis) 1
quaternion (quaternion) 1
position (time, body, axis) m
orientation (time, body, quaternion) 1
velocity (time, body, axis) m s-1
angular_velocity (time, body, axis) rad s-1
mass (body) kg
inertia (body, axis, axis_2) kg m2
center_of_mass (body, axis) m
material (body) 1
fixed (body) 1
energy/kinetic_translational (time) J
energy/kinetic_rotational (time) J
energy/gravitational (time) J
energy/gravitation (time) J
energy/spring (time) J
energy/work_forces (time) J
energy/work_motors (time) J
energy/lost_damping (time) J
energy/lost_friction (time) J
energy/lost_impact (time) J
energy/stabilization (time) J
energy/residual (time) J
momentum/linear (time, axis) kg m s-1
momentum/angular (time, axis) kg m2 s-1
contacts/frame (contact) 1
contacts/body_a (contact) 1
contacts/body_b (contact) 1
contacts/position (contact, axis) m
contacts/normal (contact, axis) 1
contacts/depth (contact) m
contacts/impulse (contact, axis) N s
contacts/normal_impulse (contact) N s
contacts/tangential_impulse (contact, axis) N s
contacts/force (contact, axis) N
contacts/relative_velocity_before (contact, axis) m s-1
contacts/relative_velocity_after (contact, axis) m s-1
contacts/pair (contact) 1
contacts/sliding (contact) 1
contacts/offset (boundary) 1
events/time (event) s
events/body_a (event) 1
events/body_b (event) 1
events/position (event, axis) m
events/normal (event, axis) 1
events/speed_before (event) m s-1
events/speed_after (event) m s-1
events/impulse (event) N s
events/restitution_declared (event) 1
events/restitution_measured (event) 1
solver/residual (time) m s-1
solver/iterations (time) 1
solver/contact_count (time) 1
solver/fallbacks (time) 1
joints/joint (joint) 1
joints/type (joint) 1
joints/body_a (joint) 1
joints/body_b (joint) 1
joints/anchor_a (joint, axis) m
joints/anchor_b (joint, axis) m
joints/force (time, joint, axis) N
joints/torque (time, joint, axis) N m
joints/coordinate (time, joint) 1
joints/coordinate_unit (joint) 1
joints/coordinate_2 (time, joint) 1
joints/coordinate_3 (time, joint) 1
joints/violation (time, joint) m
joints/angular_violation (time, joint) rad
joints/broken (time, joint) 1
springs/spring (spring) 1
springs/type (spring) 1
springs/body_a (spring) 1
springs/body_b (spring) 1
springs/anchor_a (spring, axis) m
springs/anchor_b (spring, axis) m
springs/length (time, spring) 1
springs/length_unit (spring) 1
springs/force (time, spring) 1
springs/force_unit (spring) 1
pairs/material_a (pair) 1
pairs/material_b (pair) 1
pairs/restitution (pair) 1
pairs/static_friction (pair) 1
pairs/kinetic_friction (pair) 1
pairs/rolling_friction (pair) m
pairs/spinning_friction (pair) m
pairs/source (pair) 1
provenance/scene () 1
provenance/scene_resolved () 1
provenance/mesh_sha256 () 1
provenance/versions () 1
provenance/host () 1
provenance/command () 1
"""
LINES = [re.fullmatch(r"(\S+) \((.*)\) (.*)", line) for line in PROMISED.strip().splitlines()]
# Base symbols of UDUNITS that the file uses, each with an integer power.
UDUNITS = re.compile(r"1|(?:(?:kg|m|s|rad|N|J)(?:-?\d)?)(?: (?:kg|m|s|rad|N|J)(?:-?\d)?)*")


@pytest.fixture
def file(recorded: Callable[..., Path]) -> h5py.File:
    with h5py.File(recorded()) as opened:
        yield opened


def test_every_promised_dataset_has_its_axes_and_unit(file: h5py.File) -> None:
    for line in LINES:
        assert line
        path, dims, units = line.groups()
        dataset = file[path]
        assert dataset.attrs["units"] == units, path
        wanted = tuple(dims.split(", ")) if dims else ()
        assert tuple(axis_names(dataset)) == wanted, path


def axis_names(dataset: h5py.Dataset) -> list[str]:
    if dataset.is_scale:
        return [dataset.name.rpartition("/")[2]]
    return [dataset.dims[k][0].name.rpartition("/")[2] for k in range(dataset.ndim)]


def test_every_dataset_has_a_unit_that_udunits_can_read_and_a_description(file: h5py.File) -> None:
    found = []
    file.visititems(lambda name, item: found.append(item) if isinstance(item, h5py.Dataset) else None)
    assert len(found) > len(LINES)
    for dataset in found:
        assert UDUNITS.fullmatch(dataset.attrs["units"]), dataset.name


def test_root_attributes(file: h5py.File) -> None:
    assert file.attrs["format"] == "physsim-trajectory"
    assert file.attrs["format_version"] == 1
    assert {"Conventions", "physsim_version", "title", "seed", "status"} <= set(file.attrs)
    assert file.attrs["status"] == "complete"


def test_no_pickles_and_no_compound_types(file: h5py.File) -> None:
    def check(name: str, item: h5py.HLObject) -> None:
        if isinstance(item, h5py.Dataset):
            assert item.dtype.names is None, name
            assert item.dtype.kind in "fiu" or h5py.check_string_dtype(item.dtype), name

    file.visititems(check)


def test_numbers_are_doubles_in_gzip_with_shuffle(file: h5py.File) -> None:
    position = file["position"]
    assert (position.dtype, position.compression, position.shuffle) == (np.float64, "gzip", True)


def test_the_table_has_no_name_twice() -> None:
    assert len(layout.BY_PATH) == len(layout.EVERYTHING)


def test_groups_that_are_not_recorded_are_absent() -> None:
    groups = {column.group for column in layout.recorded(())}
    assert not groups & {"energy", "contacts", "joints", "springs"}
    assert {"momentum", "events"} <= groups


def test_the_page_names_every_dataset() -> None:
    page = layout.as_markdown()
    assert all(f"`/{column.path}`" in page for column in layout.EVERYTHING)
