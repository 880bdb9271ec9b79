"""`physsim export --to glb`: every body is where the trajectory has it, to the tolerance that is told."""

from __future__ import annotations

import json
import re
import shutil
import tracemalloc
from pathlib import Path

import h5py
import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from view_glb import Glb, rotation, z_up

import physsim
from physsim import Trajectory, open_trajectory
from physsim.cli.app import answer
from physsim.errors import FileTrouble
from physsim.view import clip as clip_room
from physsim.view.gltf import glb_file
from physsim.view.gltf import spool as spool_room
from physsim.view.gltf.motion import clock

SCENE = """
physsim: 1
title: Things tumble
simulation: {duration: 1.2 s, timestep: 1 ms}
materials:
  red: {color: "#cc3300", density: 900, restitution: 0.5, static_friction: 0.5, kinetic_friction: 0.4}
  blue: {color: "#3366cc", density: 1200, restitution: 0.5, static_friction: 0.5, kinetic_friction: 0.4}
mixing: {restitution: minimum, friction: minimum}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0.6, 0.8], offset: -0.3}, material: concrete}
  post: {fixed: true, shape: {type: cylinder, radius: 2 cm, height: 30 cm}, material: blue,
         position: [1, 2, 0], orientation: {axis: [1, 2, 3], angle: 40 deg}}
  ball: {shape: {type: sphere, radius: 5 cm}, material: red, position: [0, 0, 0.5], velocity: [0.3, 0, 1],
         angular_velocity: [3, 40, -5]}
  marble: {shape: {type: sphere, radius: 2 cm}, material: red, position: [0.4, 0, 0.2]}
  box: {shape: {type: box, size: [10 cm, 20 cm, 5 cm]}, material: blue, position: [-0.5, 0, 0.5],
        angular_velocity: [1, 20, 3]}
  cone: {shape: {type: cone, radius: 5 cm, height: 20 cm}, material: red, position: [0, 1, 0.6],
         angular_velocity: [9, 0, 3]}
  hammer:
    position: [1, 0, 0.6]
    angular_velocity: [2, 6, -3]
    material: red
    shape:
      type: compound
      parts:
        - {shape: {type: box, size: [20 cm, 8 cm, 8 cm]}, material: blue, position: [0, 0, 20 cm]}
        - {shape: {type: capsule, radius: 2 cm, height: 30 cm},
           orientation: {axis: [0, 1, 0], angle: 20 deg}}
  still: {shape: {type: ellipsoid, radii: [5 cm, 6 cm, 7 cm]}, material: red, position: [-2, 0, 3],
          collides: false}
joints: {peg: {type: fixed, between: [world, still], anchor: [-2, 0, 3]}}
record: {every: 5 ms}
"""
SMALLEST = 0.02  # m, the radius of the marble


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with run.h5 in it."""
    made = tmp_path_factory.mktemp("gltf")
    (made / "scene.yaml").write_text(SCENE)
    physsim.run(made / "scene.yaml", output=made / "run.h5").close()
    return made


@pytest.fixture(scope="module")
def trajectory(folder: Path):
    with open_trajectory(folder / "run.h5") as opened:
        yield opened


def export(folder: Path, *words: str) -> Path:
    """Writes run.glb beside run.h5."""
    target = folder / "run.glb"
    assert (
        answer(["export", str(folder / "run.h5"), "--to", "glb", "-o", str(target), "--force", *words]) == 0
    )
    return target


def exported(folder: Path, *words: str) -> Glb:
    return Glb(export(folder, *words))


def pose(glb: Glb, name: str, time: float) -> tuple[np.ndarray, Rotation]:
    """Position and orientation of a body with z up: as Blender shows them."""
    node = glb.nodes[name]
    assert glb.parents[node] not in glb.parents
    x, y, z, w = glb.value(node, "rotation", time)
    return z_up(glb.value(node, "translation", time)), Rotation.from_quat([x, -z, y, w])


def errors(glb: Glb, trajectory: Trajectory, frames: range, start: float = 0.0) -> tuple[float, float, float]:
    """The largest error of a position [m], an orientation [rad] and a drawn point [m] at these frames."""
    worst = np.zeros(3)
    for name in trajectory.body_names:
        if name == "floor":
            continue
        body = trajectory.body(name)
        at_first, turned_first = pose(glb, name, 0)
        own = turned_first.inv().apply(glb.points(glb.nodes[name], 0) - at_first)
        for frame in frames:
            time = trajectory.time[frame] - start
            position, orientation = pose(glb, name, time)
            true = Rotation.from_quat(body.orientation[frame], scalar_first=True)
            points = glb.points(glb.nodes[name], time)
            apart = np.linalg.norm(points - (true.apply(own) + body.position[frame]), axis=1)
            found = (np.linalg.norm(position - body.position[frame]), (true.inv() * orientation).magnitude())
            worst = np.maximum(worst, [*found, apart.max()])
    return tuple(worst)


def test_a_node_for_each_body_under_one_with_the_title(folder: Path, trajectory: Trajectory) -> None:
    glb = exported(folder)
    (scene,) = glb.document["scenes"]
    root = glb.document["nodes"][scene["nodes"][0]]
    assert root["name"] == scene["name"] == "Things tumble"
    nodes = [glb.document["nodes"][child] for child in root["children"]]
    assert tuple(node["name"] for node in nodes) == trajectory.body_names
    assert set(root) == {"name", "children"}
    facts = {node["name"]: node["extras"] for node in nodes}
    assert facts["ball"]["mass"] == trajectory.body("ball").mass
    assert facts["ball"]["material"] == "red"
    assert facts["floor"] == {"material": "concrete", "fixed": True}
    hammer = nodes[trajectory.index_of("hammer")]
    assert "mesh" not in hammer
    assert [glb.document["nodes"][child]["name"] for child in hammer["children"]] == [
        "hammer: box",
        "hammer: capsule",
    ]
    asset = glb.document["asset"]
    assert asset["version"] == "2.0"
    assert asset["generator"] == f"physsim {physsim.__version__}"
    assert asset["extras"] == {
        "title": "Things tumble",
        "physsim_version": physsim.__version__,
        "start": 0.0,
        "end": 1.2,
        "speed": 1.0,
        "tolerance": pytest.approx(1e-3 * SMALLEST, rel=1e-6),
    }


def test_every_point_is_where_it_should_be(folder: Path, trajectory: Trajectory) -> None:
    for tolerance in (1e-3 * SMALLEST, 1e-2):
        glb = exported(folder, *(() if tolerance < 1e-2 else ("--tolerance", str(tolerance))))
        shift, turn, point = errors(glb, trajectory, range(0, trajectory.frames, 4))
        assert shift < tolerance / 4 + 8e-7  # measured 3.3e-7, 1.7e-3
        assert turn < tolerance / 4 / SMALLEST + 2e-5  # the marble's; measured 1.3e-5, 0.057
        assert point < tolerance  # measured 5.3e-7, 3.0e-3


def test_without_a_tolerance_only_what_is_superfluous_is_left_out(
    folder: Path, trajectory: Trajectory, capsys: pytest.CaptureFixture[str]
) -> None:
    glb = exported(folder, "--tolerance", "0")
    shift, turn, point = errors(glb, trajectory, range(0, trajectory.frames, 4))
    assert max(shift, point) < 8e-7  # 32-bit numbers of 3 m, and of times of 1 s at 5 m/s; measured 5.3e-7
    assert turn < 2e-5  # times, of the marble at 240 rad/s; measured 1.3e-5
    lengths = {len(times) for times, _ in glb.tracks.values()}
    assert max(lengths) == trajectory.frames
    said = capsys.readouterr()
    assert said.err == ""
    assert f"{sum(len(times) for times, _ in glb.tracks.values())} of 2410 key frames" in said.out


def test_a_tolerance_in_metres_leaves_frames_out(folder: Path, trajectory: Trajectory) -> None:
    kept = []
    for tolerance in (0, 1e-5, 1e-4, 1e-2):
        glb = exported(folder, "--tolerance", str(tolerance))
        assert errors(glb, trajectory, range(0, trajectory.frames, 16))[2] < tolerance + 8e-7
        kept.append(sum(len(times) for times, _ in glb.tracks.values()))
    assert kept == sorted(kept, reverse=True)
    assert kept[3] < kept[0] / 4  # measured 427 of 2345


def test_what_does_not_move_has_no_channels(folder: Path) -> None:
    glb = exported(folder)
    moving = {glb.document["nodes"][node]["name"] for node, _ in glb.tracks}
    assert moving == {"ball", "marble", "box", "cone", "hammer"}


def test_neighbours_are_in_one_hemisphere_and_near(folder: Path) -> None:
    """Also for players that go straight from one quaternion to the next, as Blender does."""
    glb = exported(folder)
    turned = [track for (_, path), track in glb.tracks.items() if path == "rotation"]
    assert len(turned) == 5
    for times, values in turned:
        np.testing.assert_allclose(np.linalg.norm(values, axis=1), 1, atol=2e-7)
        cosines = np.einsum("ki,ki->k", values[1:], values[:-1])
        assert cosines[np.diff(times) > 0.0051].min(initial=1) > np.cos(0.4 / 2)  # where frames are left out
        assert cosines.min() > np.cos(1.3 / 2)  # the marble turns by 1.26 rad in 5 ms
    (_, ball), *_ = turned
    half_turns = np.abs(np.diff(np.unwrap(np.arctan2(ball[:, 1], ball[:, 3])))).sum() / np.pi
    assert half_turns > 5  # signs of quaternions have changed on the way


def test_times_are_seconds_from_the_start(folder: Path, trajectory: Trajectory) -> None:
    glb = exported(folder, "--tolerance", "0")
    longest = [times for times, _ in glb.tracks.values() if len(times) == trajectory.frames]
    assert len(longest) > 5
    for times in longest:
        np.testing.assert_allclose(times, trajectory.time, rtol=6e-8)
    samplers = glb.document["animations"][0]["samplers"]
    assert len({sampler["input"] for sampler in samplers}) < len(samplers) == len(glb.tracks)


def test_a_part_begins_at_zero(folder: Path, trajectory: Trajectory) -> None:
    glb = exported(folder, "--from", "0.4", "--until", "0.8", "--tolerance", "0")
    assert {times[0] for times, _ in glb.tracks.values()} == {0}
    assert max(len(times) for times, _ in glb.tracks.values()) == 81
    assert {times[-1] for times, _ in glb.tracks.values()} == {np.float32(0.4)}
    inside = range(trajectory.frame_at(0.4), trajectory.frame_at(0.8) + 1, 8)
    assert errors(glb, trajectory, inside, start=0.4)[2] < 8e-7
    assert glb.document["asset"]["extras"]["start"] == pytest.approx(0.4, abs=1e-15)


@pytest.mark.parametrize("fps", [24.0, 30.0, 500.0])
def test_other_rates_lie_between_frames(folder: Path, trajectory: Trajectory, fps: float) -> None:
    glb = exported(folder, "--fps", str(fps), "--tolerance", "0")
    steps = int(1.2 * fps + 1e-9)
    for times, _ in glb.tracks.values():
        np.testing.assert_allclose(times * fps, np.round(times * fps), rtol=1.2e-7)
        assert times[-1] == np.float32(steps / fps)
    box = trajectory.body("box")
    turns = Slerp(trajectory.time, Rotation.from_quat(box.orientation[:], scalar_first=True))
    for step in range(0, steps + 1, 7):
        position, orientation = pose(glb, "box", step / fps)
        expected = [np.interp(step / fps, trajectory.time, box.position[:, axis]) for axis in range(3)]
        np.testing.assert_allclose(position, expected, atol=5e-7)  # measured 3.4e-7
        assert (turns(step / fps).inv() * orientation).magnitude() < 4e-6  # measured 1.9e-6


def test_slow_motion(folder: Path, trajectory: Trajectory) -> None:
    """At a quarter of the speed 30 frames of each shown second are 120 of a simulated one."""
    glb = exported(folder, "--speed", "0.25", "--fps", "30", "--tolerance", "0")
    assert {times[-1] for times, _ in glb.tracks.values()} == {np.float32(4.8)}
    assert max(len(times) for times, _ in glb.tracks.values()) == 4.8 * 30 + 1
    ball = trajectory.body("ball")
    for frame in range(0, 241, 10):
        shown = trajectory.time[frame] / 0.25
        np.testing.assert_allclose(pose(glb, "ball", shown)[0], ball.position[frame], atol=1e-6)
    plain = exported(folder, "--speed", "0.25", "--tolerance", "0")
    assert max(len(times) for times, _ in plain.tracks.values()) == 241
    assert plain.document["asset"]["extras"]["speed"] == 0.25


@pytest.mark.parametrize("words", [(), ("--fps", "77"), ("--fps", "777"), ("--tolerance", "0")])
def test_blocks_leave_no_trace(folder: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]) -> None:
    whole = export(folder, *words).read_bytes()
    monkeypatch.setattr(clip_room, "BLOCK_BYTES", 5 * 8 * 56)
    monkeypatch.setattr(spool_room, "SPILL_ROWS", 11)
    assert export(folder, *words).read_bytes() == whole


def test_memory_is_that_of_a_block(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """20 000 frames of 30 bodies are 34 MB, and key frames 17 MB; what is taken does not grow with them."""
    ball = "repeat: {count: [30, 1, 1], spacing: [1, 0, 0]}, shape: {type: sphere, radius: 5 cm}, mass: 1"
    (tmp_path / "scene.yaml").write_text(
        "physsim: 1\nsimulation: {duration: 10 s, timestep: 0.5 ms}\n"
        "record: {every: 0.5 ms, contacts: false, energy: false}\n"
        f"bodies: {{ball: {{{ball}, collides: false, angular_velocity: [1, 2, 3]}}}}\n"
    )
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    monkeypatch.setattr(clip_room, "BLOCK_BYTES", 1 << 18)
    monkeypatch.setattr(spool_room, "SPILL_ROWS", 1 << 12)
    peaks = []
    for words in (("--until", "1"), ()):
        tracemalloc.start()
        export(tmp_path, "--tolerance", "0", *words)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert (tmp_path / "run.glb").stat().st_size > 16e6
    assert peaks[1] < peaks[0] + 5e6  # times and the key frames of one body; measured 2.9e6 and 4.8e6


def test_materials_and_shared_meshes(folder: Path) -> None:
    glb = exported(folder)
    names = [material["name"] for material in glb.document["materials"]]
    assert sorted(names) == ["blue", "concrete", "red"]
    look = glb.material("ball")["pbrMetallicRoughness"]
    linear = [
        0.603827,
        0.0331048,
        0.0,
    ]  # of #cc3300: ((0.8 + 0.055) / 1.055)^2.4, ((0.2 + 0.055) / 1.055)^2.4
    np.testing.assert_allclose(look["baseColorFactor"], [*linear, 1], rtol=1e-5)
    assert look["metallicFactor"] == 0
    ball, marble = (glb.document["nodes"][glb.nodes[name]] for name in ("ball", "marble"))
    assert ball["mesh"] == marble["mesh"]
    assert ball["scale"] == [0.05] * 3
    still = glb.document["meshes"][glb.document["nodes"][glb.nodes["still"]]["mesh"]]
    sphere = glb.document["meshes"][ball["mesh"]]
    assert still["primitives"][0]["attributes"] == sphere["primitives"][0]["attributes"]


def test_shapes_have_their_sizes_and_face_outward(folder: Path) -> None:
    glb = exported(folder)
    for name, size in {"box": (0.1, 0.2, 0.05), "cone": (0.1, 0.1, 0.2), "still": (0.1, 0.12, 0.14)}.items():
        position, orientation = pose(glb, name, 0)
        own = orientation.inv().apply(glb.points(glb.nodes[name], 0) - position)
        np.testing.assert_allclose(np.ptp(own, axis=0), size, rtol=1e-6)
    for mesh in range(len(glb.document["meshes"])):
        for vertices, normals, triangles in glb.primitives(mesh):
            a, b, c = (vertices[triangles[:, corner]] for corner in range(3))
            assert (np.einsum("ti,tki->tk", np.cross(b - a, c - a), normals[triangles]) > 0).all()


def test_the_ground_reaches_under_everything(folder: Path) -> None:
    glb = exported(folder)
    ground = glb.points(glb.nodes["floor"], 0)
    np.testing.assert_allclose(ground @ [0, 0.6, 0.8], -0.3, atol=1e-6)
    middle = ground.mean(axis=0)
    reach = np.linalg.norm(ground - middle, axis=1).min() / np.sqrt(2)
    others = [glb.points(glb.nodes[name], time) for name in ("ball", "post", "still") for time in (0, 1.2)]
    assert all((np.linalg.norm(points - middle, axis=1) < reach).all() for points in others)


def test_the_camera_sees_everything(folder: Path, trajectory: Trajectory) -> None:
    glb = exported(folder, "--camera")
    lens = glb.document["cameras"][0]["perspective"]
    view = np.linalg.inv(glb.matrix(glb.nodes["camera"], 0))
    seen = np.concatenate(
        [
            glb.points(glb.nodes[name], time)
            for name in trajectory.body_names[1:]
            for time in np.linspace(0, 1.2, 13)
        ]
    )
    y_up = np.stack([seen[:, 0], seen[:, 2], -seen[:, 1]], axis=1)
    x, y, z = (y_up @ view[:3, :3].T + view[:3, 3]).T
    half = np.tan(lens["yfov"] / 2)
    assert (-z > lens["znear"]).all()
    assert (-z < lens["zfar"]).all()
    assert 0.5 < np.abs(np.stack([y / (half * -z), x / (half * 4 / 3 * -z)])).max() < 1  # measured 0.64
    upright = rotation(glb.value(glb.nodes["camera"], "rotation", 0)) @ [1, 0, 0]
    assert abs(upright[1]) < 1e-7
    assert glb.document["extensionsUsed"] == ["KHR_lights_punctual"]
    assert glb.document["nodes"][glb.nodes["sun"]]["extensions"]["KHR_lights_punctual"]["light"] == 0


def test_without_motion_there_is_no_animation(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "scene.yaml").write_text(
        "physsim: 1\nsimulation: {duration: 2 ms, timestep: 1 ms}\nrecord: {every: 1 ms}\n"
        "bodies: {block: {fixed: true, shape: {type: box, size: [1, 1, 1]}, material: steel}}\n"
    )
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    glb = exported(tmp_path)
    assert "animations" not in glb.document
    assert "1 body, 3 frames" in capsys.readouterr().out
    assert exported(tmp_path, "--until", "0").tracks == {}


def test_names_are_only_names(tmp_path: Path) -> None:
    """Quotes, control characters and other scripts arrive as they are; no title gives the file's name."""
    names = ['<img src=x onerror="alert(1)">', "a\\b/c", "zwei Bälle ☃", "</script>"]
    bodies = {
        name: {
            "shape": {"type": "sphere", "radius": 1},
            "mass": 1,
            "collides": False,
            "position": [3 * k, 0, 0],
        }
        for k, name in enumerate(names)
    }
    scene = {"physsim": 1, "simulation": {"duration": 0.01, "timestep": 0.001}, "bodies": bodies}
    (tmp_path / "scene.yaml").write_text(json.dumps(scene))
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    glb = exported(tmp_path)
    assert [node["name"] for node in glb.document["nodes"]] == [*names, "scene"]


