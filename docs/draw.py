"""Draws frames of a trajectory side by side into a PNG, with numpy alone: the pictures of these pages.

    python docs/draw.py SCENE.yaml TRAJECTORY.h5 PICTURE.png TIME [TIME ...]

The pictures of README.md are frames of three scenes at these times:

    nuts_and_brackets 0 0.2 2
    wrecking_ball 0.3 0.76 1
    mobile 0 0.3 20

A small z-buffer over triangles, on a floor at z = 0 (or below what hangs lower), with soft shadows on it.
Linear springs are zigzag wires and distance joints straight ones between their ends.
"""

from __future__ import annotations

import struct
import sys
import zlib
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

import physsim
from physsim.model import rotation

Array = Any
WIDTH, HEIGHT, SMOOTHING, GAP = 420, 460, 2, 6
SKY, FLOOR, LINE = np.array([0.93, 0.95, 0.97]), np.array([0.80, 0.81, 0.80]), np.array([0.70, 0.71, 0.71])
PALETTE = np.array(
    [
        [0.36, 0.54, 0.66],
        [0.78, 0.47, 0.28],
        [0.47, 0.62, 0.38],
        [0.80, 0.66, 0.30],
        [0.58, 0.45, 0.60],
        [0.45, 0.48, 0.52],
    ]
)
WIRE, SPRING, STRING = 0.004, np.array([0.25, 0.27, 0.30]), np.array([0.45, 0.36, 0.25])
SUN = np.array([0.45, -0.55, 1.0]) / np.linalg.norm([0.45, -0.55, 1.0])


@dataclass(frozen=True)
class Camera:
    """Eye, unit axes (right, up, forward), and `focus`, the focal length over half the picture's height."""

    eye: Array
    axes: Array
    focus: float

    @classmethod
    def around(cls, points: Array) -> Camera:
        """A view from the front right and above that holds all the points (n, 3) [m]."""
        forward = np.array([-0.55, 0.75, -0.42]) / np.linalg.norm([-0.55, 0.75, -0.42])
        right = np.cross(forward, [0, 0, 1]) / np.linalg.norm(np.cross(forward, [0, 0, 1]))
        axes, focus = np.array([right, np.cross(right, forward), forward]), 4.4
        seen = points @ axes.T
        middle, half = (seen.max(axis=0) + seen.min(axis=0)) / 2, np.ptp(seen, axis=0) / 2
        distance = 1.12 * focus * max(half[1], half[0] * HEIGHT / WIDTH) + half[2]
        return cls((middle - [0, 0, distance]) @ axes, axes, focus)

    def pixels(self, points: Array) -> Array:
        """Columns, rows and depths [m] (n, 3) of world points (n, 3)."""
        seen = (points - self.eye) @ self.axes.T
        half = HEIGHT * SMOOTHING / 2
        scale = self.focus * half / seen[:, 2]
        return np.column_stack(
            [WIDTH * SMOOTHING / 2 + scale * seen[:, 0], half - scale * seen[:, 1], seen[:, 2]]
        )

    def floor_points(self) -> Array:
        """Where the ray of each pixel meets z = 0, (rows, columns, 2); NaN above the horizon."""
        half = HEIGHT * SMOOTHING / 2
        rows, columns = np.mgrid[0 : HEIGHT * SMOOTHING, 0 : WIDTH * SMOOTHING] + 0.5
        local = np.stack(
            [columns - WIDTH * SMOOTHING / 2, half - rows, np.full(rows.shape, self.focus * half)], axis=-1
        )
        rays = local @ self.axes
        distance = np.where(rays[..., 2] < 0, -self.eye[2] / rays[..., 2], np.nan)
        return (self.eye + distance[..., None] * rays)[..., :2]


def triangles_of(shape: Any, scene: Any) -> Array:
    """Triangles (n, 3, 3) [m] of a shape in the body's own frame."""
    if shape.type == "compound":
        return np.concatenate([placed_part(part, scene) for part in shape.parts])
    makers = {
        "mesh": lambda: mesh_of(shape, scene),
        "sphere": lambda: trimesh.creation.icosphere(subdivisions=3, radius=shape.radius),
        "hollow_sphere": lambda: trimesh.creation.icosphere(subdivisions=3, radius=shape.radius),
        "rod": lambda: trimesh.creation.cylinder(radius=2 * WIRE, height=shape.length, sections=12),
        "box": lambda: trimesh.creation.box(extents=shape.size),
        "cylinder": lambda: trimesh.creation.cylinder(radius=shape.radius, height=shape.height, sections=48),
        "capsule": lambda: trimesh.creation.capsule(radius=shape.radius, height=shape.height),
    }
    return np.array(makers[shape.type]().triangles)


