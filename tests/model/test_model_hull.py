"""Convex hulls: closed polyhedra of planar convex polygons, no false edges."""

from __future__ import annotations

import fine_meshes
import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from physsim.model import polyhedron, rotation
from physsim.model.hull import Hull, convex_hull
from physsim.model.trouble import ShapeTrouble


def check(hull: Hull, points: np.ndarray) -> None:
    """Closed (every edge once each way, Euler's formula), planar, convex, outward, of the right volume."""
    size = np.linalg.norm(np.ptp(points, axis=0))
    edges = [(f[i], f[(i + 1) % len(f)]) for f in hull.faces for i in range(len(f))]
    assert len(set(edges)) == len(edges)
    assert set(edges) == {(b, a) for a, b in edges}
    assert len(hull.vertices) - len(edges) // 2 + len(hull.faces) == 2
    inside = hull.vertices.mean(axis=0)
    for face in hull.faces:
        corners = hull.vertices[list(face)]
        normal = newell(corners)
        assert np.abs((corners - corners.mean(axis=0)) @ normal).max() < 2e-6 * size
        assert (corners.mean(axis=0) - inside) @ normal > 0
        ahead = np.roll(corners, -1, axis=0) - corners
        turns = np.cross(np.roll(ahead, 1, axis=0), ahead) @ normal
        assert turns.min() > -1e-6 * size**2
    volume = polyhedron.solid(hull.vertices, hull.triangles()).mass
    assert volume == pytest.approx(ConvexHull(points).volume, rel=1e-6, abs=1e-7 * size**3)


def newell(corners: np.ndarray) -> np.ndarray:
    """Unit normal of a polygon, by Newell's sum."""
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return normal / np.linalg.norm(normal)


def sizes(hull: Hull) -> list[int]:
    return sorted(len(face) for face in hull.faces)


def test_a_box_has_six_squares() -> None:
    points = np.array(trimesh.creation.box((1, 2, 3)).vertices)
    hull = convex_hull(points)
    check(hull, points)
    assert sizes(hull) == [4] * 6
    assert len(hull.vertices) == 8


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e5])
def test_rounding_as_in_an_stl_file_makes_no_false_edges(scale: float) -> None:
    """A turned, finely divided box in 32-bit numbers, far from the origin, is still six squares."""
    mesh = trimesh.creation.box((1, 2, 3)).subdivide().subdivide()
    turned = (
        mesh.vertices
        @ rotation.matrix(np.array([0.5, 0.5, 0.1, 0.7]) / np.linalg.norm([0.5, 0.5, 0.1, 0.7])).T
    )
    points = ((turned + np.array([3, -2, 1])) * scale).astype(np.float32).astype(np.float64)
    hull = convex_hull(points)
    check(hull, points)
    assert sizes(hull) == [4] * 6


def test_a_cylinder_keeps_its_sides_and_has_two_lids() -> None:
    points = np.array(fine_meshes.cylinder(0.3, 0.8)(2).vertices)
    hull = convex_hull(points)
    check(hull, points)
    assert sizes(hull) == [4] * 64 + [64, 64]


def test_a_fine_sphere_keeps_its_facets() -> None:
    """10 242 vertices: neighbours differ by 1e-4 of the size, a hundred times the tolerance."""
    points = np.array(trimesh.creation.icosphere(subdivisions=5).vertices)
    hull = convex_hull(points)
    check(hull, points)
    assert len(hull.vertices) == len(points)


@pytest.mark.parametrize("thickness", [1e-5, 1e-4, 1e-3])
def test_thin_plates_keep_two_sides_and_an_edge(thickness: float) -> None:
    """Down to 1e-5 of the size; thinner ones are refused as flat."""
    points = np.array(fine_meshes.cylinder(0.5, thickness)(1).vertices)
    hull = convex_hull(points)
    check(hull, points)
    assert sizes(hull) == [4] * 32 + [32, 32]


def test_a_concave_mesh_gets_its_hull() -> None:
    points = np.array(trimesh.creation.torus(1.0, 0.3, major_sections=16, minor_sections=12).vertices)
    check(convex_hull(points), points)


numbers = st.integers(-8, 8).map(float)


@settings(max_examples=150)
@given(st.lists(st.tuples(numbers, numbers, numbers), min_size=4, max_size=40, unique=True))
def test_points_on_a_grid_with_many_in_one_plane(listed: list[tuple[float, float, float]]) -> None:
    """Grids are full of coplanar and collinear points: either flat, or a sound polyhedron."""
    points = np.array(listed)
    flat = np.linalg.matrix_rank(points - points[0]) < 3
    if flat:
        with pytest.raises(ShapeTrouble, match="no volume"):
            convex_hull(points)
    else:
        check(convex_hull(points), points)


@settings(max_examples=50)
@given(st.integers(0, 2**32 - 1), st.integers(5, 60))
def test_points_anywhere(seed: int, count: int) -> None:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    check(convex_hull(points), points)


def test_the_order_of_the_points_does_not_matter() -> None:
    """Same polygons, whatever the order in which a file lists the vertices."""
    points = np.random.default_rng(3).normal(size=(30, 3))
    shuffled = points[np.random.default_rng(4).permutation(30)]
    first, second = convex_hull(points), convex_hull(shuffled)
    assert {frozenset(map(tuple, first.vertices[list(f)])) for f in first.faces} == {
        frozenset(map(tuple, second.vertices[list(f)])) for f in second.faces
    }


@pytest.mark.parametrize(
    ("points", "said"),
    [
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "3 points"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0.5, 0.5, 1e-7]], "one plane"),
        ([[1, 1, 1]] * 5, "one plane"),
    ],
)
def test_flat_points_have_no_hull(points: list[list[float]], said: str) -> None:
    with pytest.raises(ShapeTrouble, match=said):
        convex_hull(np.array(points, dtype=float))
