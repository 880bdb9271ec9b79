"""A run in pieces is the same run, bit for bit."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from contents import differing
from stops import many_short_calls, stopping_at  # noqa: F401, the first is a fixture

import physsim
from physsim.errors import FileTrouble
from physsim.simulation import Interrupted, Progress
from physsim.simulation.resume import differences

Scene = Callable[..., Path]
FCL = (("duration: 600 ms", "duration: 200 ms, collision: fcl"),)


def interrupted(path: Path, output: Path, step: int, resume: bool = False) -> None:
    with pytest.raises(Interrupted):
        physsim.run(path, output=output, progress=stopping_at(step), resume=resume)


@pytest.mark.parametrize("changes", [(), FCL], ids=["own kernels", "fcl"])
@pytest.mark.parametrize("steps", [(57,), (3, 100, 101, 153)])
def test_interrupted_in_the_middle_of_frames(
    scene: Scene, tmp_path: Path, steps: tuple[int, ...], changes: tuple[tuple[str, str], ...]
) -> None:
    path = scene(*changes)
    physsim.run(path, output=tmp_path / "through.h5").close()
    for number, step in enumerate(steps):
        interrupted(path, tmp_path / "pieces.h5", step, resume=number > 0)
    physsim.run(path, output=tmp_path / "pieces.h5", resume=True).close()
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


def test_a_complete_run_goes_on_longer(scene: Scene, tmp_path: Path) -> None:
    """The shorter one ends at 205 ms, between two frames: that frame must be gone afterwards."""
    path = scene()
    physsim.run(path, output=tmp_path / "through.h5").close()
    with physsim.run(path, output=tmp_path / "pieces.h5", duration="205 ms") as shorter:
        assert shorter.step[-2:].tolist() == [200, 205]
    physsim.run(path, output=tmp_path / "pieces.h5", resume=True).close()
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


def test_a_complete_run_has_nothing_left_to_do(scene: Scene, tmp_path: Path) -> None:
    path, output = scene(), tmp_path / "run.h5"
    physsim.run(path, output=output).close()
    before = output.read_bytes()
    with physsim.run(path, output=output, resume=True) as trajectory:
        assert trajectory.status == "complete"
    assert output.read_bytes() == before


def test_nothing_to_resume_starts_anew(scene: Scene, tmp_path: Path) -> None:
    path = scene()
    physsim.run(path, output=tmp_path / "through.h5").close()
    physsim.run(path, output=tmp_path / "anew.h5", resume=True).close()
    assert differing(tmp_path / "through.h5", tmp_path / "anew.h5") == []


def test_a_file_of_another_kind_is_not_overwritten(scene: Scene, tmp_path: Path) -> None:
    output = tmp_path / "notes.h5"
    output.write_text("not a trajectory")
    with pytest.raises(FileTrouble, match="exists already"):
        physsim.run(scene(), output=output, resume=True)
    assert output.read_text() == "not a trajectory"


def test_a_shorter_duration_is_refused(scene: Scene, tmp_path: Path) -> None:
    physsim.run(scene(), output=tmp_path / "run.h5").close()
    with pytest.raises(FileTrouble, match=r"holds 0.6 s already, more than the 0.2 s asked for"):
        physsim.run(scene(), output=tmp_path / "run.h5", duration=0.2, resume=True)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (
            ("[0, 0, 30 cm]", "[0, 0, 31 cm]"),
            r"bodies.ball.position\[2\]: 0.3 in the file, 0.31 in",
        ),
        (("timestep: 1 ms", "timestep: 2 ms"), r"simulation.timestep: 0.001 in the file, 0.002 in the scene"),
        (("  ball:", "  marble:"), r"bodies.ball: .* in the file, nothing in the scene"),
    ],
)
def test_another_scene_is_refused(scene: Scene, tmp_path: Path, change: tuple[str, str], told: str) -> None:
    physsim.run(scene(), output=tmp_path / "run.h5", duration="50 ms").close()
    before = (tmp_path / "run.h5").read_bytes()
    with pytest.raises(FileTrouble, match=f"cannot be resumed, it is another run: {told}"):
        physsim.run(scene(change), output=tmp_path / "run.h5", resume=True)
    assert (tmp_path / "run.h5").read_bytes() == before


def test_duration_and_expectations_may_differ(scene: Scene, tmp_path: Path) -> None:
    physsim.run(scene(), output=tmp_path / "run.h5", duration="50 ms").close()
    expect = ("record:", "expect: [{quantity: time, min: 0}]\nrecord:")
    with physsim.run(scene(expect), output=tmp_path / "run.h5", duration="60 ms", resume=True) as trajectory:
        assert trajectory.time[-1] == 0.06


def test_differences_have_paths() -> None:
    before = {"a": [1, {"b": 2}], "c": 3, "simulation": {"duration": 1.0}}
    after = {"a": [1, {"b": 4}], "d": 5, "simulation": {"duration": 2.0}}
    assert list(differences(before, after)) == [
        "a[1].b: 2 in the file, 4 in the scene",
        "c: 3 in the file, nothing in the scene",
        "d: nothing in the file, 5 in the scene",
    ]


KILLED = """
import sys
import physsim
physsim.run(sys.argv[1], output=sys.argv[2], force=True, progress=lambda p: print(p.step, flush=True))
"""


def killed(path: Path, output: Path) -> None:
    """Runs in a process of its own, killed a moment after the run has begun."""
    command = [sys.executable, "-c", KILLED, str(path), str(output)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(0.2)
        process.kill()


LONG = (("duration: 600 ms", "duration: 1000 s"),)


def test_after_a_kill(scene: Scene, tmp_path: Path) -> None:
    output = tmp_path / "killed.h5"
    killed(scene(*LONG), output)
    with physsim.open_trajectory(output) as trajectory:
        assert trajectory.status == "running"
        assert trajectory.frames > 0
    checked = scene(("600 ms", "1 s"), name="short.yaml")
    physsim.run(checked, output=output, resume=True).close()
    physsim.run(checked, output=tmp_path / "through.h5").close()
    assert differing(tmp_path / "through.h5", output) == []


def test_a_long_frame_is_saved_in_between(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One frame in the whole run: there are checkpoints all the same, here as often as can be."""
    monkeypatch.setattr("physsim.recording.recorder.SECONDS_BETWEEN_CHECKPOINTS", 0.0)
    steps = []

    def look(progress: Progress) -> None:
        with physsim.open_trajectory(tmp_path / "run.h5") as trajectory:
            checkpoint = trajectory.checkpoint()
            assert checkpoint is not None
            steps.append(checkpoint.step)

    once = (("every: 10 ms", "every: 600 ms"), ("600 ms, timestep: 1 ms", "600 ms, timestep: 20 ms"))
    physsim.run(scene(*once), output=tmp_path / "run.h5", progress=look).close()
    assert len(set(steps)) > 5


def test_after_a_kill_while_replacing_an_old_file(scene: Scene, tmp_path: Path) -> None:
    output = tmp_path / "old.h5"
    physsim.run(scene(), output=output, duration="30 ms").close()
    before = output.read_bytes()
    killed(scene(*LONG), output)
    assert output.read_bytes() == before
    with physsim.run(scene(("600 ms", "1 s")), output=output, resume=True) as trajectory:
        assert (trajectory.path, trajectory.status) == (output, "complete")
        assert trajectory.time[-1] == 1.0
    assert not (tmp_path / "old.h5.part").exists()
