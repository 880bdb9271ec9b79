"""kill -9 at any moment: what was written before is there, to the last whole frame, and nothing else."""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import made_up_run
import numpy as np
import pytest

from physsim.errors import FileTrouble
from physsim.recording import Trajectory, open_trajectory

BODIES = 70
WRITER = f"""
import sys
sys.path.insert(0, {str(Path(made_up_run.__file__).parent)!r})
from pathlib import Path
import made_up_run
recorder = made_up_run.start(Path(sys.argv[1]), {BODIES})
for number in range(10**6):
    made_up_run.feed(recorder, number, {BODIES})
    if number % 5 == 0:
        recorder.write_checkpoint(b"state %d" % number, number)
    elif number % 3 == 0:
        recorder.write_block()
    recorder.settle()
    sys.stdout.write(f"{{recorder.frames}}\\n")
    sys.stdout.flush()
"""


@pytest.mark.parametrize("trial", range(5))
def test_every_acknowledged_frame_survives(tmp_path: Path, trial: int) -> None:
    """Blocks of odd sizes, so that chunks are stored anew all the time: the hardest case for the file."""
    path = tmp_path / "killed.h5"
    acknowledged = killed_after(path, 0.02 + random.Random(trial).random() * 0.5)
    with open_trajectory(path) as trajectory:
        assert trajectory.status == "running"
        assert not trajectory.being_written
        assert trajectory.frames >= acknowledged
        check_every_frame(trajectory)
        checkpoint = trajectory.checkpoint()
        assert checkpoint is not None
        assert checkpoint.frames <= trajectory.frames
        assert checkpoint.engine == b"state %d" % checkpoint.step


def killed_after(path: Path, seconds: float) -> int:
    """Frames that the writer said were on disk when it was killed, `seconds` after the first."""
    with subprocess.Popen(
        [sys.executable, "-c", WRITER, str(path)], stdout=subprocess.PIPE, text=True
    ) as writer:
        assert writer.stdout is not None
        acknowledged = int(writer.stdout.readline())
        time.sleep(seconds)
        writer.send_signal(signal.SIGKILL)
        for line in writer.stdout.read().splitlines()[:-1]:
            acknowledged = int(line)
    return acknowledged


def check_every_frame(trajectory: Trajectory) -> None:
    frames = trajectory.frames
    wanted = np.array([made_up_run.frame(k, BODIES)["position"] for k in range(frames)])
    np.testing.assert_array_equal(trajectory.position[:], wanted)
    np.testing.assert_array_equal(trajectory.angular_velocity[:], -wanted)
    np.testing.assert_array_equal(trajectory.step, np.arange(frames) * made_up_run.STEPS_PER_FRAME)
    np.testing.assert_array_equal(trajectory.energy.residual, np.arange(frames))
    np.testing.assert_array_equal(
        trajectory.contacts().frame, np.repeat(np.arange(frames), np.arange(frames) % 3)
    )
    np.testing.assert_array_equal(trajectory.contacts().force[:, 1], trajectory.contacts().frame)
    assert trajectory.events.rows == frames // 4


def test_an_old_file_survives_a_killed_run_that_was_to_replace_it(tmp_path: Path) -> None:
    path = made_up_run.record(tmp_path / "old.h5", frames=12, bodies=BODIES)
    before = path.read_bytes()
    killed_after(path, 0.1)
    assert path.read_bytes() == before
    with open_trajectory(path.with_name("old.h5.part")) as trajectory:
        assert trajectory.frames > 0
        check_every_frame(trajectory)


def test_a_killed_file_can_be_continued(tmp_path: Path) -> None:
    path = tmp_path / "killed.h5"
    killed_after(path, 0.2)
    with open_trajectory(path) as trajectory:
        frames = min(trajectory.frames, 20)
        events = frames // 4
    recorder = made_up_run.Recorder.resume(
        path, made_up_run.Target(path), made_up_run.COLUMNS, frames, events
    )
    for number in range(frames, 90):
        made_up_run.feed(recorder, number, BODIES)
    recorder.finish("complete", "", b"end", 0, {})
    with open_trajectory(path) as trajectory:
        assert (trajectory.frames, trajectory.status) == (90, "complete")
        check_every_frame(trajectory)


def test_a_file_that_is_being_written_is_not_continued(tmp_path: Path) -> None:
    path = tmp_path / "busy.h5"
    recorder = made_up_run.start(path, BODIES)
    made_up_run.feed(recorder, 0, BODIES)
    recorder.write_block()
    recorder.settle()
    with pytest.raises(FileTrouble, match="another run is writing"):
        made_up_run.Recorder.resume(path, made_up_run.Target(path), made_up_run.COLUMNS, 1, 0)
    recorder.finish("complete", "", None, 0, {})
