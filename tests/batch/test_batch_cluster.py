"""A real Dask scheduler and real workers: the same bits as here, also when a worker is killed half-way."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from small_sweeps import DROP, bits

import physsim
from physsim.errors import PhyssimError

REPOSITORY = Path(__file__).resolve().parents[2]
SAMPLE = {
    "method": "latin_hypercube",
    "count": 40,
    "values": {
        "parameters.e": {"type": "uniform", "from": 0.2, "to": 0.9},
        "bodies.ball.velocity[0]": {"type": "normal", "mean": "1 m/s", "deviation": "20 cm/s"},
    },
}
MESH_SCENE = DROP.replace("{type: box, size: [10 cm, 1 m, 1 m]}", "{type: mesh, file: ../meshes/post.obj}")
POST = """\
v -0.05 -0.5 -0.5
v 0.05 -0.5 -0.5
v 0.05 0.5 -0.5
v -0.05 0.5 -0.5
v -0.05 -0.5 0.5
v 0.05 -0.5 0.5
v 0.05 0.5 0.5
v -0.05 0.5 0.5
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


class Cluster:
    """A scheduler and two workers, each a process of its own, in a folder of their own."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._processes: list[subprocess.Popen[str]] = []
        scheduler = self._start("scheduler", "--port", "0", "--host", "127.0.0.1")
        self.address = self._told(scheduler, r"Scheduler at:\s+(tcp://\S+)")
        self.workers = [self._worker() for _ in range(2)]

    def _worker(self) -> subprocess.Popen[str]:
        worker = self._start("worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard")
        self._told(worker, r"Registered to:\s+(tcp://\S+)")
        return worker

    def _start(self, *arguments: str) -> subprocess.Popen[str]:
        more = ["--no-dashboard"] if arguments[0] == "scheduler" else []
        process = subprocess.Popen(
            [sys.executable, "-m", "dask", *arguments, *more],
            cwd=self._folder,
            env={**os.environ, "PYTHONPATH": str(REPOSITORY)},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._processes.append(process)
        return process

    @staticmethod
    def _told(process: subprocess.Popen[str], pattern: str) -> str:
        assert process.stderr is not None
        seen = []
        for line in process.stderr:
            seen.append(line)
            found = re.search(pattern, line)
            if found:
                return found[1]
        raise AssertionError("".join(seen))

    def close(self) -> None:
        for process in self._processes:
            process.kill()
            with process:
                process.wait()


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    cluster = Cluster(folder)
    yield cluster
    cluster.close()


@pytest.mark.filterwarnings("ignore")  # Dask's own, of sockets of the worker that is killed
def test_a_worker_killed_half_way_shows_nowhere(write, tmp_path: Path, cluster: Cluster) -> None:
    trial = write(sample=SAMPLE)
    here = physsim.sweep(trial, output=tmp_path / "here", workers=2)
    assert len(here.table.rows) == 200
    killed_at = []

    def kill_one(now) -> None:
        if now.done >= 100 and not killed_at:
            killed_at.append(now.done)
            cluster.workers[0].send_signal(signal.SIGKILL)

    there = physsim.sweep(trial, output=tmp_path / "there", cluster=cluster.address, progress=kill_one)
    assert killed_at
    assert killed_at[0] < 200
    assert cluster.workers[0].wait(timeout=10) == -signal.SIGKILL
    assert bits(there) == bits(here)
    assert there.failed == 0


@pytest.mark.filterwarnings("ignore")
def test_meshes_go_there_and_trajectories_come_back(write, tmp_path: Path, cluster: Cluster) -> None:
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "post.obj").write_text(POST)
    (tmp_path / "project").mkdir()
    trial = write(keep="all")
    (tmp_path / "drop.yaml").rename(tmp_path / "project" / "drop.yaml")
    (tmp_path / "project" / "drop.yaml").write_text(MESH_SCENE)
    trial = trial.rename(tmp_path / "project" / "trial.yaml")
    here = physsim.sweep(trial, output=tmp_path / "here", workers=1)
    there = physsim.sweep(trial, output=tmp_path / "there", cluster=cluster.address)
    assert here.failed == 0
    assert bits(there) == bits(here)
    for file in here.table.column("file"):
        a, b = (physsim.open_trajectory(tmp_path / where / file) for where in ("here", "there"))
        with a, b:
            assert (a.position[:] == b.position[:]).all()
            assert a.provenance["mesh_sha256"] == b.provenance["mesh_sha256"] != "{}"


def test_nobody_at_the_address(write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("physsim.batch.cluster.SECONDS_TO_CONNECT", 0.5)
    with pytest.raises(PhyssimError, match=r"no Dask scheduler answers at tcp://127\.0\.0\.1:9"):
        physsim.sweep(write(), output=tmp_path / "out", cluster="tcp://127.0.0.1:9")
