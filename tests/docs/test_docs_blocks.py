"""Every command, program and scene of README and docs is tried out, page by page and in order."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from pages import PAGES, Block, blocks, without_installation

from physsim.scene import load_scene

SCENE_AROUND = """
physsim: 1
simulation: {duration: 1 s, timestep: 1 ms}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1]}
"""


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_blocks_of_a_page(page: Path, desk: Path, environment: dict[str, str]) -> None:
    for block in blocks(page):
        where = f"{page.name}:{block.line}"
        if block.language == "console":
            try_console(block, where, desk, environment)
        elif block.language == "bash":
            run(["bash", "-n", "-c", block.text], where, desk, environment)
        elif block.language == "python":
            run([sys.executable, "-W", "error", "-c", block.text], where, desk, environment)
        elif block.language == "yaml":
            try_yaml(block, desk)
        else:
            assert block.language in {"text", "toml", "rust"}, (
                f"{where}: nobody tries out ```{block.language}"
            )


def try_console(block: Block, where: str, desk: Path, environment: dict[str, str]) -> None:
    assert block.commands, f"{where}: no line begins with '$ '"
    for number, (command, shown) in enumerate(block.commands, start=1):
        run(["bash", "-n", "-c", command], where, desk, environment)
        offline = without_installation(command)
        if offline is not None and "pytest" not in offline:
            expected = block.exit_code if number == len(block.commands) else 0
            said = run(["bash", "-c", offline], f"{where}: {offline}", desk, environment, expected)
            assert not shown or said.strip("\n") == shown, f"{where}: {offline}\n{said}"


def try_yaml(block: Block, desk: Path) -> None:
    """A scene, or part of one in a scene made up around it; named blocks are judged by the commands below."""
    if block.name is not None:
        (desk / block.name).write_text(block.text)
        return
    part = yaml.safe_load(block.text)
    whole = part if "physsim" in part else yaml.safe_load(SCENE_AROUND) | part
    trial = desk / "part_of_a_page.yaml"
    trial.write_text(yaml.safe_dump(whole, sort_keys=False))
    load_scene(trial)


def run(command: list[str], where: str, desk: Path, environment: dict[str, str], expected: int = 0) -> str:
    """What the command writes to either stream; fails when it does not exit as expected."""
    done = subprocess.run(
        command,
        cwd=desk,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == expected, f"{where}\nexit {done.returncode}\n{done.stdout}"
    return done.stdout
