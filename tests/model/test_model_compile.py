"""Scenes to models: masses, compounds, the border dictionary, doubts about the timestep."""

from __future__ import annotations

import subprocess
import sys
from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_scenes import body, body_problem, compiled, problems

from physsim.errors import dotted
from physsim.model import GeomKind, no_contact, primitives

FLOOR = "  floor: {fixed: true, shape: {type: halfspace}, material: concrete}\n"


# ---------------------------------------------------------------- mass and where it comes from


def test_mass_is_given_or_density_times_volume() -> None:
    """The body's density goes before the material's, the scene's material before the library's."""
    cube = "shape: {type: box, size: [10 cm, 10 cm, 10 cm]}, material: steel"
    assert body(cube).mass[0] == pytest.approx(7.85)
    assert body(cube).mass_method[0] == "closed form (box), density of steel"
    assert body(f"{cube}, density: 1 g/cm^3").mass[0] == pytest.approx(1.0)
    assert body(f"{cube}, mass: 3 kg").mass_method[0] == "closed form (box), mass given"
    redefined = compiled(f"materials: {{steel: {{density: 8000}}}}\nbodies: {{a: {{{cube}}}}}\n")
    assert redefined.mass[0] == pytest.approx(8.0)


def test_inertia_scales_with_the_given_mass() -> None:
    model = body("shape: {type: cylinder, radius: 0.2, height: 0.5}, mass: 3 kg, material: steel")
    assert np.diag(model.inertia[0]) == pytest.approx(primitives.cylinder_inertia(3, 0.2, 0.5), rel=1e-14)


def test_declared_inertia_overrides() -> None:
    keys = "inertia: {xx: 3, yy: 4, zz: 5, xy: 0.1, xz: -0.2, yz: 0.3}"
    model = body(f"shape: {{type: sphere, radius: 1}}, mass: 2 kg, material: steel, {keys}")
    assert model.inertia[0].tolist() == [[3, 0.1, -0.2], [0.1, 4, 0.3], [-0.2, 0.3, 5]]
    assert "inertia given in the scene" in model.mass_method[0]


def test_what_has_no_volume_needs_a_mass() -> None:
    problem = body_problem("shape: {type: hollow_sphere, radius: 1}, material: steel")
    assert "needs a mass" in problem.message
    assert body("shape: {type: hollow_sphere, radius: 1}, mass: 1 kg, material: steel").mass[0] == 1


def test_a_material_without_density_needs_a_mass() -> None:
    problem = body_problem("shape: {type: sphere, radius: 1}, material: shoe")
    assert "'shoe' has no density" in problem.message


def test_fixed_bodies_need_no_mass() -> None:
    model = body("shape: {type: hollow_sphere, radius: 1}, fixed: true, material: steel")
    assert model.mass[0] == inf
    assert "not needed" in model.mass_method[0]


# ---------------------------------------------------------------- compounds

DUMBBELL = (
    "shape: {type: compound, parts: ["
    "{shape: {type: sphere, radius: 10 cm}, position: [0.5, 0, 0], material: lead}, "
    "{shape: {type: cylinder, radius: 2 cm, height: 1 m}, orientation: {axis: [0, 1, 0], angle: 90 deg}}, "
    "{shape: {type: sphere, radius: 10 cm}, position: [-0.5, 0, 0]}]}, material: steel"
)


def dumbbell_by_hand(densities: tuple[float, float, float]) -> tuple[float, float, np.ndarray]:
    """Mass, centre along x and the moments, from the textbook formulas alone; the cylinder lies along x."""
    ball, bar = 4 / 3 * np.pi * 0.1**3, np.pi * 0.02**2
    right, middle, left = densities[0] * ball, densities[1] * bar, densities[2] * ball
    mass = right + middle + left
    x = (0.5 * right - 0.5 * left) / mass
    along = 0.4 * (right + left) * 0.1**2 + middle * 0.02**2 / 2
    across = 0.4 * (right + left) * 0.1**2 + middle * (3 * 0.02**2 + 1) / 12
    across += right * (0.5 - x) ** 2 + middle * x**2 + left * (0.5 + x) ** 2
    return mass, x, np.array([along, across, across])


