"""The same frames give the same file, whatever the clock says and however they were cut into blocks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest


def contents(path: Path) -> dict[str, object]:
    """Every dataset's bytes and every attribute, outside of /provenance."""
    found: dict[str, object] = {}

    def take(name: str, item: h5py.HLObject) -> None:
        if name.startswith("provenance"):
            return
        found[f"{name} attributes"] = {
            key: str(item.attrs[key]) for key in ("units", "long_name") if key in item.attrs
        }
        if isinstance(item, h5py.Dataset):
            data = item[()]
            found[name] = (item.shape, list(data) if data.dtype == object else np.asarray(data).tobytes())

    with h5py.File(path) as file:
        found["root"] = {key: str(value) for key, value in file.attrs.items()}
        file.visititems(take)
    return found


@pytest.mark.parametrize("blocks", [1, 5, 100])
def test_blocks_leave_no_trace(recorded: Callable[..., Path], blocks: int) -> None:
    assert contents(recorded("a.h5", blocks=7)) == contents(recorded("b.h5", blocks=blocks))


def test_the_same_run_gives_the_same_bytes(recorded: Callable[..., Path]) -> None:
    assert recorded("a.h5").read_bytes() == recorded("b.h5").read_bytes()
