"""Builds the meshes of the example scenes: closed surfaces, one file unit = 1 mm.

    python scenes/meshes/make_meshes.py [FOLDER]

Writes hex_nut.obj, flange.obj, mug.obj and funnel.stl into FOLDER (default: beside this script).
"""

from __future__ import annotations

import math
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

Points = NDArray[np.float64]
Faces = list[tuple[int, int, int]]
TURNS = 48  # points around a circle


def plate_with_hole(outline: Points, radius: float, thickness: float) -> trimesh.Trimesh:
    """A flat plate with a round hole around the origin; `outline` (n, 2) convex, counter-clockwise, mm."""
    angles = 2 * math.pi * np.arange(TURNS) / TURNS
    flat = np.vstack([outline, radius * np.column_stack([np.cos(angles), np.sin(angles)])])
    below, above = (np.column_stack([flat, np.full(len(flat), z)]) for z in (-thickness / 2, thickness / 2))
    corners, shift = len(outline), len(flat)
    top = [(a + shift, b + shift, c + shift) for a, b, c in ring_faces(flat, corners)]
    bottom = [(c, b, a) for a, b, c in ring_faces(flat, corners)]
    outside = wall(list(range(corners)), shift)
    inside = wall(list(range(shift - 1, corners - 1, -1)), shift)
    return closed(np.vstack([below, above]), top + bottom + outside + inside)


def ring_faces(flat: Points, corners: int) -> Faces:
    """Triangles between the outline (the first `corners` points) and the circle (the rest), seen from +z.

    Every piece of the circle goes with the corner that looks at it most straight: no point lies within
    an edge of the outline, and the convex hull of the plate has the corners only.
    """
    circle = list(range(corners, len(flat)))
    looks = flat[:corners] / np.linalg.norm(flat[:corners], axis=1)[:, None]
    faces: Faces = []
    pieces = [(a, b, int(np.argmax(looks @ (flat[a] + flat[b])))) for a, b in around(circle)]
    for (start, end, corner), (_, _, following) in around(pieces):
        faces.append((corner, end, start))
        if following != corner:
            faces.append((corner, following, end))
    return faces


def around(loop: list[Any]) -> list[tuple[Any, Any]]:
    """Neighbours in a closed loop."""
    return list(zip(loop, [*loop[1:], loop[0]], strict=True))


def wall(loop: list[int], shift: int) -> Faces:
    """Quads, halved, between a loop of points and the same loop `shift` points later."""
    return [face for a, b in around(loop) for face in ((a, b, b + shift), (a, b + shift, a + shift))]


def hex_nut() -> trimesh.Trimesh:
    """An M10 nut without its thread: 16 mm across flats, 8.4 mm thick, hole of 10 mm (ISO 4032)."""
    angles = math.pi / 3 * np.arange(6)
    return plate_with_hole(16 / math.sqrt(3) * np.column_stack([np.cos(angles), np.sin(angles)]), 5.0, 8.4)


def flange() -> trimesh.Trimesh:
    """One leg of an L-bracket: 40 mm x 30 mm x 5 mm with a hole of 9 mm in its middle."""
    return plate_with_hole(np.array([[-20.0, -15.0], [20.0, -15.0], [20.0, 15.0], [-20.0, 15.0]]), 4.5, 5.0)


def revolved(profile: Points, turns: int) -> tuple[Points, list[list[int]]]:
    """Points of a profile (n, 2: radius and height, mm) turned about z, and their numbers [row][turn]."""
    angles = 2 * math.pi * np.arange(turns) / turns
    points = [[r * math.cos(a), r * math.sin(a), z] for r, z in profile for a in angles]
    return np.array(points), [list(range(row * turns, (row + 1) * turns)) for row in range(len(profile))]


def quads(rows: list[list[int]], skip: set[tuple[int, int]] | None = None) -> Faces:
    """Triangles between neighbouring closed rows, but for the quads (row, turn) of `skip`."""
    faces: Faces = []
    for r, (low, high) in enumerate(pairwise(rows)):
        for t in range(len(low)):
            if (r, t) not in (skip or set()):
                n = (t + 1) % len(low)
                faces += [(low[t], low[n], high[n]), (low[t], high[n], high[t])]
    return faces