def test_a_compound_of_several_materials() -> None:
    mass, x, moments = dumbbell_by_hand((11340, 7850, 7850))
    model = body(DUMBBELL)
    assert model.mass[0] == pytest.approx(mass, rel=1e-14)
    assert model.center_of_mass[0] == pytest.approx([x, 0, 0], abs=1e-15)
    assert np.diag(model.inertia[0]) == pytest.approx(moments, rel=1e-13)
    assert model.material_names == ("lead", "steel")
    assert [model.material_names[m] for m in model.geoms.material] == ["lead", "steel", "steel"]
    assert model.geoms.position[:, 0] == pytest.approx([0.5 - x, -x, -0.5 - x])


def test_a_total_mass_scales_the_distribution() -> None:
    """Given 10 kg, the lead ball still weighs 1.44 times the steel one."""
    mass, x, moments = dumbbell_by_hand((11340, 7850, 7850))
    model = body(f"{DUMBBELL}, mass: 10 kg")
    assert model.mass[0] == pytest.approx(10)
    assert model.center_of_mass[0][0] == pytest.approx(x, rel=1e-13)
    assert np.diag(model.inertia[0]) == pytest.approx(moments * 10 / mass, rel=1e-13)


def test_a_part_without_volume_has_no_share_of_the_mass() -> None:
    parts = "[{shape: {type: sphere, radius: 1}}, {shape: {type: rod, length: 1}}]"
    problem = body_problem(f"mass: 1 kg, material: steel, shape: {{type: compound, parts: {parts}}}")
    assert dotted(problem.path) == "bodies.thing.shape.parts[1]"
    assert "no volume" in problem.message


def test_a_cone_collides_about_its_centre_of_mass() -> None:
    """The geom's frame is the centre of mass already: base at -H/4, apex at 3H/4 (the border's rule)."""
    model = body("shape: {type: cone, radius: 0.3, height: 0.8}, material: steel, position: [0, 0, 0.2]")
    assert model.center_of_mass[0].tolist() == [0, 0, 0]
    assert model.geoms.position[0].tolist() == [0, 0, 0]
    assert model.geoms.parameters[0].tolist() == [0.3, 0.8, 0, 0]


def test_convex_from_points_keeps_origin_and_centre_apart() -> None:
    """A corner tetrahedron: volume 1/6, centre at a quarter of each edge."""
    model = body(
        "shape: {type: convex, points: [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, density: 6, material: steel"
    )
    assert model.mass[0] == pytest.approx(1)
    assert model.center_of_mass[0] == pytest.approx([0.25] * 3)
    corners = model.geoms.hulls[0].vertices + model.geoms.position[0] + 0.25
    assert sorted(map(tuple, corners.round(12))) == [(0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0)]


def test_flat_points_are_told_at_their_key() -> None:
    problem = body_problem(
        "shape: {type: convex, points: [[0,0,0], [1,0,0], [0,1,0], [1,1,0]]}, material: steel"
    )
    assert dotted(problem.path) == "bodies.thing.shape.points"


# ---------------------------------------------------------------- the border dictionary

EVERY_KIND = "".join(
    f"  {name}: {{shape: {{type: {name}, {keys}}}, mass: 1 kg, material: steel, position: [{i}, 0, 9]}}\n"
    for i, (name, keys) in enumerate(
        {
            "sphere": "radius: 0.1",
            "capsule": "radius: 0.1, height: 0.4",
            "box": "size: [0.2, 0.4, 0.6]",
            "cylinder": "radius: 0.1, height: 0.4",
            "cone": "radius: 0.1, height: 0.4",
            "ellipsoid": "radii: [0.1, 0.2, 0.3]",
            "rod": "length: 0.4",
            "convex": "points: [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]",
            "hollow_sphere": "radius: 0.1",
        }.items()
    )
)


