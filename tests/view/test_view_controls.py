"""What can be switched on and off is seen, or is no longer seen, in the picture."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
import pytest
from view_chromium import press, state, until
from view_pictures import SETTLED, block_means, canvas_pixels, center_of, difference, pixels, still

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
WIDE = {"width": 1280, "height": 720}


@pytest.mark.parametrize(
    ("scene", "key"),
    [("balls", "w"), ("balls", "g"), ("balls", "a"), ("balls", "n"), ("machine", "s"), ("machine", "j")],
)
def test_a_key_shows_and_hides(visit: Visit, scene: str, key: str) -> None:
    """Wireframe, grid, axes, names, springs, joints: another picture, and the first one again."""
    page = visit(scene)
    first = still(page)
    page.keyboard.press(key)
    changed = still(page)
    assert difference(first, changed) > 3
    page.keyboard.press(key)
    assert difference(first, still(page)) < 0.5


def test_contact_arrows(visit: Visit) -> None:
    """Only in frames with contacts: nothing has touched anything at the declared state."""
    page = visit("balls")
    plain, touching = still(page), (page.evaluate("physsim.seek(0.1)"), still(page))[1]
    page.keyboard.press("c")
    assert difference(touching, still(page)) > 3
    page.evaluate("physsim.seek(0)")
    assert difference(plain, still(page)) < 0.5


def test_trails_show_where_a_body_has_been(visit: Visit) -> None:
    """The red ball falls from 60 cm: its trail changes the picture above it, where it was at first."""
    page = visit("balls")
    page.evaluate("physsim.select('red_ball')")
    start = center_of(still(page), "red")
    page.evaluate("physsim.seek(0.3)")
    without = still(page)
    page.keyboard.press("t")
    with_trail = still(page)
    assert near(without, with_trail, start) > 8
    page.evaluate("physsim.seek(0)")
    page.evaluate("physsim.seek(0.3)")
    assert difference(with_trail, still(page)) < 0.5


def near(first: np.ndarray, second: np.ndarray, place: tuple[float, float], reach: int = 12) -> float:
    """The largest difference of any pixel around a place."""
    x, y = map(int, place)
    window = slice(max(0, y - reach), y + reach), slice(max(0, x - reach), x + reach)
    return float(np.abs(first[window] - second[window]).max())


def test_the_camera_follows_a_body(visit: Visit) -> None:
    """It falls by half a metre, about 100 pixels; followed, it stays where it is in the picture."""
    moved = {}
    for followed in (False, True):
        page = visit("balls")
        page.evaluate("physsim.select('red_ball')")
        if followed:
            page.keyboard.press("f")
        before = center_of(still(page), "red")
        page.evaluate("physsim.seek(0.3)")
        moved[followed] = np.hypot(*np.subtract(center_of(still(page), "red"), before))
    assert moved[False] > 40
    assert moved[True] < 3


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_light_and_dark_follow_the_system(visit: Visit, scheme: str) -> None:
    page = visit("balls", color_scheme=scheme, viewport=WIDE)
    lightness = pixels(page.screenshot()).mean()
    assert lightness > 190 if scheme == "light" else lightness < 60


def test_light_or_dark_can_be_chosen(visit: Visit) -> None:
    page = visit("balls", color_scheme="light", viewport=WIDE)
    press(page, "Show")
    page.get_by_role("radio", name="Dark").check(force=True)
    page.wait_for_timeout(SETTLED)
    assert pixels(page.screenshot()).mean() < 60


def test_colours_by_speed(visit: Visit) -> None:
    """At the start the red ball rests and the blue one flies: they get different colours of one scale."""
    page = visit("balls")
    places = [center_of(still(page), colour) for colour in ("red", "blue")]
    page.keyboard.press("v")
    picture = still(page)
    red, blue = (picture[int(y), int(x)] for x, y in places)
    assert red[0] < 1.6 * red[2]
    assert np.abs(red - blue).max() > 30


def test_a_plot_tells_the_value_at_the_cursor(visit: Visit, show: Callable[[str], Any]) -> None:
    page = visit("balls", viewport=WIDE)
    page.evaluate("physsim.seek(0.2)")
    with h5py.File(show("balls").recording) as file:
        expected = file["energy/kinetic_rotational"][20]
    row = page.get_by_role("listitem").filter(has_text="kinetic rotational")
    row.get_by_text(f"{expected:.5g}").wait_for()


def test_a_click_in_a_plot_goes_to_that_time(visit: Visit) -> None:
    page = visit("balls", viewport=WIDE)
    plot = page.get_by_role("img", name="energy")
    box = plot.bounding_box()
    assert box is not None
    times = []
    for share in (0.4, 0.8):
        page.mouse.click(box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        times.append(state(page)["time"])
    # 0.6 s are a little less than the whole width, the rest are numbers of the axis.
    assert times[1] - times[0] == pytest.approx(0.4 * 0.6, rel=0.25)


def test_any_quantity_can_be_plotted(visit: Visit, show: Callable[[str], Any]) -> None:
    page = visit("balls", viewport=WIDE)
    page.get_by_role("searchbox", name="Search for a quantity").fill("blue position")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.get_by_role("region", name="blue_ball").wait_for()
    page.evaluate("physsim.seek(0.3)")
    with h5py.File(show("balls").recording) as file:
        x = file["position"][30, list(file["body"].asstr()).index("blue_ball"), 0]
    page.get_by_role("region", name="blue_ball").get_by_text(f"{x:.4f}").wait_for()


def test_names_stand_beside_their_bodies(visit: Visit) -> None:
    """Also after a panel has moved the drawing: the names then are where a new picture puts them."""
    page = visit("balls", viewport=WIDE)
    page.keyboard.press("n")
    still(page)
    press(page, "About")
    still(page)
    before = places_of_names(page)
    page.keyboard.press("g")
    still(page)
    assert np.abs(np.subtract(before, places_of_names(page))).max() < 1


def places_of_names(page: Page) -> list[tuple[float, float]]:
    boxes = [
        page.locator(".labels").get_by_text(f"{colour}_ball").bounding_box() for colour in ("red", "blue")
    ]
    return [(box["x"], box["y"]) for box in boxes if box]


def test_a_phone(visit: Visit) -> None:
    """390 x 844, fingers only: nothing is wider than the screen, a tap picks, buttons can be hit."""
    page = visit("balls", viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    page.evaluate("physsim.seek(0.1)")
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.touchscreen.tap(*center_of(still(page), "green"))
    until(page, "physsim.state().selected === 'green_ball'")
    small = [
        (button.get_attribute("aria-label"), box)
        for button in page.locator("button:visible").all()
        if (box := button.bounding_box()) and min(box["width"], box["height"]) < 24
    ]
    assert small == []  # 24 x 24 pixels: WCAG 2.2, 2.5.8
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    picture = block_means(canvas_pixels(page), 20)
    assert picture.std() > 5
