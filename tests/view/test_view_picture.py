"""Pictures against closed forms: the pinhole, the lights, the shadow. Without display or graphics card."""

from __future__ import annotations

import numpy as np
import pytest

from physsim.recording.orientation import rotation_matrices
from physsim.view.picture import things, wires
from physsim.view.picture.camera import FILLED, FOCUS, Camera, View, fitting, looking, placed
from physsim.view.picture.caption import Caption, Mark, captioned
from physsim.view.picture.light import FILL, GROUND, SKYLIGHT, SUN, SUNLIGHT, linear
from physsim.view.picture.outlook import Outlook, Screen
from physsim.view.picture.painter import Painter, grid_spacing
from physsim.view.picture.setting import Setting, setting_of, without_strays
from physsim.view.picture.signs import Signs
from physsim.view.shapes.tessellate import tessellated
from physsim.view.stage import WORLD, Actor, Link, Solid, Stage

SIZE = (400, 300)
UPRIGHT = np.array([1.0, 0, 0, 0])
NO_SCREENS = Outlook(np.zeros((0, 3)), ())


def solid(kind: str, *parameters: float, body: int = 0, colour: str = "#cc2222") -> Solid:
    numbers = np.array([*parameters, 0, 0, 0, 0][:4], np.float64)
    return Solid(body, kind, numbers, np.zeros(3), UPRIGHT, "paint", colour, True, True, None)


def stage(*solids: Solid, joints: tuple[Link, ...] = (), springs: tuple[Link, ...] = ()) -> Stage:
    actors = tuple(
        Actor(f"body {k}", "paint", 1.0, solids[k].kind == "halfspace", np.zeros(3), np.eye(3))
        for k in range(len(solids))
    )
    return Stage("made up", actors, solids, joints, springs)


def around(middle: tuple[float, float, float], reach: float) -> Setting:
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return Setting(np.array(middle) + reach * corners, NO_SCREENS)


def drawn(scene: Stage, places: list[list[float]], camera: Camera, setting: Setting) -> np.ndarray:
    return (
        Painter(scene).draw(camera, setting, np.array(places), np.tile(UPRIGHT, (len(places), 1))).astype(int)
    )


def rays(camera: Camera) -> np.ndarray:
    """Unit vectors (height, width, 3) through the middles of the pixels, in world axes."""
    width, height = camera.size
    columns, rows = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    focal = FOCUS * height / 2
    local = np.stack([columns - width / 2, height / 2 - rows, np.full(columns.shape, focal)], axis=-1)
    return local @ camera.axes / np.linalg.norm(local, axis=-1, keepdims=True)


@pytest.mark.parametrize(("azimuth", "elevation"), [(-90.0, 0.0), (25.0, 40.0), (160.0, -20.0)])
def test_a_sphere_is_seen_within_its_cone(azimuth: float, elevation: float) -> None:
    """It is seen along all rays that make an angle below asin(r / distance) with the way to its middle."""
    middle, radius = np.array([0.3, -0.2, 1.1]), 0.25
    setting = around((0.2, -0.1, 1.0), 0.4)
    camera = placed(View(azimuth, elevation), setting, SIZE)
    with_ball = drawn(stage(solid("sphere", radius)), [middle.tolist()], camera, setting)
    seen = with_ball[..., 0] > with_ball[..., 2] + 10
    away = middle - camera.eye
    distance = np.linalg.norm(away)
    angle = np.arccos(rays(camera) @ (away / distance)) - np.arcsin(radius / distance)
    pixel = 1 / (FOCUS * SIZE[1] / 2)
    assert seen[angle < -1.5 * pixel].all()
    assert not seen[angle > 1.5 * pixel].any()
    assert seen.sum() > 2000


