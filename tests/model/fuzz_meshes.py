"""Coverage-guided fuzzing of mesh files, for as long as one likes (needs `pip install physsim[fuzz]`).

    python tests/model/fuzz_meshes.py -max_total_time=600

The first byte chooses the format, the rest is the file of a body that is compiled as solid, shell or hull.
Anything but a model or an error in plain words stops the run.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["physsim.model", "trimesh.exchange"]):
    from physsim.errors import PhyssimError
    from physsim.model import compile_scene
    from physsim.scene import load_scene_text

MESHES = Path(__file__).parents[2] / "scenes" / "meshes"
SUFFIXES = (".obj", ".stl", ".ply", ".off")
SCENE = """
physsim: 1
simulation: {{duration: 1 s, timestep: 1 ms}}
bodies:
  part:
    shape: {{type: mesh, file: fuzz{suffix}, collision: hull, inertia: {inertia}}}
    mass: 1 kg
    material: steel
"""


def main() -> None:
    """Start from the meshes of the scenes, in a corpus that is thrown away."""
    with tempfile.TemporaryDirectory() as corpus, tempfile.TemporaryDirectory() as folder:

        def one_input(data: bytes) -> None:
            choice = data[0] if data else 0
            suffix, inertia = SUFFIXES[choice % 4], ("solid", "shell", "hull")[choice // 4 % 3]
            (Path(folder) / f"fuzz{suffix}").write_bytes(data[1:])
            try:
                text = SCENE.format(suffix=suffix, inertia=inertia)
                compile_scene(load_scene_text(text, folder=Path(folder)))
            except PhyssimError as error:
                if not str(error):
                    raise AssertionError("refused without a reason") from error

        for mesh in MESHES.iterdir():
            if mesh.suffix in SUFFIXES:
                seed = bytes([SUFFIXES.index(mesh.suffix)]) + mesh.read_bytes()
                (Path(corpus) / mesh.name).write_bytes(seed)
        atheris.Setup([*sys.argv, corpus], one_input)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
