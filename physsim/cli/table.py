"""Plain text tables: columns as wide as their widest cell, numbers to the right."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest

import click


def table(head: Sequence[str], rows: Sequence[Sequence[str]], *, right: Sequence[int] = ()) -> str:
    """Head and rows, two spaces between columns; the columns numbered in `right` are set to the right."""
    widths = [max(len(cell) for cell in column) for column in zip_longest(head, *rows, fillvalue="")]
    lines = [_line(row, widths, right) for row in (head, *rows)]
    return "\n".join([click.style(lines[0], bold=True), *lines[1:]])


def number(value: float | None, digits: int = 4) -> str:
    """A number in few digits; a dash for what is not known."""
    return "-" if value is None else f"{value:.{digits}g}"


def vector(values: Sequence[float], digits: int = 4) -> str:
    """`[0, 0, 0.05]`"""
    return f"[{', '.join(number(value, digits) for value in values)}]"


def place(values: Sequence[float]) -> str:
    """A point in metres, to the nanometre: what is smaller is the dust of rounding."""
    return vector([round(value, 9) + 0.0 for value in values])


def direction(values: Sequence[float]) -> str:
    """A unit vector in three decimals, without the dust of rounding: `[0, 0.707, -0.707]`."""
    return vector([round(value, 3) + 0.0 for value in values])


def _line(cells: Sequence[str], widths: Sequence[int], right: Sequence[int]) -> str:
    padded = [
        cell.rjust(width) if k in right else cell.ljust(width)
        for k, (cell, width) in enumerate(zip(cells, widths, strict=False))
    ]
    return "  ".join(padded).rstrip()