def test_points_are_where_the_camera_says() -> None:
    setting = around((0, 0, 0), 1.0)
    camera = placed(View(-40, 25), setting, SIZE)
    for place in ([0.5, 0.1, -0.6], [-0.7, 0.2, 0.5], [0.1, -0.8, 0.3]):
        picture = drawn(stage(solid("sphere", 0.06)), [place], camera, setting)
        rows, columns = np.nonzero(picture[..., 0] > picture[..., 2] + 10)
        column, row, _ = camera.pixels(np.array([place]))[0]
        assert abs(columns.mean() + 0.5 - column) < 0.6
        assert abs(rows.mean() + 0.5 - row) < 0.6


def test_what_is_behind_the_camera_has_no_pixel() -> None:
    camera = Camera(np.zeros(3), looking(0, 0), SIZE)
    assert np.isnan(camera.pixels(np.array([[1.0, 0, 0]]))[0, :2]).all()


def test_the_camera_sees_all_points_and_stands_as_near_as_it_can() -> None:
    points = np.random.default_rng(4).normal(size=(50, 3)) * [1, 2, 0.3]
    axes = looking(30, 20)
    eye, _ = fitting(points, axes, SIZE)
    found = Camera(eye, axes, SIZE).pixels(points)
    half = np.array(SIZE) / 2
    reach = np.abs(found[:, :2] - half).max(axis=0) / half
    assert reach.max() == pytest.approx(FILLED, abs=1e-9)


def test_the_camera_looks_at_planes_from_their_broad_side() -> None:
    flat = np.array([[x, y, 0.0] for x in (-1, 1) for y in (-1, 1)])
    upright = flat[:, [0, 2, 1]]
    for points, axis in ((flat, 2), (upright, 1), (upright[:, [1, 0, 2]], 0)):
        into = placed(View(), Setting(points, NO_SCREENS), SIZE).axes[2]
        assert abs(into[axis]) > 0.7


def test_the_camera_goes_where_nothing_hides_what_moves() -> None:
    """A wall in front: the usual side is left."""
    points = np.random.default_rng(2).uniform(-0.5, 0.5, (60, 3))
    wall = Screen(np.array([0.0, -2.0, 0.0]), np.eye(3), np.array([-9, -0.1, -9.0]), np.array([9, 0.1, 9.0]))
    free = placed(View(), Setting(points, NO_SCREENS), SIZE)
    walled = placed(View(), Setting(points, Outlook(points, (wall,))), SIZE)
    assert free.eye[1] < 0 < walled.eye[1]


def test_a_screen_hides_what_is_behind_it_and_not_what_is_in_it() -> None:
    turned = rotation_matrices(np.array([[np.cos(0.2), 0, 0, np.sin(0.2)]]))[0]
    box = Screen(np.array([2.0, 0, 0]), turned, -np.ones(3), np.ones(3))
    points = np.array([[0.0, 0, 0], [2.0, 0, 0], [4.0, 0, 0], [0, 3.0, 0]])
    assert box.hides(points, np.array([1.0, 0, 0])).tolist() == [True, False, False, False]


def test_one_that_rolls_away_does_not_make_all_others_small() -> None:
    crowd = np.random.default_rng(1).uniform(-1, 1, (1000, 3))
    kept = without_strays(np.vstack([crowd, [[50.0, 0, 0]] * 20]))
    assert len(kept) == 1000


def test_open_ground_has_the_colour_that_its_lights_give_it() -> None:
    """Straight from above, out of the sun's reflection: albedo times every light by its cosine, in sRGB."""
    setting = around((0, 0, 0), 1.0)
    camera = placed(View(0, 89.9), setting, SIZE)
    picture = drawn(stage(solid("halfspace")), [[0, 0, 0]], camera, setting)
    cosine = SUN[2] / np.linalg.norm(SUN)
    light = linear(GROUND) * (SUNLIGHT * cosine + SKYLIGHT + FILL)
    expected = 255 * (1.055 * np.clip(light, 0, 1) ** (1 / 2.4) - 0.055)
    colours, counts = np.unique(picture.reshape(-1, 3), axis=0, return_counts=True)
    assert np.abs(colours[counts.argmax()] - expected).max() <= 2  # 1 measured


