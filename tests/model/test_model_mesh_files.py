"""Mesh files: every format, every mistake, and nothing but the file itself is read."""

from __future__ import annotations

import builtins
import hashlib
import io
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from small_scenes import HEAD, body, body_problem, compiled, problems

from physsim.errors import SceneError, dotted
from physsim.model import MeshMemory, compile_scene, hull, mesh_obj, mesh_text
from physsim.model import mesh as mesh_room
from physsim.model.mesh import FORMATS, read_mesh
from physsim.model.trouble import ShapeTrouble
from physsim.scene import load_scene_text

STEEL = "material: steel"


def write(folder: Path, mesh: trimesh.Trimesh, name: str = "part.stl", **options: Any) -> Path:
    path = folder / name
    mesh.export(path, **options)
    return path


def mesh_body(name: str, more: str = "", keys: str = STEEL) -> str:
    extra = f", {more}" if more else ""
    return f"shape: {{type: mesh, file: {name}{extra}}}, {keys}"


def wedge() -> trimesh.Trimesh:
    """A closed body without any symmetry."""
    points = [[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4], [2, 1, 3]]
    return trimesh.convex.convex_hull(np.array(points, dtype=float))


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("part.obj", {}),
        ("part.stl", {}),
        ("ascii.stl", {"file_type": "stl_ascii"}),
        ("part.ply", {}),
        ("ascii.ply", {"encoding": "ascii"}),
        ("part.off", {}),
        ("PART.STL", {"file_type": "stl"}),
    ],
)
def test_every_format_gives_the_same_body(tmp_path: Path, name: str, options: dict[str, Any]) -> None:
    """Mass, centre and inertia against trimesh; 1e-6, since STL holds 32-bit numbers."""
    part = wedge()
    write(tmp_path, part, name, **options)
    model = body(mesh_body(name, "scale: 10 cm"), tmp_path)
    part.apply_scale(0.1)
    part.density = 7850.0
    assert model.mass[0] == pytest.approx(part.mass, rel=1e-6)
    assert model.center_of_mass[0] == pytest.approx(part.center_mass, rel=1e-6)
    assert model.inertia[0] == pytest.approx(part.moment_inertia, rel=1e-5, abs=1e-8)
    assert model.mass_method[0] == f"mesh, solid, {len(part.faces)} triangles, density of steel"


def test_origin_and_centre_of_mass_are_kept_apart(tmp_path: Path) -> None:
    """`position` is the file's origin; the engine gets the centre, and the geom where it was drawn."""
    part = wedge()
    write(tmp_path, part)
    keys = f"{STEEL}, position: [10, 0, 0], orientation: {{axis: [0, 0, 1], angle: 90 deg}}"
    model = body(mesh_body("part.stl", keys=keys), tmp_path)
    x, y, z = part.center_mass
    given = model.engine_input()
    assert model.position[0].tolist() == [10, 0, 0]
    assert given["position"] == pytest.approx(np.array([[10 - y, x, z]]), abs=1e-6)
    in_body = model.geoms.hulls[0].vertices + model.geoms.position[0] + model.center_of_mass[0]
    assert np.sort(in_body, axis=0) == pytest.approx(np.sort(part.vertices, axis=0), abs=1e-6)


def test_shell_and_hull_inertia(tmp_path: Path) -> None:
    """An L profile: its surface and its hull, against trimesh's own area and hull."""
    lying, standing = trimesh.creation.box((3, 1, 1)), trimesh.creation.box((1, 1, 2))
    lying.apply_translation((1, 0, 0))
    standing.apply_translation((0, 0, 1.5))
    profile = trimesh.util.concatenate([lying, standing])
    write(tmp_path, profile, "l.obj")
    hull = body(mesh_body("l.obj", "inertia: hull"), tmp_path)
    assert hull.mass[0] == pytest.approx(profile.convex_hull.volume * 7850, rel=1e-12)
    assert hull.center_of_mass[0] == pytest.approx(profile.convex_hull.center_mass, abs=1e-12)
    shell = body(mesh_body("l.obj", "inertia: shell", keys=f"{STEEL}, mass: 2 kg"), tmp_path)
    centers, areas = profile.triangles_center, profile.area_faces
    assert shell.center_of_mass[0] == pytest.approx(areas @ centers / areas.sum(), abs=1e-12)
    problem = body_problem(mesh_body("l.obj", "inertia: shell"), tmp_path)
    assert "needs a mass" in problem.message


