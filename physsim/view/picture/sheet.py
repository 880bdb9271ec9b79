"""Stills and contact sheets: pictures at chosen times."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from physsim.recording.whole_file import whole_file
from physsim.view.picture.pillow import pillow
from physsim.view.stage import FloatArray

GAP = 4
"""Pixels between the pictures of a sheet."""


def still_names(path: Path, times: Sequence[float]) -> list[Path]:
    """`path` for one time; NAME-0.500s.png for several: as many decimals as tell them apart, 3 to 9."""
    if len(times) == 1:
        return [path]
    for digits in range(3, 10):
        names = [path.with_name(f"{path.stem}-{time:.{digits}f}s{path.suffix}") for time in times]
        if len(set(names)) == len(names):
            break
    return names


def write_png(path: Path, picture: Any) -> None:
    """A Pillow image. Raises FileTrouble when it cannot be written."""
    with whole_file(path) as part:
        picture.save(part, format="PNG", optimize=True)


def even_times(first: float, last: float, count: int) -> FloatArray:
    """`count` times [s] from the first to the last, evenly."""
    return np.linspace(first, last, count)


def tile_size(size: tuple[int, int], columns: int) -> tuple[int, int]:
    """Pixels of each picture of a sheet that is as wide as `size`; each has the shape of `size`."""
    width = max(1, (size[0] - (columns - 1) * GAP) // columns)
    return width, max(1, round(width * size[1] / size[0]))


def sheet_of(pictures: Iterable[Any], columns: int, rows: int, tile: tuple[int, int]) -> Any:
    """The pictures in rows, from the upper left."""
    size = (columns * (tile[0] + GAP) - GAP, rows * (tile[1] + GAP) - GAP)
    sheet = pillow().new("RGB", size, "white")
    for number, picture in enumerate(pictures):
        row, column = divmod(number, columns)
        sheet.paste(picture, (column * (tile[0] + GAP), row * (tile[1] + GAP)))
    return sheet