def test_the_shadow_of_a_ball_lies_where_the_sun_throws_it() -> None:
    radius, height = 0.08, 0.8
    setting = around((0, 0, 0.5), 1.0)
    camera = placed(View(0, 89.9), setting, SIZE)
    picture = drawn(
        stage(solid("sphere", radius), solid("halfspace", body=1)),
        [[0, 0, height], [0, 0, 0]],
        camera,
        setting,
    )
    grey = np.ptp(picture, axis=2) < 30
    brightness = picture.sum(axis=2)
    rows, columns = np.nonzero(grey & (brightness < (np.median(brightness) + brightness[grey].min()) / 2))
    column, row, _ = camera.pixels(np.array([[-height * SUN[0] / SUN[2], -height * SUN[1] / SUN[2], 0.0]]))[0]
    assert abs(np.median(columns) + 0.5 - column) < 1.5
    assert abs(np.median(rows) + 0.5 - row) < 1.5


def test_the_same_picture_has_the_same_bytes() -> None:
    setting = around((0, 0, 0), 1.0)
    camera = placed(View(), setting, SIZE)
    scene = stage(solid("box", 0.3, 0.2, 0.1), solid("halfspace", body=1))
    one, other = (drawn(scene, [[0, 0, 0.5], [0, 0, 0]], camera, setting) for _ in range(2))
    assert np.array_equal(one, other)


def test_grid_lines_are_round_numbers_apart() -> None:
    for reach, expected in ((1.0, 0.5), (0.1, 0.05), (40.0, 20.0), (3e-4, 1e-4)):
        assert grid_spacing(around((0, 0, 0), reach)) == pytest.approx(expected)


def test_a_closed_mesh_is_known() -> None:
    kinds = ("sphere", "box", "cylinder", "cone", "capsule")
    meshes, _ = tessellated(stage(*(solid(kind, 1, 1, 1) for kind in kinds)), 12, 1.0)
    assert all(things.closed(mesh) for mesh in meshes)
    square, _ = tessellated(stage(solid("halfspace")), 12, 1.0)
    assert not things.closed(square[0])


def test_a_tube_keeps_its_distance_from_its_line() -> None:
    turn = np.linspace(0, 9, 200)
    line = np.column_stack([np.cos(turn), np.sin(turn), 0.3 * turn])
    mesh = wires.tube(line, 0.02)
    away = np.linalg.norm(mesh.vertices.reshape(200, -1, 3) - line[:, None], axis=2)
    assert np.allclose(away, 0.02, rtol=1e-12)


def test_a_coil_goes_from_end_to_end_whatever_its_length() -> None:
    for length in (1.0, 3.0):
        ends = np.array([[0, 0, 0], [0, 0, length]])
        mesh = wires.coil(ends, 0.1, 0.01)
        assert np.ptp(mesh.vertices[:, 2]) == pytest.approx(length, abs=0.02)
        assert np.linalg.norm(mesh.vertices[:, :2], axis=1).max() == pytest.approx(0.11, abs=1e-3)


def test_an_arrow_ends_at_its_point() -> None:
    vector = np.array([0.3, -0.4, 1.2])
    mesh = wires.arrow(np.array([1.0, 2, 3]), vector, 0.01)
    farthest = mesh.vertices[(mesh.vertices @ vector).argmax()]
    assert np.allclose(farthest, [1.3, 1.6, 4.2])


def test_a_broken_string_is_not_drawn() -> None:
    string = Link("string", "distance", (WORLD, 0), np.array([[0, 0, 1.0], [0, 0, 0]]), np.full(3, np.nan))
    scene = stage(solid("sphere", 0.1), joints=(string,))
    places, turned = np.zeros((1, 3)), UPRIGHT[None]
    signs = Signs(scene, around((0, 0, 0), 1.0), Painter(scene).boxes, places, turned)
    assert len(list(signs.springs(places, turned, frozenset()))) == 1
    assert list(signs.springs(places, turned, frozenset({0}))) == []


