"""A run that is watched: what pages get is what the file has, and nothing that they do reaches the run."""

from __future__ import annotations

import io
import os
import queue
import signal
import socket
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import h5py
import numpy as np
import pytest
from view_watcher import PATIENCE, Watcher, frames, get

import physsim
from physsim.simulation import Onlooker
from physsim.view.live_feed import Feed
from physsim.view.live_store import MOST_BEHIND, Kept, Store, caught_up
from physsim.view.live_wire import Message, encoded, read

SCENE = """
physsim: 1
title: "<b>Two bricks & a ball</b>"
simulation: {duration: 400 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 20 cm], velocity: [1, 0, 0]}
  "<img src=x onerror=alert(1)>":
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
    position: [40 cm, 0, 35 mm]
  bob: {shape: {type: box, size: [5 cm, 5 cm, 5 cm]}, material: steel, position: [0, 1, 1]}
joints:
  "</script>": {type: hinge, between: [world, bob], anchor: [0, 1, 1.5], axis: [0, 1, 0]}
springs:
  tether: {type: linear, between: [world, ball], anchors: [[0, 0, 1], [0, 0, 0]], rest_length: 0.5, stiffness: 10}
record: {every: 1 ms}
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE, encoding="utf-8")
    return path


class Offer:
    """A feed, the address that it announces, and its troubles."""

    def __init__(self) -> None:
        self._announced: queue.Queue[str] = queue.Queue()
        self.troubles: list[str] = []
        self.feed = Feed(self._announce, self.troubles.append)

    def _announce(self, address: str) -> bool:
        self._announced.put(address)
        return False

    def address(self) -> str:
        return self._announced.get(timeout=PATIENCE)


@pytest.fixture
def offer() -> Iterator[Callable[[], Offer]]:
    made: list[Offer] = []

    def make() -> Offer:
        made.append(Offer())
        return made[-1]

    yield make
    for offered in made:
        offered.feed.close()


class Waiting:
    """Holds up a run after its first frame until somebody sees it, so that the rest is seen as well."""

    def __init__(self, offer: Offer, look: Callable[[str], Watcher]) -> None:
        self._offer = offer
        self._look = look
        self.watcher: Watcher | None = None

    def begin(self, title: str, duration: float, fixed: Any) -> None:
        self._offer.feed.begin(title, duration, fixed)

    def frame(self, step: int, time: float, rows: Any, contacts: Any) -> None:
        self._offer.feed.frame(step, time, rows, contacts)
        if self.watcher is None:
            self.watcher = self._look(self._offer.address())
            assert self.watcher.sees.wait(PATIENCE)

    def end(self, status: Any, detail: str, file: Path) -> None:
        self._offer.feed.end(status, detail, file)


def small_run(onlooker: Onlooker, bodies: int = 2) -> None:
    """A feed told of a run by hand: who takes part."""
    names = [f"body {number}" for number in range(bodies)]
    onlooker.begin("by hand", 1.0, STILL | {
        "body": names, "material": ["steel"] * bodies, "mass": np.ones(bodies), "fixed": np.zeros(bodies, np.int8),
        "center_of_mass": np.zeros((bodies, 3)), "inertia": np.tile(np.eye(3), (bodies, 1, 1)),
    })


STILL = {
    "geometry/body": np.array([0], np.int32), "geometry/kind": ["sphere"],
    "geometry/parameters": np.array([[0.1, 0, 0, 0]]), "geometry/position": np.zeros((1, 3)),
    "geometry/orientation": np.array([[1.0, 0, 0, 0]]), "geometry/material": ["steel"], "geometry/color": [""],
    "geometry/shown": np.array([1], np.int8), "geometry/collides": np.array([1], np.int8),
    "geometry/surface": np.array([-1]),
    "geometry/vertex_offset": np.array([0]), "geometry/vertices": np.zeros((0, 3)),
    "geometry/triangle_offset": np.array([0]), "geometry/triangles": np.zeros((0, 3)),
    "provenance/scene": "secret text",
}


class TestWhatPagesGet:
    def test_frames_have_the_bits_of_the_file_and_the_last_is_among_them(self, scene: Path, tmp_path, offer) -> None:
        offered = offer()
        onlooker = Waiting(offered, Watcher)
        physsim.run(scene, output=tmp_path / "run.h5", onlooker=onlooker).close()
        offered.feed.close()
        *seen, end = onlooker.watcher.wait()
        assert (end.kind, end.facts) == (
            "end", {"status": "complete", "detail": "ran to its end at 0.4 s", "file": "run.h5"}
        )
        numbers = [message.facts["frame"] for message in seen]
        assert numbers == sorted(set(numbers))
        assert (numbers[0], numbers[-1]) == (0, 400)
        assert offered.troubles == []
        with h5py.File(tmp_path / "run.h5") as file:
            for message in seen:
                assert_same_bits(message, file)

    def test_pages_that_come_late_get_everything(self, scene: Path, tmp_path, offer) -> None:
        offered = offer()
        physsim.run(scene, output=tmp_path / "run.h5", onlooker=offered.feed).close()
        *seen, end = frames(offered.address())
        assert end.kind == "end"
        assert (seen[0].facts["frame"], seen[-1].facts["frame"]) == (0, 400)
        *later, _ = frames(offered.address, after=399) if False else frames(offered_address(offered), 399)
        assert [message.facts["frame"] for message in later] == [400]