def funnel() -> trimesh.Trimesh:
    """A funnel with a wall of 4 mm: mouth 200 mm, spout 40 mm wide and 60 mm long; its lower end at z = 0."""
    inner = [(100.0, 150.0), (20.0, 60.0), (20.0, 0.0)]
    outer = [(24.0, 0.0), (24.0, 58.0), (104.0, 148.0)]
    points, rows = revolved(np.array(outer + inner), TURNS)
    return closed(points, quads([*rows, rows[0]]))


def mug() -> trimesh.Trimesh:
    """A mug with a handle: 80 mm wide, 90 mm high, wall 4 mm, floor 6 mm; z = 0 is its underside."""
    turns = 32
    outer = [(40.0, z) for z in (0.0, 8.0, 16.0, 24.0, 32.0, 44.0, 56.0, 64.0, 72.0, 80.0, 90.0)]
    inner = [(36.0, 90.0), (36.0, 48.0), (36.0, 6.0)]
    points, rows = revolved(np.array(outer + inner), turns)
    lower, upper = patch(rows, 2, turns), patch(rows, 7, turns)
    skip = {(row, turn) for row in (2, 3, 7, 8) for turn in (turns - 1, 0)}
    handle_points, handle_faces = handle(points, lower, upper)
    ends = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 6.0]])
    under, floor = (len(points) + len(handle_points) + k for k in (0, 1))
    caps = [(under, b, a) for a, b in around(rows[0])] + [(floor, a, b) for a, b in around(rows[-1])]
    return closed(np.vstack([points, handle_points, ends]), quads(rows, skip) + handle_faces + caps)


def patch(rows: list[list[int]], row: int, turns: int) -> list[int]:
    """Rim of two by two quads around turn 0, from `row` up, counter-clockwise seen from outside."""
    left, right = turns - 1, 1
    low, middle, high = rows[row], rows[row + 1], rows[row + 2]
    return [low[left], low[0], low[right], middle[right], high[right], high[0], high[left], middle[left]]


def handle(points: Points, lower: list[int], upper: list[int]) -> tuple[Points, Faces]:
    """A bent tube from one patch of the wall to the other: new points and triangles."""
    ends = points[lower].mean(axis=0), points[upper].mean(axis=0)
    middle, half = (ends[0] + ends[1]) / 2, (ends[1][2] - ends[0][2]) / 2
    flipped = [upper[k] for k in (6, 5, 4, 3, 2, 1, 0, 7)]
    steps = 12
    new = np.vstack([tube_ring(middle, half, math.pi * (k / steps - 0.5)) for k in range(1, steps)])
    numbers = [[len(points) + 8 * k + i for i in range(8)] for k in range(steps - 1)]
    return new, quads([lower, *numbers, flipped])


def tube_ring(middle: Points, half: float, angle: float) -> Points:
    """Eight points around the handle's axis, a half ellipse in the plane y = 0, `angle` along it."""
    centre = middle + np.array([2 + 28 * math.cos(angle), 0, half * math.sin(angle)])
    inward = -np.array([math.cos(angle), 0, math.sin(angle)])
    turns = math.pi / 4 * (np.arange(8)[:, None] - 3)
    return np.asarray(centre + 4.5 * (np.cos(turns) * [0, 1, 0] + np.sin(turns) * inward))


def closed(points: Points, faces: Faces) -> trimesh.Trimesh:
    """The mesh. Raises ValueError when it is not closed with its triangles turned outwards."""
    mesh = trimesh.Trimesh(points, faces, process=False)
    if not (mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0):
        raise ValueError("the surface is not closed, or is inside out")
    return mesh


def main(folder: Path) -> None:
    """Writes every mesh."""
    meshes = {"hex_nut.obj": hex_nut(), "flange.obj": flange(), "mug.obj": mug(), "funnel.stl": funnel()}
    for name, mesh in meshes.items():
        mesh.export(folder / name)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