def test_kinds_and_parameters_of_the_border() -> None:
    given = compiled("bodies:\n" + EVERY_KIND + FLOOR).engine_input()
    assert given["geom_kind"].tolist() == [*range(8), GeomKind.SPHERE, GeomKind.HALFSPACE]  # type: ignore[attr-defined]
    expected = [
        [0.1],
        [0.1, 0.2],
        [0.1, 0.2, 0.3],
        [0.1, 0.2],
        [0.1, 0.4],
        [0.1, 0.2, 0.3],
        [0.2],
        [0],
        [0.1],
        [],
    ]
    assert given["geom_parameters"].tolist() == [row + [0.0] * (4 - len(row)) for row in expected]  # type: ignore[attr-defined]


def test_arrays_of_the_border_are_contiguous_and_typed() -> None:
    given = compiled("bodies:\n" + EVERY_KIND + FLOOR + "no_contact: [[box, cone]]\n").engine_input()
    arrays = {name: value for name, value in given.items() if isinstance(value, np.ndarray)}
    whole = {"fixed", "no_contact", "force_frame"}
    counted = ("_body", "_bodies", "_kind", "_material", "_profile", "_joint", "_coordinate")
    for name, array in arrays.items():
        assert array.flags.c_contiguous, name
        is_whole = name in whole or name.endswith(counted)
        assert array.dtype == (np.int32 if is_whole else np.float64), name
    assert arrays["inertia"].shape == (10, 3, 3)
    assert arrays["restitution"].shape == (2, 2)
    assert arrays["no_contact"].tolist() == [[2, 4]]


def test_the_engine_takes_it() -> None:
    """The other side of the border builds a world from it and hands the state back unchanged."""
    engine = pytest.importorskip("physsim._engine")
    model = compiled("bodies:\n" + EVERY_KIND + FLOOR)
    state = engine.World(model.engine_input()).state()
    assert state["position"] == pytest.approx(model.world_center_of_mass(), abs=0)
    assert state["orientation"] == pytest.approx(model.orientation, abs=0)


@given(
    st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(-1, 1)).filter(lambda n: np.linalg.norm(n) > 0.1)
)
def test_halfspaces_face_along_their_normal(normal: tuple[float, float, float]) -> None:
    """The geom's z axis is the normal, its origin lies at offset along it."""
    from physsim.model import rotation  # noqa: PLC0415

    model = body(
        f"shape: {{type: halfspace, normal: {list(normal)}, offset: 2}}, fixed: true, material: steel"
    )
    unit = np.array(normal) / np.linalg.norm(normal)
    assert rotation.matrix(model.geoms.orientation[0])[:, 2] == pytest.approx(unit, abs=1e-14)
    assert model.geoms.position[0] == pytest.approx(2 * unit, abs=1e-14)


def test_bodies_that_do_not_collide_have_no_geoms() -> None:
    model = body("shape: {type: sphere, radius: 1}, mass: 1 kg, collides: false")
    assert len(model.geoms.body) == 0
    assert model.engine_input()["geom_parameters"].shape == (0, 4)  # type: ignore[attr-defined]


def test_copies_of_a_repeated_body() -> None:
    model = body(
        "shape: {type: box, size: [1, 1, 1]}, material: concrete, position: [5, 0, 0], "
        "repeat: {count: [2, 1, 3], spacing: [2, 0, 3]}"
    )
    assert model.body_names[:3] == ("thing[0,0,0]", "thing[0,0,1]", "thing[0,0,2]")
    assert model.position[:, 0].tolist() == [5, 5, 5, 7, 7, 7]
    assert model.position[:, 2].tolist() == [0, 3, 6, 0, 3, 6]
    assert len(set(model.mass)) == 1


