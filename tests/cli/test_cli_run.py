"""`physsim run`: file, summary, exit codes, and what happens to old files and interrupted runs."""

from __future__ import annotations

import json
import shlex
import signal
import subprocess
import time
from pathlib import Path

import pytest
from shell import PHYSSIM, clean_environment, on_a_terminal, running

from physsim import open_trajectory

ESCAPE = "\x1b["
FALL = """
physsim: 1
title: A ball falls freely
simulation: {duration: 200 ms, timestep: 1 ms}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1]}
expect:
  - {quantity: bodies.ball.position.z, at: 200 ms, value: 0.8038, within: 1 mm}
"""
# z = 1 - g t^2 / 2 = 0.8038 at 0.2 s; the scheme's own error is g t h / 2 = 0.98 mm at h = 1 ms.


@pytest.fixture
def fall(tmp_path: Path) -> Path:
    scene = tmp_path / "fall.yaml"
    scene.write_text(FALL)
    return scene


@pytest.mark.usefixtures("fall")
class TestRun:
    def test_the_trajectory_has_the_scenes_name_and_the_summary_says_where(
        self, physsim, tmp_path: Path
    ) -> None:
        said = physsim("run", "fall.yaml")
        assert said.code == 0
        assert said.out.startswith("fall.h5: complete, ran to its end at 0.2 s\n21 frames, 200 steps in ")
        assert "expectations: 1 held, 0 failed" in said.out
        assert "bodies.ball.position.z at 0.2 s: wanted 0.8038 within 0.001, got 0.802819" in said.out
        assert said.err == ""
        with open_trajectory(tmp_path / "fall.h5") as trajectory:
            assert (trajectory.status, trajectory.frames) == ("complete", 21)

    def test_the_scene_may_stand_elsewhere_and_the_file_is_put_here(self, physsim, tmp_path: Path) -> None:
        (tmp_path / "elsewhere").mkdir()
        (tmp_path / "elsewhere" / "other.v2.yaml").write_text(FALL)
        assert physsim("run", "elsewhere/other.v2.yaml").code == 0
        assert (tmp_path / "other.v2.h5").is_file()

    def test_quiet_says_nothing(self, physsim) -> None:
        said = physsim("run", "fall.yaml", "--quiet")
        assert (said.code, said.out, said.err) == (0, "", "")

    def test_a_failed_expectation_is_exit_4_and_the_file_is_kept(self, physsim, tmp_path: Path) -> None:
        said = physsim("run", "fall.yaml", "--set", "bodies.ball.position[2]=2 m")
        assert said.code == 4
        assert "expectations: 0 held, 1 failed" in said.out
        assert "does not hold" in said.out
        assert (tmp_path / "fall.h5").is_file()
        quiet = physsim("run", "fall.yaml", "--set", "bodies.ball.position[2]=2 m", "--force", "--quiet")
        assert (quiet.code, quiet.out) == (4, "")
        assert "wanted 0.8038 within 0.001, got 1.802819 m" in quiet.err

    def test_an_existing_file_is_not_overwritten_without_force(self, physsim, tmp_path: Path) -> None:
        (tmp_path / "fall.h5").write_bytes(b"precious")
        said = physsim("run", "fall.yaml")
        assert said.code == 3
        assert "fall.h5" in said.err
        assert "--force" in said.err
        assert (tmp_path / "fall.h5").read_bytes() == b"precious"
        assert physsim("run", "fall.yaml", "--force").code == 0

    def test_a_broken_scene_writes_nothing(self, physsim, tmp_path: Path) -> None:
        said = physsim("run", "fall.yaml", "--set", "simulation.timestep=-1")
        assert said.code == 2
        assert "simulation.timestep" in said.err
        assert [path.name for path in tmp_path.iterdir()] == ["fall.yaml"]

    def test_a_missing_scene_and_a_missing_folder_are_file_trouble(self, physsim) -> None:
        assert physsim("run", "nope.yaml").code == 3
        assert physsim("run", "fall.yaml", "-o", "nowhere/a.h5").code == 3

    def test_json_is_one_document(self, physsim, tmp_path: Path) -> None:
        document = json.loads(physsim("run", "fall.yaml", "--json").out)
        assert (document["command"], document["exit_code"], document["status"]) == ("run", 0, "complete")
        assert (document["frames"], document["steps"], document["file"]) == (21, 200, "fall.h5")
        assert document["simulated_time"] == pytest.approx(0.2, rel=1e-12)
        assert document["wall_time"] > 0
        (expectation,) = document["expectations"]
        assert expectation["held"] is True
        assert expectation["got"] == pytest.approx(0.8038, abs=1e-3)
        assert document["problems"] == []

    def test_json_also_when_it_goes_wrong(self, physsim) -> None:
        broken = physsim("run", "fall.yaml", "--json", "--set", "bodies.ball.mas=1")
        document = json.loads(broken.out)
        assert (broken.code, document["exit_code"], broken.err) == (2, 2, "")
        assert document["problems"][0]["path"] == "bodies.ball.mas"
        assert physsim("run", "fall.yaml", "--quiet").code == 0
        again = physsim("run", "fall.yaml", "--json")
        assert (again.code, json.loads(again.out)["exit_code"]) == (3, 3)
        assert "exists" in json.loads(again.out)["error"]

    def test_duration_wins_over_the_scene_and_is_checked(self, physsim, tmp_path: Path) -> None:
        assert physsim("run", "fall.yaml", "--duration", "400 ms").code == 0
        with open_trajectory(tmp_path / "fall.h5") as trajectory:
            assert trajectory.time[-1] == pytest.approx(0.4, rel=1e-12)
        said = physsim("run", "fall.yaml", "--duration", "5 kg")
        assert said.code == 2
        assert "simulation.duration" in said.err

    def test_resume_goes_on_to_the_same_bits(self, physsim, tmp_path: Path) -> None:
        assert physsim("run", "fall.yaml", "--quiet", "--duration", "400 ms", "-o", "through.h5").code == 0
        assert physsim("run", "fall.yaml", "--quiet").code == 0
        assert physsim("run", "fall.yaml", "--quiet", "--resume", "--duration", "400 ms").code == 0
        with open_trajectory("through.h5") as through, open_trajectory("fall.h5") as resumed:
            for name in ("time", "position", "orientation", "velocity", "angular_velocity"):
                assert through.series(name)[:].tobytes() == resumed.series(name)[:].tobytes()

    def test_warnings_are_shown_and_counted(self, physsim) -> None:
        said = physsim(
            "run", "fall.yaml", "--set", "simulation.timestep=50 ms", "--set", "bodies.ball.velocity[0]=9"
        )
        assert "warning: bodies.ball: moves" in said.err
        assert "1 warning, see above" in said.out


