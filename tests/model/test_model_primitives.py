"""Closed forms of mass and inertia: the formula sheet's section 6, and each shape against a fine mesh."""

from __future__ import annotations

from math import pi

import fine_meshes
import numpy as np
import pytest

from physsim.model import polyhedron, primitives

M, R, H, L = 2.5, 0.3, 0.8, 1.4


def test_the_sheets_formulas_one_by_one() -> None:
    """Typed anew from section 6 of the sheet, its lost lines from Beer & Johnston; a, b, c are half edges."""
    a, b, c = 0.2, 0.35, 0.5
    exact = {"rel": 1e-14, "abs": 0}
    assert primitives.sphere_inertia(M, R) == pytest.approx([0.4 * M * R**2] * 3, **exact)
    assert primitives.hollow_sphere_inertia(M, R) == pytest.approx([2 * M * R**2 / 3] * 3, **exact)
    across = M * R**2 / 4 + M * H**2 / 12
    assert primitives.cylinder_inertia(M, R, H) == pytest.approx([across, across, M * R**2 / 2], **exact)
    sides = [M * (b**2 + c**2) / 3, M * (a**2 + c**2) / 3, M * (a**2 + b**2) / 3]
    assert primitives.box_inertia(M, (2 * a, 2 * b, 2 * c)) == pytest.approx(sides, **exact)
    across = 3 * M * (4 * R**2 + H**2) / 80
    assert primitives.cone_inertia(M, R, H) == pytest.approx([across, across, 3 * M * R**2 / 10], **exact)
    assert primitives.rod_inertia(M, L)[:2] == pytest.approx([M * L**2 / 12] * 2, **exact)
    ellipsoid = [M * (b**2 + c**2) / 5, M * (a**2 + c**2) / 5, M * (a**2 + b**2) / 5]
    assert primitives.ellipsoid_inertia(M, (a, b, c)) == pytest.approx(ellipsoid, **exact)


def test_volumes() -> None:
    """Textbook volumes; a capsule is a cylinder and a sphere."""
    assert primitives.sphere_volume(R) == pytest.approx(4 * pi * R**3 / 3, rel=1e-15)
    assert primitives.box_volume((1, 2, 3)) == 6
    assert primitives.cylinder_volume(R, H) == pytest.approx(pi * R * R * H, rel=1e-15)
    assert primitives.cone_volume(R, H) == pytest.approx(pi * R * R * H / 3, rel=1e-15)
    assert primitives.capsule_volume(R, H) == pytest.approx(pi * R * R * H + 4 * pi * R**3 / 3, rel=1e-15)
    assert primitives.ellipsoid_volume((1, 2, 3)) == pytest.approx(8 * pi, rel=1e-15)


def test_the_thin_rod_has_a_small_moment_about_itself() -> None:
    """The sheet says about zero: 6e-6 of the moment across is that, and can be inverted."""
    across, _, along = primitives.rod_inertia(M, L)
    assert 0 < along < 1e-5 * across


def test_limits_of_the_capsule() -> None:
    """Without height it is the sphere; very long, the cylinder."""
    assert primitives.capsule_inertia(M, R, 0) == pytest.approx(primitives.sphere_inertia(M, R), rel=1e-14)
    long_capsule, long_cylinder = (
        primitives.capsule_inertia(M, R, 1e6),
        primitives.cylinder_inertia(M, R, 1e6),
    )
    assert long_capsule == pytest.approx(long_cylinder, rel=1e-5)


SOLIDS = {
    "sphere": (fine_meshes.sphere(R), primitives.sphere_volume(R), primitives.sphere_inertia(1, R)),
    "cylinder": (
        fine_meshes.cylinder(R, H),
        primitives.cylinder_volume(R, H),
        primitives.cylinder_inertia(1, R, H),
    ),
    "capsule": (
        fine_meshes.capsule(R, H),
        primitives.capsule_volume(R, H),
        primitives.capsule_inertia(1, R, H),
    ),
    "cone": (fine_meshes.cone(R, H), primitives.cone_volume(R, H), primitives.cone_inertia(1, R, H)),
    "ellipsoid": (
        fine_meshes.ellipsoid((0.2, 0.35, 0.5)),
        primitives.ellipsoid_volume((0.2, 0.35, 0.5)),
        primitives.ellipsoid_inertia(1, (0.2, 0.35, 0.5)),
    ),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_a_fine_mesh_tends_to_the_closed_form_at_second_order(name: str) -> None:
    """Halving the edges divides the error by four: 3.90 to 4.05 measured over three halvings."""
    mesher, volume, inertia = SOLIDS[name]
    errors = []
    for level in (1, 2, 3, 4):
        mesh = mesher(level)
        solid = polyhedron.solid(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int32))
        per_kilogram = np.diag(solid.inertia) / solid.mass
        errors.append([abs(solid.mass / volume - 1), *np.abs(per_kilogram / inertia - 1)])
    ratios = np.array(errors)[:-1] / np.array(errors)[1:]
    assert ratios[-1] == pytest.approx([4, 4, 4, 4], abs=0.1)
    assert np.max(errors[-1]) < 5e-3


def test_the_box_mesh_is_exact() -> None:
    mesh = fine_meshes.box((0.4, 0.7, 1.1))(0)
    solid = polyhedron.solid(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int32))
    assert solid.mass == pytest.approx(primitives.box_volume((0.4, 0.7, 1.1)), rel=1e-14)
    assert np.diag(solid.inertia) == pytest.approx(
        primitives.box_inertia(solid.mass, (0.4, 0.7, 1.1)), rel=1e-13
    )


def test_the_shell_of_a_sphere_mesh_tends_to_the_hollow_sphere() -> None:
    """Second order: ratio 4.0 measured."""
    errors = []
    for level in (1, 2, 3):
        mesh = fine_meshes.sphere(R)(level)
        shell = polyhedron.shell(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int32))
        closed = primitives.hollow_sphere_inertia(shell.mass, R)
        errors.append(abs(shell.inertia[2, 2] / closed[2] - 1))
    assert errors[1] / errors[2] == pytest.approx(4, abs=0.1)


def test_the_cones_centre_is_a_quarter_of_its_height_above_the_base() -> None:
    """The origin of a cone is its centre of mass, so its geom must have the base at -H/4."""
    mesh = fine_meshes.cone(R, H)(2)
    solid = polyhedron.solid(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int32))
    assert solid.center == pytest.approx([0, 0, H / 4], abs=1e-14)
