"""What stands on the stage: the shapes of the scene as the file keeps them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from physsim import Trajectory, open_trajectory, run
from physsim.errors import FileTrouble
from physsim.model import compile_scene
from physsim.scene import load_scene_text
from physsim.simulation.about import fixed_values
from physsim.view.stage import KINDS, PALETTE, Solid, Stage, stage_of, staged

SCENE = """
physsim: 1
simulation: {duration: 1 ms, timestep: 1 ms}
materials: {red: {color: "#d33", density: 1000}, plain: {density: 1000}, other: {density: 1000}}
mixing: {restitution: minimum, friction: minimum}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [1, 0, 0], offset: -9}, material: steel}
  ball: {shape: {type: sphere, radius: 0.2}, material: red, position: [0, 0, 1]}
  shell: {shape: {type: hollow_sphere, radius: 0.3}, material: plain, mass: 1, position: [0, 0, 2]}
  brick: {shape: {type: box, size: [1, 2, 4]}, material: other, position: [0, 0, 5]}
  pill: {shape: {type: capsule, radius: 0.1, height: 0.6}, material: red, position: [3, 0, 0]}
  can: {shape: {type: cylinder, radius: 0.1, height: 0.6}, material: red, position: [4, 0, 0]}
  hat: {shape: {type: cone, radius: 0.1, height: 0.6}, material: red, position: [5, 0, 0]}
  egg: {shape: {type: ellipsoid, radii: [0.1, 0.2, 0.3]}, material: red, position: [6, 0, 0]}
  stick: {shape: {type: rod, length: 0.8}, mass: 1, material: red, position: [7, 0, 0]}
  gem:
    shape: {type: convex, points: [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]}
    material: red
    position: [9, 0, 0]
  ghost: {shape: {type: sphere, radius: 0.2}, material: red, collides: false, position: [0, 0, 9]}
  ell:
    shape: {type: mesh, file: ell.obj, scale: 2, collision: hull}
    material: red
    position: [0, 9, 0]
  hammer:
    material: plain
    position: [0, -9, 0]
    shape:
      type: compound
      parts:
        - {shape: {type: box, size: [1, 1, 1]}, material: red, position: [0, 0, 3]}
        - {shape: {type: cylinder, radius: 0.1, height: 3}}
springs:
  wire: {type: torsional, between: [brick, shell], axis: [0, 0, 3], stiffness: 1}
  coil: {type: linear, between: [world, ball], anchors: [[0, 0, 3], [0, 0, 0]], stiffness: 1}
joints:
  axle: {type: hinge, between: [brick, hat], anchor: [0, 0, 1], axis: [0, 2, 0]}
  knot: {type: ball, between: [world, pill], anchor: [3, 0, 1]}