def test_a_file_is_read_once_and_its_hash_told(tmp_path: Path) -> None:
    path = write(tmp_path, wedge())
    shape = "shape: {type: mesh, file: part.stl}, material: steel"
    model = compiled(f"bodies:\n  a: {{{shape}, position: [9, 0, 0]}}\n  b: {{{shape}}}\n", tmp_path)
    assert model.mesh_sha256 == {"part.stl": hashlib.sha256(path.read_bytes()).hexdigest()}
    assert len(model.geoms.hulls) == 1


def test_copies_share_one_hull(tmp_path: Path) -> None:
    write(tmp_path, wedge())
    keys = f"{STEEL}, repeat: {{count: [3, 2, 1], spacing: [9, 9, 0]}}"
    model = body(mesh_body("part.stl", keys=keys), tmp_path)
    assert len(model.body_names) == 6
    assert len(model.geoms.hulls) == 1
    assert model.geoms.parameters[:, 0].tolist() == [0] * 6


@pytest.mark.parametrize("collision", ["hull", "pieces"])
def test_what_never_collides_needs_no_hull(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, collision: str
) -> None:
    """A torus of 160 000 triangles was refused for its hull, and cut into pieces for nothing."""
    monkeypatch.setattr(hull, "MAX_TRIANGLES", 3)
    write(tmp_path, wedge())
    keys = mesh_body("part.stl", f"collision: {collision}")
    problem = body_problem("shape: {type: mesh, file: part.stl}, material: steel", tmp_path)
    assert "has a convex hull of" in problem.message
    assert body(f"{keys}, collides: false", tmp_path).mass[0] > 0


# ---------------------------------------------------------------- mistakes


def test_missing_file(tmp_path: Path) -> None:
    problem = body_problem(mesh_body("part.stl"), tmp_path)
    assert dotted(problem.path) == "bodies.thing.shape.file"
    assert "no such file" in problem.message


def test_unknown_format(tmp_path: Path) -> None:
    (tmp_path / "part.step").write_text("ISO-10303-21;")
    problem = body_problem(mesh_body("part.step"), tmp_path)
    assert "no known mesh format" in problem.message
    assert problem.allowed == ", ".join(FORMATS)


def test_not_closed(tmp_path: Path) -> None:
    part = wedge()
    part.update_faces(np.arange(len(part.faces)) > 0)
    write(tmp_path, part)
    problem = body_problem(mesh_body("part.stl"), tmp_path)
    assert problem.message.startswith("is not closed: 3 edges")
    assert "inertia: hull" in str(problem.hint)
    assert body(mesh_body("part.stl", "inertia: hull"), tmp_path).mass[0] > 0


def test_one_triangle_turned_over_is_not_closed(tmp_path: Path) -> None:
    part = wedge()
    part.faces[2] = part.faces[2][::-1]
    write(tmp_path, part, "part.obj")
    assert body_problem(mesh_body("part.obj"), tmp_path).message.startswith("is not closed: 3 edges")


def test_inside_out(tmp_path: Path) -> None:
    part = wedge()
    part.invert()
    write(tmp_path, part)
    problem = body_problem(mesh_body("part.stl"), tmp_path)
    assert "is inside out" in problem.message
    assert "normals" in str(problem.hint)


