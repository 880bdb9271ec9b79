"""Every example of every manual page runs as it stands, in order, in a folder with my_scene.yaml."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from shell import clean_environment

from physsim.cli.app import VERBS, answer, group


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """my_scene.yaml, its trajectory but for `run` and `new`, and `physsim` and `python3` on the path."""
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, arguments in (("physsim", "-m physsim"), ("python3", "")):
        (programs / name).write_text(f'#!/bin/sh\nexec "{sys.executable}" {arguments} "$@"\n')
        (programs / name).chmod(0o755)
    monkeypatch.chdir(tmp_path)
    return tmp_path


FIT = """
physsim_fit: 1
scene: my_scene.yaml
set: {simulation.duration: 0.4 s}
parameters: {parameters.drop: {start: 40 cm, min: 10 cm, max: 1 m}}
data: [{file: measured.h5, quantities: {bodies.ball.position.z: {sigma: 1 mm}}}]
"""


@pytest.mark.parametrize("verb", VERBS)
def test_examples_of_the_manual_page(folder: Path, verb: str) -> None:
    if verb != "new":
        assert answer(["new", "my_scene"]) == 0
    if verb in {"view", "info", "diff", "plot", "export"}:
        assert answer(["run", "my_scene.yaml", "--quiet"]) == 0
    if verb == "fit":
        shorter = ["--set", "expect=[]", "--duration", "0.4 s"]
        assert answer(["run", "my_scene.yaml", "--quiet", *shorter, "-o", "measured.h5"]) == 0
        (folder / "my_fit.yaml").write_text(FIT)
    environment = clean_environment()
    environment["PATH"] = f"{folder / 'bin'}:{environment['PATH']}"
    for example in group.get_command(None, verb).examples:
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", example.command],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        assert done.returncode == 0, f"{example.command}\n{done.stdout}\n{done.stderr}"
        assert "Traceback" not in done.stderr


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_scripts_call_physsim(physsim, shell: str) -> None:
    said = physsim("completion", shell)
    assert said.code == 0
    assert f"_PHYSSIM_COMPLETE={shell}_complete" in said.out


def test_completion_knows_verbs_options_and_materials(folder: Path) -> None:
    def completed(*words: str) -> str:
        environment = clean_environment(
            _PHYSSIM_COMPLETE="bash_complete",
            COMP_WORDS=" ".join(["physsim", *words]),
            COMP_CWORD=str(len(words)),
        )
        done = subprocess.run(
            [sys.executable, "-m", "physsim"],
            env=environment,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
        assert done.stderr == ""
        return done.stdout

    assert "validate" in completed("val")
    assert "--resume" in completed("run", "--re")
    assert "greased_steel" in completed("materials", "grea")
    assert "file" in completed("run", "my")
