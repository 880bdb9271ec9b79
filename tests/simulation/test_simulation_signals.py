"""Ctrl-C and SIGTERM: the file is kept, marked, and readable."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import physsim

RUN = """
import sys
import physsim
from physsim.simulation import Interrupted
try:
    physsim.run(sys.argv[1], output=sys.argv[2], progress=lambda p: print(p.time, flush=True))
except Interrupted as error:
    print(error)
    sys.exit(error.exit_code)
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("every", ["10 ms", "1000 s"], ids=["many frames", "one endless frame"])
def test_a_signal_ends_the_run_in_good_order(
    scene: Callable[..., Path], tmp_path: Path, number: signal.Signals, every: str
) -> None:
    path = scene(("600 ms", "1000 s"), ("every: 10 ms", f"every: {every}"))
    output = tmp_path / "run.h5"
    command = [sys.executable, "-c", RUN, str(path), str(output)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for _ in range(3):
            process.stdout.readline()
        process.send_signal(number)
        said, complaints = process.communicate(timeout=20)
    assert (process.returncode, complaints) == (130, "")
    assert f"stopped by {number.name} at" in said.splitlines()[-1]
    assert "--resume goes on from there" in said.splitlines()[-1]
    with physsim.open_trajectory(output) as trajectory:
        assert trajectory.status == "interrupted"
        assert trajectory.status_detail.startswith(f"stopped by {number.name}")
        checkpoint = trajectory.checkpoint()
        assert checkpoint is not None
        assert checkpoint.step > 0
        assert checkpoint.frames == trajectory.frames
        assert trajectory.position.shape[0] == trajectory.frames