LINKED = """
physsim: 1
simulation: {duration: 0.8 s, timestep: 1 ms, integrator: rk4}
record: {every: 10 ms}
bodies:
  weight: {shape: {type: sphere, radius: 5 cm}, mass: 1, collides: false, position: [0.3, 0, -1]}
  bob: {shape: {type: sphere, radius: 5 cm}, mass: 1, collides: false, position: [1, 1, 0]}
springs:
  coil: {type: linear, between: [world, weight], anchors: [[0, 0, 0.5], [0, 3 cm, 4 cm]],
         stiffness: 30, rest_length: 1}
  wire: {type: torsional, between: [world, weight], axis: [0, 0, 1], stiffness: 1}
joints:
  thread: {type: distance, between: [world, bob], anchors: [[0, 1, 0], [0, 0, 0]], break_force: 12 N}
"""


def test_springs_stretch_and_strings_break(tmp_path: Path) -> None:
    (tmp_path / "scene.yaml").write_text(LINKED)
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    glb = exported(tmp_path, "--tolerance", "1e-6")
    assert "wire" not in glb.nodes
    with open_trajectory(tmp_path / "run.h5") as trajectory:
        broken = trajectory.time[np.argmax(trajectory.joint("thread").broken[:])]
        assert 0.1 < broken < 0.7
        for frame in range(0, trajectory.frames, 8):
            time = trajectory.time[frame]
            weight = trajectory.body("weight")
            turned = Rotation.from_quat(weight.orientation[frame], scalar_first=True)
            ends = np.array([[0, 0, 0.5], weight.position[frame] + turned.apply([0, 0.03, 0.04])])
            np.testing.assert_allclose(axis(glb, "coil", time), ends, atol=1e-6)  # measured 4e-7
            bob = trajectory.body("bob").position[frame]
            np.testing.assert_allclose(axis(glb, "thread", time), [[0, 1, 0], bob], atol=1e-6)
            thickness = np.ptp(glb.points(glb.nodes["thread"], time), axis=0).min()
            assert (thickness > 1e-3) == (time < broken)


