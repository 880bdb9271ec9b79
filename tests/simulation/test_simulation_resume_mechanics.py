"""A run in pieces is the same run, bit for bit, whatever the scene is made of.

Joints with their warm starts and counted turns, springs, forces and motions with profiles, located impacts,
pairs that FCL answers; stopped between any two steps, or killed at any moment.
"""

from __future__ import annotations

import random
import subprocess
import sys
import time
from pathlib import Path

import pytest
from contents import differing
from stops import many_short_calls, stopping_at  # noqa: F401, the first is a fixture

import physsim
from physsim.simulation import Interrupted

INTEGRATORS = ("explicit_euler", "semi_implicit_euler", "verlet", "velocity_verlet", "leapfrog", "rk4")
HERE = Path(__file__).parent
CONTACTS, MACHINE = HERE / "resume_contacts.yaml", HERE / "resume_machine.yaml"


def in_pieces(scene: Path, output: Path, stops: tuple[int, ...], **changes: str) -> None:
    """Runs the scene, stopped and resumed at these steps."""
    for number, step in enumerate(stops):
        with pytest.raises(Interrupted):
            physsim.run(scene, set=changes, output=output, progress=stopping_at(step), resume=number > 0)
    physsim.run(scene, set=changes, output=output, resume=True).close()


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("impacts", ["stepped", "located"])
@pytest.mark.parametrize("scene", [CONTACTS, MACHINE], ids=["contacts", "machine"])
def test_interrupted_anywhere(tmp_path: Path, scene: Path, integrator: str, impacts: str) -> None:
    changes = {"simulation.integrator": integrator, "simulation.impacts": impacts}
    physsim.run(scene, set=changes, output=tmp_path / "through.h5").close()
    in_pieces(scene, tmp_path / "pieces.h5", (1, 64, 65, 111, 202), **changes)
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


@pytest.mark.parametrize("impacts", ["stepped", "located"])
def test_interrupted_where_fcl_answers_every_pair(tmp_path: Path, impacts: str) -> None:
    changes = {
        "simulation.collision": "fcl",
        "simulation.impacts": impacts,
        "simulation.duration": "150 ms",
    }
    physsim.run(CONTACTS, set=changes, output=tmp_path / "through.h5").close()
    in_pieces(CONTACTS, tmp_path / "pieces.h5", (1, 64, 111), **changes)
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


@pytest.mark.parametrize("scene", [CONTACTS, MACHINE], ids=["contacts", "machine"])
@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "rk4"])
def test_a_finished_run_goes_on_longer(tmp_path: Path, scene: Path, integrator: str) -> None:
    """Each end but the last falls between two frames: that frame must be gone afterwards."""
    changes = {"simulation.integrator": integrator, "simulation.impacts": "located"}
    physsim.run(scene, set=changes, output=tmp_path / "through.h5").close()
    for duration in ("33 ms", "101 ms", "254 ms", "300 ms"):
        physsim.run(scene, set=changes, output=tmp_path / "pieces.h5", duration=duration, resume=True).close()
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


KILLED = """
import sys
import physsim
from physsim.recording import writer
writer.SECONDS_BETWEEN_CHECKPOINTS = 0.02
print("ready", flush=True)
physsim.run(sys.argv[1], output=sys.argv[2], duration=sys.argv[3], resume=True)
"""


@pytest.mark.parametrize(
    ("scene", "duration"), [(CONTACTS, "12 s"), (MACHINE, "8 s")], ids=["contacts", "machine"]
)
def test_killed_again_and_again(tmp_path: Path, scene: Path, duration: str) -> None:
    """kill -9 at random moments, whatever it is doing: loading, stepping, writing, saving."""
    output, moments = tmp_path / "killed.h5", random.Random(5)
    for _ in range(8):
        command = [sys.executable, "-c", KILLED, str(scene), str(output), duration]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            process.stdout.readline()
            time.sleep(0.2 + moments.random() * 0.8)
            process.kill()
    with physsim.run(scene, output=output, duration=duration, resume=True) as trajectory:
        assert trajectory.status == "complete"
    physsim.run(scene, output=tmp_path / "through.h5", duration=duration).close()
    assert differing(tmp_path / "through.h5", output) == []
