"""Pictures of a stage: bodies at given poses, light, ground and camera; drawn by the engine."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim import _engine
from physsim.recording.orientation import rotation_matrices
from physsim.view.picture import things
from physsim.view.picture.camera import FOCUS, Camera
from physsim.view.picture.light import BACKGROUND, GROUND, GROUND_LINE, WALL, lights, linear, told_apart
from physsim.view.picture.setting import Setting, boxes_of
from physsim.view.picture.things import Cast, Extra, Finish
from physsim.view.shapes.tessellate import tessellated
from physsim.view.stage import FloatArray, Solid, Stage

Pixels = npt.NDArray[np.uint8]

GROUND_RADIUS = 4.0
"""The ground fades away at this many sizes of the setting around its middle."""
LINES = 6
"""About so many lines of the ground's grid lie across the setting."""
FINENESS, COARSE, MANY_BODIES = 64, 24, 150
"""Segments around a circle, and with many bodies."""
TURNING = ("sphere", "ellipsoid", "cylinder", "capsule", "cone")
"""Kinds on which one sees a turn only by two tones."""


class Painter:
    """Draws one stage again and again."""

    def __init__(self, stage: Stage) -> None:
        shown = [number for number, solid in enumerate(stage.solids) if solid.shown]
        fineness = FINENESS if len(shown) <= MANY_BODIES else COARSE
        meshes, placed = tessellated(stage, fineness, 1.0)
        self.stage = stage
        self.placed = [placed[number] for number in shown if stage.solids[number].kind != "halfspace"]
        self.boxes = boxes_of(stage, meshes, self.placed)
        self._planes = [stage.solids[number] for number in shown if stage.solids[number].kind == "halfspace"]
        self._solids = [stage.solids[one.solid] for one in self.placed]
        self._cast = self._cast_of(meshes)
        self._scale = np.array([one.scale for one in self.placed], np.float64).reshape(-1, 1, 3)
        self._turn = rotation_matrices(_stacked(self._solids, "orientation", 4))
        self._offset = _stacked(self._solids, "position", 3)
        self._body = np.array([solid.body for solid in self._solids], np.intp)
        self._triangles = sum(len(meshes[one.mesh].triangles) for one in self.placed)

    def draw(
        self,
        camera: Camera,
        setting: Setting,
        positions: FloatArray,
        orientations: FloatArray,
        *,
        extras: Sequence[Extra] = (),
        fine: bool = True,
        colours: FloatArray | None = None,
    ) -> Pixels:
        """The picture (height, width, 3) of the bodies at positions (N, 3) [m] and orientations (N, 4).

        setting: what casts shadows and how large the ground is. fine: as good as can be, for stills.
        colours (N, 3): linear RGB of bodies, in the place of their materials'.
        """
        turned = rotation_matrices(orientations)[self._body]
        matrices = turned @ self._turn * self._scale
        places = positions[self._body] + np.einsum("nij,nj->ni", turned, self._offset)
        picture = things.rows(self._cast, matrices, places, extras)
        if colours is not None:
            picture["colour"][: len(self._body)] = colours[self._body]
        picture |= self._ground(setting, positions, orientations)
        picture |= _seen(camera) | _lit(setting, self._triangles, fine)
        return _engine.draw(picture, threads=os.cpu_count() or 1)

    @property
    def grounded(self) -> bool:
        """Whether there is a ground, or a wall, with its grid."""
        return bool(self._planes)

    def _cast_of(self, meshes: list[Any]) -> Cast:
        known = {number: things.closed(meshes[number]) for number in {one.mesh for one in self.placed}}
        return Cast(
            meshes=meshes,
            mesh=[one.mesh for one in self.placed],
            colour=[told_apart(linear(solid.colour), solid.body) for solid in self._solids],
            finish=[self._finish(solid) for solid in self._solids],
            closed=[known[one.mesh] for one in self.placed],
        )

    def _finish(self, solid: Solid) -> Finish:
        turns = solid.kind in TURNING and not self.stage.actors[solid.body].fixed
        return Finish.QUARTERED if turns else Finish.PLAIN

    def _ground(self, setting: Setting, positions: FloatArray, orientations: FloatArray) -> dict[str, Any]:
        """Half-spaces as planes with a grid; the steepest are walls."""
        spacing = grid_spacing(setting)
        rows = [
            self._plane(solid, setting.middle, spacing, positions, orientations) for solid in self._planes
        ]
        middle, axes, colour = zip(*rows, strict=True) if rows else ((), (), ())
        count = len(rows)
        return {
            "plane_middle": np.array(middle, np.float64).reshape(-1, 3),
            "plane_axes": np.array(axes, np.float64).reshape(-1, 3, 3),
            "plane_colour": np.array(colour, np.float64).reshape(-1, 3),
            "plane_line": np.tile(linear(GROUND_LINE), (count, 1)),
            "plane_size": np.tile([spacing, GROUND_RADIUS * setting.size], (count, 1)),
        }

    def _plane(
        self,
        solid: Solid,
        middle: FloatArray,
        spacing: float,
        positions: FloatArray,
        orientations: FloatArray,
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """A point of its grid near the middle, its axes, its colour."""
        body = rotation_matrices(orientations[solid.body : solid.body + 1])[0]
        normal = body @ rotation_matrices(solid.orientation[None])[0][:, 2]
        origin = positions[solid.body] + body @ solid.position
        axes = upright(normal)
        steps = np.round(axes[:2] @ (middle - origin) / spacing) * spacing
        return origin + steps @ axes[:2], axes, linear(GROUND if normal[2] > 0.9 else WALL)


def upright(normal: FloatArray) -> FloatArray:
    """Unit vectors (3, 3): level along the plane, upwards along it, and its normal."""
    level = np.cross([0.0, 0.0, 1.0], normal)
    first = level if np.linalg.norm(level) > 1e-9 else np.array([1.0, 0.0, 0.0])
    first = first / np.linalg.norm(first)
    return np.array([first, np.cross(normal, first), normal])


def grid_spacing(setting: Setting) -> float:
    """1, 2 or 5 times a power of ten [m]: about LINES lines across the setting."""
    wanted = max(setting.size, 1e-12) / LINES
    power = 10 ** np.floor(np.log10(wanted))
    return float(power * max(step for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


def _seen(camera: Camera) -> dict[str, Any]:
    return {
        "eye": camera.eye[None],
        "camera_axes": camera.axes,
        "focus": FOCUS,
        "width": camera.size[0],
        "height": camera.size[1],
    }


def _lit(setting: Setting, triangles: int, fine: bool) -> dict[str, Any]:
    found = lights(triangles, fine)
    return {
        "light_direction": found.direction,
        "light_strength": found.strength,
        "light_map": found.map,
        "light_gloss": found.gloss,
        "stage_middle": setting.middle[None],
        "stage_radius": 0.55 * setting.size,
        "near": 1e-3 * setting.size,
        "background": np.array([linear(colour) for colour in BACKGROUND]),
        "samples": 3 if fine else 2,
    }


def _stacked(solids: Sequence[Solid], name: str, width: int) -> FloatArray:
    return np.array([getattr(solid, name) for solid in solids], np.float64).reshape(-1, width)
