"""Onlookers: what they are told, and that a run does the same whether somebody looks on or not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from contents import differing

import physsim
from physsim.errors import RunFailed
from physsim.view.live.feed import Feed


class Notes:
    """Writes down what it is told."""

    def __init__(self) -> None:
        self.begun: list[tuple[str, Path, float]] = []
        self.fixed: dict[str, Any] = {}
        self.frames: list[tuple[int, int, float, dict[str, Any]]] = []
        self.ended: list[tuple[str, str]] = []

    def begin(self, title: str, file: Path, duration: float, fixed: Any) -> None:
        self.begun.append((title, file, duration))
        self.fixed = fixed

    def frame(self, number: int, step: int, time: float, rows: Any, contacts: Any) -> None:
        self.frames.append((number, step, time, {**rows, **(contacts or {})}))

    def end(self, status: str, detail: str) -> None:
        self.ended.append((status, detail))


def assert_told(notes: Notes, path: Path, first: int = 0) -> None:
    """What was written down is what the file has from a frame on."""
    with h5py.File(path) as file:
        numbers = [number for number, *_ in notes.frames]
        assert numbers == list(range(first, len(file["time"])))
        for number, step, time, rows in notes.frames:
            assert (step, time) == (file["step"][number], file["time"][number])
            start, stop = file["contacts/offset"][number : number + 2]
            for name, value in rows.items():
                there = file[name][start:stop] if name.startswith("contacts/") else file[name][number]
                np.testing.assert_array_equal(there, value, strict=False)


def test_everything_recorded_is_told(scene: Callable[..., Path], tmp_path: Path) -> None:
    notes = Notes()
    physsim.run(scene(), output=tmp_path / "run.h5", onlooker=notes).close()
    assert notes.begun == [("A ball and two bricks", tmp_path / "run.h5", 0.6)]
    assert list(notes.fixed["body"]) == ["floor", "ball", "brick[0,0,0]", "brick[0,0,1]"]
    assert notes.ended == [("complete", "ran to its end at 0.6 s")]
    assert len(notes.frames) == 61
    assert_told(notes, tmp_path / "run.h5")


def test_a_resumed_run_tells_what_it_adds(scene: Callable[..., Path], tmp_path: Path) -> None:
    first, second = Notes(), Notes()
    physsim.run(scene(), output=tmp_path / "run.h5", duration="0.3 s", onlooker=first).close()
    for _ in range(2):  # the second time there is nothing left to do
        physsim.run(scene(), output=tmp_path / "run.h5", resume=True, onlooker=second).close()
    assert len(second.begun) == len(second.ended) == 1
    assert (len(first.frames), len(second.frames)) == (31, 30)
    assert_told(second, tmp_path / "run.h5", 31)


def test_a_run_that_blows_up_has_told_how_it_ended(scene: Callable[..., Path], tmp_path: Path) -> None:
    notes = Notes()
    with pytest.raises(RunFailed):
        physsim.run(scene(("[1, 0, 0]", "[1e12, 0, 0]")), output=tmp_path / "run.h5", onlooker=notes)
    ((status, detail),) = notes.ended
    assert status == "failed"
    assert "blew up" in detail


@pytest.mark.parametrize("resumed", [False, True], ids=["at once", "in two parts"])
def test_the_file_has_the_same_bits_whoever_looks_on(
    scene: Callable[..., Path], tmp_path: Path, resumed: bool
) -> None:
    """With a server process behind it, which takes what it can get."""

    def run(name: str, onlooker: Feed | None) -> None:
        if resumed:
            physsim.run(scene(), output=tmp_path / name, duration="0.3 s", onlooker=onlooker).close()
        physsim.run(scene(), output=tmp_path / name, resume=resumed, onlooker=onlooker).close()

    troubles: list[str] = []
    feed = Feed(lambda _: False, troubles.append)
    try:
        run("watched.h5", feed)
    finally:
        feed.close()
    run("alone.h5", None)
    assert troubles == []
    assert differing(tmp_path / "alone.h5", tmp_path / "watched.h5") == []
