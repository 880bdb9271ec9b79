"""The server of a run that is watched: a process of its own, told by its stdin, looked at by browsers.

Beyond what `loopback` does to keep others out, it answers only under a path that nobody can guess. It can be
asked for nothing but the page and the stream of its frames.

    /TOKEN/                 the page
    /TOKEN/frames?after=N   messages of `live_wire`: frames later than N as they come, then the end, and then
                            the page of the whole trajectory where frames were left out
"""

from __future__ import annotations

import json
import os
import secrets
import sys
import threading
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from pathlib import Path
from urllib.parse import parse_qs

from physsim.view.live.page import live_page, whole_page
from physsim.view.live.show import Show
from physsim.view.live.store import caught_up
from physsim.view.live.wire import Message, encoded, read
from physsim.view.loopback import HTML, LoopbackHandler, LoopbackServer

# Lower than that of the run, which comes first where processors are few.
NICENESS = 10
# When all is told: so long for a page that is on its way or slow.
LAST_SECONDS = 5.0
# A stream without frames says so often that it goes on, and finds out whether its reader does.
SECONDS_BETWEEN_SIGNS = 5.0

ALIVE = encoded(Message("alive"))
LOST = {"status": "failed", "detail": "the run ended without a word", "frames": 0}


class Server(LoopbackServer):
    """Serves one show under one token."""

    def __init__(self, port: int, show: Show) -> None:
        """Raises OSError when the port is taken."""
        self.show = show
        self.root = f"/{secrets.token_urlsafe(16)}/"
        super().__init__(port, Handler)

    @property
    def address(self) -> str:
        """Where the page is."""
        return super().address.rstrip("/") + self.root


class Handler(LoopbackHandler):
    """One request of a browser."""

    server: Server

    def answer(self, path: str, query: str) -> None:
        """The page, or the stream of its frames."""
        if path == self.server.root:
            self._send_page()
        elif path == self.server.root + "frames":
            self._send_frames(_number(query))
        else:
            self.refuse(HTTPStatus.NOT_FOUND)

    def _send_page(self) -> None:
        page = self.server.show.visit()
        if page is None:
            self.refuse(HTTPStatus.GONE)
        else:
            self.send(HTTPStatus.OK, HTML, [page])

    def _send_frames(self, after: int) -> None:
        with self.server.show.stream() as room:
            if room:
                self.start(HTTPStatus.OK, {"Content-Type": "application/octet-stream"})
                self._follow(after)
            else:
                self.refuse(HTTPStatus.SERVICE_UNAVAILABLE)

    def _follow(self, after: int) -> None:
        """All that is kept at first, then what comes, thinner for a reader that falls behind."""
        store = self.server.show.store
        frames, end = store.after(after, SECONDS_BETWEEN_SIGNS)
        while True:
            for kept in frames:
                self.wfile.write(kept.data)
                after = kept.number
            if end is not None:
                self.wfile.write(end)
                self.wfile.write(self.server.show.rest())
                return
            if not frames:
                self.wfile.write(ALIVE)
            frames, end = store.after(after, SECONDS_BETWEEN_SIGNS)
            frames = caught_up(frames)


def _number(query: str) -> int:
    """`after=N` of a query; all frames when it is not there, or no number."""
    with suppress(ValueError, LookupError):
        return int(parse_qs(query)["after"][0])
    return -1


def main() -> int:
    """Says on stdout where the page is, shows what comes on stdin, and leaves when that ends.

    Returns 1 when that could not be done, and says why.
    """
    _step_back()
    show = Show()
    try:
        server = Server(int(sys.argv[1]), show)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        _say(address=server.address)
        _listen(show)
    except Exception as error:
        _say(trouble=f"the server of the page failed: {error}")
        return 1
    show.close()
    show.wait_until_seen(LAST_SECONDS)
    return 0


def _listen(show: Show) -> None:
    """Takes in what is told until there is no more of it. An end that is not told is one too."""
    file, ended = Path(), False
    while (got := read(sys.stdin.buffer)) is not None:
        message, data = got
        if message.kind == "begin":
            file = Path(message.facts["file"])
            show.open(live_page(message), expected=message.facts["on_its_way"])
        elif message.kind == "frame":
            show.store.add(message.facts["frame"], data)
        elif message.kind == "end":
            frames = message.facts["frames"]
            seen = show.store.has_all(frames)
            show.finish(data, bytes if seen else partial(whole_page, file, frames))
            ended = True
    if not ended:
        show.finish(encoded(Message("end", LOST)), bytes)


def _step_back() -> None:
    """To a lower priority, where this is not done when a process is started (on Windows)."""
    if sys.platform != "win32":
        os.nice(NICENESS)


def _say(**said: str) -> None:
    print(json.dumps(said), flush=True)


if __name__ == "__main__":
    sys.exit(main())
