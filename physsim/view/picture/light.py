"""The light in pictures, and colours as light: the one place that says how a picture looks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from physsim.view.stage import FloatArray

SUN = np.array([0.45, -0.38, 1.0])
SUNLIGHT = np.array([1.10, 1.05, 0.97])
SKYLIGHT = np.array([0.46, 0.50, 0.57])
"""What the whole sky sends to a surface that faces it, unless something stands in the way."""
FILL = np.array([0.13, 0.13, 0.14])
"""Light without shadows from above and, as the floor sends it back, from below: no hole is quite black."""
GLOSS = 0.10
BACKGROUND = ("#d3e0ee", "#eaf0f6")
GROUND, GROUND_LINE, WALL = "#b4b8bb", "#8d9297", "#a5abb0"
GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))
MANY_TRIANGLES = 60_000


@dataclass(frozen=True)
class Lights:
    """Rows as the engine wants them: direction (L, 3) unit, towards the light; strength (L, 3) linear RGB;
    map (L, 2): texels of its shadow map and softness of shadows in texels; gloss (L).
    """

    direction: FloatArray
    strength: FloatArray
    map: FloatArray
    gloss: FloatArray


def lights(triangles: int, fine: bool) -> Lights:
    """A sun, a sky of several directions and two lights that fill the dark. triangles: how many are drawn; a
    scene of many gets a sky of fewer directions. fine: for stills.
    """
    count = 16 if triangles < MANY_TRIANGLES else 8 if triangles < 8 * MANY_TRIANGLES else 4
    sky = _sky(count)
    share = SKYLIGHT / sky[:, 2].sum()
    up = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    texels = 2048 if fine else 1280
    return Lights(
        direction=np.vstack([SUN / np.linalg.norm(SUN), sky, up]),
        strength=np.vstack([SUNLIGHT, np.tile(share, (count, 1)), FILL, FILL * 1.4]),
        map=np.array([[texels, 3], *[[320, 2]] * count, [0, 0], [0, 0]], np.int32),
        gloss=np.array([GLOSS, *[0.0] * (count + 2)]),
    )


def _sky(count: int) -> FloatArray:
    """Directions (count, 3) spread over the upper half sphere, denser upwards as the cosine: a spiral."""
    k = np.arange(count)
    z = np.sqrt((k + 0.5) / count)
    away, angle = np.sqrt(1 - z**2), GOLDEN_ANGLE * k
    return np.column_stack([away * np.cos(angle), away * np.sin(angle), z])


def linear(colour: str) -> FloatArray:
    """`#rrggbb` as linear RGB from 0 to 1 (3); IEC 61966-2-1."""
    part = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(part <= 0.04045, part / 12.92, ((part + 0.055) / 1.055) ** 2.4)


SLOW_TO_FAST = ("#1f3f75", "#55607c", "#8a887f", "#c4b470", "#fee838")
"""Colours of speeds, from dark to light for any eye: after "cividis" (Nunez, Anderton, Renslow 2018)."""


def of_speeds(speeds: FloatArray, fastest: float) -> FloatArray:
    """Linear RGB (N, 3) of speeds (N) between 0 and the fastest."""
    part = np.clip(speeds / max(fastest, 1e-300), 0, 1) * (len(SLOW_TO_FAST) - 1)
    known = np.array([linear(colour) for colour in SLOW_TO_FAST])
    steps = np.arange(len(known))
    return np.stack([np.interp(part, steps, channel) for channel in known.T], axis=1)


def told_apart(colour: FloatArray, number: int) -> FloatArray:
    """The colour (3) of the body of that number: bodies of one material differ a little in brightness."""
    return colour * (0.84 + 0.08 * (number * 7 % 5))
