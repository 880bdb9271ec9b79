"""`physsim sweep` as users meet it: summary, JSON, mistakes, exit codes, and what it imports."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

SCENE = """\
physsim: 1
parameters: {drop: 20 cm}
simulation: {duration: 200 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, "${drop}"]}
"""
SWEEP = """\
physsim_sweep: 1
scene: scene.yaml
grid: {bodies.ball.mass: [1 kg, -1 kg]}
metrics: {z: {type: final, quantity: bodies.ball.position.z}}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scene.yaml").write_text(SCENE)
    (tmp_path / "trial.yaml").write_text(SWEEP)
    return tmp_path


def test_summary_tells_folder_metrics_and_failures(folder: Path, physsim) -> None:
    said = physsim("sweep", "trial.yaml", "--workers", "1")
    assert said.code == 0, said.err
    assert said.out.startswith("trial_sweep: 2 runs (1 complete, 1 invalid) in ")
    assert "run 1 invalid: bodies.ball.mass: must be greater than 0, got -1 kg" in said.out
    assert (folder / "trial_sweep" / "table.parquet").exists()


def test_json_is_one_document(folder: Path, physsim) -> None:
    document = json.loads(physsim("sweep", "trial.yaml", "--workers", "1", "--json").out)
    assert (document["command"], document["exit_code"], document["runs"]) == ("sweep", 0, 2)
    assert document["by_status"] == {"complete": 1, "invalid": 1}
    assert document["metrics"][0]["count"] == 1
    assert document["failures"][0]["run"] == 1


def test_a_dry_run_writes_nothing(folder: Path, physsim) -> None:
    said = physsim("sweep", "trial.yaml", "--dry-run")
    assert said.out.splitlines()[0] == "trial: 2 runs of scene.yaml"
    plan = json.loads(physsim("sweep", "trial.yaml", "--dry-run", "--json").out)
    assert plan["runs"] == 2
    assert [column["name"] for column in plan["columns"]][2:4] == ["bodies.ball.mass", "z"]
    assert not (folder / "trial_sweep").exists()


def test_mistakes_have_their_place_and_exit_code(folder: Path, physsim) -> None:
    (folder / "trial.yaml").write_text(SWEEP.replace("grid", "gird"))
    said = physsim("sweep", "trial.yaml")
    assert said.code == 2
    assert said.err.startswith("trial.yaml:3:1: gird: unknown key; did you mean 'grid'?\n    3 | gird:")
    found = json.loads(physsim("sweep", "trial.yaml", "--json").out)["problems"]
    assert [(problem["line"], problem["column"]) for problem in found] == [(3, 1)]
    assert physsim("sweep", "nowhere.yaml").code == 3
    assert physsim("sweep", "trial.yaml", "--workers", "2", "--cluster", "tcp://a:1").code == 2


def test_when_every_run_fails_so_does_the_sweep(folder: Path, physsim) -> None:
    (folder / "trial.yaml").write_text(
        SWEEP.replace("1 kg, -1 kg", "1 kg") + "set: {simulation.duration: 1 s}\n"
    )
    assert physsim("sweep", "trial.yaml", "--workers", "1", "--quiet").code == 0
    scene = SCENE + "forces: {push: {body: ball, force: [1 N, 0, 0]}}\n"
    (folder / "scene.yaml").write_text(scene)
    (folder / "trial.yaml").write_text(SWEEP.replace("1 kg, -1 kg", "1e-15 kg, 1e-16 kg"))
    assert physsim("sweep", "trial.yaml", "--workers", "1", "--force", "--quiet").code == 1


def test_a_piped_sweep_tells_its_progress_in_lines(folder: Path, physsim, monkeypatch) -> None:
    monkeypatch.setattr("physsim.cli.progress.SECONDS_BETWEEN_LINES", 0.0)
    said = physsim("sweep", "trial.yaml", "--workers", "1")
    assert "trial: 2 of 2 runs, 1 failed, 0 s left" in said.err
