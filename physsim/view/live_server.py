"""The server of a run that is watched: a process of its own, told by its stdin, looked at by browsers.

It listens on this machine only, under a path that nobody can guess, and answers only requests that name it as
their host, so that no other web site can reach it under a name of its own (DNS rebinding). It can be asked
for nothing but the page and the stream of its frames.

    /TOKEN/                 the page
    /TOKEN/frames?after=N   messages of `live_wire`: frames later than N as they come, then the end, and then
                            the page of the whole trajectory where frames were left out

Each browser has a thread, which waits for that browser alone.
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
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

from physsim.view.live_page import live_page, whole_page
from physsim.view.live_show import Show
from physsim.view.live_store import caught_up
from physsim.view.live_wire import Message, encoded, read

HOST = "127.0.0.1"
# Lower than that of the run, which comes first where processors are few.
NICENESS = 10
# When all is told: so long for a page that is on its way or slow.
LAST_SECONDS = 5.0
# A stream without frames says so often that it goes on, and finds out whether its reader does.
SECONDS_BETWEEN_SIGNS = 5.0
# A reader that takes nothing for so long is gone.
PATIENCE = 60.0

ALIVE = encoded(Message("alive"))
LOST = {"status": "failed", "detail": "the run ended without a word", "frames": 0}
HEADERS = {
    "Cache-Control": "no-store",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


class Server(ThreadingHTTPServer):
    """Serves one show under one token."""

    # Two programs may share a port on Windows when this is set; elsewhere it only spares waiting.
    allow_reuse_address = os.name == "posix"
    daemon_threads = True
    block_on_close = False

    def __init__(self, port: int, show: Show) -> None:
        """Raises OSError when the port is taken."""
        self.show = show
        self.token = secrets.token_urlsafe(16)
        super().__init__((HOST, port), Handler)

    @property
    def address(self) -> str:
        """Where the page is."""
        return f"http://{HOST}:{self.server_port}/{self.token}/"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that went away is no news."""


class Handler(BaseHTTPRequestHandler):
    """One request of a browser."""

    server: Server
    timeout = PATIENCE
    server_version = "physsim"
    sys_version = ""

    def do_GET(self) -> None:
        """The page, or the stream of its frames."""
        port = self.server.server_port
        asked = urlsplit(self.path)
        if self.headers.get("Host") not in {f"{HOST}:{port}", f"localhost:{port}"}:
            self._refuse(HTTPStatus.FORBIDDEN)
        elif asked.path == f"/{self.server.token}/":
            self._send_page()
        elif asked.path == f"/{self.server.token}/frames":
            self._send_frames(_number(asked.query))
        else:
            self._refuse(HTTPStatus.NOT_FOUND)

    def log_message(self, format: str, *args: Any) -> None:
        """Nobody reads a log of this."""

    def _send_page(self) -> None:
        page = self.server.show.visit()
        if page is None:
            self._refuse(HTTPStatus.GONE)
            return
        self._start(
            HTTPStatus.OK, {"Content-Type": "text/html; charset=utf-8", "Content-Length": str(len(page))}
        )
        self.wfile.write(page)

    def _send_frames(self, after: int) -> None:
        with self.server.show.stream() as room:
            if not room:
                self._refuse(HTTPStatus.SERVICE_UNAVAILABLE)
                return
            self._start(HTTPStatus.OK, {"Content-Type": "application/octet-stream"})
            self._follow(after)

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

    def _refuse(self, status: HTTPStatus) -> None:
        text = f"{status.value} {status.phrase}\n".encode()
        self._start(status, {"Content-Type": "text/plain", "Content-Length": str(len(text))})
        self.wfile.write(text)

    def _start(self, status: HTTPStatus, headers: dict[str, str]) -> None:
        self.send_response(status)
        for name, value in (HEADERS | headers).items():
            self.send_header(name, value)
        self.end_headers()


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
            seen = show.store.has_all(message.facts["frames"])
            show.finish(data, bytes if seen else partial(whole_page, file))
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
