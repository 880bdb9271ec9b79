"""The end of the file is written ahead of time, with a checksum of our own making."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import h5py
import pytest

from physsim.recording.superblock import lookup3, tell_end


@pytest.mark.parametrize(
    ("text", "checksum"),
    [(b"", 0xDEADBEEF), (b"Four score and seven years ago", 0x17770551)],
)
def test_lookup3_gives_the_published_values(text: bytes, checksum: int) -> None:
    """Bob Jenkins, lookup3.c, driver5."""
    assert lookup3(text) == checksum


def test_lookup3_agrees_with_hdf5(recorded: Callable[..., Path]) -> None:
    head = recorded().read_bytes()[:48]
    assert lookup3(head[:44]).to_bytes(4, "little") == head[44:]


def test_a_file_with_a_later_end_opens(recorded: Callable[..., Path]) -> None:
    path = recorded()
    size = path.stat().st_size
    with path.open("r+b") as file:
        os.ftruncate(file.fileno(), size + 1000)
        tell_end(file.fileno(), size + 1000)
    with h5py.File(path) as file:
        assert file.id.get_filesize() == size + 1000
        assert file["position"].shape[0] == 40
