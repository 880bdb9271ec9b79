"""Moving, turning and joining of mass properties."""

from __future__ import annotations

import fine_meshes
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from physsim.model import inertia, polyhedron, primitives, rotation
from physsim.model.inertia import MassProperties

lengths = st.floats(0.05, 5.0)
coordinates = st.floats(-3.0, 3.0)
vectors = st.tuples(coordinates, coordinates, coordinates)
quaternions = (
    st.tuples(coordinates, coordinates, coordinates, coordinates)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: np.array(q) / np.linalg.norm(q))
)


def of_mesh(mesh: trimesh.Trimesh) -> MassProperties:
    return polyhedron.solid(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int32))


def box(size: tuple[float, float, float]) -> MassProperties:
    volume = primitives.box_volume(size)
    return MassProperties(volume, np.zeros(3), np.diag(primitives.box_inertia(volume, size)))


@given(vectors)
def test_parallel_axis_against_a_displaced_mesh(offset: tuple[float, float, float]) -> None:
    """Centre at `offset`, inertia about the world's origin, products included (1e-12 of the largest entry).

    The mesh's own route: eight mass points at size / sqrt(12) have exactly the second moments of a box.
    """
    size = (0.4, 0.7, 1.1)
    mesh = trimesh.creation.box(size)
    mesh.apply_translation(offset)
    moved = inertia.parallel_axis(of_mesh(mesh).inertia, mesh.volume, offset)
    nodes = np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T * (np.array(size) / np.sqrt(12))
    points = nodes + np.array(offset)
    direct = mesh.volume / 8 * sum(np.dot(p, p) * np.eye(3) - np.outer(p, p) for p in points)
    assert moved == pytest.approx(direct, abs=1e-12 * np.abs(direct).max())


def test_parallel_axis_products_have_the_sheets_signs() -> None:
    """I'_xx = I_xx + m (dy^2 + dz^2), I'_xy = I_xy - m dx dy."""
    moved = inertia.parallel_axis(np.zeros((3, 3)), 2.0, (1.0, 2.0, 3.0))
    assert moved.tolist() == [[26, -4, -6], [-4, 20, -12], [-6, -12, 10]]


@given(quaternions, vectors)
def test_a_turned_and_shifted_mesh_has_the_turned_and_shifted_properties(
    quaternion: np.ndarray, offset: tuple[float, float, float]
) -> None:
    """R I R^T and R c + t against a mesh with every vertex moved; 1e-11 of the largest entry."""
    mesh = trimesh.creation.cone(radius=0.5, height=1.2, sections=7)
    moved = of_mesh(mesh).moved(rotation.matrix(quaternion), offset)
    mesh.vertices = mesh.vertices @ rotation.matrix(quaternion).T + offset
    direct = of_mesh(mesh)
    assert moved.center == pytest.approx(direct.center, abs=1e-12)
    assert moved.inertia == pytest.approx(direct.inertia, abs=1e-11 * np.abs(direct.inertia).max())


@given(lengths, lengths, lengths, quaternions)
def test_every_turned_box_can_exist(a: float, b: float, c: float, quaternion: np.ndarray) -> None:
    """Positive definite, triangle inequality, and principal moments that do not depend on the frame."""
    body = box((a, b, c))
    turned = inertia.rotated(body.inertia, rotation.matrix(quaternion))
    assert inertia.impossible(turned) is None
    moments, axes = inertia.principal(turned)
    assert moments == pytest.approx(np.sort(np.diag(body.inertia)), rel=1e-12)
    assert axes @ np.diag(moments) @ axes.T == pytest.approx(turned, abs=1e-13 * moments[2])
    assert np.linalg.det(axes) == pytest.approx(1, abs=1e-12)


def test_a_compound_equals_the_merged_mesh() -> None:
    """A T of two boxes that touch: parts composed against one surface; 1e-13 relative."""
    upright, bar = (0.2, 0.3, 1.0), (0.8, 0.3, 0.2)
    bar_center = (0.05, 0.0, 0.6)
    composed = inertia.composed([box(upright), box(bar).moved(np.eye(3), bar_center)])
    second = trimesh.creation.box(bar)
    second.apply_translation(bar_center)
    merged = of_mesh(trimesh.util.concatenate([trimesh.creation.box(upright), second]))
    assert composed.mass == pytest.approx(merged.mass, rel=1e-14)
    assert composed.center == pytest.approx(merged.center, rel=1e-13)
    assert composed.inertia == pytest.approx(merged.inertia, rel=1e-13, abs=1e-15)


@given(vectors, st.lists(st.tuples(lengths, lengths, lengths, vectors), min_size=2, max_size=4))
def test_compounds_do_not_depend_on_where_the_frame_is(shift: tuple, parts: list) -> None:
    """Moving all parts moves the centre and leaves the inertia, however many parts there are."""
    here = [box((a, b, c)).moved(np.eye(3), position) for a, b, c, position in parts]
    there = [part.moved(np.eye(3), shift) for part in here]
    first, second = inertia.composed(here), inertia.composed(there)
    assert second.center == pytest.approx(first.center + np.array(shift), abs=1e-12)
    assert second.inertia == pytest.approx(first.inertia, abs=1e-11 * np.abs(first.inertia).max())


def test_solids_agree_with_trimesh_far_from_the_origin() -> None:
    """A part modelled 10 km from its origin keeps nine digits here; sums about the origin keep none."""
    mesh = fine_meshes.capsule(0.3, 0.8)(1)
    near = of_mesh(mesh)
    trimesh_inertia = mesh.moment_inertia
    assert near.inertia == pytest.approx(trimesh_inertia, rel=1e-10, abs=1e-12)
    mesh.vertices = mesh.vertices + 1e4
    assert np.diag(of_mesh(mesh).inertia) == pytest.approx(np.diag(near.inertia), rel=1e-9)


@pytest.mark.parametrize(
    ("moments", "said"),
    [((1, 1, 3), "triangle inequality"), ((1, -1, 1), "positive definite"), ((0, 1, 1), "positive definite")],
)
def test_impossible_tensors_are_named(moments: tuple[float, float, float], said: str) -> None:
    assert said in str(inertia.impossible(np.diag(np.array(moments, dtype=float))))


def test_a_flat_plate_is_possible() -> None:
    """I_3 = I_1 + I_2 exactly: the limit of the triangle inequality."""
    assert inertia.impossible(np.diag([1.0, 2.0, 3.0])) is None


def test_nothing_cannot_be_composed() -> None:
    with pytest.raises(ValueError, match="no mass"):
        inertia.composed([MassProperties(0.0, np.zeros(3), np.zeros((3, 3)))])
