"""Chunks that are packed outside of HDF5 are what HDF5 itself would read and write."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physsim.recording.packed import Packed, packed

SHAPES = [((), ()), ((7,), (3,)), ((5, 4), (2, 4))]


@pytest.mark.parametrize("kind", ["f8", "i4", "i1"])
@pytest.mark.parametrize(("item", "part"), SHAPES)
@settings(max_examples=20, deadline=None)
@given(lengths=st.lists(st.integers(1, 23), min_size=1, max_size=6), seed=st.integers(0, 99))
def test_what_was_put_is_read_back(  # noqa: PLR0917, what is drawn and what is listed
    tmp_path_factory: pytest.TempPathFactory,
    item: tuple[int, ...],
    part: tuple[int, ...],
    kind: str,
    lengths: list[int],
    seed: int,
) -> None:
    """Pieces of any length, one after the other, with chunks of 8 rows, after closing and opening, too."""
    path = tmp_path_factory.mktemp("packed") / "file.h5"
    whole = (100 * np.random.default_rng(seed).normal(size=(sum(lengths), *item))).astype(kind)
    with h5py.File(path, "w") as file:
        more = {"maxshape": (None, *item), "chunks": (8, *part), "compression": "gzip", "shuffle": True}
        file.create_dataset("x", shape=(0, *item), dtype=kind, **more)
    start = 0
    for length in lengths:
        with h5py.File(path, "r+") as file:
            dataset = Packed(file["x"])
            dataset.append(whole[start : start + length // 2])
            dataset.append(whole[start + length // 2 : start + length])
            dataset.settle()
        start += length
    with h5py.File(path) as file:
        np.testing.assert_array_equal(file["x"][()], whole)


def test_the_stream_is_that_of_the_filters(tmp_path: Path) -> None:
    """HDF5's own chunk, unpacked by zlib, holds the same bytes in the same order."""
    import zlib  # noqa: PLC0415

    rows = np.random.default_rng(0).normal(size=(16, 3))
    with h5py.File(tmp_path / "file.h5", "w") as file:
        x = file.create_dataset("x", data=rows, chunks=(16, 3), compression="gzip", shuffle=True)
        _, stream = x.id.read_direct_chunk((0, 0))
        assert zlib.decompress(stream) == zlib.decompress(packed(rows))
