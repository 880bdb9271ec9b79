"""Somebody who watches a run, without a browser: fetches the page and its frames as a browser does."""

from __future__ import annotations

import http.client
import threading
from collections.abc import Iterator
from urllib.parse import urlsplit

from physsim.view.live_wire import Message, read

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