def axis(glb: Glb, name: str, time: float) -> np.ndarray:
    """Both ends of a link, z up, (2, 3)."""
    world = glb.matrix(glb.nodes[name], time)
    return z_up(np.array([world[:3, 3], world[:3, 3] - world[:3, 2] * 0 + world[:3, 1]]))


def test_as_large_as_players_take(folder: Path, tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.setattr(glb_file, "MOST_BYTES", 100_000)
    words = ["export", str(folder / "run.h5"), "--to", "glb", "-o", str(tmp_path / "a.glb")]
    assert answer([*words, "--tolerance", "0"]) == 3
    assert "larger than 2 GiB" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_poses_that_are_none(folder: Path, tmp_path: Path, capsys) -> None:
    shutil.copy(folder / "run.h5", tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5", "r+") as file:
        file["position"][100, 2, 0] = np.nan
    target = tmp_path / "run.glb"
    target.write_text("older")
    words = ["export", str(tmp_path / "run.h5"), "--to", "glb", "-o", str(target), "--force"]
    assert answer(words) == 3
    assert "poses that are no poses" in capsys.readouterr().err
    assert target.read_text() == "older"
    assert answer([*words, "--until", "0.4"]) == 0
    with h5py.File(tmp_path / "run.h5", "r+") as file:
        file["orientation"][0, 2] = 0
    assert answer(words) == 3
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.glb", "run.h5"]


@pytest.fixture
def refused(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    """`refused("--fps", "0")`: exit code and message, in a folder that has there.glb and stays as it is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "there.glb").write_text("mine")

    def call(*words: str) -> tuple[int, str]:
        code = answer(["export", str(folder / "run.h5"), "--to", "glb", *words])
        assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("there.glb", "mine")]
        return code, capsys.readouterr().err

    return call


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["--from", "7"], 3, "has no frames in that span of time"),
        (["--fps", "0"], 2, "--fps"),
        (["--fps", "inf"], 2, "not a finite number"),
        (["--fps", "1e12"], 3, "would be 1.2e+12 of them"),
        (["--tolerance", "-1"], 2, "--tolerance"),
        (["--tolerance", "nan"], 2, "not a finite number"),
        (["-o", "nowhere/a.glb"], 3, "the folder nowhere does not exist"),
        (["-o", "there.glb"], 3, "exists already; --force replaces it"),
    ],
)
def test_trouble(refused, words: list[str], code: int, told: str) -> None:
    found, said = refused(*words)
    assert found == code
    assert told in said


def test_times_that_32_bits_cannot_tell_apart() -> None:
    assert clock(np.array([5, 105, 105.00001]), 1.0).tolist() == [0, 100, 100.00001]
    with pytest.raises(FileTrouble, match="too close together"):
        clock(np.array([5, 105, 105.000001]), 1.0)


def test_files_of_before_shapes_were_kept(folder: Path, tmp_path: Path, capsys) -> None:
    shutil.copy(folder / "run.h5", tmp_path / "old.h5")
    with h5py.File(tmp_path / "old.h5", "r+") as file:
        del file["geometry"]
    assert answer(["export", str(tmp_path / "old.h5"), "--to", "glb", "-o", str(tmp_path / "old.glb")]) == 3
    assert re.search("run the scene again", capsys.readouterr().err)
