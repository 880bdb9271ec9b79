"""Films: pictures of a trajectory at an even rate, as MP4 (H.264) or GIF."""

# ruff: noqa: PLC0415  PyAV is an extra

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from physsim.errors import FileTrouble
from physsim.recording.whole_file import whole_file
from physsim.view.picture.pillow import missing, pillow
from physsim.view.stage import FloatArray

MOST_FRAMES = {"mp4": 100_000, "gif": 1_500}
QUALITY = "20"
"""Constant rate factor of x264: 18 cannot be told from the original, 23 is its default."""
GIF_CLOCK = 100
"""A GIF counts hundredths of a second; browsers slow down what stands for less than two of them."""
LEAST_HUNDREDTHS = 2
COLOURS = 255
"""Of a GIF; one more is kept for pixels that stay as they were."""
PALETTE_PICTURES = 6


def film_times(
    known: FloatArray, span: tuple[float | None, float | None], fps: Fraction, speed: float, kind: str
) -> FloatArray:
    """The times [s] of the film's pictures, `speed` simulated seconds in each second of the film.

    known: the times of the frames; span: from and until; kind: mp4 or gif. Raises FileTrouble when no frame
    is in the span, or the film would be too long.
    """
    start, end = span
    first = max(-np.inf if start is None else start, known.min(initial=np.inf))
    last = min(np.inf if end is None else end, known.max(initial=-np.inf))
    if first > last:
        raise FileTrouble("the trajectory has no frames in that span of time")
    step = speed / float(fps)
    count = int(np.floor((last - first) / step * (1 + 1e-12))) + 1
    if count > MOST_FRAMES[kind]:
        raise FileTrouble(
            f"the film would have {count} pictures, more than {MOST_FRAMES[kind]}; --speed makes it "
            "shorter, and --from and --until choose a part"
        )
    return np.asarray(np.minimum(first + np.arange(count) * step, last))


def even(size: tuple[int, int]) -> tuple[int, int]:
    """H.264 halves the resolution of colours: width and height of a film are even."""
    return size[0] + size[0] % 2, size[1] + size[1] % 2


def write_mp4(path: Path, pictures: Iterable[Any], fps: Fraction) -> None:
    """Pillow images of one even size as H.264, 8 bits, 4:2:0: what every player and browser shows. The index
    stands before the pictures, so that it plays while it loads. Raises MissingExtra and FileTrouble.
    """
    try:
        import av
    except ImportError:
        raise missing("films", "PyAV") from None
    with (
        whole_file(path) as part,
        part.open("w+b") as file,
        av.open(file, "w", format="mp4", options={"movflags": "faststart"}) as container,
    ):
        stream: Any = None
        for picture in pictures:
            if stream is None:
                stream = container.add_stream("libx264", rate=fps, options={"crf": QUALITY})
                stream.width, stream.height = picture.size
                stream.pix_fmt = "yuv420p"
            frame = av.VideoFrame.from_ndarray(np.asarray(picture), format="rgb24")
            container.mux(stream.encode(frame))
        if stream is not None:
            container.mux(stream.encode())


def hundredths(fps: float) -> int:
    """How long a picture of a GIF stands [s / 100]."""
    return max(LEAST_HUNDREDTHS, round(GIF_CLOCK / fps))


def write_gif(path: Path, pictures: Iterator[Any], sample: Iterable[Any], stand: int) -> None:
    """Pillow images as a GIF that loops, each for `stand` hundredths of a second.

    sample: some of the pictures, from which the colours are taken: one palette for all, so that what does not
    change costs nothing. Raises FileTrouble.
    """
    palette = _palette(list(sample))
    indexed = (picture.quantize(palette=palette, dither=0) for picture in pictures)
    first = next(indexed)
    with whole_file(path) as part:
        first.save(
            part,
            format="GIF",
            save_all=True,
            append_images=indexed,
            duration=10 * stand,
            loop=0,
            disposal=1,
            optimize=False,
        )


def _palette(sample: list[Any]) -> Any:
    """A palette image of the colours in the sample."""
    width, height = sample[0].size
    together = pillow().new("RGB", (width, height * len(sample)))
    for row, picture in enumerate(sample):
        together.paste(picture, (0, row * height))
    return together.quantize(COLOURS, method=0)


def some_of(times: FloatArray) -> FloatArray:
    """A few times, evenly chosen."""
    return np.asarray(times[np.unique(np.linspace(0, len(times) - 1, PALETTE_PICTURES).astype(int))])
