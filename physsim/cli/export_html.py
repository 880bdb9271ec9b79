"""`physsim export --to html`: the page of `physsim view`."""

from __future__ import annotations

from physsim.cli.export_format import Format, Order
from physsim.cli.verb import Example
from physsim.cli.view import MAX_SIZE, said, written


def write_page(order: Order, *, max_size: float) -> str:
    """One HTML file that plays the trajectory."""
    return said(order.target, written(order.file, order.target, max_size, force=order.force))


PAGE = Format(
    names=("html",),
    write=write_page,
    options=(MAX_SIZE,),
    examples=(
        Example("a page that plays it, as `physsim view` makes it", "physsim export my_scene.h5 --to html"),
    ),
)
