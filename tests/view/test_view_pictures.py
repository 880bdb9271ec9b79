"""Known scenes look as they looked when somebody last looked at them.

The pictures in tests/view/pictures are renewed, and then looked at, by

    PHYSSIM_NEW_PICTURES=1 python -m pytest tests/view/test_view_pictures.py

Only the drawing is compared, not the letters around it (fonts differ between machines), by the mean colour of
blocks of 20 x 20 pixels of the page: edges of a pixel, which differ between browsers, do not count.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from PIL import Image
from view_pictures import block_means, difference, still

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
PICTURES = Path(__file__).parent / "pictures"
SIZE = {"width": 640, "height": 480}
HALF = 2
"""They are kept at half the size, to be small."""
BLOCK = 20 // HALF
TOLERANCE = 12.0
"""Of 255. Measured: 0.0 between two runs, 18.2 for a ball that is moved by a tenth of its radius."""

VIEWS = {
    "balls": ("balls", 0.2, "", "light"),
    "balls_contacts_trails": ("balls", 0.45, "ctt", "light"),
    "offset": ("offset", 0.3, "mb", "light"),
    "machine": ("machine", 0.25, "", "light"),
    "machine_dark": ("machine", 0.5, "w", "dark"),
}
"""Name: scene, time [s], keys that are pressed, light or dark."""


def shot(visit: Visit, scene: str, time: float, keys: str, scheme: str) -> np.ndarray:
    page = visit(scene, viewport=SIZE, color_scheme=scheme)
    page.evaluate("time => physsim.seek(time)", time)
    for key in keys:
        page.keyboard.press(key)
    return block_means(still(page), HALF)


@pytest.mark.parametrize("name", VIEWS)
def test_a_known_scene_looks_as_it_did(visit: Visit, name: str) -> None:
    path = PICTURES / f"{name}.png"
    seen = shot(visit, *VIEWS[name])
    if os.environ.get("PHYSSIM_NEW_PICTURES"):
        PICTURES.mkdir(exist_ok=True)
        Image.fromarray(np.rint(seen).astype(np.uint8)).save(path, optimize=True)
    with Image.open(path) as image:
        known = np.asarray(image.convert("RGB"), float)
    assert seen.shape == known.shape
    assert difference(seen, known, BLOCK) < TOLERANCE


def test_the_comparison_sees_a_ball_that_is_elsewhere(visit: Visit) -> None:
    """5 ms later the red ball has fallen by about a tenth of its radius: that is told from no change."""
    first, again, later = (shot(visit, "balls", time, "", "light") for time in (0.2, 0.2, 0.205))
    assert difference(first, again, BLOCK) < 1
    assert difference(first, later, BLOCK) > TOLERANCE
