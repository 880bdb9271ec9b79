"""Whole sweeps: the same table however they are done, rows for what fails, folders that go on."""

from __future__ import annotations

import csv
import json
import math
import os
import signal
from pathlib import Path

import h5py
import numpy as np
import pyarrow.parquet as pq
import pytest
from small_sweeps import DROP, bits

import physsim
from physsim.batch import load_sweep
from physsim.errors import FileTrouble, SceneError
from physsim.simulation import Interrupted

ZIP = {"parameters.e": [0.1, 0.5, 0.9], "bodies.ball.velocity": [[1, 0, 0], [1, 0, 1], [0, 0, 0]]}


def journal_of(folder: Path) -> list[dict]:
    return [json.loads(line) for line in (folder / "journal.jsonl").read_text().splitlines()]


def test_the_numbers_do_not_depend_on_workers_or_on_what_is_kept(write, tmp_path: Path) -> None:
    trial = write(zip=ZIP)
    one = physsim.sweep(trial, output=tmp_path / "one", workers=1)
    two = physsim.sweep(trial, output=tmp_path / "two", workers=2)
    kept = physsim.sweep(write("kept.yaml", zip=ZIP, keep="all"), output=tmp_path / "kept", workers=2)
    assert len(one.table.rows) == 15
    assert bits(one) == bits(two)
    file = [column.name for column in one.table.columns].index("file")
    assert [row[:file] for row in bits(kept)] == [row[:file] for row in bits(one)]


def test_a_row_is_what_a_run_by_hand_gives(write, tmp_path: Path) -> None:
    result = physsim.sweep(write(zip=ZIP), output=tmp_path / "out", workers=1)
    row = dict(zip([column.name for column in result.table.columns], result.table.rows[7], strict=True))
    changes = {
        "parameters.drop": row["parameters.drop"],
        "parameters.e": 0.5,
        "bodies.ball.velocity": [1, 0, 1],
    }
    with physsim.run(tmp_path / "drop.yaml", set=changes, output=tmp_path / "run.h5") as run:
        assert row["x"] == run.body("ball").position[-1, 0]
        assert row["hits"] == run.events.rows
        assert row["share"] == row["top"] / row["parameters.drop"]
    assert row["bodies.ball.velocity"] == "[1, 0, 1]"
    assert (row["run"], row["status"], row["error"]) == (7, "complete", None)


def test_what_fails_is_a_row_with_its_error(write, tmp_path: Path) -> None:
    scene = DROP.replace("expect:", "forces: {push: {body: ball, force: [1 N, 0, 0]}}\nexpect:")
    scene = scene.replace("max: 10 cm", "max: -1 m")
    trial = write(scene=scene, grid={"bodies.ball.mass": ["-1 kg", "1 kg", "1e-15 kg"]}, keep="failed")
    result = physsim.sweep(trial, output=tmp_path / "out", workers=1)
    table = result.table
    assert table.column("status") == ["invalid", "complete", "failed"]
    assert table.column("error")[0] == "bodies.ball.mass: must be greater than 0, got -1 kg"
    assert "bodies.ball: its motion blew up at" in table.column("error")[2]
    assert table.column("x")[0] is None
    assert table.column("x")[2] is None
    assert result.failed == 2
    # The second run is complete, but its expectation does not hold: kept, too.
    assert table.column("expectations_failed") == [None, 1, None]
    assert table.column("file")[0] is None
    for row, status in ((1, "complete"), (2, "failed")):
        with physsim.open_trajectory(result.folder / table.column("file")[row]) as trajectory:
            assert trajectory.status == status


def test_only_what_is_missing_is_done(write, tmp_path: Path) -> None:
    trial, folder = write(), tmp_path / "out"
    first = physsim.sweep(trial, output=folder, workers=1)
    lines = (folder / "journal.jsonl").read_text().splitlines(keepends=True)
    (folder / "journal.jsonl").write_text("".join(lines[:3]) + lines[3][:40])
    again = physsim.sweep(trial, output=folder, workers=2)
    assert bits(again) == bits(first)
    assert [entry["key"] for entry in journal_of(folder)[:3]] == [
        json.loads(line)["key"] for line in lines[:3]
    ]
    assert len(journal_of(folder)) == 5
    seen = []
    physsim.sweep(trial, output=folder, progress=seen.append)
    assert seen == []


