"""A scene before it runs, drawn so that a wrong pose is seen at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from physsim.view.picture.camera import View, placed
from physsim.view.picture.caption import Caption, Mark, captioned
from physsim.view.picture.painter import Painter, grid_spacing
from physsim.view.picture.setting import at, setting_of
from physsim.view.picture.show import labels
from physsim.view.picture.signs import Signs
from physsim.view.stage import FloatArray, Stage

MOST_NAMES = 40
"""More names than this hide the picture: then only overlaps are named."""
TOLD_OVERLAPS = 12


def draft(
    stage: Stage,
    positions: FloatArray,
    orientations: FloatArray,
    overlaps: Sequence[tuple[FloatArray, str]],
    size: tuple[int, int],
) -> Any:
    """A Pillow image: bodies at positions (N, 3) [m] and orientations (N, 4) with their frames, centres of
    mass and names, joints with anchors and axes, springs.

    overlaps: where bodies overlap (3) [m], and what to write there. Raises MissingExtra.
    """
    painter = Painter(stage)
    setting = setting_of(stage, painter.boxes, positions[None], orientations[None])
    camera = placed(View(), setting, size)
    signs = Signs(stage, setting, painter.boxes, positions, orientations)
    nothing: frozenset[int] = frozenset()
    extras = [
        *signs.springs(positions, orientations, nothing),
        *signs.joints(positions, orientations, nothing),
        *signs.frames(positions, orientations),
    ]
    pixels = painter.draw(camera, setting, positions, orientations, extras=extras)
    caption = Caption(
        scale=f"grid {grid_spacing(setting):g} m" if painter.grounded else "",
        title=stage.title,
        time="axes: x red, longest; y green; z blue, shortest",
        marks=[*_names(stage, positions, orientations), *_wrong(overlaps)],
    )
    return captioned(pixels, camera, caption)


def _names(stage: Stage, positions: FloatArray, orientations: FloatArray) -> Iterator[Mark]:
    """Of bodies at their centres of mass, of joints and springs at their first anchor."""
    links = [*stage.joints, *stage.springs]
    few = len(stage.actors) + len(links) <= MOST_NAMES
    for mark in labels(stage, positions, orientations, massive=True):
        yield mark if few else replace(mark, text="")
    for link in links if few else ():
        ends = [at(link.bodies[k], link.anchors[k], positions, orientations) for k in (0, 1)]
        yield Mark(np.mean(ends, axis=0), link.name, link=True)


def _wrong(overlaps: Sequence[tuple[FloatArray, str]]) -> Iterator[Mark]:
    for place, text in overlaps[:TOLD_OVERLAPS]:
        yield Mark(place, text, wrong=True)
