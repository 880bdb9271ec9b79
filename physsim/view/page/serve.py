"""A page served to the browsers of this machine, and nothing else."""

from __future__ import annotations

from http import HTTPStatus

from physsim.view.loopback import HTML, LoopbackHandler, LoopbackServer
from physsim.view.page.page import Page


class Server(LoopbackServer):
    """Serves one page at `address`."""

    def __init__(self, page: Page, port: int = 0) -> None:
        """port 0: any that is free. Raises OSError when the port is taken or not allowed."""
        self.page = page
        super().__init__(port, _Handler)


class _Handler(LoopbackHandler):
    server: Server

    def answer(self, path: str, query: str) -> None:
        """The page."""
        if path == "/":
            self.send(HTTPStatus.OK, HTML, self.server.page.parts)
        else:
            self.refuse(HTTPStatus.NOT_FOUND)
