"""The file as xarray sees it, by itself and through `to_xarray`."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import xarray

from physsim.recording import open_trajectory


@pytest.mark.parametrize("engine", [None, "h5netcdf"])
def test_selecting_by_name(recorded: Callable[..., Path], engine: str | None) -> None:
    with warnings.catch_warnings(), xarray.open_dataset(recorded(), engine=engine) as ds:
        warnings.simplefilter("error")
        height = ds.position.sel(body="ball[1,0,0]", axis="z")
        np.testing.assert_array_equal(height, 1000.0 * np.arange(40) + 22)
        assert height.attrs["units"] == "m"
        assert ds.orientation.sel(quaternion="w").dims == ("time", "body")
        assert float(ds.position.sel(time=0.2, body="floor", axis="x")) == 20000.0
        assert ds.attrs["format"] == "physsim-trajectory"
        assert ds.material.sel(body="floor").item() == "steel"


def test_groups_inherit_the_time_axis(recorded: Callable[..., Path]) -> None:
    with warnings.catch_warnings(), xarray.open_datatree(recorded()) as tree:
        warnings.simplefilter("error")
        assert float(tree["energy"].lost_impact.sel(time=0.2)) == 20.0
        assert tree["contacts"]["depth"].dims == ("contact",)
        assert tree["contacts"].sizes["boundary"] == 41
        assert list(tree["pairs"].pair.values) == ["steel, steel"]


def test_to_xarray_is_what_xarray_reads_itself(recorded: Callable[..., Path]) -> None:
    path = recorded()
    with xarray.open_dataset(path) as read, open_trajectory(path) as trajectory:
        ours = trajectory.to_xarray()
        assert set(ours.variables) == set(read.variables)
        for name in read.variables:
            assert ours[name].dims == read[name].dims
            assert list(ours[name].values.ravel()) == list(read[name].values.ravel()), name
