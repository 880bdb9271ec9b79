"""Words in pictures: the time, the title, the grid's spacing, names at bodies, centres of mass."""

# ruff: noqa: PLC0415  Pillow is an extra

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from physsim.view.picture.camera import Camera
from physsim.view.picture.painter import Pixels
from physsim.view.picture.pillow import pillow
from physsim.view.stage import FloatArray

INK, HALO, FAINT, ALARM, LINK = (33, 41, 54), (255, 255, 255), (92, 102, 114), (190, 18, 18), (136, 34, 85)
LETTERS = 1 / 30
"""Height of letters over the height of the picture; never under SMALLEST pixels."""
SMALLEST = 11
LONGEST_TEXT = 80
MOST_BELOW = 30
Box = tuple[float, float, float, float]
"""Left, upper, right and lower edge [pixels]."""


@dataclass(frozen=True)
class Mark:
    """A word at a place (3) [m]; with the sign of a centre of mass when `massive`, with a ring around it when
    `wrong`; in the colour of joints and springs when `link`.
    """

    place: FloatArray
    text: str
    massive: bool = False
    wrong: bool = False
    link: bool = False


@dataclass(frozen=True)
class Caption:
    """time: lower left; scale: lower right; title: upper left; empty for none."""

    time: str = ""
    scale: str = ""
    title: str = ""
    marks: Sequence[Mark] = ()


def captioned(pixels: Pixels, camera: Camera, caption: Caption) -> Any:
    """A Pillow image: the picture with its words."""
    from PIL import ImageDraw

    image = pillow().fromarray(pixels)
    draw = ImageDraw.Draw(image)
    width, height = image.size
    size = max(SMALLEST, round(height * LETTERS))
    edge = round(0.8 * size)
    taken: list[Box] = []
    for mark in caption.marks:
        _mark(draw, camera, mark, max(SMALLEST - 1, round(0.75 * size)), taken)
    _write(draw, (edge, height - edge), caption.time, size, anchor="ls", ink=INK)
    _write(draw, (width - edge, height - edge), caption.scale, round(0.8 * size), anchor="rs", ink=FAINT)
    _write(draw, (edge, edge), caption.title, round(1.1 * size), anchor="lt", ink=INK)
    return image


def _short(text: str) -> str:
    """In one line, cut where it is too long."""
    plain = " ".join(text.split())
    return plain if len(plain) <= LONGEST_TEXT else plain[: LONGEST_TEXT - 1] + "…"


def _write(
    draw: Any, where: tuple[float, float], text: str, size: int, *, anchor: str, ink: tuple[int, ...]
) -> None:
    from PIL import ImageFont

    if text:
        draw.text(
            where,
            _short(text),
            font=ImageFont.load_default(size),
            fill=ink,
            anchor=anchor,
            stroke_width=max(1, size // 9),
            stroke_fill=HALO,
        )


def _mark(draw: Any, camera: Camera, mark: Mark, size: int, taken: list[Box]) -> None:
    """The sign at its place, and the word beside it, below those that are there already."""
    x, y, _ = camera.pixels(mark.place[None])[0]
    if not (np.isfinite(x) and np.isfinite(y)):
        return
    if mark.massive:
        _center_of_mass(draw, (x, y), 0.42 * size)
    if mark.wrong:
        box = (x - size, y - size, x + size, y + size)
        draw.ellipse(box, outline=ALARM, width=max(2, round(size / 6)))
    beside = 1.2 if mark.wrong else 0.6
    ink = ALARM if mark.wrong else LINK if mark.link else INK
    where = _free((x + beside * size, y - 0.35 * size), mark.text, size, taken)
    _write(draw, where, mark.text, size, anchor="ls", ink=ink)


def _free(where: tuple[float, float], text: str, size: int, taken: list[Box]) -> tuple[float, float]:
    """The nearest place below on which no word stands; it is taken then."""
    x, y = where
    width = 0.55 * size * min(len(text), LONGEST_TEXT)
    for _ in range(MOST_BELOW):
        over = [
            box for box in taken if x < box[2] and x + width > box[0] and y > box[1] and y - size < box[3]
        ]
        if not over or not text:
            break
        y = max(box[3] for box in over) + 1.05 * size
    taken.append((x, y - size, x + width, y))
    return x, y


def _center_of_mass(draw: Any, middle: tuple[float, float], radius: float) -> None:
    """The engineers' sign: a disc in four quarters."""
    x, y = middle
    box = (x - radius, y - radius, x + radius, y + radius)
    draw.ellipse(box, fill=HALO)
    draw.pieslice(box, 0, 90, fill=INK)
    draw.pieslice(box, 180, 270, fill=INK)
    draw.ellipse(box, outline=INK, width=max(1, round(radius / 5)))