def test_a_sweep_that_has_grown_does_what_is_new(write, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    physsim.sweep(write(grid={"parameters.e": [0.2, 0.4]}), output=folder, workers=1)
    grown = physsim.sweep(write(grid={"parameters.e": [0.1, 0.2, 0.3, 0.4]}), output=folder, workers=1)
    assert len(journal_of(folder)) == 4
    anew = physsim.sweep(
        write(grid={"parameters.e": [0.1, 0.2, 0.3, 0.4]}), output=tmp_path / "anew", workers=1
    )
    assert bits(grown) == bits(anew)


def test_a_trajectory_that_was_deleted_is_made_again(write, tmp_path: Path) -> None:
    trial, folder = write(keep="all"), tmp_path / "out"
    first = physsim.sweep(trial, output=folder, workers=1)
    gone = folder / first.table.column("file")[2]
    gone.unlink()
    assert bits(physsim.sweep(trial, output=folder, workers=1)) == bits(first)
    assert gone.exists()


def test_a_folder_of_another_sweep_is_left_alone(write, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    physsim.sweep(write(), output=folder, workers=1)
    before = (folder / "table.csv").read_bytes()
    other = write(scene=DROP.replace("radius: 5 cm", "radius: 6 cm"))
    with pytest.raises(FileTrouble, match=r"holds another sweep \(scene differ\)"):
        physsim.sweep(other, output=folder, workers=1)
    assert (folder / "table.csv").read_bytes() == before
    physsim.sweep(other, output=folder, workers=1, force=True)
    assert (folder / "table.csv").read_bytes() != before
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("years of work")
    with pytest.raises(FileTrouble, match="is not empty and holds no sweep"):
        physsim.sweep(other, output=tmp_path / "mine", workers=1, force=True)
    assert (tmp_path / "mine" / "thesis.txt").exists()
    (folder / "manifest.json").unlink()  # as a kill in the first moments leaves it
    physsim.sweep(write(), output=folder, workers=1)
    assert (folder / "table.csv").read_bytes()[:60] == before[:60]


def test_csv_and_parquet_hold_every_digit(write, tmp_path: Path) -> None:
    result = physsim.sweep(write(zip=ZIP), output=tmp_path / "out", workers=1)
    parquet = pq.read_table(result.folder / "table.parquet")
    with (result.folder / "table.csv").open() as file:
        lines = list(csv.DictReader(file))
    for k, column in enumerate(result.table.columns):
        cells = [row[k] for row in result.table.rows]
        assert repr(parquet[column.name].to_pylist()) == repr(cells)
        read = [line[column.name] for line in lines]
        if column.kind == "float":
            assert [repr(float(text)) for text in read] == [repr(cell) for cell in cells]
        else:
            assert read == ["" if cell is None else str(cell) for cell in cells]
    assert any(math.isnan(value) for value in result.table.column("hit"))
    assert parquet.schema.field("parameters.drop").metadata == {b"role": b"input", b"unit": b"m"}
    assert parquet.schema.field("lost").metadata == {b"role": b"metric", b"unit": b"J"}
    assert list(result.to_pandas()["x"]) == result.table.column("x")


def test_the_manifest_repeats_the_sweep(write, tmp_path: Path) -> None:
    result = physsim.sweep(write(zip=ZIP, seed=3), output=tmp_path / "out", workers=1)
    manifest = json.loads((result.folder / "manifest.json").read_text())
    assert manifest["status"] == "complete"
    assert manifest["by_status"] == {"complete": 15}
    (tmp_path / "copy").mkdir()
    (tmp_path / "copy" / "trial.yaml").write_text(manifest["sweep"]["text"])
    (tmp_path / "copy" / "drop.yaml").write_text(manifest["scene"]["text"])
    again = physsim.sweep(tmp_path / "copy" / "trial.yaml", output=tmp_path / "again", workers=1)
    assert bits(again) == bits(result)
    assert again.manifest["digest"] == manifest["digest"]


def test_all_trajectories_as_one_by_virtual_datasets(write, tmp_path: Path) -> None:
    """Also after the folder has moved; runs that end early are filled up."""
    scene = DROP.replace("timestep: 1 ms", "timestep: 1 ms, until: at_rest")
    grid = {"parameters.drop": ["30 cm", "5 cm"], "bodies.ball.velocity": [[0, 0, 0], [1, 0, 0]]}
    trial = write(scene=scene, grid=grid, keep="all", gather=True)
    result = physsim.sweep(trial, output=tmp_path / "out", workers=1)
    (tmp_path / "out").rename(tmp_path / "moved")
    with h5py.File(tmp_path / "moved" / "runs.h5") as whole:
        assert whole["position"].is_virtual
        frames = whole["frames"][:]
        assert frames.min() < frames.max()
        for row, file in enumerate(result.table.column("file")):
            with physsim.open_trajectory(tmp_path / "moved" / file) as one:
                assert one.frames == frames[row]
                np.testing.assert_array_equal(whole["position"][row, : frames[row]], one.position[:])
                np.testing.assert_array_equal(
                    whole["energy/lost_impact"][row, : frames[row]], one.energy.lost_impact
                )
                assert np.isnan(whole["position"][row, frames[row] :]).all()
        assert list(whole["table/x"]) == result.table.column("x")


def test_a_run_that_kills_its_worker_is_a_row(write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "patch").mkdir()
    (tmp_path / "patch" / "sitecustomize.py").write_text(DEADLY)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "patch"))
    trial = write(zip=ZIP)
    result = physsim.sweep(trial, output=tmp_path / "out", workers=2)
    assert result.table.column("status") == ["crashed" if run == 4 else "complete" for run in range(15)]
    assert result.table.column("error")[4] == "its worker was killed by SIGKILL"
    monkeypatch.delenv("PYTHONPATH")
    healed = physsim.sweep(trial, output=tmp_path / "out", workers=1)
    assert bits(healed) == bits(physsim.sweep(trial, output=tmp_path / "anew", workers=1))


