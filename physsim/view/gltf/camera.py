"""A camera that sees everything, and a sun: for programs that show a glTF file as it is.

Both look along -z of their nodes in glTF, which is y in the axes of a scene.
"""

from __future__ import annotations

from itertools import product
from math import asin, atan2, cos, sin, tan
from typing import Any

import numpy as np

from physsim.recording.orientation import rotated
from physsim.view.gltf.nodes import pose
from physsim.view.stage import FloatArray

VIEW = np.array([0.5, -0.8, 0.4])
"""From the middle of the scene to the camera: from the front, a little from the right and above."""
SUNLIGHT = np.array([0.3, -0.5, 1.0])
FIELD_OF_VIEW = 0.7  # rad, from top to bottom
ASPECT = 4 / 3
"""Narrowest picture, width over height, that everything fits into."""
MARGIN = 1.1
LUX = 3.0
"""Daylight for players that show a light of 1 as white; the 100 000 lx of the real one would dazzle them."""


def with_camera(document: dict[str, Any], low: FloatArray, high: FloatArray) -> dict[str, Any]:
    """The document with both, for what is between the corners `low` and `high` (3) [m].

    Light: extension KHR_lights_punctual.
    """
    facing = looking_from(VIEW)
    away = distance(low, high, facing)
    eye = (low + high) / 2 + VIEW / np.linalg.norm(VIEW) * away
    root = document["nodes"][-1]
    first = len(document["nodes"])
    camera = pose(eye, facing) | {"name": "camera", "camera": 0}
    sun = pose(np.zeros(3), looking_from(SUNLIGHT)) | {
        "name": "sun",
        "extensions": {"KHR_lights_punctual": {"light": 0}},
    }
    lens = {"yfov": FIELD_OF_VIEW, "znear": away / 1000, "zfar": away * 1000}
    light = {"name": "sun", "type": "directional", "intensity": LUX}
    return document | {
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [light]}},
        "cameras": [{"name": "camera", "type": "perspective", "perspective": lens}],
        "nodes": [
            *document["nodes"][:-1],
            root | {"children": [*root["children"], first, first + 1]},
            camera,
            sun,
        ],
    }


def distance(low: FloatArray, high: FloatArray, facing: FloatArray) -> float:
    """From how far away [m] all corners of the box are in the picture, for a camera turned by `facing`.

    A corner that is x to the side, y behind and z above the middle is d + y away, and wants half a picture of
    tan(angle / 2) (d + y) above the middle and `ASPECT` times as much beside it.
    """
    corners = np.array(list(product(*np.stack([low, high], axis=1)))) - (low + high) / 2
    x, y, z = rotated(np.broadcast_to(facing * [1, -1, -1, -1], (8, 4)), corners).T
    half = tan(FIELD_OF_VIEW / 2)
    return MARGIN * float(np.max([np.abs(z) / half - y, np.abs(x) / (ASPECT * half) - y]))


def looking_from(away: FloatArray) -> FloatArray:
    """The orientation (4) of what looks along its y axis against `away` (3), its z axis up: a turn about z,
    and before it one about x.
    """
    ahead = -away / np.linalg.norm(away)
    yaw, pitch = atan2(-ahead[0], ahead[1]) / 2, asin(ahead[2]) / 2
    return np.array(
        [cos(yaw) * cos(pitch), cos(yaw) * sin(pitch), sin(yaw) * sin(pitch), sin(yaw) * cos(pitch)]
    )
