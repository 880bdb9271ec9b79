"""`physsim sweep` killed at any moment goes on where it was, and leaves nobody behind."""

from __future__ import annotations

import csv
import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
ZIP = {"parameters.e": [k / 40 for k in range(40)]}


def start(sweep: Path, *more: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "physsim", "sweep", str(sweep), "--workers", "2", *more],
        cwd=sweep.parent,
        env={**os.environ, "PYTHONPATH": str(REPOSITORY)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def finished(process: subprocess.Popen[str]) -> int:
    with process:
        process.communicate(timeout=120)
    return process.returncode


def rows(folder: Path) -> list[list[str]]:
    """The table as text, without the wall time."""
    with (folder / "table.csv").open() as file:
        return [line[:-1] for line in csv.reader(file)]


def lines(folder: Path) -> list[str]:
    """Whole lines of the journal."""
    path = folder / "journal.jsonl"
    return [line for line in path.read_text().split("\n")[:-1] if line] if path.exists() else []


@pytest.mark.parametrize("keep", ["none", "all"])
def test_killed_again_and_again_it_ends_with_the_same_table(write, tmp_path: Path, keep: str) -> None:
    trial = write(zip=ZIP, keep=keep)
    assert finished(start(trial, "-o", "whole")) == 0
    chance = random.Random(keep)
    for _ in range(4):
        process = start(trial, "-o", "killed")
        before, until = len(lines(tmp_path / "killed")), time.monotonic() + 60
        while (
            process.poll() is None and len(lines(tmp_path / "killed")) <= before and time.monotonic() < until
        ):
            time.sleep(0.01)
        time.sleep(chance.random() * 0.3)
        workers = psutil.Process(process.pid).children() if process.poll() is None else []
        process.kill()
        finished(process)
        _, alive = psutil.wait_procs(workers, timeout=20)
        assert alive == []
    done_before = lines(tmp_path / "killed")
    assert finished(start(trial, "-o", "killed")) == 0
    assert rows(tmp_path / "killed") == rows(tmp_path / "whole")
    keys = [json.loads(line)["key"] for line in lines(tmp_path / "killed")]
    assert keys[: len(done_before)] == [json.loads(line)["key"] for line in done_before]
    assert len(keys) == len(set(keys)) == 200


def test_ctrl_c_says_what_is_left_and_the_next_call_goes_on(write, tmp_path: Path) -> None:
    trial = write(zip=ZIP)
    process = start(trial, "-o", "out", "--json")
    while process.poll() is None and not lines(tmp_path / "out"):
        time.sleep(0.01)
    process.send_signal(2)
    with process:
        said, complained = process.communicate(timeout=60)
    assert process.returncode == 130, complained
    assert "Traceback" not in complained
    document = json.loads(said)
    assert "runs are left, run it again to go on" in document["error"]
    assert len(rows(tmp_path / "out")) - 1 == len(lines(tmp_path / "out")) < 200
    assert finished(start(trial, "-o", "out")) == 0
    assert len(rows(tmp_path / "out")) == 201


def test_two_sweeps_do_not_write_to_one_folder(write, tmp_path: Path) -> None:
    trial = write(zip=ZIP)
    first = start(trial, "-o", "out")
    while first.poll() is None and not lines(tmp_path / "out"):
        time.sleep(0.01)
    psutil.Process(first.pid).suspend()  # it would be through before the second has begun
    second = start(trial, "-o", "out")
    _, complained = second.communicate(timeout=60)
    psutil.Process(first.pid).resume()
    assert finished(first) == 0
    assert second.returncode == 3
    assert "another sweep is writing to this folder" in complained
