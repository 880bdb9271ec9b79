"""Stills, sheets and films of a ball in free fall: the heights in them are those of g t^2 / 2."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from physsim.cli.app import answer
from physsim.view.picture.camera import FOCUS
from physsim.view.picture.show import Show

Image = pytest.importorskip("PIL.Image")
av = pytest.importorskip("av")

SCENE = """
physsim: 1
title: A ball falls
simulation: {duration: 0.5 s, timestep: 1 ms, integrator: velocity_verlet}
materials: {paint: {density: 1000 kg/m^3, color: "#cc2222"}}
bodies:
  ball: {shape: {type: sphere, radius: 10 cm}, material: paint, position: [0, 0, 1]}
record: {every: 20 ms}
"""
CAMERA = ["--view=-90,0,5", "--look-at", "0,0,0.5", "--caption", "none"]
"""5 m in front of the ball, half a metre up: f / 5 m pixels in a metre of the plane of its fall."""
SIZE = (200, 160)
BARE = [*CAMERA, "--size", "200x160"]

Call = Callable[..., tuple[int, str]]


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("fall")
    (folder / "fall.yaml").write_text(SCENE)
    assert answer(["run", str(folder / "fall.yaml"), "-o", str(folder / "fall.h5"), "--quiet"]) == 0
    return folder / "fall.h5"


@pytest.fixture
def export(
    recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Call:
    """`export("--to", "png")` of the falling ball in an empty folder: exit code and all that was said."""
    monkeypatch.chdir(tmp_path)

    def call(*arguments: str) -> tuple[int, str]:
        capsys.readouterr()
        code = answer(["export", str(recording), *arguments])
        said = capsys.readouterr()
        return code, said.out + said.err

    return call


def row_of_ball(picture: Any) -> float:
    """The mean row of the red pixels."""
    pixels = np.asarray(picture.convert("RGB")).astype(int)
    return float(np.nonzero(pixels[..., 0] > pixels[..., 2] + 25)[0].mean()) + 0.5


def row_at(time: float, size: tuple[int, int] = SIZE) -> float:
    """Where the ball's middle must be: z = 1 - g t^2 / 2, seen from 0.5 m up and 5 m away."""
    return size[1] / 2 - FOCUS * size[1] / 2 / 5 * (0.5 - 9.81 * time**2 / 2)


def test_stills_show_the_ball_where_it_is_at_their_times(export: Call) -> None:
    """0.1 s is a frame, 0.251 s is none: there the picture is between two of them."""
    code, said = export("--to", "png", "--at", "251 ms,0.1s", *BARE)
    assert code == 0, said
    names = ["fall-0.100s.png", "fall-0.251s.png"]
    assert sorted(path.name for path in Path().iterdir()) == names
    for name, time in zip(names, (0.1, 0.251), strict=True):
        picture = Image.open(name)
        assert picture.size == SIZE
        assert abs(row_of_ball(picture) - row_at(time)) < 0.7, name


def test_without_a_time_the_end_is_drawn(export: Call) -> None:
    code, said = export("--to", "png", *BARE, "-o", "end.png")
    assert (code, said.split(":")[0]) == (0, "end.png")
    assert abs(row_of_ball(Image.open("end.png")) - row_at(0.5)) < 0.7


def test_every_frame_gets_a_file_of_its_own(export: Call) -> None:
    code, _ = export("--to", "png", "--at", "all", "--until", "0.1", *CAMERA, "--size", "40x32")
    assert code == 0
    times = [0, 0.02, 0.04, 0.06, 0.08, 0.1]
    assert sorted(path.name for path in Path().iterdir()) == [f"fall-{time:.3f}s.png" for time in times]


