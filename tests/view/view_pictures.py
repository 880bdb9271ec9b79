"""Pictures compared as a person would compare them from afar: by the mean colour of blocks."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

if TYPE_CHECKING:
    from playwright.sync_api import Page

SETTLED = 300
"""Milliseconds until a picture that was asked for is there; `still` waits for longer ones."""


def pixels(png: bytes) -> np.ndarray:
    """(rows, columns, 3) of a picture, 0 to 255."""
    with Image.open(io.BytesIO(png)) as image:
        return np.asarray(image.convert("RGB"), float)


def block_means(picture: np.ndarray, side: int) -> np.ndarray:
    """(rows / side, columns / side, 3): the mean colour of each block of side x side pixels."""
    rows, columns = picture.shape[0] // side, picture.shape[1] // side
    cut = picture[: rows * side, : columns * side]
    return cut.reshape(rows, side, columns, side, 3).mean(axis=(1, 3))


def difference(first: np.ndarray, second: np.ndarray, side: int = 20) -> float:
    """The largest difference of any colour of any block, 0 to 255."""
    return float(np.abs(block_means(first, side) - block_means(second, side)).max())


def center_of(picture: np.ndarray, colour: str) -> tuple[float, float]:
    """Middle (x, y) [pixels] of what shows a strong "red", "green" or "blue"."""
    wanted = ("red", "green", "blue").index(colour)
    others = np.delete(picture, wanted, axis=2).max(axis=2)
    rows, columns = np.nonzero(picture[..., wanted] > 60 + 1.6 * others)
    assert len(rows) > 20, f"nothing {colour} is seen"
    return float(np.median(columns)), float(np.median(rows))


def canvas_pixels(page: Page) -> np.ndarray:
    """The picture of the page without the legend; what is no part of the drawing is made grey."""
    page.get_by_role("group", name="What the picture means", include_hidden=True).evaluate(
        "it => { it.style.visibility = 'hidden' }"
    )
    whole = pixels(page.screenshot())
    box = page.locator("canvas").first.bounding_box()
    assert box is not None
    inside = np.full_like(whole, 128.0)
    rows = slice(int(box["y"]), int(box["y"] + box["height"]))
    columns = slice(int(box["x"]), int(box["x"] + box["width"]))
    inside[rows, columns] = whole[rows, columns]
    return inside


def still(page: Page) -> np.ndarray:
    """The picture once two in a row are the same."""
    before = canvas_pixels(page)
    for _ in range(50):
        page.wait_for_timeout(SETTLED)
        now = canvas_pixels(page)
        if (now == before).all():
            return now
        before = now
    raise AssertionError("the picture does not come to rest")
