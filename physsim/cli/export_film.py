"""`physsim export --to mp4|gif`: a film."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from physsim.cli.drawing import LOOKS, counted, look_of
from physsim.cli.export_format import END, FPS, SPEED, START, Format, Order
from physsim.cli.export_still import measures
from physsim.cli.verb import Example

if TYPE_CHECKING:
    from physsim.view.picture.show import Show
    from physsim.view.stage import FloatArray

USUAL_SIZE = {"mp4": (1280, 720), "gif": (480, 300)}
USUAL_FPS = {"mp4": 30.0, "gif": 20.0}
FASTEST = 240.0


def write_film(
    order: Order, *, fps: float | None, start: float | None, end: float | None, speed: float, **looks: Any
) -> str:
    """Pictures at an even rate."""
    from physsim.recording import open_trajectory
    from physsim.recording.whole_file import check_name
    from physsim.view.picture.film import film_times
    from physsim.view.picture.pillow import pillow
    from physsim.view.picture.show import Show

    rate = rate_of(order.format, fps)
    look = look_of(film_size(order.format, looks.pop("size")), size=None, **looks)
    check_name(order.target, force=order.force)
    pillow()
    with open_trajectory(order.file) as trajectory:
        times = film_times(trajectory.time, (start, end), rate, speed, order.format)
        show = Show(trajectory, look, (float(times[0]), float(times[-1])))
        save(order, show, times, rate)
    facts = f"{len(times)} pictures, {len(times) / float(rate):.3g} s"
    return f"{order.target}: {facts}, {measures(order.target, look.size)}"


def save(order: Order, show: Show, times: FloatArray, rate: Fraction) -> None:
    """Draw and write, picture by picture."""
    from physsim.view.picture.film import hundredths, some_of, write_gif, write_mp4

    pictures = counted(show.pictures(times, fine=False), len(times), "drawing")
    if order.format == "mp4":
        write_mp4(order.target, pictures, rate)
    else:
        sample = show.pictures(some_of(times), fine=False)
        write_gif(order.target, pictures, sample, hundredths(float(rate)))


def film_size(format: str, size: tuple[int, int] | None) -> tuple[int, int]:
    """The size asked for; of an MP4 both sides even."""
    from physsim.view.picture.film import even

    wanted = size or USUAL_SIZE[format]
    return even(wanted) if format == "mp4" else wanted


def rate_of(format: str, fps: float | None) -> Fraction:
    """Pictures a second: of a GIF the nearest that its clock knows."""
    from physsim.view.picture.film import GIF_CLOCK, hundredths

    wanted = USUAL_FPS[format] if fps is None else fps
    if wanted > FASTEST:
        raise click.UsageError(f"--fps: up to {FASTEST:g}, got {wanted:g}")
    if format == "gif":
        return Fraction(GIF_CLOCK, hundredths(wanted))
    return Fraction(wanted).limit_denominator(1001)


FILM = Format(
    names=("mp4", "gif"),
    write=write_film,
    options=(FPS, START, END, SPEED, *LOOKS),
    examples=(
        Example(
            "a film at a quarter of the speed: my_scene.mp4",
            "physsim export my_scene.h5 --to mp4 --speed 0.25 --until 0.2 --size 320x200",
        ),
        Example(
            "a small film for a web page, with the way of each body",
            "physsim export my_scene.h5 --to gif --show springs,trails --until 0.5 --size 240x150",
        ),
    ),
)