def test_a_sheet_goes_from_the_first_time_to_the_last(export: Call) -> None:
    code, _ = export("--to", "png", "--sheet", "3x2", *CAMERA, "--size", "608x400", "-o", "sheet.png")
    assert code == 0
    sheet = Image.open("sheet.png")
    tile = (200, 132)
    assert sheet.size == (3 * 200 + 2 * 4, 2 * 132 + 4)
    for number in range(6):
        left, top = (number % 3) * 204, (number // 3) * 136
        one = sheet.crop((left, top, left + tile[0], top + tile[1]))
        assert abs(row_of_ball(one) - row_at(0.1 * number, tile)) < 0.7


def test_an_mp4_has_the_pictures_the_length_and_the_size_that_it_says(export: Call) -> None:
    """An odd side becomes even; a quarter of the speed makes the film four times as long."""
    code, said = export("--to", "mp4", "--speed", "0.25", "--fps", "25", *CAMERA, "--size", "199x160")
    assert code == 0
    assert "51 pictures" in said
    assert "200x160" in said
    with av.open("fall.mp4") as film:
        stream = film.streams.video[0]
        assert (stream.codec_context.name, stream.codec_context.pix_fmt) == ("h264", "yuv420p")
        assert stream.average_rate == 25
        assert film.duration / av.time_base == pytest.approx(51 / 25, abs=0.01)
        pictures = [frame.to_image() for frame in film.decode(video=0)]
    assert len(pictures) == 51
    for number in (0, 13, 40, 50):
        assert pictures[number].size == SIZE
        assert abs(row_of_ball(pictures[number]) - row_at(number / 25 * 0.25)) < 1.5


def test_the_index_of_an_mp4_stands_first(export: Call) -> None:
    """So that a browser plays it while it loads: moov before mdat."""
    assert export("--to", "mp4", "--until", "0.1", *BARE)[0] == 0
    data = Path("fall.mp4").read_bytes()
    assert 0 < data.index(b"moov") < data.index(b"mdat")


def test_a_gif_loops_at_its_rate(export: Call) -> None:
    code, said = export("--to", "gif", "--fps", "33", *BARE)
    assert code == 0
    with Image.open("fall.gif") as film:
        assert f"{film.n_frames} pictures" in said
        assert film.info["loop"] == 0
        assert film.n_frames == 17  # a GIF counts hundredths of a second: 30 ms each
        for number in (0, 5, 16):
            film.seek(number)
            assert film.info["duration"] == 30
            assert abs(row_of_ball(film) - row_at(0.03 * number)) < 1


def test_a_part_of_the_time(export: Call) -> None:
    assert export("--to", "gif", "--from", "0.2", "--until", "0.3", "--fps", "50", *BARE)[0] == 0
    with Image.open("fall.gif") as film:
        assert film.n_frames == 6
        assert abs(row_of_ball(film) - row_at(0.2)) < 1


def test_the_camera_keeps_up_with_a_body(export: Call) -> None:
    code, _ = export(
        "--to", "png", "--at", "0,0.5", "--follow", "ball", "--caption", "none", "--size", "200x160"
    )
    assert code == 0
    rows = [row_of_ball(Image.open(f"fall-{time}s.png")) for time in ("0.000", "0.500")]
    assert rows == pytest.approx([80, 80], abs=0.7)


def test_words_and_signs_change_the_picture(export: Call) -> None:
    plain = ["--to", "png", "--size", "200x160", "--at", "0.4"]
    made = {}
    for name, more in {
        "plain": ["--caption", "none"],
        "time": ["--caption", "time"],
        "title": ["--caption", "title"],
        "labels": ["--caption", "none", "--show", "labels"],
        "trails": ["--caption", "none", "--show", "trails"],
        "frames": ["--caption", "none", "--show", "frames"],
        "contacts": ["--caption", "none", "--show", "contacts"],
    }.items():
        code, said = export(*plain, *more, "-o", f"{name}.png")
        assert code == 0, said
        made[name] = np.asarray(Image.open(f"{name}.png")).astype(int)
    changed = {name: np.abs(picture - made["plain"]).max(axis=2) > 20 for name, picture in made.items()}
    rows, columns = np.nonzero(changed["time"])
    assert rows.min() > 130
    assert columns.max() < 100
    assert np.nonzero(changed["title"])[0].max() < 40
    assert changed["labels"].any()
    assert changed["trails"].any()
    assert changed["frames"].any()
    assert not changed["contacts"].any()  # it touches nothing


def test_a_faster_ball_is_lighter(export: Call) -> None:
    """At rest at the start, fastest at the end."""
    assert export("--to", "png", "--at", "0,0.25,0.5", "--color", "speed", *BARE)[0] == 0
    light = []
    for name in ("0.000", "0.250", "0.500"):
        pixels = np.asarray(Image.open(f"fall-{name}s.png").convert("RGB")).astype(int)
        row, column = round(row_at(float(name))), SIZE[0] // 2
        light.append(pixels[row - 2 : row + 3, column - 2 : column + 3].sum(axis=2).mean())
    assert light[0] < 150
    assert light[0] < light[1] - 50 < light[2] - 100


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["--to", "png", "--at", "0.6"], 2, "within 0 s to 0.5 s"),
        (["--to", "png", "--at", "3 kg"], 2, "no time"),
        (["--to", "png", "--at", "soon"], 2, "no time"),
        (["--to", "png", "--at", "0.1", "--sheet", "2x2"], 2, "one of them"),
        (["--to", "png", "--sheet", "4"], 2, "4x3"),
        (["--to", "png", "--sheet", "100x100"], 2, "up to 400"),
        (["--to", "png", "--size", "8x8"], 2, "16 to 8192"),
        (["--to", "png", "--size", "large"], 2, "1280x720"),
        (["--to", "png", "--view", "1"], 2, "-60,25"),
        (["--to", "png", "--view", "0,95"], 2, "-90 to 90"),
        (["--to", "png", "--view", "0,9,-1"], 2, "greater than 0"),
        (["--to", "png", "--look-at", "a,b,c"], 2, "numbers"),
        (["--to", "png", "--show", "ghosts"], 2, "none of contacts"),
        (["--to", "png", "--follow", "bal"], 2, "did you mean 'ball'"),
        (["--to", "png", "--from", "9"], 3, "no frames"),
        (["--to", "png", "-o", "nowhere/a.png"], 3, "does not exist"),
        (["--to", "mp4", "--speed", "1e-9"], 3, "--speed makes it shorter"),
        (["--to", "mp4", "--speed", "0"], 2, "x>0"),
        (["--to", "mp4", "--fps", "1000"], 2, "up to 240"),
        (["--to", "mp4", "--from", "9"], 3, "no frames"),
        (["--to", "gif", "--at", "0.1"], 2, "--at is for --to png"),
    ],
)
def test_mistakes_are_told_in_a_line_and_leave_nothing(
    export: Call, arguments: list[str], code: int, words: str
) -> None:
    found, said = export(*arguments)
    assert found == code, said
    assert words in said
    assert "Traceback" not in said
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize("kind", ["png", "mp4", "gif"])
def test_an_old_file_is_not_replaced_unless_forced(export: Call, kind: str) -> None:
    old = Path(f"fall.{kind}")
    old.write_bytes(b"mine")
    more = [] if kind == "png" else ["--until", "0.04"]
    code, said = export("--to", kind, *BARE, *more)
    assert code == 3
    assert "exists already" in said
    assert old.read_bytes() == b"mine"
    assert export("--to", kind, *BARE, *more, "--force")[0] == 0
    assert old.stat().st_size > 100