def run_and_signal(folder: Path, number: signal.Signals, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Start a run that would take minutes, send a signal once its file is there, and wait for its end."""
    scene = folder / "long.yaml"
    scene.write_text(FALL.replace("duration: 200 ms", "duration: 1000 h").partition("expect:")[0])
    command = [*PHYSSIM, "run", "long.yaml", "--set", "record.every=1 s", *arguments]
    with running(command, folder) as child:
        deadline = time.monotonic() + 60
        while not (folder / "long.h5").exists() and time.monotonic() < deadline and child.poll() is None:
            time.sleep(0.02)
        child.send_signal(number)
        out, err = child.communicate(timeout=60)
    return subprocess.CompletedProcess(child.args, child.returncode, out, err)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_run_is_exit_130_keeps_its_file_and_says_how_to_go_on(
    tmp_path: Path, number: signal.Signals
) -> None:
    done = run_and_signal(tmp_path, number)
    assert done.returncode == 130
    assert "Traceback" not in done.stderr
    assert "--resume" in done.stderr
    with open_trajectory(tmp_path / "long.h5") as trajectory:
        assert trajectory.status == "interrupted"
        assert trajectory.frames >= 1


def test_an_interrupted_run_answers_with_its_document(tmp_path: Path) -> None:
    done = run_and_signal(tmp_path, signal.SIGINT, "--json")
    document = json.loads(done.stdout)
    assert (done.returncode, document["exit_code"], document["file"]) == (130, 130, "long.h5")


def test_the_bar_is_drawn_on_a_terminal_and_leaves_stdout_alone(fall: Path) -> None:
    out, seen = on_a_terminal(["run", "fall.yaml", "--duration", "40 s"], fall.parent)
    assert out.startswith("fall.h5: complete")
    assert ESCAPE not in out
    assert "A ball falls freely" in seen
    assert "real time" in seen
    assert ESCAPE in seen


def test_a_full_disk_is_exit_3_and_what_was_written_can_be_read(fall: Path) -> None:
    """A limit on the file's size stands in for a full disk; h5py cannot even close its file after either."""
    command = (
        f"ulimit -f 400; {shlex.join(PHYSSIM)} run fall.yaml --duration '200 s' --set record.every='1 ms'"
    )
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=fall.parent,
        env=clean_environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 3
    assert done.stderr.splitlines()[-1].startswith("physsim: fall.h5: ")
    assert "Traceback" not in done.stderr
    with open_trajectory(fall.with_suffix(".h5")) as trajectory:
        assert trajectory.frames > 100
        assert trajectory.status == "interrupted"
