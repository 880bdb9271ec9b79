"""`physsim export`: every number arrives with all its bits, in CSV and in Parquet, whatever the blocks."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas
import pyarrow.parquet
import pytest

import physsim
from physsim.analysis.export import rows, writers
from physsim.cli.app import answer
from physsim.recording import Trajectory

SCENE = """
physsim: 1
title: A ball bounces on a box, a puck lies on it
simulation: {duration: 500 ms, timestep: 1 ms}
bodies:
  "box, wide": {fixed: true, shape: {type: box, size: [1, 1, 0.1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: rubber, position: [0, 0, 30 cm],
         velocity: [0.1, 0, 0]}
  puck: {shape: {type: box, size: [5 cm, 5 cm, 2 cm]}, material: rubber, position: [0.3, 0, 6 cm]}
joints: {free: {type: distance, between: [world, ball], anchors: [[0, 0, 0], [0, 0, 0]], limits: [0, 9]}}
record: {every: 5 ms}
"""


@pytest.fixture(scope="module")
def run_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("export")
    (folder / "scene.yaml").write_text(SCENE)
    physsim.run(folder / "scene.yaml", output=folder / "run.h5").close()
    return folder / "run.h5"


@pytest.fixture
def trajectory(run_file: Path) -> Iterator[Trajectory]:
    with physsim.open_trajectory(run_file) as opened:
        yield opened


@pytest.fixture(params=["csv", "parquet"])
def exported(request, run_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """`exported(words...)` gives the table as pandas reads it; small blocks, so that there are many."""
    monkeypatch.setattr(rows, "FRAMES_AT_ONCE", 7)
    monkeypatch.setattr(writers, "ROWS_PER_GROUP", 30)

    def table(*words: str) -> pandas.DataFrame:
        path = tmp_path / f"table.{request.param}"
        assert (
            answer(["export", str(run_file), *words, "--to", request.param, "-o", str(path), "--force"]) == 0
        )
        if request.param == "parquet":
            return pandas.read_parquet(path)
        return pandas.read_csv(path, keep_default_na=False)

    return table


def test_the_state_of_all_bodies(exported, trajectory: Trajectory) -> None:
    found = exported()
    assert list(found)[:4] == ["time", *(f"bodies.box, wide.position.{axis}" for axis in "xyz")]
    assert found.shape == (101, 1 + 3 * 13)
    np.testing.assert_array_equal(found["time"], trajectory.time)
    for name in trajectory.body_names:
        for field, parts in (("position", "xyz"), ("orientation", "wxyz"), ("angular_velocity", "xyz")):
            columns = found[[f"bodies.{name}.{field}.{part}" for part in parts]]
            np.testing.assert_array_equal(columns, getattr(trajectory.body(name), field)[:])


def test_chosen_quantities(exported, trajectory: Trajectory) -> None:
    found = exported("bodies.*.speed", "energy.total", "joints.free.coordinate")
    assert list(found) == [
        "time",
        "bodies.box, wide.speed",
        "bodies.ball.speed",
        "bodies.puck.speed",
        "energy.total",
        "joints.free.coordinate",
    ]
    np.testing.assert_array_equal(found["energy.total"], trajectory.quantity("energy.total"))
    np.testing.assert_array_equal(found["bodies.ball.speed"], trajectory.quantity("bodies.ball.speed"))


def test_one_row_per_number(exported, trajectory: Trajectory) -> None:
    found = exported("bodies.ball.velocity", "energy.total", "momentum.linear", "--rows", "long")
    assert list(found) == ["time", "name", "quantity", "component", "value", "unit"]
    assert len(found) == 101 * 7
    x = found[(found["name"] == "ball") & (found["quantity"] == "velocity") & (found["component"] == "x")]
    np.testing.assert_array_equal(x["time"], trajectory.time)
    np.testing.assert_array_equal(x["value"], trajectory.body("ball").velocity[:, 0])
    assert set(x["unit"]) == {"m/s"}
    own = found[found["name"] == ""]
    assert set(own["quantity"]) == {"energy.total", "momentum.linear"}
    assert set(own[own["quantity"] == "momentum.linear"]["component"]) == {"x", "y", "z"}


def test_contacts_and_impacts(exported, trajectory: Trajectory) -> None:
    contacts, there = exported("--rows", "contacts"), trajectory.contacts()
    assert len(contacts) == there.rows > 0
    np.testing.assert_array_equal(contacts["time"], trajectory.time[there.frame])
    np.testing.assert_array_equal(contacts[["force.x", "force.y", "force.z"]], there.force)
    assert set(contacts["body_a"]) | set(contacts["body_b"]) == {"box, wide", "puck"}
    impacts = exported("--rows", "impacts")
    np.testing.assert_array_equal(impacts["speed_after"], trajectory.events.speed_after)
    assert list(impacts["body_a"]) == list(trajectory.events.body_a)


def test_parquet_knows_units(run_file: Path, tmp_path: Path) -> None:
    path = tmp_path / "run.parquet"
    assert answer(["export", str(run_file), "--to", "parquet", "-o", str(path)]) == 0
    schema = pyarrow.parquet.read_schema(path)
    assert schema.field("bodies.ball.velocity.x").metadata == {b"units": b"m/s"}
    assert schema.field("time").metadata == {b"units": b"s"}


def test_contacts_that_are_none(tmp_path: Path) -> None:
    (tmp_path / "scene.yaml").write_text(SCENE.replace("500 ms", "20 ms").replace("6 cm]}", "7 cm]}"))
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    for format in ("csv", "parquet"):
        for content in ("contacts", "impacts"):
            path = tmp_path / f"{content}.{format}"
            assert (
                answer(
                    ["export", str(tmp_path / "run.h5"), "--to", format, "--rows", content, "-o", str(path)]
                )
                == 0
            )
            read = pandas.read_csv(path) if format == "csv" else pandas.read_parquet(path)
            assert len(read) == 0
            assert "time" in read


def test_memory_is_that_of_a_block(tmp_path: Path) -> None:
    """5000 frames of 60 bodies are 31 MB; what is taken does not grow with their number."""
    balls = "repeat: {count: [60, 1, 1], spacing: [1, 0, 0]}, shape: {type: sphere, radius: 5 cm}, mass: 1"
    (tmp_path / "scene.yaml").write_text(
        "physsim: 1\nsimulation: {duration: 5 s, timestep: 1 ms}\nrecord: {every: 1 ms, contacts: false}\n"
        f"bodies: {{ball: {{{balls}, collides: false}}}}\n"
    )
    physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5").close()
    peaks = []
    for count in (6, 60):
        words = [f"bodies.ball[{k},0,0].position" for k in range(count)]
        with physsim.open_trajectory(tmp_path / "run.h5") as trajectory:
            batches, _ = rows.wide_rows(trajectory, words)
            tracemalloc.start()
            assert sum(len(batch["time"]) for batch in batches) == 5001
            peaks.append(tracemalloc.get_traced_memory()[1])
            tracemalloc.stop()
    assert peaks[1] < 3e6  # measured 1.1e6: 256 frames of 180 columns, and the times


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (["none.h5", "--to", "csv"], 3, "none.h5: no such file"),
        (["RUN", "--to", "glb", "--rows", "long"], 2, "--rows is for --to csv and parquet, not for --to glb"),
        (["RUN", "energy.total", "--to", "glb"], 2, "--to glb shows the whole scene"),
        (["RUN", "--to", "csv", "--fps", "30"], 2, "--fps is for --to "),
        (["RUN", "--to", "glb", "-o", "./RUN", "--force"], 2, "is the trajectory itself"),
        (["RUN", "--to", "xls"], 2, "'xls' is not one of"),
        (["RUN"], 2, "Missing option '--to'"),
        (["RUN", "--to", "csv", "-o", "there.csv"], 3, "exists already; --force replaces it"),
        (["RUN", "--to", "csv", "-o", "nowhere/a.csv"], 3, "the folder nowhere does not exist"),
        (["RUN", "bodies.bal.speed", "--to", "csv"], 2, "did you mean 'ball'"),
        (["RUN", "time", "--to", "csv", "--rows", "contacts"], 2, "writes all columns"),
    ],
)
def test_trouble(
    in_folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], code: int, told: str
) -> None:
    (in_folder / "there.csv").write_text("mine")
    before = sorted(in_folder.iterdir())
    assert answer(["export", *(word.replace("RUN", "run.h5") for word in arguments)]) == code
    assert told in capsys.readouterr().err
    assert sorted(in_folder.iterdir()) == before


@pytest.fixture
def in_folder(run_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with run.h5 in it."""
    (tmp_path / "run.h5").symlink_to(run_file)
    monkeypatch.chdir(tmp_path)
    return tmp_path