"""

# An L of two cubes' width, 2 x 2 x 1, its corner at the origin: concave, so that the hull is another shape.
ELL = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def write_ell(path: Path) -> None:
    corners = [(x, y, z) for z in (0, 1) for x, y in ELL]
    sides = [f"f {k + 1} {(k + 1) % 6 + 1} {(k + 1) % 6 + 7} {k + 7}" for k in range(6)]
    caps = ["f 1 4 3 2", "f 1 6 5 4", "f 7 8 9 10", "f 7 10 11 12"]
    path.write_text("\n".join([*(f"v {x} {y} {z}" for x, y, z in corners), *sides, *caps]) + "\n")


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory: pytest.TempPathFactory) -> Trajectory:
    folder = tmp_path_factory.mktemp("stage")
    write_ell(folder / "ell.obj")
    scene = folder / "scene.yaml"
    scene.write_text(SCENE)
    with run(scene, output=folder / "scene.h5") as done:
        return open_trajectory(done.path)


@pytest.fixture(scope="module")
def stage(trajectory: Trajectory) -> Stage:
    return stage_of(trajectory)


@pytest.fixture
def of(stage: Stage) -> Callable[[str], list[Solid]]:
    names = [actor.name for actor in stage.actors]
    return lambda name: [solid for solid in stage.solids if names[solid.body] == name]


def test_every_kind_stands_there_with_its_parameters(of: Callable[[str], list[Solid]]) -> None:
    expected = {
        "floor": ("halfspace", (0, 0, 0)),
        "ball": ("sphere", (0.2, 0, 0)),
        "shell": ("sphere", (0.3, 0, 0)),
        "brick": ("box", (0.5, 1, 2)),
        "pill": ("capsule", (0.1, 0.3, 0)),
        "can": ("cylinder", (0.1, 0.3, 0)),
        "hat": ("cone", (0.1, 0.6, 0)),
        "egg": ("ellipsoid", (0.1, 0.2, 0.3)),
        "stick": ("rod", (0.4, 0, 0)),
        "gem": ("surface", (0, 0, 0)),
    }
    assert {kind for kind, _ in expected.values()} == set(KINDS)
    for name, (kind, parameters) in expected.items():
        (solid,) = of(name)
        assert (solid.kind, solid.shown, solid.collides) == (kind, True, True)
        np.testing.assert_allclose(solid.parameters[:3], parameters, rtol=1e-15)


def test_half_space_faces_its_normal(of: Callable[[str], list[Solid]]) -> None:
    """Solid where z is below 0 in its own frame: its z axis is the normal x, its origin 9 below."""
    (floor,) = of("floor")
    w, x, y, z = floor.orientation
    normal = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
    np.testing.assert_allclose(normal, [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(floor.position, [-9, 0, 0])


def test_a_mesh_is_shown_as_drawn_and_collides_as_its_hull(of: Callable[[str], list[Solid]]) -> None:
    drawn, hull = of("ell")
    assert (drawn.shown, drawn.collides, hull.shown, hull.collides) == (True, False, False, True)
    assert drawn.surface is not None
    assert hull.surface is not None
    corners = {tuple(vertex) for vertex in np.round(drawn.surface.vertices + drawn.position, 12)}
    assert corners == {(2.0 * x, 2.0 * y, 2.0 * z) for z in (0, 1) for x, y in ELL}
    on_hull = {tuple(vertex) for vertex in np.round(hull.surface.vertices + hull.position, 12)}
    assert on_hull == corners - {(2.0, 2.0, 0.0), (2.0, 2.0, 2.0)}


def test_surfaces_face_outward(stage: Stage) -> None:
    """Signed volumes: the gem 1/6; the L three squares of 2 x 2, 2 high; its hull half a square more."""
    volumes = []
    for solid in stage.solids:
        if solid.surface is not None:
            corners = solid.surface.vertices[solid.surface.triangles]
            volumes.append(float(np.linalg.det(corners).sum() / 6))
    np.testing.assert_allclose(sorted(volumes), [1 / 6, 24, 28], rtol=1e-12)


def test_what_does_not_collide_is_still_seen(of: Callable[[str], list[Solid]]) -> None:
    (ghost,) = of("ghost")
    assert (ghost.shown, ghost.collides) == (True, False)


def test_parts_of_a_compound_stand_in_the_frame_of_the_body(of: Callable[[str], list[Solid]]) -> None:
    head, shaft = of("hammer")
    np.testing.assert_allclose(head.position, [0, 0, 3])
    np.testing.assert_allclose(shaft.position, [0, 0, 0])
    assert (head.material, shaft.material) == ("red", "plain")


def test_colours_are_declared_or_from_the_library_or_from_the_palette(stage: Stage) -> None:
    colours = {solid.material: solid.colour for solid in stage.solids}
    assert colours["red"] == "#dd3333"
    assert colours["steel"] == "#8a949e"
    assert (colours["plain"], colours["other"]) == PALETTE[:2]


def test_links_have_ends_anchors_and_axes(stage: Stage) -> None:
    axle, knot = stage.joints
    names = [actor.name for actor in stage.actors]
    assert (axle.kind, axle.bodies) == ("hinge", (names.index("brick"), names.index("hat")))
    np.testing.assert_allclose(axle.anchors, [[0, 0, -4], [-5, 0, 1]])
    np.testing.assert_allclose(axle.axis, [0, 1, 0], atol=1e-15)
    assert knot.bodies == (-1, names.index("pill"))
    assert np.isnan(knot.axis).all()
    wire, coil = stage.springs
    np.testing.assert_allclose(wire.axis, [0, 0, 1], atol=1e-15)
    np.testing.assert_allclose(coil.anchors, [[0, 0, 3], [0, 0, 0]])


def test_a_scene_that_was_not_run_gives_the_same_stage(trajectory: Trajectory, stage: Stage) -> None:
    folder = trajectory.path.parent
    scene = load_scene_text(SCENE, folder=folder)
    values = fixed_values(scene, compile_scene(scene))
    ahead = staged(scene.title, values.get)
    assert [solid.kind for solid in ahead.solids] == [solid.kind for solid in stage.solids]
    for one, other in zip(ahead.solids, stage.solids, strict=True):
        np.testing.assert_array_equal(one.position, other.position)
    assert [link.name for link in ahead.joints] == [link.name for link in stage.joints]


def test_a_file_of_before_is_told_apart(trajectory: Trajectory, tmp_path: Path) -> None:
    old = tmp_path / "old.h5"
    old.write_bytes(trajectory.path.read_bytes())
    with h5py.File(old, "r+") as file:
        del file["geometry"]
        del file["joints/axis_a"]
    with open_trajectory(old) as found:
        assert found.frames == 2
        with pytest.raises(FileTrouble, match="run the scene again"):
            stage_of(found)


@pytest.mark.parametrize(
    ("path", "row", "value"),
    [
        ("geometry/body", 0, 99),
        ("geometry/kind", 0, "torus"),
        ("geometry/surface", 0, 5),
        ("geometry/surface", 9, -1),
        ("geometry/position", (0, 0), np.nan),
        ("geometry/triangles", (0, 0), 10**6),
        ("geometry/vertex_offset", 1, -3),
        ("geometry/vertices", (0, 0), np.inf),
        ("joints/body_a", 0, 99),
    ],
)
def test_damaged_shapes_are_file_trouble(
    trajectory: Trajectory, tmp_path: Path, path: str, row: Any, value: Any
) -> None:
    broken = tmp_path / "broken.h5"
    broken.write_bytes(trajectory.path.read_bytes())
    with h5py.File(broken, "r+") as file:
        file[path][row] = value
    with open_trajectory(broken) as found, pytest.raises(FileTrouble, match="the shapes in the file"):
        stage_of(found)
