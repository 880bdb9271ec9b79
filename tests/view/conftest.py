"""Pages in a real browser: started once for each file of tests, and closed before the next file begins."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from view_chromium import find_browser, started

if TYPE_CHECKING:
    from playwright.sync_api import Browser


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
