"""What a trajectory file holds, for comparing two of them bit for bit."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np


def contents(path: Path) -> dict[str, object]:
    """Shape and bytes of every dataset outside of /provenance, and the attributes of the root."""
    found: dict[str, object] = {}

    def take(name: str, item: h5py.HLObject) -> None:
        if isinstance(item, h5py.Dataset) and not name.startswith("provenance"):
            data = item[()]
            found[name] = (item.shape, list(data) if data.dtype == object else np.asarray(data).tobytes())

    with h5py.File(path) as file:
        found["root"] = {key: str(value) for key, value in file.attrs.items()}
        file.visititems(take)
    return found


def differing(one: Path, other: Path) -> list[str]:
    """Names of what differs."""
    a, b = contents(one), contents(other)
    return sorted(name for name in {*a, *b} if a.get(name) != b.get(name))
