"""Triangles of every kind of solid: closed, turned outward, converging to the true volume; meshes shared."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import trimesh

from physsim.view.shapes.creases import creased
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.tessellate import tessellated
from physsim.view.stage import FloatArray, Solid, Stage, Surface

# kind, parameters, volume, and whether drawing it with flat triangles costs volume
ROUND = [
    ("sphere", (0.5,), 4 / 3 * pi * 0.5**3),
    ("capsule", (0.3, 0.4), 4 / 3 * pi * 0.3**3 + pi * 0.3**2 * 0.8),
    ("cylinder", (0.5, 2.0), pi * 0.25 * 4),
    ("cone", (0.5, 2.0), pi * 0.25 * 2 / 3),
    ("ellipsoid", (1.0, 2.0, 3.0), 4 / 3 * pi * 6),
    ("rod", (1.0,), pi * 0.02**2 * 2),
]
BOX = ("box", (1.0, 2.0, 3.0), 48.0)


def solid(kind: str, *parameters: float, surface: Surface | None = None) -> Solid:
    padded = np.zeros(4)
    padded[: len(parameters)] = parameters
    still = np.array([1.0, 0, 0, 0])
    return Solid(0, kind, padded, np.zeros(3), still, "steel", "#888888", True, True, surface)


def stage(*solids: Solid) -> Stage:
    return Stage("", (), solids, (), ())


def drawn(kind: str, *parameters: float, fineness: int = 24) -> tuple[Mesh, FloatArray]:
    """The mesh of one solid and its scale."""
    meshes, placed = tessellated(stage(solid(kind, *parameters)), fineness, 7.0)
    return meshes[placed[0].mesh], placed[0].scale


def edges(mesh: Mesh) -> list[tuple[int, int]]:
    """Every directed edge, as numbers of points: vertices at one place count as one."""
    points = np.unique(mesh.vertices, axis=0, return_inverse=True)[1].reshape(-1)[mesh.triangles]
    return [(int(t[k]), int(t[(k + 1) % 3])) for t in points for k in range(3)]


def volume(mesh: Mesh, scale: FloatArray) -> float:
    """By the divergence theorem: positive when the triangles are counter-clockwise from outside."""
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] * scale for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@pytest.mark.parametrize(("kind", "parameters", "_"), [*ROUND, BOX])
@pytest.mark.parametrize("fineness", [3, 4, 7, 24])
def test_every_edge_has_one_triangle_on_each_side(kind: str, parameters, _, fineness: int) -> None:
    found = edges(drawn(kind, *parameters, fineness=fineness)[0])
    assert len(set(found)) == len(found)
    assert {(b, a) for a, b in found} == set(found)
    assert all(a != b for a, b in found)


@pytest.mark.parametrize(("kind", "parameters", "true"), ROUND)
def test_volume_converges_with_order_two(kind: str, parameters, true: float) -> None:
    errors = [1 - volume(*drawn(kind, *parameters, fineness=n)) / true for n in (24, 48, 96)]
    assert 0 < errors[-1] < 0.002  # measured 0.00071 (cylinder) to 0.00178 (sphere)
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    np.testing.assert_allclose(orders, 2, atol=0.02)  # measured 1.987 to 1.999


def test_a_box_is_exact() -> None:
    assert volume(*drawn(*BOX[:1], *BOX[1])) == pytest.approx(BOX[2], rel=1e-15)


@pytest.mark.parametrize(("kind", "parameters", "_"), [*ROUND, BOX, ("halfspace", (), 0)])
def test_normals_are_unit_and_agree_with_the_triangles(kind: str, parameters, _) -> None:
    mesh, _scale = drawn(kind, *parameters)
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-15)
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    faces = np.cross(b - a, c - a)
    faces /= np.linalg.norm(faces, axis=1, keepdims=True)
    cosines = np.einsum("tj,tkj->tk", faces, mesh.normals[mesh.triangles])
    assert cosines.min() > np.cos(np.radians(360 / 24))  # 0.966; measured 0.983: 10.5 degrees, at a pole


def test_normals_are_those_of_the_true_surface() -> None:
    sphere, _ = drawn("sphere", 1)
    np.testing.assert_allclose(sphere.normals, sphere.vertices, atol=1e-15)
    cone, scale = drawn("cone", 0.5, 2)
    side = cone.normals[:, 2] > 0
    stretched = cone.normals[side] / scale  # the inverse transpose of the scale
    slope = stretched[:, 2] / np.hypot(*stretched[:, :2].T)
    np.testing.assert_allclose(slope, 0.5 / 2, rtol=1e-14)  # radius over height
    assert (cone.normals[~side] == [0, 0, -1]).all()


def test_where_solids_stand_in_their_frames() -> None:
    def span(kind: str, *parameters: float) -> list[list[float]]:
        mesh, scale = drawn(kind, *parameters)
        points = mesh.vertices * scale
        return [points.min(axis=0).tolist(), points.max(axis=0).tolist()]

    assert span("cone", 0.4, 2) == [[-0.4, -0.4, -0.5], [0.4, 0.4, 1.5]]
    assert span("capsule", 0.25, 0.5) == [[-0.25, -0.25, -0.75], [0.25, 0.25, 0.75]]
    assert span("rod", 3.0) == [[-0.06, -0.06, -3], [0.06, 0.06, 3]]
    assert span("halfspace") == [[-7, -7, 0], [7, 7, 0]]
    assert (drawn("halfspace")[0].normals == [0, 0, 1]).all()


def test_equal_meshes_are_there_once() -> None:
    cube = trimesh.creation.box()
    first = Surface(cube.vertices, cube.faces.astype(np.int32))
    equal, other = replace(first, vertices=first.vertices.copy()), replace(first, vertices=2 * first.vertices)
    solids = [
        *(solid("sphere", radius) for radius in (1, 2, 3)),
        solid("ellipsoid", 1, 2, 3),
        *(solid("capsule", 1, height) for height in (1, 2, 1)),
        *(solid("surface", surface=surface) for surface in (first, equal, other, first)),
        solid("cylinder", 1, 2),
        solid("rod", 5),
    ]
    meshes, placed = tessellated(stage(*solids), 12, 1)
    assert [part.mesh for part in placed] == [0, 0, 0, 0, 1, 2, 1, 3, 3, 4, 3, 5, 5]
    assert [part.solid for part in placed] == list(range(13))
    assert len(meshes) == 6
    assert placed[3].scale.tolist() == [1, 2, 3]


def test_the_same_stage_gives_the_same_bits() -> None:
    solids = stage(*(solid(kind, *parameters) for kind, parameters, _ in ROUND))
    one, other = (tessellated(solids, 17, 1)[0] for _ in range(2))
    for a, b in zip(one, other, strict=True):
        assert a.vertices.tobytes() == b.vertices.tobytes()
        assert a.normals.tobytes() == b.normals.tobytes()
        assert a.triangles.tobytes() == b.triangles.tobytes()


def test_fineness_has_a_least_value() -> None:
    with pytest.raises(ValueError, match="fineness must be at least 3, got 2"):
        tessellated(stage(solid("sphere", 1)), 2, 1)


def prism(sides: int) -> Mesh:
    """A cylinder of radius 1 and height 2 given as a surface."""
    shape = trimesh.creation.cylinder(radius=1, height=2, sections=sides)
    return creased(shape.vertices, shape.faces.astype(np.int32))


def test_soft_edges_are_smooth_and_sharp_ones_split() -> None:
    smooth = prism(24)  # 15 degrees between its sides
    side = np.abs(smooth.normals[:, 2]) < 0.5
    assert side.sum() == 48
    np.testing.assert_allclose(
        smooth.normals[side], smooth.vertices[side] * [1, 1, 0], atol=1e-12
    )  # measured 3e-16
    assert set(np.abs(smooth.normals[~side, 2])) == {1.0}
    nut = prism(6)  # 60 degrees
    assert (np.abs(nut.normals[:, 2]) < 0.5).sum() == 24
    faces = {tuple(normal) for normal in nut.normals.round(9) + 0.0}
    assert len(faces) == 8


def test_how_a_flat_face_is_cut_does_not_turn_a_normal() -> None:
    """At one corner of a cube meet three faces of one or two triangles; each side keeps its own normal."""
    cube = trimesh.creation.box().subdivide()
    mesh = creased(cube.vertices, cube.faces.astype(np.int32))
    assert {tuple(normal) for normal in np.abs(mesh.normals)} == {(1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)}


def test_a_soup_of_triangles_becomes_smooth() -> None:
    """Every triangle with vertices of its own, as STL has them."""
    ball = trimesh.creation.icosphere(3)
    soup = ball.vertices[ball.faces].reshape(-1, 3)
    mesh = creased(soup, np.arange(len(soup), dtype=np.int32).reshape(-1, 3))
    assert len(mesh.vertices) == len(ball.vertices)
    np.testing.assert_allclose(mesh.normals, mesh.vertices, atol=0.01)  # measured 0.0046
    assert set(edges(mesh)) == {(b, a) for a, b in edges(mesh)}


def test_broken_surfaces_are_drawn_too() -> None:
    """A triangle without area, three triangles at one edge, two that are turned against each other."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0], [0, -1, 0]])
    triangles = np.array([[0, 1, 4], [0, 1, 2], [0, 1, 3], [1, 0, 5], [0, 1, 5]], np.int32)
    mesh = creased(points, triangles)
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-15)
    assert len(mesh.triangles) == 5
    np.testing.assert_array_equal(mesh.vertices[mesh.triangles], points[triangles])
