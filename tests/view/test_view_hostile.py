"""Names are text: a scene in which every name tries to run a script stays a scene with strange names.

A script that runs sets `window.struck`; one that is stopped by the page's own rule against foreign scripts
makes a complaint, and fails the test just so (`visit`).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import h5py
import pytest
from PIL import Image
from view_chromium import press

from physsim.cli.app import answer

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
WIDE = {"width": 1280, "height": 900}


@pytest.fixture
def names(show: Callable[[str], Any]) -> dict[str, list[str]]:
    """Names of bodies, joints and springs, as the file has them."""
    with h5py.File(show("hostile").recording) as file:
        paths = {"bodies": "body", "joints": "joints/joint", "springs": "springs/spring"}
        return {group: list(file[path].asstr()) for group, path in paths.items()}


def assert_harmless(page: Page) -> None:
    assert page.evaluate("typeof window.struck") == "undefined"
    assert page.locator("img, iframe, object, embed, [onload], [onerror], [onmouseover]").count() == 0
    assert [
        text for text in page.locator("script").all_inner_texts() if text.startswith("window.struck")
    ] == []


def test_names_stand_in_the_list_as_text(visit: Visit, names: dict[str, list[str]]) -> None:
    page = visit("hostile", viewport=WIDE)
    press(page, "Bodies")
    for group in names.values():
        for name in group:
            page.locator("li button").filter(has=page.get_by_text(name, exact=True)).first.wait_for()
    assert_harmless(page)


def test_the_title_is_text(visit: Visit, show: Callable[[str], Any]) -> None:
    with h5py.File(show("hostile").recording) as file:
        title = file.attrs["title"]
    page = visit("hostile")
    assert title in page.title()
    assert page.get_by_role("heading", level=1).inner_text() == title
    press(page, "About")
    page.get_by_role("definition").filter(has_text=title).wait_for()
    assert_harmless(page)


def test_every_body_can_be_picked_named_and_plotted(visit: Visit, names: dict[str, list[str]]) -> None:
    page = visit("hostile", viewport=WIDE)
    page.keyboard.press("n")
    for name in names["bodies"]:
        page.evaluate("name => physsim.select(name)", name)
        assert page.evaluate("physsim.state().selected") == name
        assert page.get_by_role("heading", level=3).first.inner_text() == name
    page.get_by_role("button", name="Plot position").click()
    page.get_by_role("searchbox", name="Search for a quantity").fill("script")
    page.wait_for_timeout(200)
    page.evaluate("physsim.seek(0.1)")
    page.mouse.move(640, 400)
    assert_harmless(page)


def test_joints_and_springs_are_shown_by_name(visit: Visit, names: dict[str, list[str]]) -> None:
    page = visit("hostile", viewport=WIDE)
    press(page, "Bodies")
    for name in (*names["joints"], *names["springs"]):
        page.locator("li button").filter(has=page.get_by_text(name, exact=True)).click()
        assert page.get_by_role("heading", level=3).first.inner_text() == name
        page.keyboard.press("Escape")
    assert_harmless(page)


def test_a_body_that_is_not_there_is_told_from_one_that_is(visit: Visit) -> None:
    """`constructor` and `toString` are on every object of the language, but not in the scene."""
    page = visit("hostile")
    for name in ("constructor", "toString", "no such body"):
        message = page.evaluate(
            "name => { try { physsim.select(name) } catch (e) { return e.message } }", name
        )
        assert name in message


def test_a_picture_of_the_scene(show: Callable[[str], Any], tmp_path: Path) -> None:
    scene = show("hostile").recording.with_suffix(".yaml")
    assert answer(["info", str(scene), "--picture", str(tmp_path / "scene.png")]) == 0
    with Image.open(tmp_path / "scene.png") as image:
        assert image.size[0] > 100


def test_a_drawn_plot(show: Callable[[str], Any], names: dict[str, list[str]], tmp_path: Path) -> None:
    """An SVG is read by browsers as well: it holds no script and no handler."""
    target = tmp_path / "plot.svg"
    body = next(name for name in names["bodies"] if name.startswith("<!--"))
    recording = str(show("hostile").recording)
    assert answer(["plot", recording, f"bodies.{body}.position.z", "-o", str(target)]) == 0
    for part in ElementTree.parse(target).iter():
        assert not part.tag.endswith(("script", "foreignObject"))
        assert not [name for name in part.attrib if name.startswith("on")]
