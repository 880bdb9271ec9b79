"""Every script in `examples/` runs in its quick form, and what it prints is what physics says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
EXAMPLES = REPOSITORY / "examples"


def printed(name: str, folder: Path, *more: str) -> list[list[str]]:
    """The words of every line that the quick form prints, without its head."""
    done = subprocess.run(
        [sys.executable, "-W", "error", str(EXAMPLES / name), "--quick", *more],
        cwd=folder,
        env={"PYTHONPATH": str(REPOSITORY), "PATH": ""},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return [re.split(r"\s{2,}|±|to", line.strip()) for line in done.stdout.splitlines()[1:]]


def test_restitution(tmp_path: Path) -> None:
    """All three ways agree with what is declared; heights are cut by frames 2 ms apart."""
    rows = printed("restitution_from_a_bounce.py", tmp_path)
    assert len(rows) == 7
    for name, declared, speeds, _, heights, *times in rows:
        if name != "clay_ball":
            assert float(speeds) == pytest.approx(float(declared), abs=1e-4)
            assert float(heights) == pytest.approx(float(declared), abs=3e-3)  # measured 1.6e-3
        if times[-2:-1] and name in {"rubber_ball", "golf_ball"}:
            assert float(times[-2]) == pytest.approx(float(declared), abs=1e-4)


def test_angle_of_repose(tmp_path: Path) -> None:
    """To one degree, for two materials and two masses."""
    rows = printed("friction_angle_of_repose.py", tmp_path)
    assert len(rows) == 3
    for row in rows:
        wanted, found = (float(re.sub(r"[ °]", "", cell)) for cell in row[-2:])
        assert abs(wanted - found) < 1


def test_pendulum(tmp_path: Path) -> None:
    rows = printed("pendulum_period.py", tmp_path, "-o", "period.png")
    assert (tmp_path / "period.png").read_bytes().startswith(b"\x89PNG")
    assert max(abs(float(row[-1])) for row in rows[:3]) < 1e-8  # measured 3.3e-10


def test_dice(tmp_path: Path) -> None:
    """60 throws, each face with bounds around its share; a seed makes it the same ones every time."""
    rows = printed("dice_monte_carlo.py", tmp_path)
    assert sum(int(row[1]) for row in rows[:6]) == 60
    for row in rows[:6]:
        low, high = float(row[2]), float(row[3])
        assert low < int(row[1]) / 60 < high
    assert [row[1] for row in rows[:6]] == [row[1] for row in printed("dice_monte_carlo.py", tmp_path)[:6]]


def test_dominoes(tmp_path: Path) -> None:
    """The wave runs at some 0.9 m/s, and hardly depends on the gap near the one that the scene has."""
    (row,) = printed("domino_sensitivity.py", tmp_path)
    speeds = [float(cell.removesuffix(" m/s").split()[0]) for cell in row[1:3]]
    assert all(0.5 < speed < 1.5 for speed in speeds)
    assert abs(float(row[-1])) < 0.5


def test_all_examples_are_tried() -> None:
    text = Path(__file__).read_text(encoding="utf-8")
    assert [path.name for path in EXAMPLES.glob("*.py") if f'"{path.name}"' not in text] == []
