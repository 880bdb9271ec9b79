"""Runs that are watched, and somebody who watches without a browser: fetches page and frames as one does."""

from __future__ import annotations

import http.client
import queue
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from physsim.view.live.feed import Feed
from physsim.view.live.wire import Message, read

PATIENCE = 60.0
"""Seconds until something that does not come counts as missing."""


def get(address: str, path: str = "", **headers: str) -> http.client.HTTPResponse:
    """The answer to a GET of something beside the page, with these headers besides (`Host=...`)."""
    parts = urlsplit(address)
    connection = http.client.HTTPConnection(parts.hostname or "", parts.port, timeout=PATIENCE)
    connection.putrequest("GET", parts.path + path, skip_host="Host" in headers)
    for name, value in headers.items():
        connection.putheader(name, value)
    connection.endheaders()
    return connection.getresponse()


def frames(address: str, after: int = -1) -> Iterator[Message]:
    """Messages of the stream until it ends, but the signs that it is alive."""
    with get(address, f"frames?after={after}") as answer:
        assert answer.status == 200
        yield from messages(answer)


def messages(answer: http.client.HTTPResponse) -> Iterator[Message]:
    """Those of a stream that has begun, until it ends."""
    while (got := read(answer)) is not None:
        if got[0].kind != "alive":
            yield got[0]


class Watcher:
    """Reads the stream in a thread of its own, from now to its end."""

    def __init__(self, address: str) -> None:
        self.seen: list[Message] = []
        self.sees = threading.Event()
        self._thread = threading.Thread(target=self._watch, args=(address,), daemon=True)
        self._thread.start()

    def _watch(self, address: str) -> None:
        for message in frames(address):
            self.seen.append(message)
            self.sees.set()

    def wait(self) -> list[Message]:
        """All messages, after the end of the stream."""
        self._thread.join(PATIENCE)
        assert not self._thread.is_alive(), "the stream did not end"
        return self.seen


class Offer:
    """A feed, the address that it announces, and its troubles."""

    def __init__(self, *, expected: bool = False) -> None:
        self._expected = expected
        self._announced: queue.Queue[str] = queue.Queue()
        self.troubles: list[str] = []
        self.feed = Feed(self._announce, self.troubles.append)

    def _announce(self, address: str) -> bool:
        self._announced.put(address)
        return self._expected

    def address(self) -> str:
        return self._announced.get(timeout=PATIENCE)


@contextmanager
def offers() -> Iterator[Callable[..., Offer]]:
    """`make()` gives an Offer; all of them are closed at the end."""
    made: list[Offer] = []

    def make(**how: bool) -> Offer:
        made.append(Offer(**how))
        return made[-1]

    try:
        yield make
    finally:
        for offered in made:
            offered.feed.close()


class HeldUp:
    """Tells a feed of a run, which it stops after the first frame until `meanwhile(address)` is done."""

    def __init__(self, offered: Offer, meanwhile: Callable[[str], None]) -> None:
        self._offered = offered
        self._meanwhile = meanwhile
        self.begin, self.end = offered.feed.begin, offered.feed.end

    def frame(self, number: int, step: int, time: float, rows: Any, contacts: Any) -> None:
        self._offered.feed.frame(number, step, time, rows, contacts)
        if step == 0:
            self._meanwhile(self._offered.address())


BALL = {
    "body": ["ball"],
    "material": ["steel"],
    "mass": np.ones(1),
    "fixed": np.zeros(1, np.int8),
    "center_of_mass": np.zeros((1, 3)),
    "inertia": np.eye(3)[None],
    "geometry/body": np.zeros(1, np.int32),
    "geometry/kind": ["sphere"],
    "geometry/parameters": np.array([[0.1, 0, 0, 0]]),
    "geometry/position": np.zeros((1, 3)),
    "geometry/orientation": np.array([[1.0, 0, 0, 0]]),
    "geometry/material": ["steel"],
    "geometry/color": [""],
    "geometry/shown": np.ones(1, np.int8),
    "geometry/collides": np.ones(1, np.int8),
    "geometry/surface": np.array([-1]),
    "geometry/vertex_offset": np.zeros(1, np.int64),
    "geometry/vertices": np.zeros((0, 3)),
    "geometry/triangle_offset": np.zeros(1, np.int64),
    "geometry/triangles": np.zeros((0, 3)),
    "provenance/scene": "# a secret of the author",
}


def begun(feed: Feed, **different: Any) -> None:
    """Tells a feed of a run of one ball."""
    fixed = BALL | {path.replace("__", "/"): value for path, value in different.items()}
    feed.begin("By hand", Path("hand.h5"), 1.0, fixed)
