"""Pages say what is there: files exist, links lead somewhere, generated parts are fresh."""

from __future__ import annotations

import re
import struct
import subprocess
import sys
import tomllib
import zlib
from pathlib import Path

import numpy as np
import pytest
from pages import PAGES, REPOSITORY

TOP_LEVEL = ("physsim/", "engine/", "docs/", "tests/", "scenes/", "schemas/", "benchmarks/", ".ci/")
NAMED = re.compile(r"`((?:[\w.-]+/)+[\w.-]*|engine|schemas|scenes|tests|docs|physsim)`")
FALL = """
physsim: 1
simulation: {duration: 400 ms, timestep: 1 ms}
materials: {red: {color: "#e02020", density: 1000}}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: red, position: [0, 0, 1]}
"""
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


def test_architecture_names_files_that_exist() -> None:
    text = (REPOSITORY / "docs" / "architecture.md").read_text(encoding="utf-8")
    named = {name for name in NAMED.findall(text) if f"{name}/".startswith(TOP_LEVEL)}
    assert len(named) > 10
    assert [name for name in sorted(named) if not (REPOSITORY / name).exists()] == []


def test_architecture_knows_every_room() -> None:
    text = (REPOSITORY / "docs" / "architecture.md").read_text(encoding="utf-8")
    rooms = [
        path.name for path in (REPOSITORY / "physsim").iterdir() if path.is_dir() and any(path.glob("*.py"))
    ]
    assert [room for room in rooms if f"physsim/{room}" not in text] == []


def test_architecture_gives_a_reason_for_every_dependency() -> None:
    text = (
        (REPOSITORY / "docs" / "architecture.md").read_text(encoding="utf-8").partition("## Dependencies")[2]
    )
    python = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"][
        "dependencies"
    ]
    rust = tomllib.loads((REPOSITORY / "engine" / "Cargo.toml").read_text(encoding="utf-8"))["dependencies"]
    names = [re.split(r"[>=<\[ ]", requirement)[0] for requirement in python] + list(rust)
    assert [name for name in names if name not in text] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files(page) -> None:
    targets = [target for target in LINK.findall(page.read_text(encoding="utf-8")) if "://" not in target]
    assert [target for target in targets if not (page.parent / target).exists()] == []


def test_generated_parts_are_fresh() -> None:
    command = [sys.executable, str(REPOSITORY / "docs" / "generate.py"), "--check"]
    done = subprocess.run(command, cwd=REPOSITORY, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, f"{done.stdout}{done.stderr}\nrenew them: python docs/generate.py"


def test_readme_has_the_one_test_command_that_the_checks_run() -> None:
    script = (REPOSITORY / ".ci" / "run").read_text(encoding="utf-8")
    pattern = re.search(r"sed -n '(s/.*?/p)' README.md", script)
    assert pattern is not None
    done = subprocess.run(
        ["sed", "-n", pattern[1], "README.md"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    assert done.stdout.splitlines() == [
        "python3 -m venv .venv && .venv/bin/pip install -e '.[test]' && .venv/bin/python -m pytest -n 2"
    ]


def test_pictures_are_drawn_from_trajectories(desk: Path, environment: dict[str, str]) -> None:
    """Two frames of one ball: the sky is the same in both, and the ball is where it fell."""
    (desk / "fall.yaml").write_text(FALL)
    script = f"physsim run fall.yaml && python {REPOSITORY}/docs/draw.py fall.yaml fall.h5 fall.png 0 0.4"
    done = subprocess.run(
        ["bash", "-c", script],
        cwd=desk,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    width, height, pixels = read_png(desk / "fall.png")
    assert (width, height) == (2 * 420 + 6, 460)
    left, right = pixels[:, :420], pixels[:, 426:]
    assert (left[0] == right[0]).all()
    rows = [np.argwhere(panel[..., 0] > panel[..., 2] + 60)[:, 0].mean() for panel in (left, right)]
    assert rows[1] - rows[0] > 200


def read_png(path: Path) -> tuple[int, int, np.ndarray]:
    """Width, height and pixels (rows, columns, 3) of an 8-bit RGB image without filters."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = {}, 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        chunks[data[at + 4 : at + 8]] = data[at + 8 : at + 8 + length]
        at += 12 + length
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, 1 + 3 * width)
    assert not rows[:, 0].any()
    return width, height, rows[:, 1:].reshape(height, width, 3).astype(int)
