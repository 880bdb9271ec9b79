"""Pictures compared as a person would compare them from afar: by the mean colour of blocks."""

from __future__ import annotations

import io

import numpy as np
from PIL import Image


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
