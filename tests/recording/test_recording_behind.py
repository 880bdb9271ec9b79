"""Writing behind the run's back: in order, one block ahead at most, and every error is told."""

from __future__ import annotations

import errno
import threading
from pathlib import Path
from typing import Any

import made_up_run
import pytest

from physsim.errors import FileTrouble
from physsim.recording import disk, open_trajectory
from physsim.recording.behind import Behind


def test_work_is_done_in_order() -> None:
    behind, done = Behind("test"), []
    for number in range(50):
        behind.do(lambda number=number: done.append(number))
    behind.settle()
    behind.close()
    assert done == list(range(50))


def test_who_is_further_ahead_waits() -> None:
    """The third piece is not taken before the first is done."""
    behind, gate, taken = Behind("test"), threading.Event(), []

    def hand_over() -> None:
        for number in range(3):
            behind.do(gate.wait)
            taken.append(number)

    other = threading.Thread(target=hand_over)
    other.start()
    while not taken:
        pass
    assert taken == [0]
    gate.set()
    other.join()
    behind.close()
    assert taken == [0, 1, 2]


def test_an_error_is_told_and_nothing_is_done_after_it() -> None:
    behind, done = Behind("test"), []

    def fail() -> None:
        raise ValueError("no")

    behind.do(fail)
    for _ in range(2):
        with pytest.raises(ValueError, match="no"):
            behind.do(lambda: done.append(1))
        with pytest.raises(ValueError, match="no"):
            behind.settle()
        with pytest.raises(ValueError, match="no"):
            behind.check()
    behind.close()
    assert done == []


def test_a_disk_that_fails_later_is_told_at_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`finish` raises what went wrong with a block before it."""
    recorder = made_up_run.start(tmp_path / "run.h5", 3)
    made_up_run.feed(recorder, 0, 3)
    recorder.write_block()
    recorder.settle()

    def fail(*_: Any) -> int:
        raise OSError(errno.EIO, "x")

    with monkeypatch.context() as broken:
        broken.setattr(disk.os, "pwrite", fail)
        made_up_run.feed(recorder, 1, 3)
        recorder.write_block()
        with pytest.raises(FileTrouble, match="input/output error"):
            recorder.finish("complete", "", None, 0, {})
    with open_trajectory(tmp_path / "run.h5") as trajectory:
        assert trajectory.frames == 1