def placed_part(part: Any, scene: Any) -> Array:
    """Triangles of one part of a compound in the body's frame."""
    return (
        triangles_of(part.shape, scene) @ rotation.matrix(np.array(part.orientation.as_quaternion())).T
        + part.position
    )


def wire(points: Array) -> Array:
    """Triangles (n, 3, 3) of a round wire along points (k, 3) [m]."""
    pieces = [
        trimesh.creation.cylinder(radius=WIRE, segment=ends, sections=8).triangles
        for ends in pairwise(points)
    ]
    return np.concatenate(pieces)


def zigzag(ends: Array, turns: int = 9) -> Array:
    """Points of a spring between two ends (2, 3) [m]: straight at both, teeth to the sides between."""
    along = ends[1] - ends[0]
    across = np.cross(along, [0.55, -0.75, 0.3])
    across *= 4 * WIRE / max(np.linalg.norm(across), 1e-12)
    teeth = [k + 0.5 for k in range(turns)]
    middle = [ends[0] + along * (0.15 + 0.7 * k / turns) + across * (-1) ** round(k - 0.5) for k in teeth]
    return np.array([ends[0], *middle, ends[1]])


def connections(scene: Any, poses: dict[str, tuple[Array, Array]]) -> list[tuple[Array, Array]]:
    """Triangles and colours of linear springs and distance joints, for poses (position, matrix) by body."""
    drawn = []
    for spec in [*(scene.spec.springs or {}).values(), *(scene.spec.joints or {}).values()]:
        if spec.type in ("linear", "distance"):
            ends = np.array(
                [
                    poses[name][0] + poses[name][1] @ np.array(anchor)
                    for name, anchor in zip(spec.between, spec.anchors, strict=True)
                ]
            )
            coil = spec.type == "linear"
            drawn.append((wire(zigzag(ends) if coil else ends), SPRING if coil else STRING))
    return drawn


def mesh_of(shape: Any, scene: Any) -> Any:
    """The mesh file at its scale."""
    mesh = trimesh.load(scene.resolve_file(shape.file), force="mesh")
    mesh.apply_scale(shape.scale)
    return mesh


def colours_of(materials: list[str], scene: Any) -> list[Array]:
    """The colour that the scene gives a material, else one of ours; neighbours differ in brightness."""
    palette = {name: PALETTE[k % len(PALETTE)] for k, name in enumerate(dict.fromkeys(materials))}
    declared = {name: spec.color for name, spec in scene.spec.materials.items() if spec.color is not None}
    base = {name: parsed(declared[name]) if name in declared else palette[name] for name in palette}
    return [base[name] * (0.94 + 0.06 * (k * 7 % 5) / 2) for k, name in enumerate(materials)]


def parsed(color: str) -> Array:
    """`#rgb` or `#rrggbb` as three numbers from 0 to 1."""
    digits = color[1:] if len(color) == 7 else "".join(2 * digit for digit in color[1:])
    return np.array([int(digits[k : k + 2], 16) for k in (0, 2, 4)]) / 255


