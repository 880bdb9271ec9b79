"""Two slots that take turns; a torn one is never used."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import pytest

from physsim.recording.checkpoint import Checkpoint, newest, save, save_last


@pytest.fixture
def file(recorded: Callable[..., Path]) -> h5py.File:
    with h5py.File(recorded(), "r+") as opened:
        yield opened


def at(step: int) -> Checkpoint:
    return Checkpoint(b"engine at %d " % step * step, step, step // 10, step // 20)


def test_the_newest_is_found(file: h5py.File) -> None:
    for step in (1000, 1010, 1020):
        save(file, at(step))
        assert newest(file) == at(step)


def test_the_one_before_stays_while_the_next_is_written(file: h5py.File) -> None:
    save(file, at(1000))
    save(file, at(1010))
    save(file, at(1020))
    tear(file, step=1020)
    assert newest(file) == at(1010)


def tear(file: h5py.File, step: int) -> None:
    """As a kill in the middle of writing the slot would: one byte of the engine's state is not there yet."""
    slot = next(slot for slot in "ab" if file[f"checkpoint/{slot}/step"][()] == step)
    file[f"checkpoint/{slot}/engine"][3] ^= 0xFF


@pytest.mark.parametrize("name", ["step", "frames", "events"])
def test_a_torn_count_is_noticed(file: h5py.File, name: str) -> None:
    save_last(file, at(1000), file.flush)
    file[f"checkpoint/a/{name}"][()] += 1
    assert newest(file) is None


@pytest.mark.parametrize("saves", [1, 2, 3])
def test_runs_end_alike_however_often_they_saved(file: h5py.File, saves: int) -> None:
    for step in range(saves):
        save(file, at(1000 + step))
    save_last(file, at(2000), file.flush)
    assert newest(file) == at(2000)
    assert file["checkpoint/a/step"][()] == 2000
    assert file["checkpoint/b/step"][()] == -1
    assert file["checkpoint/b/engine"].shape == (0,)
