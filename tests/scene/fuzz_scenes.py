"""Coverage-guided fuzzing of the scene reader, for as long as one likes (needs `pip install physsim[fuzz]`).

    python tests/scene/fuzz_scenes.py -max_total_time=600

Bytes go the whole way of a scene file: decoding, YAML, overrides, validation, checks, messages. Anything but
a scene or an error in plain words stops the run, and libFuzzer writes the bytes that did it. Options are its
own.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["physsim.scene", "yaml"]):
    from physsim.errors import SceneError
    from physsim.scene import format_problems, load_scene_text
    from physsim.scene.source import decoded

HERE = Path(__file__).parent
SEPARATOR = b"\n--set "
SEED = HERE / "everything.yaml"


def one_input(data: bytes) -> None:
    """Load a scene, with what follows the separator as an override, and tell what is wrong with it."""
    scene, _, override = data.partition(SEPARATOR)
    try:
        text = decoded(scene, Path("fuzz.yaml"))
        overrides = [override.decode("utf-8", errors="replace")] if override else None
        load_scene_text(text, folder=HERE, overrides=overrides).resolved_yaml()
    except SceneError as error:
        if not format_problems(error.problems, error.file):
            raise AssertionError("refused without a reason") from error


def main() -> None:
    """Start from the scene beside this file, in a corpus that is thrown away."""
    with tempfile.TemporaryDirectory() as corpus:
        content = SEED.read_bytes()
        (Path(corpus) / SEED.name).write_bytes(content)
        (Path(corpus) / f"{SEED.name}.set").write_bytes(content + SEPARATOR + b"bodies.crate.mass=3 kg")
        atheris.Setup([*sys.argv, corpus], one_input)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