def fill(pixels: Array, depth: Array, paint: Array | None, colour: Array) -> None:
    """Put a triangle (3, 3) of columns, rows, depths into the depth buffer, and its colour where nearest."""
    low = np.maximum(np.floor(pixels[:, :2].min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(pixels[:, :2].max(axis=0)).astype(int) + 1, [depth.shape[1], depth.shape[0]])
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = pixels
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if (low >= high).any() or abs(area) < 1e-9:
        return
    x, y = np.arange(low[0], high[0]) + 0.5, (np.arange(low[1], high[1]) + 0.5)[:, None]
    v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
    w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
    z = 1 / ((1 - v - w) / az + v / bz + w / cz)
    window = np.s_[low[1] : high[1], low[0] : high[0]]
    nearer = (v >= 0) & (w >= 0) & (v + w <= 1) & (z < depth[window])
    depth[window][nearer] = z[nearer]
    if paint is not None:
        paint[window][nearer] = colour


def shadow(triangles: Array, camera: Camera) -> Array:
    """How much of the sun each floor pixel misses, 0 to 1; the sun has some breadth."""
    missing = np.zeros((HEIGHT * SMOOTHING, WIDTH * SMOOTHING))
    directions = [SUN + 0.07 * np.array([np.cos(a), np.sin(a), 0]) for a in np.arange(6) * np.pi / 3]
    for direction in directions:
        covered = np.full(missing.shape, np.inf)
        cast = triangles - triangles[..., 2:] / direction[2] * direction
        for corners in camera.pixels(cast.reshape(-1, 3)).reshape(-1, 3, 3):
            fill(corners, covered, None, SKY)
        missing += np.isfinite(covered) / len(directions)
    return missing


def floor_picture(camera: Camera, spacing: float) -> Array:
    """Sky, and a floor with lines every `spacing` metres that fade into the distance."""
    points = camera.floor_points()
    off_line = np.abs(points / spacing - np.round(points / spacing)).min(axis=-1) * spacing
    distance = np.linalg.norm(points - camera.eye[:2], axis=-1)
    fading = np.exp(-distance / (4 * np.linalg.norm(camera.eye)))[..., None]
    floor = np.where((off_line < 0.01 * spacing)[..., None], LINE, FLOOR)
    return np.where(np.isnan(distance)[..., None], SKY, fading * floor + (1 - fading) * SKY)


def picture(bodies: list[Array], colours: list[Array], camera: Camera, spacing: float) -> Array:
    """Bodies as world triangles, their colours: an image (HEIGHT, WIDTH, 3) from 0 to 1."""
    everything = np.concatenate(bodies)
    image = floor_picture(camera, spacing) * (1 - 0.45 * shadow(everything, camera))[..., None]
    depth = np.full(image.shape[:2], np.inf)
    for triangles, colour in zip(bodies, colours, strict=True):
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        light = 0.45 + 0.15 * normals[:, 2] + 0.5 * np.clip(normals @ SUN, 0, None)
        facing = np.einsum("ij,ij->i", normals, triangles[:, 0] - camera.eye) < 0
        for corners, brightness in zip(
            camera.pixels(triangles[facing].reshape(-1, 3)).reshape(-1, 3, 3), light[facing], strict=True
        ):
            fill(corners, depth, image, np.clip(colour * brightness, 0, 1))
    return image.reshape(HEIGHT, SMOOTHING, WIDTH, SMOOTHING, 3).mean(axis=(1, 3))


def write_png(path: Path, image: Array) -> None:
    """An image (rows, columns, 3) from 0 to 1 as an 8-bit PNG (ISO/IEC 15948)."""
    pixels = np.round(np.clip(image, 0, 1) * 255).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(name: bytes, content: bytes) -> bytes:
        return (
            struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
        )

    header = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    signature = b"\x89PNG\r\n\x1a\n"
    path.write_bytes(
        signature + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    )


def main() -> None:
    """Draw the frames nearest to the given times, one beside the other."""
    scene_file, trajectory_file, target, *times = sys.argv[1:]
    scene = physsim.load(scene_file)
    moving = {name: body for name, body in scene.bodies.items() if not body.fixed}
    shapes = [triangles_of(body.shape, scene) for body in moving.values()]
    colours = colours_of([body.material for body in moving.values()], scene)
    with physsim.open_trajectory(trajectory_file) as trajectory:
        clock = np.asarray(trajectory.time)
        frames = [int(np.abs(clock - float(time)).argmin()) for time in times]
        names = list(trajectory.body_names)
        states = [(trajectory.position[frame], trajectory.orientation[frame]) for frame in frames]
    placed, painted = [], []
    for positions, turned in states:
        poses = {name: (positions[k], rotation.matrix(turned[k])) for k, name in enumerate(names)}
        wires = connections(scene, poses | {"world": (np.zeros(3), np.eye(3))})
        solids = [
            shape @ poses[name][1].T + poses[name][0] for name, shape in zip(moving, shapes, strict=True)
        ]
        placed.append([*solids, *(triangles for triangles, _ in wires)])
        painted.append([*colours, *(colour for _, colour in wires)])
    corners = np.concatenate([triangles.reshape(-1, 3) for bodies in placed for triangles in bodies])
    lift = np.array([0, 0, max(0.0, -corners[:, 2].min())])
    corners = corners + lift
    camera = Camera.around(corners)
    panels = [
        picture([shape + lift for shape in bodies], paint, camera, np.ptp(corners, axis=0).max() / 5)
        for bodies, paint in zip(placed, painted, strict=True)
    ]
    gap = np.ones((HEIGHT, GAP, 3))
    row = [part for panel in panels for part in (panel, gap)][:-1]
    write_png(Path(target), np.concatenate(row, axis=1))


if __name__ == "__main__":
    main()
