"""Picking: what is clicked is what is meant, and what is then printed is what the file says."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
import pytest
from view_chromium import press, state
from view_pictures import canvas_pixels, center_of

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
WIDE = {"width": 1280, "height": 900}


@pytest.mark.parametrize("colour", ["red", "green", "blue"])
def test_a_click_on_a_body_selects_it(visit: Visit, colour: str) -> None:
    """Where the body is seen is found in the picture, by its colour: no camera is asked."""
    page = visit("balls")
    page.evaluate("window.physsim.seek(0.1)")
    page.mouse.click(*center_of(canvas_pixels(page), colour))
    assert state(page)["selected"] == f"{colour}_ball"
    assert page.get_by_role("heading", name=f"{colour}_ball").is_visible()


def test_a_click_on_nothing_deselects(visit: Visit) -> None:
    page = visit("balls")
    page.evaluate("window.physsim.select('red_ball')")
    box = page.locator("canvas").first.bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] - 5, box["y"] + 5)
    assert state(page)["selected"] is None


def test_turning_the_view_is_no_click(visit: Visit) -> None:
    page = visit("balls")
    x, y = center_of(canvas_pixels(page), "green")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 80, y + 10, steps=4)
    page.mouse.up()
    assert state(page)["selected"] is None


def test_the_list_finds_and_selects(visit: Visit) -> None:
    page = visit("machine", viewport=WIDE)
    press(page, "Bodies")
    page.get_by_role("searchbox", name="Search for a body").fill("SLED")
    page.get_by_role("listitem").get_by_role("button", name=re.compile("^sledge")).click()
    assert state(page)["selected"] == "sledge"
    page.keyboard.press("Escape")
    assert state(page)["selected"] is None


@pytest.mark.parametrize(
    ("scene", "body", "frame"), [("balls", "blue_ball", 37), ("offset", "slab", 20), ("machine", "bob", 44)]
)
def test_printed_numbers_equal_the_file(
    visit: Visit, show: Callable[[str], Any], scene: str, body: str, frame: int
) -> None:
    """To the last digit that is printed, and at least six decimals are."""
    page = visit(scene, viewport=WIDE)
    page.evaluate(
        "([body, frame]) => { physsim.select(body); physsim.step(frame) }",
        [body, frame],
    )
    page.get_by_text(f"at frame {frame + 1}", exact=True).wait_for()
    with h5py.File(show(scene).recording) as file:
        row = list(file["body"].asstr()).index(body)
        for title, name in (
            ("position m", "position"),
            ("orientation", "orientation"),
            ("velocity m/s", "velocity"),
            ("angular velocity rad/s", "angular_velocity"),
        ):
            printed = numbers_under(page, title)
            expected = file[name][frame, row]
            assert len(printed) == len(expected)
            for text, value in zip(printed, expected, strict=True):
                decimals = len(text.partition(".")[2])
                assert decimals >= 6, (title, text)
                assert abs(float(text) - value) <= 10.0**-decimals, (title, text, value)


def test_contacts_of_a_body_are_those_of_the_file(visit: Visit, show: Callable[[str], Any]) -> None:
    """At each tenth frame: whom the green ball touches, at how many points, with what force."""
    page = visit("balls", viewport=WIDE)
    page.evaluate("window.physsim.select('green_ball')")
    with h5py.File(show("balls").recording) as file:
        names = file["body"].asstr()[:]
        touched = 0
        for frame in range(0, 61, 10):
            page.evaluate("([t]) => physsim.seek(t)", [file["time"][frame]])
            page.get_by_text(f"at frame {frame + 1}", exact=True).wait_for()
            rows = slice(*file["contacts/offset"][frame : frame + 2])
            expected: dict[str, list[Any]] = {}
            for a, b, force in zip(
                *(file[f"contacts/{name}"][rows] for name in ("body_a", "body_b", "force")), strict=True
            ):
                ends = names[a], names[b]
                if "green_ball" in ends:
                    other = ends[1 - ends.index("green_ball")]
                    expected.setdefault(other, []).append(force)
            lines = page.locator(".card table tr").all_inner_texts()
            assert sorted(lines) == sorted(in_words(expected)), frame
            touched += len(expected)
        assert touched >= 5


def in_words(contacts: dict[str, list[Any]]) -> list[str]:
    """As the card prints them; the force is that of all points together, with four digits."""
    if not contacts:
        return ["touches nothing"]
    return [
        f"{other}\t{len(forces)} point{'s' if len(forces) > 1 else ''}\t{four_digits(np.sum(forces, axis=0))}"
        for other, forces in contacts.items()
    ]


def four_digits(force: np.ndarray) -> str:
    size = float(np.linalg.norm(force))
    return f"{size:#.4g}\N{NARROW NO-BREAK SPACE}N" if size else "0.000\N{NARROW NO-BREAK SPACE}N"


def numbers_under(page: Page, title: str) -> list[str]:
    """The numbers below a heading of the card, with the minus sign that programs read."""
    group = page.locator(".reading", has=page.get_by_role("heading", name=title, exact=True))
    texts = group.locator(".cell > :last-child").all_inner_texts()
    return [text.strip().replace("\N{MINUS SIGN}", "-") for text in texts]
