"""A trajectory as one animated binary glTF file, for Blender, model viewers and game engines.

Metres, seconds, y up; a node for each body under its name. Khronos Group, "glTF 2.0 Specification" (2021).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any

import numpy as np

import physsim
from physsim.recording import Trajectory
from physsim.recording.whole_file import whole_file
from physsim.view.clip import Clip, clip_of
from physsim.view.gltf.camera import with_camera
from physsim.view.gltf.extent import bounds, radii
from physsim.view.gltf.glb_file import Binary, write_glb
from physsim.view.gltf.links import (
    LOOKS,
    LinkMover,
    break_times,
    drawn_links,
    held_at,
    link_meshes,
    link_nodes,
)
from physsim.view.gltf.motion import BodyMover, Mover, animate
from physsim.view.gltf.nodes import Figures, body_nodes, shapes
from physsim.view.shapes.tessellate import Placed, tessellated
from physsim.view.stage import FloatArray, Stage, stage_of

FINENESS, FINENESS_OF_MANY, MANY = 48, 24, 200
"""Segments around a circle, of few solids and of more than 200."""
RELATIVE_TOLERANCE = 1e-3
"""Of the radius of the smallest body that moves: half a pixel where that is drawn 1000 pixels wide."""
ROUNDING = 2.0**-24
"""Of a number in 32 bits, relative."""


@dataclass(frozen=True)
class Wishes:
    """start, end: of the part to write [s]; fps: poses in a second that is shown, None: the frames of the
    file; speed: simulated seconds in a second that is shown; tolerance [m]: how far any point may be off at
    any frame, None: 1e-3 of the radius of the smallest body that moves; camera: whether to add a camera that
    sees everything, and a sun.
    """

    start: float | None = None
    end: float | None = None
    fps: float | None = None
    speed: float = 1.0
    tolerance: float | None = None
    camera: bool = False


@dataclass(frozen=True)
class Written:
    """What became of a trajectory. kept of samples: how many key frames the poses of moving bodies became;
    tolerance, rounding [m]: how far a point may be off by that, and by numbers of 32 bits; visible [m]: the
    tolerance that nobody would see.
    """

    size: int
    bodies: int
    instants: int
    samples: int
    kept: int
    tolerance: float
    rounding: float
    visible: float


def write_gltf(trajectory: Trajectory, path: Path, wishes: Wishes) -> Written:
    """Writes `path`, which takes its name when it is whole.

    Raises FileTrouble when the trajectory keeps no shapes or has no frames there, or the file cannot be
    written.
    """
    stage = stage_of(trajectory)
    stage = replace(stage, solids=tuple(solid for solid in stage.solids if solid.shown))
    clip = clip_of(trajectory, wishes.start, wishes.end, wishes.fps and wishes.fps / wishes.speed)
    with whole_file(path) as part, TemporaryFile(dir=path.parent) as chunk:
        return _write(part, stage, clip, wishes, Binary(chunk))


def _write(path: Path, stage: Stage, clip: Clip, wishes: Wishes, binary: Binary) -> Written:
    meshes, placed = tessellated(stage, FINENESS if len(stage.solids) <= MANY else FINENESS_OF_MANY, 1.0)
    around = radii(stage, meshes, placed)
    links = drawn_links(stage)
    low, high = bounds(clip, around, held_at(links))
    first = clip.first()
    placed = on_ground(stage, placed, first[0], low, high)
    movers = np.flatnonzero([not actor.fixed for actor in stage.actors])
    visible = default_tolerance(around[movers])
    tolerance = visible if wishes.tolerance is None else wishes.tolerance

    looks = {kind: LOOKS[kind] for kind in LOOKS if any(link.kind == kind for link in links)}
    figures = Figures(shapes([*meshes, *(look.mesh() for look in looks.values())], binary))
    nodes = body_nodes(stage, placed, figures, *first)
    cast: list[Mover] = [BodyMover(movers, around[movers], tolerance)]
    if links:
        held = LinkMover(
            links, len(nodes) + np.arange(len(links)), first, tolerance, break_times(clip.trajectory, links)
        )
        nodes += link_nodes(links, link_meshes(links, figures, len(meshes)), held.first)
        cast.append(held)
    motion = animate(clip, cast, wishes.speed, binary, path.parent)

    document = with_root(stage, clip, nodes, wishes.speed, tolerance) | figures.document() | motion.document()
    size = write_glb(path, with_camera(document, low, high) if wishes.camera else document, binary)
    return Written(
        size=size,
        bodies=len(stage.actors),
        instants=len(clip.times),
        samples=motion.samples,
        kept=motion.kept,
        tolerance=tolerance,
        rounding=ROUNDING * float(np.abs([low, high]).max()),
        visible=visible,
    )


def default_tolerance(around: FloatArray) -> float:
    """[m] for movers of these radii (R) [m]; a millimetre where none has any size."""
    return RELATIVE_TOLERANCE * float(np.min(around[around > 0], initial=1.0))


def on_ground(
    stage: Stage, placed: Sequence[Placed], positions: FloatArray, low: FloatArray, high: FloatArray
) -> list[Placed]:
    """With half-spaces wide enough to reach under everything between the corners `low` and `high`."""
    corners = np.array([[x, y, z] for x, y, z in product(*np.stack([low, high], axis=1))])
    wide = []
    for one in placed:
        solid = stage.solids[one.solid]
        if solid.kind == "halfspace":
            reach = np.linalg.norm(corners - positions[solid.body], axis=1).max()
            wide.append(replace(one, scale=one.scale * [reach, reach, 1.0]))
        else:
            wide.append(one)
    return wide


def with_root(
    stage: Stage, clip: Clip, nodes: Sequence[dict[str, Any]], speed: float, tolerance: float
) -> dict[str, Any]:
    """The document of the nodes, all that are nobody's children under one node with the title."""
    title = stage.title or clip.trajectory.path.stem
    children = {child for node in nodes for child in node.get("children", ())}
    root = {"name": title, "children": [number for number in range(len(nodes)) if number not in children]}
    version = clip.trajectory.physsim_version
    facts = {
        "title": stage.title,
        "physsim_version": version,
        "start": float(clip.times[0]),
        "end": float(clip.times[-1]),
        "speed": speed,
        "tolerance": tolerance,
    }
    return {
        "asset": {"version": "2.0", "generator": f"physsim {physsim.__version__}", "extras": facts},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [len(nodes)]}],
        "nodes": [*nodes, root],
    }