# ---------------------------------------------------------------- doubts


def test_a_fast_small_body_needs_a_shorter_timestep() -> None:
    """1 cm at 50 m/s moves 5 times its size in a millisecond; 0.1 ms is the bound the hint gives."""
    ball = "shape: {type: sphere, radius: 5 mm}, material: steel, velocity: [30, 40, 0]"
    (warning,) = body(ball).warnings
    assert dotted(warning.path) == "bodies.thing"
    assert warning.message.startswith("moves 5 of its smallest dimension (0.01 m)")
    assert "below 0.0001 s" in str(warning.hint)
    slow = compiled(f"bodies: {{a: {{{ball.replace('30, 40', '2, 4')}}}}}\n")
    assert slow.warnings == ()


def test_one_warning_for_all_copies() -> None:
    keys = "shape: {type: sphere, radius: 1 mm}, material: steel, velocity: [9, 0, 0]"
    assert len(body(f"{keys}, repeat: {{count: [5, 1, 1], spacing: [1, 0, 0]}}").warnings) == 1


def test_a_fast_spin_needs_a_shorter_timestep() -> None:
    (warning,) = body(
        "shape: {type: sphere, radius: 1}, material: steel, angular_velocity: [0, 0, 6e4 rpm]"
    ).warnings
    assert "turns 6.28 rad in one step" in warning.message


def test_a_tiny_body_under_gravity_is_told() -> None:
    """At rest, but one step of free fall is as long as the body is thick."""
    (warning,) = compiled("bodies: {a: {shape: {type: sphere, radius: 1 um}, material: steel}}\n").warnings
    assert "contacts can be missed" in warning.message


# ---------------------------------------------------------------- no_contact


def test_patterns_take_brackets_as_they_stand() -> None:
    """`a[*` is a bracket and a star: copies of a, and not the body called ab."""
    copies = "shape: {type: sphere, radius: 0.1}, material: steel"
    model = compiled(
        f"bodies:\n  a: {{{copies}, repeat: {{count: [2, 1, 1], spacing: [1, 0, 0]}}}}\n  ab: {{{copies}}}\n"
        'no_contact: [["a[*", ab], ["*", "a[0,0,0]"]]\n'
    )
    assert model.no_contact.tolist() == [[0, 1], [0, 2], [1, 2]]


def test_everything_against_everything_is_every_pair_once() -> None:
    keys = (
        "shape: {type: sphere, radius: 0.1}, material: steel, repeat: {count: [20, 1, 1], spacing: [1, 0, 0]}"
    )
    model = compiled(f'bodies:\n  a: {{{keys}}}\nno_contact: [["*", "a*"]]\n')
    i, j = np.triu_indices(20, k=1)
    assert model.no_contact.tolist() == np.column_stack([i, j]).tolist()


def test_too_many_pairs_are_refused_before_they_are_listed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(no_contact, "MAX_PAIRS", 99)
    keys = (
        "shape: {type: sphere, radius: 0.1}, material: steel, repeat: {count: [10, 1, 1], spacing: [1, 0, 0]}"
    )
    (problem,) = problems(f'bodies:\n  a: {{{keys}}}\nno_contact: [["*", "*"]]\n')
    assert problem.line == 5
    assert "more than 99 pairs" in problem.message


# ---------------------------------------------------------------- imports


def test_primitives_need_neither_trimesh_nor_scipy() -> None:
    code = (
        "import sys; from physsim.scene import load_scene_text; from physsim.model import compile_scene; "
        "compile_scene(load_scene_text(sys.argv[1])); "
        "sys.exit(any(name in sys.modules for name in ('trimesh', 'scipy', 'fcl', 'coacd')))"
    )
    text = "physsim: 1\nsimulation: {duration: 1 s, timestep: 1 ms}\nbodies:\n" + FLOOR
    assert subprocess.run([sys.executable, "-c", code, text], check=False).returncode == 0