@pytest.mark.parametrize(
    ("name", "text"), [("a.obj", ""), ("b.obj", "v 0 0 0\nv 1 0 0\n"), ("c.stl", "solid\nendsolid\n")]
)
def test_empty(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    assert "is empty" in body_problem(mesh_body(name), tmp_path).message


def test_degenerate(tmp_path: Path) -> None:
    (tmp_path / "line.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 2 3 4\n")
    (tmp_path / "point.obj").write_text("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")
    for name in ("line.obj", "point.obj"):
        assert "is degenerate" in body_problem(mesh_body(name), tmp_path).message


def test_zero_volume(tmp_path: Path) -> None:
    """A tetrahedron pressed flat is closed, and holds nothing."""
    faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
    (tmp_path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + faces)
    assert "encloses no volume" in body_problem(mesh_body("flat.obj"), tmp_path).message


@pytest.mark.parametrize("value", ["nan", "inf", "1e999"])
def test_not_finite(tmp_path: Path, value: str) -> None:
    (tmp_path / "part.obj").write_text(f"v 0 0 0\nv 1 0 {value}\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    assert "not finite" in body_problem(mesh_body("part.obj"), tmp_path).message


def test_indices_beyond_the_vertices(tmp_path: Path) -> None:
    (tmp_path / "part.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    assert body_problem(mesh_body("part.obj"), tmp_path).path[-1] == "file"


@pytest.mark.parametrize("name", ["part.stl", "part.obj", "part.off"])
def test_too_many_triangles(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    write(tmp_path, wedge(), name)
    monkeypatch.setattr(mesh_room, "MAX_TRIANGLES", 5)
    problem = body_problem(mesh_body(name), tmp_path)
    assert "too many triangles" in problem.message
    assert problem.allowed == "at most 5"


@pytest.mark.parametrize(("name", "options"), [("part.off", {}), ("part.ply", {"encoding": "ascii"})])
def test_long_texts_are_asked_for_in_binary(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, options: dict[str, Any]
) -> None:
    monkeypatch.setattr(mesh_text, "MAX_TEXT_BYTES", 99)
    write(tmp_path, wedge(), name, **options)
    assert "binary STL or PLY" in str(body_problem(mesh_body(name), tmp_path).hint)


def test_a_count_in_the_header_does_not_make_memory(tmp_path: Path) -> None:
    """An STL that claims four thousand million triangles, and a PLY that claims as many vertices."""
    (tmp_path / "part.stl").write_bytes(b"\0" * 80 + struct.pack("<I", 2**32 - 1) + b"\0" * 50)
    head = b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
    (tmp_path / "part.ply").write_bytes(head + b"end_header\n\0\0\0\0")
    for name in ("part.stl", "part.ply"):
        assert body_problem(mesh_body(name), tmp_path).path[-1] == "file"


@pytest.mark.parametrize("suffix", FORMATS)
def test_what_is_no_mesh_is_told_in_one_line(tmp_path: Path, suffix: str) -> None:
    (tmp_path / f"part{suffix}").write_bytes(bytes(range(256)) * 8)
    problem = body_problem(mesh_body(f"part{suffix}"), tmp_path)
    assert problem.path[-1] == "file"
    assert "\n" not in problem.message


def test_a_surface_that_gives_an_impossible_inertia(tmp_path: Path) -> None:
    """A cube and, ten edges away, a smaller one turned inside out: closed, and of positive volume."""
    first, second = trimesh.creation.box((1, 1, 1)), trimesh.creation.box((0.9, 0.9, 0.9))
    second.invert()
    second.apply_translation((10, 0, 0))
    write(tmp_path, trimesh.util.concatenate([first, second]), "part.obj")
    problem = body_problem(mesh_body("part.obj"), tmp_path)
    assert "inertia that is not positive definite" in problem.message
    assert "cut itself" in str(problem.hint)


def test_a_file_that_vanishes_after_the_scene_was_read(tmp_path: Path) -> None:
    path = write(tmp_path, wedge())
    text = HEAD + "bodies:\n  thing: {" + mesh_body("part.stl") + "}\n"
    scene = load_scene_text(text, folder=tmp_path)
    path.unlink()
    with pytest.raises(SceneError) as raised:
        compile_scene(scene)
    assert raised.value.problems[0].line == 4


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    part = wedge()
    part.invert()
    write(tmp_path, part, "out.stl")
    (tmp_path / "empty.obj").write_text("")
    found = problems(
        "bodies:\n"
        "  a: {shape: {type: mesh, file: out.stl}, material: steel}\n"
        "  b: {shape: {type: mesh, file: empty.obj}, material: steel}\n"
        "  c: {shape: {type: hollow_sphere, radius: 1}, material: steel}\n",
        tmp_path,
    )
    assert [(problem.line, dotted(problem.path)) for problem in found] == [
        (4, "bodies.a.shape.file"),
        (5, "bodies.b.shape.file"),
        (6, "bodies.c"),
    ]


# ---------------------------------------------------------------- doubts


def test_a_metre_drawn_in_millimetres(tmp_path: Path) -> None:
    """A crate of one metre in a file of millimetres, without `scale`: a warning with the remedy."""
    write(tmp_path, trimesh.creation.box((1000, 1000, 1000)))
    (warning,) = body(mesh_body("part.stl"), tmp_path).warnings
    assert warning.severity == "warning"
    assert dotted(warning.path) == "bodies.thing.shape.scale"
    assert warning.line == 4
    assert "scale: 1 mm" in str(warning.hint)
    assert body(mesh_body("part.stl", "scale: 1 mm"), tmp_path).warnings == ()


def test_out_of_scale_beside_the_other_bodies(tmp_path: Path) -> None:
    """A 3 cm nut drawn in millimetres is 52 m across: no giant by itself, but beside a ball of 2 cm."""
    write(tmp_path, trimesh.creation.box((30, 30, 30)))
    ball = "  ball: {shape: {type: sphere, radius: 1 cm}, material: steel}\n"
    nut = "  nut: {shape: {type: mesh, file: part.stl}, material: steel}\n"
    (warning,) = compiled("bodies:\n" + ball + nut, tmp_path).warnings
    assert "times the other bodies" in warning.message
    large, small = ball.replace("1 cm", "1 m"), nut.replace("part.stl", "part.stl, scale: 1e-5")
    (warning,) = compiled("bodies:\n" + large + small, tmp_path).warnings
    assert "times smaller" in warning.message


def test_an_open_mesh_may_stand_fixed(tmp_path: Path) -> None:
    """A funnel has no inside and needs none: exact triangles, mass unknown and not needed."""
    funnel = trimesh.creation.cone(radius=1, height=1, sections=12)
    funnel.update_faces(np.abs(funnel.face_normals[:, 2]) < 0.99)
    write(tmp_path, funnel)
    model = body(mesh_body("part.stl", "collision: exact", "fixed: true, material: steel"), tmp_path)
    assert np.isinf(model.mass[0])
    (surface,) = model.geoms.surfaces
    assert len(surface.triangles) == 12
    assert model.geoms.kind.tolist() == [9]


# ---------------------------------------------------------------- how people write OBJ

TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
COUNTED_BACK = "v {x} 0 0\nv {y} 0 0\nv {x} 1 0\nv {x} 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n"


@pytest.mark.parametrize(
    ("text", "volumes"),
    [
        (TETRAHEDRON, 1),
        (TETRAHEDRON.replace("\n", " # remark\n"), 1),
        (TETRAHEDRON.replace("\n", "\r\n"), 1),
        ("\ufeff" + TETRAHEDRON, 1),
        (TETRAHEDRON.replace("v 1 0 0", "v 1 0 0 0.5 0.5 0.5"), 1),
        (TETRAHEDRON.replace("f 1 3 2", "f 1/7/8 3//9 \\\n 2/1"), 1),
        ("mtllib no.mtl\no a\ng b\nusemtl c\ns off\nvn 0 0 1\nvt 0 0\n" + TETRAHEDRON, 1),
        (COUNTED_BACK.format(x=0, y=1) + COUNTED_BACK.format(x=5, y=6), 2),
    ],
)
def test_dialects_of_obj(tmp_path: Path, text: str, volumes: int) -> None:
    """Each is one tetrahedron of volume 1/6 or two of them; indices count back from where the face stands."""
    (tmp_path / "part.obj").write_bytes(text.encode())
    model = body(mesh_body("part.obj", keys="density: 6, material: steel"), tmp_path)
    assert model.mass[0] == pytest.approx(volumes, rel=1e-14)


def test_polygons_become_fans(tmp_path: Path) -> None:
    """A pyramid of height 1 on a unit square."""
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
    (tmp_path / "part.obj").write_text(corners + "f 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
    model = body(mesh_body("part.obj", keys="density: 3, material: steel"), tmp_path)
    assert model.mass[0] == pytest.approx(1)


@pytest.mark.parametrize("line", ["v 1 2", "v a b c", "f 0 1 2", "f -9 1 2", "f 1 2 x"])
def test_broken_lines_are_numbered(tmp_path: Path, line: str) -> None:
    (tmp_path / "part.obj").write_text(TETRAHEDRON + line + "\n")
    assert "line 9 is no vertex or face" in body_problem(mesh_body("part.obj"), tmp_path).message


def test_endless_lines_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mesh_obj, "MAX_LINE", 100)
    (tmp_path / "part.obj").write_text(TETRAHEDRON + "f" + " 1 2 3" * 50)
    assert "line 9 is longer" in body_problem(mesh_body("part.obj"), tmp_path).message


# ---------------------------------------------------------------- nothing else is read


def test_material_files_and_textures_are_not_opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    part = wedge()
    text = "mtllib secret.mtl\nusemtl paint\n" + trimesh.exchange.obj.export_obj(part, include_normals=False)
    (tmp_path / "part.obj").write_text(text)
    (tmp_path / "secret.mtl").write_text("newmtl paint\nmap_Kd secret.png\n")
    opened: list[str] = []
    true_open = io.open

    def watched(file: Any, *args: Any, **options: Any) -> Any:
        opened.append(str(file))
        return true_open(file, *args, **options)

    monkeypatch.setattr(builtins, "open", watched)
    monkeypatch.setattr(io, "open", watched)
    read_mesh(tmp_path / "part.obj")
    assert not [name for name in opened if "secret" in name]


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.sampled_from(["part.obj", "part.stl", "ascii.stl", "part.ply", "ascii.ply", "part.off"]),
    st.lists(st.tuples(st.floats(0, 1), st.binary(max_size=6)), min_size=1, max_size=6),
)
def test_mutated_files_are_read_or_refused(
    tmp_path: Path, name: str, changes: list[tuple[float, bytes]]
) -> None:
    """Bytes replaced at random: a mesh or a ShapeTrouble, never anything else."""
    options = {"ascii.stl": {"file_type": "stl_ascii"}, "ascii.ply": {"encoding": "ascii"}}.get(name, {})
    data = bytearray(write(tmp_path, wedge(), name, **options).read_bytes())
    for place, new in changes:
        at = int(place * len(data))
        data[at : at + len(new)] = new
    (tmp_path / name).write_bytes(data)
    try:
        found = read_mesh(tmp_path / name)
    except ShapeTrouble:
        return
    assert np.isfinite(found.vertices).all()
    assert found.triangles.min() >= 0
    assert found.triangles.max() < len(found.vertices)


def test_a_memory_serves_many_scenes(tmp_path: Path) -> None:
    """Each scene names only the meshes that it uses, and gets the same bits as one that reads them itself."""
    write(tmp_path, wedge())
    body = "bodies:\n  a: {{shape: {{type: mesh, file: part.stl, scale: {scale}}}, material: steel}}\n"
    head = "physsim: 1\nsimulation: {duration: 1 s, timestep: 1 ms}\n"
    memory = MeshMemory()
    for scale in (1, 2, 1):
        scene = load_scene_text(head + body.format(scale=scale), folder=tmp_path)
        alone, remembered = compile_scene(scene), compile_scene(scene, memory)
        assert remembered.mesh_sha256 == alone.mesh_sha256
        np.testing.assert_array_equal(remembered.inertia, alone.inertia)
        np.testing.assert_array_equal(remembered.geoms.hulls[0].vertices, alone.geoms.hulls[0].vertices)
    assert (len(memory.meshes), len(memory.forms)) == (1, 2)
    other = load_scene_text(head + "bodies: {b: {shape: {type: sphere, radius: 1}, material: steel}}")
    assert compile_scene(other, memory).mesh_sha256 == {}
