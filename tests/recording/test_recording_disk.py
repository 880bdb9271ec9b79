"""The file object under HDF5: what a kill between any two writes leaves, and that it is a file."""

from __future__ import annotations

import errno
import os
import random
from collections.abc import Callable
from pathlib import Path

import made_up_run
import numpy as np
import pytest

from physsim.recording import create, disk, open_trajectory, recorder
from physsim.recording.disk import Disk

BODIES = 3


def one_frame_per_chunk(monkeypatch: pytest.MonkeyPatch) -> None:
    """So that the indexes of chunks split several times in a short run."""
    for module in (create, recorder):
        monkeypatch.setattr(module, "block_frames", lambda bodies: 1)
    monkeypatch.setattr(create, "SMALL_CHUNK_FRAMES", 1)
    monkeypatch.setattr(create, "CHUNK_ROWS", (1, 1))


@pytest.mark.parametrize(
    "prepare", [lambda monkeypatch: None, one_frame_per_chunk], ids=["usual", "tiny chunks"]
)
def test_a_kill_between_any_two_writes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, prepare: Callable[[pytest.MonkeyPatch], None]
) -> None:
    """Every call that changes the file is a moment of death; one in seven is looked at."""
    prepare(monkeypatch)
    path, dice = tmp_path / "run.h5", random.Random(1)
    deaths: list[tuple[int, bytes]] = []
    acknowledged = 0

    def mortal(call: Callable[..., int]) -> Callable[..., int]:
        def before(*arguments: object) -> int:
            if acknowledged and dice.random() < 0.15:
                deaths.append((acknowledged, path.read_bytes()))
            return call(*arguments)

        return before

    recorder = made_up_run.start(path, BODIES)
    for name in ("pwrite", "ftruncate", "posix_fallocate"):
        monkeypatch.setattr(disk.os, name, mortal(getattr(os, name)))
    for number in range(150):
        made_up_run.feed(recorder, number, BODIES)
        if number % 4 == 0:
            recorder.write_checkpoint(b"state %d" % number * 200, number)
            recorder.settle()
            acknowledged = recorder.frames
        elif number % 4 == 2:
            recorder.write_part()
    recorder.finish("complete", "", b"end", 0, {})
    monkeypatch.undo()
    assert len(deaths) > 50
    for frames, left in deaths:
        path.write_bytes(left)
        check_left_over(path, frames)


def check_left_over(path: Path, acknowledged: int) -> None:
    with open_trajectory(path) as trajectory:
        assert trajectory.frames >= acknowledged
        frames = np.arange(trajectory.frames)
        np.testing.assert_array_equal(trajectory.position[:, 2, 1], 1000.0 * frames + 21)
        np.testing.assert_array_equal(trajectory.orientation[:, :, 0], 1.0)
        np.testing.assert_array_equal(trajectory.energy.residual, frames)
        np.testing.assert_array_equal(trajectory.contacts().frame, np.repeat(frames, frames % 3))
        assert np.isfinite(trajectory.contacts().force).all()
        assert trajectory.events.rows == len(frames) // 4
        assert np.isfinite(trajectory.events.impulse).all()
        checkpoint = trajectory.checkpoint()
        assert checkpoint is not None
        assert checkpoint.engine == b"state %d" % checkpoint.step * 200 or trajectory.frames == 150


def test_what_is_written_is_read_before_and_after_a_flush(tmp_path: Path) -> None:
    """Against a bytearray, with overlapping pieces of every size around the page size."""
    path, dice, model = tmp_path / "file", random.Random(2), bytearray()
    with Disk(path, create=True) as file:
        for turn in range(400):
            at, piece = (
                dice.randrange(20_000),
                dice.randbytes(dice.choice([1, 40, 4095, 4096, 4097, 9000, 30_000])),
            )
            file.seek(at)
            file.write(piece)
            model.extend(bytes(max(0, at + len(piece) - len(model))))
            model[at : at + len(piece)] = piece
            if turn % 7 == 0:
                file.flush()
                assert path.read_bytes() == model
            file.seek(at - at // 3)
            assert file.read(12_000) == bytes(model[at - at // 3 :][:12_000]).ljust(12_000, b"\0")
    assert path.read_bytes() == model


def test_a_full_disk_changes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file"

    def full(handle: int, offset: int, length: int) -> None:
        raise OSError(errno.ENOSPC, "x")

    with Disk(path, create=True) as file:
        file.write(b"a" * 5000)
        file.flush()
        with monkeypatch.context() as crowded:
            crowded.setattr(disk.os, "posix_fallocate", full)
            file.seek(0)
            file.write(b"b" * 50_000)
            file.flush()
        assert isinstance(file.error, OSError)
        file.write(b"c" * 100)
        file.flush()
    assert path.read_bytes() == b"a" * 5000


def test_where_room_cannot_be_set_aside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Some file systems and C libraries do not know the call; the file is written all the same."""

    def unknown(handle: int, offset: int, length: int) -> None:
        raise OSError(errno.EOPNOTSUPP, "x")

    monkeypatch.setattr(disk.os, "posix_fallocate", unknown)
    with Disk(tmp_path / "file", create=True) as file:
        file.write(b"a" * 5000)
        file.flush()
        assert file.error is None
    assert (tmp_path / "file").read_bytes() == b"a" * 5000


def test_truncating(tmp_path: Path) -> None:
    with Disk(tmp_path / "file", create=True) as file:
        file.write(b"a" * 9000)
        file.flush()
        file.truncate(10)
        file.flush()
    assert (tmp_path / "file").read_bytes() == b"a" * 10


def test_one_writer_at_a_time(tmp_path: Path) -> None:
    with Disk(tmp_path / "file", create=True), pytest.raises(BlockingIOError):
        Disk(tmp_path / "file", create=False)
    Disk(tmp_path / "file", create=False).close()
