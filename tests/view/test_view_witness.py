"""The witness that judges every page: an unknown request or a complaint must not go unseen."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from view_chromium import Witness

if TYPE_CHECKING:
    from playwright.sync_api import Browser

QUIET = "<!doctype html><title>quiet</title><p>nothing"
LOUD = {
    "an image from elsewhere": ('<img src="http://example.invalid/a.png">', "elsewhere"),
    "a script that throws": ("<script>setTimeout(() => { throw new Error('no') })</script>", "complaints"),
    "a promise that nobody catches": ("<script>Promise.reject(new Error('no'))</script>", "complaints"),
    "an error on the console": ("<script>console.error('no')</script>", "complaints"),
    "a request for a neighbour": ('<link rel="stylesheet" href="other.css">', "complaints"),
}


def seen_of(browser: Browser, path: Path, text: str) -> Witness:
    """What the witness has seen once the page has been quiet for a while."""
    path.write_text(text)
    witness = Witness()
    context = browser.new_context()
    witness.watch(context)
    page = context.new_page()
    page.goto(path.as_uri())
    page.wait_for_timeout(300)
    context.close()
    return witness


@pytest.mark.parametrize("name", LOUD)
def test_what_a_page_must_not_do_is_seen(browser: Browser, tmp_path: Path, name: str) -> None:
    markup, kind = LOUD[name]
    assert getattr(seen_of(browser, tmp_path / "loud.html", QUIET + markup), kind)


def test_a_quiet_page_is_seen_as_quiet(browser: Browser, tmp_path: Path) -> None:
    seen = seen_of(browser, tmp_path / "quiet.html", QUIET)
    assert (seen.complaints, seen.elsewhere) == ([], [])
    assert seen.requests == [(tmp_path / "quiet.html").as_uri()]
