"""A real browser of this machine: where it is, how it is started, and what a page did in it.

Playwright only drives the browser; it never downloads one. Everything is drawn in software, so that pictures
do not depend on a graphics card, and no name is ever resolved, so that nothing can reach a network.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

PROGRAMS = (
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "chrome",
    "msedge",
)
FLAGS = (
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--force-color-profile=srgb",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
)
PATIENCE = 60_000
"""Milliseconds until something that does not come counts as missing; machines that test are busy ones."""


def find_browser() -> str | None:
    """The program of PHYSSIM_BROWSER, or the first of PROGRAMS on this machine; None when there is none."""
    wanted = os.environ.get("PHYSSIM_BROWSER")
    return next((found for name in ([wanted] if wanted else PROGRAMS) if (found := shutil.which(name))), None)


@contextmanager
def started(program: str) -> Iterator[Browser]:
    """The browser, headless, until the block ends.

    While it runs, Playwright leaves its event loop marked as running in this thread: nothing else in the
    thread may start one of its own.
    """
    from playwright.sync_api import sync_playwright  # noqa: PLC0415, in the extra `test`, not needed to skip

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=list(FLAGS), timeout=PATIENCE)
        try:
            yield browser
        finally:
            browser.close()


@dataclass
class Witness:
    """What pages asked for and complained about: addresses requested, and console warnings and errors."""

    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)

    def watch(self, context: BrowserContext) -> None:
        """Listens to every page of a context, from its first request on."""
        context.on("request", lambda request: self.requests.append(request.url))
        context.on("console", lambda said: self.hear(said.type, said.text))
        context.on("weberror", lambda error: self.complaints.append(f"uncaught: {error.error}"))

    def hear(self, kind: str, text: str) -> None:
        if kind in {"error", "warning"} and not text.startswith(NOISE):
            self.complaints.append(f"{kind}: {text}")

    @property
    def elsewhere(self) -> list[str]:
        """Requests that left the page: all but files, and what the page itself made (data, blob)."""
        return [url for url in self.requests if not url.startswith(("file:", "data:", "blob:"))]


NOISE = ("[.WebGL-", "[GroupMarkerNotSet")
"""Remarks of the software renderer about its own speed (GPU stall due to ReadPixels)."""


def state(page: Page) -> dict[str, Any]:
    """`window.physsim.state()`."""
    found: dict[str, Any] = page.evaluate("window.physsim.state()")
    return found


def press(page: Page, name: str) -> None:
    """Clicks the button of this name."""
    page.get_by_role("button", name=name, exact=True).click()


def until(page: Page, true: str) -> None:
    """Waits until an expression is true. Playwright's own way needs `eval`, which the page forbids."""
    look = f"const look = () => ({true}) ? done() : setTimeout(look, 20)"
    page.evaluate(f"new Promise(done => {{ {look}; look(); }})")
