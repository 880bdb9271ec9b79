"""Pages in a real browser: started once for each file of tests, and closed before the next file begins."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from view_chromium import PATIENCE, Witness, find_browser, started

from physsim.cli.app import answer

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

SCENES = Path(__file__).parent / "scenes"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """A headless Chromium, Chrome or Edge of this machine.

    Skips where there is none, or fails when PHYSSIM_NEED_BROWSER=1. Per file, not per session: see `started`.
    """
    program = find_browser()
    if program is None:
        reason = (
            f"no browser: PHYSSIM_BROWSER={os.environ['PHYSSIM_BROWSER']} is not a program"
            if os.environ.get("PHYSSIM_BROWSER")
            else "no Chromium, Chrome or Edge here (apt-get install chromium, or set PHYSSIM_BROWSER)"
        )
        if os.environ.get("PHYSSIM_NEED_BROWSER") == "1":
            pytest.fail(reason)
        pytest.skip(reason)
    with started(program) as running:
        yield running


@dataclass(frozen=True)
class Show:
    """A run of a scene: its trajectory, and the page that plays it."""

    recording: Path
    page: Path


@pytest.fixture(scope="session")
def show(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Show]:
    """`show("balls")`: the scene of that name, run and turned into a page once per process."""
    folder = tmp_path_factory.mktemp("shows")
    shutil.copytree(SCENES, folder, dirs_exist_ok=True)

    def make(name: str) -> Show:
        made = Show(folder / f"{name}.h5", folder / f"{name}.html")
        if not made.page.exists():
            assert answer(["run", str(folder / f"{name}.yaml"), "-o", str(made.recording), "--quiet"]) == 0
            assert answer(["view", str(made.recording), "-o", str(made.page)]) == 0
        return made

    return make


@pytest.fixture
def visit(browser: Browser, show: Callable[[str], Show]) -> Iterator[Callable[..., Page]]:
    """`visit("balls")` opens the page of a scene, paused at its start; further options are Playwright's own.

    When the test is over, no page may have asked for anything but itself or complained of anything.
    """
    contexts, witness, pages = [], Witness(), []

    def go(name: str, **options: Any) -> Page:
        context = browser.new_context(**{"viewport": {"width": 900, "height": 600}} | options)
        contexts.append(context)
        context.set_default_timeout(PATIENCE)
        witness.watch(context)
        page = context.new_page()
        pages.append(show(name).page.as_uri())
        page.goto(pages[-1])
        page.evaluate("window.physsim.ready")
        page.evaluate("(window.physsim.pause(), window.physsim.seek(0))")
        return page

    yield go
    for context in contexts:
        context.close()
    assert witness.complaints == []
    own = ("data:", "blob:", *pages)
    assert [url for url in witness.requests if not url.startswith(own)] == []
