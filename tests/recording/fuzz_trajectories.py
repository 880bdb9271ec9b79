"""Coverage-guided fuzzing of trajectory files, for as long as one likes (needs `pip install physsim[fuzz]`).

    python tests/recording/fuzz_trajectories.py -max_total_time=600

Bytes are opened as a trajectory and read through. Anything but data or an error in plain words stops the
run, and so does a crash or a hang of the HDF5 library.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["physsim.recording"]):
    import physsim
    from physsim.errors import PhyssimError
    from physsim.recording import open_trajectory
    from physsim.scene import load_scene_text

SCENE = """
physsim: 1
simulation: {duration: 30 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: steel}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 5 cm]}
"""


def read_through(path: Path) -> None:
    """Everything that a user may ask of a trajectory."""
    with open_trajectory(path) as trajectory:
        for name in ("position", "orientation", "velocity", "angular_velocity", "time", "step"):
            _ = getattr(trajectory, name)[:]
        for name in ("energy", "momentum", "solver", "events", "pairs", "provenance"):
            _ = getattr(trajectory, name)
        trajectory.contacts()
        trajectory.checkpoint()


def main() -> None:
    """Start from one short run, in a corpus that is thrown away."""
    with tempfile.TemporaryDirectory() as corpus, tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "fuzz.h5"

        def one_input(data: bytes) -> None:
            path.write_bytes(data)
            try:
                read_through(path)
            except PhyssimError as error:
                if not str(error):
                    raise AssertionError("refused without a reason") from error

        physsim.run(load_scene_text(SCENE), output=Path(corpus) / "run.h5").close()
        atheris.Setup([*sys.argv, corpus], one_input)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
