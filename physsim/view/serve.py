"""A page served to the browsers of this machine.

The server listens on the loopback device only. It answers only requests that name it as their host, so that
no web site can reach it under a name of its own (DNS rebinding), and it has nothing but the page.
"""

from __future__ import annotations

import os
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from physsim.view.page import Page

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


class Server(ThreadingHTTPServer):
    """Serves one page at `address`."""

    # Two programs may share a port on Windows when this is set; elsewhere it only spares waiting.
    allow_reuse_address = os.name == "posix"
    daemon_threads = True

    def __init__(self, page: Page, port: int = 0) -> None:
        """port 0: any that is free. Raises OSError when the port is taken or not allowed."""
        self.page = page
        super().__init__((HOST, port), _Handler)

    @property
    def address(self) -> str:
        return f"http://{HOST}:{self.server_port}/"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that went away is no news."""


class _Handler(BaseHTTPRequestHandler):
    server: Server
    timeout = PATIENCE
    server_version = "physsim"
    sys_version = ""

    def do_GET(self) -> None:
        """The page, or why not."""
        refusal = self._refusal()
        if refusal is not None:
            self._send(refusal, "text/plain", [f"{refusal.value} {refusal.phrase}\n".encode()])
            return
        self._send(HTTPStatus.OK, "text/html; charset=utf-8", self.server.page.parts)

    def log_message(self, format: str, *args: Any) -> None:
        """Nobody reads a log of this."""

    def _refusal(self) -> HTTPStatus | None:
        port = self.server.server_port
        if self.headers.get("Host") not in {f"{HOST}:{port}", f"localhost:{port}"}:
            return HTTPStatus.FORBIDDEN
        return None if self.path.partition("?")[0] == "/" else HTTPStatus.NOT_FOUND

    def _send(self, status: HTTPStatus, kind: str, parts: list[bytes]) -> None:
        self.send_response(status)
        for name, value in HEADERS.items():
            self.send_header(name, value)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(sum(map(len, parts))))
        self.end_headers()
        self.wfile.writelines(parts)