@pytest.mark.parametrize("kind", ["png", "mp4", "gif"])
def test_an_interrupted_export_leaves_no_half_file(
    export: Call, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    """Ctrl-C at the fifth picture: what stood there before is still there, and nothing else."""
    drawn, calls = Show._picture, []

    def interrupted(self: Show, *arguments: Any) -> Any:
        calls.append(1)
        if len(calls) == 5:
            raise KeyboardInterrupt
        return drawn(self, *arguments)

    monkeypatch.setattr(Show, "_picture", interrupted)
    old = Path(f"fall.{kind}")
    old.write_bytes(b"mine")
    code, said = export("--to", kind, *BARE, "--force", *(["--sheet", "3x3"] if kind == "png" else []))
    assert (code, said.strip()) == (130, "physsim: interrupted")
    assert [path.name for path in Path().iterdir()] == [old.name]
    assert old.read_bytes() == b"mine"


@pytest.mark.parametrize(("module", "kind"), [("PIL", "png"), ("PIL", "gif"), ("av", "mp4")])
def test_a_missing_extra_is_named(
    export: Call, monkeypatch: pytest.MonkeyPatch, module: str, kind: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    code, said = export("--to", kind, *BARE)
    assert code == 2
    assert said.endswith("pip install 'physsim[view]'\n")
    assert list(Path().iterdir()) == []


def test_a_file_without_shapes_is_refused(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old = tmp_path / "old.h5"
    old.write_bytes(recording.read_bytes())
    with h5py.File(old, "r+") as file:
        del file["geometry"]
    assert answer(["export", str(old), "--to", "png", "-o", str(tmp_path / "a.png")]) == 3
    assert "run the scene again" in capsys.readouterr().err
    assert not (tmp_path / "a.png").exists()
