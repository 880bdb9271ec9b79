"""`physsim validate`: all files, all mistakes, the promised exit codes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from shell import clean_environment

GOOD = """
physsim: 1
title: A ball above a floor
simulation: {duration: 100 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 10 cm]}
"""
BROKEN = """
physsim: 1
simulation: {duration: 1 s, timestep: 1 ms}
bodies:
  ball:
    shape: {type: spere, radius: 5 cm}
    mass: -1
    positon: [0, 0, 1]
"""


@pytest.fixture
def scenes(tmp_path: Path) -> Path:
    (tmp_path / "good.yaml").write_text(GOOD)
    (tmp_path / "broken.yaml").write_text(BROKEN)
    (tmp_path / "deep.yaml").write_text(GOOD.replace("10 cm", "3 cm"))
    return tmp_path


@pytest.mark.usefixtures("scenes")
class TestValidate:
    def test_a_valid_scene_is_one_line_on_stdout(self, physsim) -> None:
        said = physsim("validate", "good.yaml")
        assert (said.code, said.out, said.err) == (0, "good.yaml: valid (2 bodies)\n", "")

    def test_every_mistake_is_told_at_once_with_line_and_column(self, physsim) -> None:
        said = physsim("validate", "broken.yaml")
        assert said.code == 2
        assert said.out == ""
        for place in (
            "broken.yaml:6:19: bodies.ball.shape.type: ",
            "broken.yaml:7:11: bodies.ball.mass: must be greater than 0, got -1",
            "broken.yaml:8:5: bodies.ball.positon: unknown key; did you mean 'position'?",
        ):
            assert place in said.err
        assert said.err.count("^") == 3

    def test_one_bad_file_does_not_stop_the_next(self, physsim) -> None:
        said = physsim("validate", "broken.yaml", "good.yaml")
        assert said.code == 2
        assert "good.yaml: valid" in said.out
        assert "broken.yaml:6:19" in said.err

    @pytest.mark.parametrize(
        ("files", "code"), [(["nope.yaml"], 3), (["broken.yaml", "nope.yaml", "good.yaml"], 3)]
    )
    def test_the_exit_code_is_the_highest(self, physsim, files: list[str], code: int) -> None:
        said = physsim("validate", *files)
        assert said.code == code
        assert "nope.yaml" in said.err
        assert "Traceback" not in said.err

    def test_warnings_do_not_make_a_scene_invalid(self, physsim) -> None:
        said = physsim("validate", "deep.yaml")
        assert (said.code, said.out) == (0, "deep.yaml: valid (2 bodies, 1 warning)\n")
        assert "warning: bodies.ball: overlaps floor by 0.02 m at the start" in said.err

    def test_json_holds_every_problem_of_every_file(self, physsim) -> None:
        said = physsim("validate", "broken.yaml", "good.yaml", "deep.yaml", "nope.yaml", "--json")
        document = json.loads(said.out)
        broken, good, deep, missing = document["scenes"]
        assert said.err == ""
        assert (said.code, document["exit_code"], document["command"]) == (3, 3, "validate")
        assert [(p["line"], p["column"], p["path"]) for p in broken["problems"]] == [
            (6, 19, "bodies.ball.shape.type"),
            (7, 11, "bodies.ball.mass"),
            (8, 5, "bodies.ball.positon"),
        ]
        assert (good["valid"], good["title"], good["bodies"]) == (True, "A ball above a floor", 2)
        assert (deep["valid"], deep["problems"][0]["severity"]) == (True, "warning")
        assert not missing["valid"]
        assert "nope.yaml" in missing["error"]

    def test_overrides_are_checked_like_the_file(self, physsim) -> None:
        assert physsim("validate", "good.yaml", "--set", "bodies.ball.mass=2 kg").code == 0
        said = physsim("validate", "good.yaml", "--set", "bodies.ball.mass=-2 kg")
        assert said.code == 2
        assert "bodies.ball.mass=-2 kg" in said.err

    def test_a_scene_without_meshes_imports_no_mesh_library(self, scenes: Path) -> None:
        script = (
            "import sys\n"
            "from physsim.cli.app import answer\n"
            "code = answer(['validate', 'good.yaml'])\n"
            "print(code, *sorted({'trimesh', 'fcl', 'scipy', 'rich'} & set(sys.modules)))\n"
        )
        done = subprocess.run(
            [sys.executable, "-c", script],
            cwd=scenes,
            env=clean_environment(),
            capture_output=True,
            text=True,
            timeout=60,
            check=True,
        )
        assert done.stdout.splitlines()[-1] == "0"