DEADLY = """\
import os
import sys
if "physsim.batch.worker" in " ".join(sys.orig_argv):
    from physsim.batch import workshop
    do = workshop.Workshop.do
    def deadly(self, task):
        if task.number == 4:
            os.kill(os.getpid(), 9)
        return do(self, task)
    workshop.Workshop.do = deadly
"""


def test_a_signal_ends_a_sweep_in_good_order(write, tmp_path: Path) -> None:
    trial = write(zip=ZIP)

    def stop(now) -> None:
        if now.done >= 3:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(Interrupted, match="runs are left"):
        physsim.sweep(trial, output=tmp_path / "out", workers=1, progress=stop)
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text())
    assert manifest["status"] == "interrupted"
    assert 3 <= manifest["done"] < 15
    again = physsim.sweep(trial, output=tmp_path / "out", workers=1)
    assert bits(again) == bits(physsim.sweep(trial, output=tmp_path / "anew", workers=1))


def test_a_sweep_made_in_a_program(write, tmp_path: Path) -> None:
    write()
    content = {
        "physsim_sweep": 1,
        "scene": str(tmp_path / "drop.yaml"),
        "grid": {"parameters.drop": np.linspace(0.2, 0.4, 3)},
        "metrics": {"hits": {"type": "impacts"}},
    }
    result = physsim.sweep(content, output=tmp_path / "out", workers=1)
    assert result.table.column("parameters.drop") == [0.2, 0.30000000000000004, 0.4]
    with pytest.raises(SceneError, match="unknown key"):
        load_sweep({**content, "gird": {}})
    with pytest.raises(FileTrouble, match="must name the folder"):
        physsim.sweep(content)
