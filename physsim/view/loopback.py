"""What servers of pages have in common: only browsers of this machine reach them, and only on purpose.

They listen on the loopback device, and answer only requests that name it as their host, so that no web site
can reach them under a name of its own (DNS rebinding).
"""

from __future__ import annotations

import os
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import urlsplit

HOST = "127.0.0.1"
# A browser that takes nothing for so long [s] is gone.
PATIENCE = 60.0
HEADERS = {
    "Cache-Control": "no-store",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}
HTML = "text/html; charset=utf-8"


class LoopbackServer(ThreadingHTTPServer):
    """Each browser has a thread, which waits for that browser alone."""

    # Two programs may share a port on Windows when this is set; elsewhere it only spares waiting.
    allow_reuse_address = os.name == "posix"
    daemon_threads = True

    def __init__(self, port: int, handler: type[LoopbackHandler]) -> None:
        """port 0: any that is free. Raises OSError when the port is taken or not allowed."""
        super().__init__((HOST, port), handler)

    @property
    def address(self) -> str:
        """Of its root."""
        return f"http://{HOST}:{self.server_port}/"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that went away is no news."""


class LoopbackHandler(BaseHTTPRequestHandler):
    """One request; `answer` is called for those that are let in."""

    server: LoopbackServer
    timeout = PATIENCE
    server_version = "physsim"
    sys_version = ""

    def do_GET(self) -> None:
        """The answer, to who is let in."""
        port = self.server.server_port
        if self.headers.get("Host") in {f"{HOST}:{port}", f"localhost:{port}"}:
            asked = urlsplit(self.path)
            self.answer(asked.path, asked.query)
        else:
            self.refuse(HTTPStatus.FORBIDDEN)

    def answer(self, path: str, query: str) -> None:
        """What is there."""
        raise NotImplementedError

    def refuse(self, status: HTTPStatus) -> None:
        """Says why there is nothing."""
        self.send(status, "text/plain", [f"{status.value} {status.phrase}\n".encode()])

    def send(self, status: HTTPStatus, kind: str, parts: list[bytes]) -> None:
        """A whole answer."""
        self.start(status, {"Content-Type": kind, "Content-Length": str(sum(map(len, parts)))})
        self.wfile.writelines(parts)

    def start(self, status: HTTPStatus, headers: dict[str, str]) -> None:
        """The head of an answer."""
        self.send_response(status)
        for name, value in (HEADERS | headers).items():
            self.send_header(name, value)
        self.end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Nobody reads a log of this."""
