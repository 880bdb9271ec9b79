"""`physsim export --to png`: pictures at chosen times, or many on one sheet."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from physsim.cli.drawing import LOOKS, counted, look_of
from physsim.cli.export_format import END, START, Format, Order
from physsim.cli.verb import Example

if TYPE_CHECKING:
    from physsim.recording import Trajectory
    from physsim.view.picture.show import Look
    from physsim.view.stage import FloatArray

USUAL_SIZE = (1280, 720)
MOST_TILES = 400


class Times(click.ParamType[tuple[float, ...]]):
    """`0.5s,1s`, `0.5,1` or `all`."""

    name = "times"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[float, ...]:
        """In seconds; none for `all`."""
        from physsim.scene.units import PLAIN, UnitError, parse_measure, parse_unit, same

        if isinstance(value, tuple) or value == "all":
            return value if isinstance(value, tuple) else ()
        times, second = [], parse_unit("s").dimension
        for part in str(value).split(","):
            try:
                measure = parse_measure(part.strip())
            except UnitError as error:
                self.fail(f"{part.strip()!r} is no time: {error}", param, ctx)
            if not any(same(measure.dimension, allowed) for allowed in (PLAIN, second)):
                self.fail(f"{part.strip()!r} is no time", param, ctx)
            times.append(measure.value)
        return tuple(times)


class Grid(click.ParamType[tuple[int, int]]):
    """`4x3`."""

    name = "grid"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """Columns and rows."""
        if isinstance(value, tuple):
            return value
        columns, _, rows = str(value).lower().partition("x")
        if not (columns.isdecimal() and rows.isdecimal() and int(columns) and int(rows)):
            self.fail(f"{value!r} is no sheet; write 4x3, columns and rows", param, ctx)
        if int(columns) * int(rows) > MOST_TILES:
            self.fail(f"a sheet holds up to {MOST_TILES} pictures, not {value}", param, ctx)
        return int(columns), int(rows)


AT = click.Option(
    ["--at", "moments"],
    type=Times(),
    metavar="TIME,...",
    help="The times of the pictures (0.5s,1s), one file each, or all for every frame. Default: the end.",
)
SHEET = click.Option(
    ["--sheet", "grid"],
    type=Grid(),
    metavar="COLUMNSxROWS",
    help="One sheet of pictures at even distances in time; --size is the width of the sheet, and the shape "
    "of each picture.",
)


def write_stills(
    order: Order,
    *,
    moments: tuple[float, ...] | None,
    grid: tuple[int, int] | None,
    start: float | None,
    end: float | None,
    **looks: Any,
) -> str:
    """A file for each time, or a sheet."""
    from physsim.recording import open_trajectory
    from physsim.view.picture.pillow import pillow

    if moments is not None and grid is not None:
        raise click.UsageError("--at chooses the times, --sheet takes them evenly; give one of them")
    look = look_of(USUAL_SIZE, **looks)
    pillow()
    with open_trajectory(order.file) as trajectory:
        if grid is not None:
            return write_sheet(order, trajectory, look, grid, (start, end))
        return write_each(order, trajectory, look, chosen_times(trajectory, moments, start, end))


def chosen_times(
    trajectory: Trajectory, moments: tuple[float, ...] | None, start: float | None, end: float | None
) -> FloatArray:
    """The times [s] that the options ask for. click.UsageError for one outside of the frames."""
    import numpy as np

    from physsim.view.clip import clip_of

    known = clip_of(trajectory, start, end).times
    if moments is None:
        return known[-1:]
    wanted = np.unique(moments) if moments else known
    if wanted[0] < known[0] or wanted[-1] > known[-1]:
        raise click.UsageError(
            f"--at: times must be within {known[0]:g} s to {known[-1]:g} s, the frames of the trajectory"
        )
    return wanted


def write_each(order: Order, trajectory: Trajectory, look: Look, times: FloatArray) -> str:
    """One file for each time."""
    from physsim.recording.whole_file import check_name
    from physsim.view.picture.sheet import still_names, write_png
    from physsim.view.picture.show import Show

    names = still_names(order.target, times.tolist())
    for name in names:
        check_name(name, force=order.force)
    show = Show(trajectory, look, whole_span(trajectory))
    for name, picture in zip(names, counted(show.pictures(times), len(names), "drawing"), strict=True):
        write_png(name, picture)
    return "\n".join(f"{name}: {measures(name, look.size)}" for name in names)


def write_sheet(
    order: Order,
    trajectory: Trajectory,
    look: Look,
    grid: tuple[int, int],
    span: tuple[float | None, float | None],
) -> str:
    """One file."""
    from dataclasses import replace

    from physsim.recording.whole_file import check_name
    from physsim.view.clip import clip_of
    from physsim.view.picture.sheet import even_times, sheet_of, tile_size, write_png
    from physsim.view.picture.show import Show

    check_name(order.target, force=order.force)
    known = clip_of(trajectory, *span).times
    times = even_times(float(known[0]), float(known[-1]), grid[0] * grid[1])
    tile = tile_size(look.size, grid[0])
    show = Show(trajectory, replace(look, size=tile), (float(known[0]), float(known[-1])))
    sheet = sheet_of(counted(show.pictures(times), len(times), "drawing"), *grid, tile)
    write_png(order.target, sheet)
    return f"{order.target}: {len(times)} pictures, {measures(order.target, sheet.size)}"


def whole_span(trajectory: Trajectory) -> tuple[float, float]:
    """First and last time [s]: the camera is the same for all stills of a trajectory."""
    return float(trajectory.time[0]), float(trajectory.time[-1])


def measures(path: Path, size: tuple[int, int]) -> str:
    """`1280x720, 210 kB`."""
    from physsim.recording.target import in_words

    return f"{size[0]}x{size[1]}, {in_words(path.stat().st_size)}"


STILL = Format(
    names=("png",),
    write=write_stills,
    options=(AT, SHEET, START, END, *LOOKS),
    examples=(
        Example(
            "pictures at two times: my_scene-0.200s.png, my_scene-0.500s.png",
            "physsim export my_scene.h5 --to png --at 0.2s,0.5s --size 640x400",
        ),
        Example(
            "twelve pictures on one sheet, with contact forces",
            "physsim export my_scene.h5 --to png --sheet 4x3 --show contacts,springs -o sheet.png",
        ),
    ),
)