def test_a_pendulum_without_a_rod_gets_an_arm() -> None:
    pivot = Link("pivot", "hinge", (WORLD, 0), np.array([[0, 0, 0], [0, 0, 1.0]]), np.array([0, 1.0, 0]))
    scene = stage(solid("sphere", 0.1), joints=(pivot,))
    places, turned = np.array([[0, 0, -1.0]]), UPRIGHT[None]
    (arm,) = Signs(scene, around((0, 0, 0), 1.0), Painter(scene).boxes, places, turned).springs(
        places, turned, frozenset()
    )
    assert np.ptp(arm.mesh.vertices[:, 2]) == pytest.approx(1, abs=1e-9)


def test_frames_point_along_the_axes_of_the_body_each_shorter_than_the_last() -> None:
    scene, places = stage(solid("box", 0.3, 0.3, 0.3)), np.array([[0.1, 0.2, 0.3]])
    turned = np.array([[np.cos(0.4), np.sin(0.4), 0, 0]])
    signs = Signs(scene, around((0, 0, 0), 1.0), Painter(scene).boxes, places, turned)
    axes = rotation_matrices(turned)[0].T
    lengths = []
    for arrow, axis in zip(signs.frames(places, turned), axes, strict=True):
        along = (arrow.mesh.vertices - places[0]) @ axis
        tip = arrow.mesh.vertices[along.argmax()] - places[0]
        lengths.append(np.linalg.norm(tip))
        assert np.allclose(tip / lengths[-1], axis, atol=1e-9)
    assert np.allclose(np.array(lengths) / lengths[0], [1, 0.8, 0.6])


def test_hostile_names_are_one_short_line() -> None:
    setting = around((0, 0, 0), 1.0)
    camera = placed(View(), setting, SIZE)
    pixels = drawn(stage(solid("sphere", 0.2)), [[0, 0, 0]], camera, setting).astype(np.uint8)
    mark = Mark(np.zeros(3), "<b>\n\0" + 5000 * "x")
    picture = captioned(pixels, camera, Caption(title="a\nb\t" + 5000 * "y", marks=[mark]))
    assert picture.size == SIZE


def test_a_scene_of_a_floor_and_nothing_else_is_drawn() -> None:
    scene = stage(solid("halfspace"))
    places, turned = np.zeros((1, 1, 3)), UPRIGHT[None, None]
    painter = Painter(scene)
    setting = setting_of(scene, painter.boxes, places, turned)
    picture = painter.draw(placed(View(), setting, SIZE), setting, places[0], turned[0])
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 20


def test_a_lone_anchor_has_a_size() -> None:
    tie = Link("tie", "ball", (WORLD, WORLD), np.full((2, 3), 0.5), np.full(3, np.nan))
    scene = stage(solid("halfspace"), joints=(tie,))
    setting = setting_of(scene, Painter(scene).boxes, np.zeros((1, 1, 3)), UPRIGHT[None, None])
    assert setting.size > 1


def test_what_moves_counts_over_the_whole_run_and_a_backdrop_does_not() -> None:
    """A ball goes from x = 0 to 1 before a wall of 100 m."""
    scene = stage(solid("sphere", 0.1), solid("box", 50, 0.1, 50, body=1))
    places = np.zeros((11, 2, 3))
    places[:, 0, 0] = np.linspace(0, 1, 11)
    places[:, 1, 1] = 2
    setting = setting_of(scene, Painter(scene).boxes, places, np.tile(UPRIGHT, (11, 2, 1)))
    assert np.allclose([setting.low, setting.high], [[-0.1, -0.1, -0.1], [1.1, 0.1, 0.1]], atol=2e-3)
