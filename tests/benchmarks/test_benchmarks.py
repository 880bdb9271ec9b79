"""The commands that docs/performance.md names run, in a quick form. What they measure is asserted nowhere."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
NAMED = re.compile(r"python -m (benchmarks[\w.]*)")


def said(module: str, *arguments: str) -> str:
    """What a command prints."""
    done = subprocess.run(
        [sys.executable, "-m", module, *arguments],
        cwd=REPOSITORY,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def cells(text: str) -> list[list[str]]:
    """Lines of the tables in Markdown, their rules left out."""
    lines = [line for line in text.splitlines() if line.startswith("|") and not line.startswith("|-")]
    table = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [row for row in table if row[0] != "---"]


def row(peer: str, number: int, **more: Any) -> dict[str, Any]:
    """A measured cell as it is stored."""
    common = {"round": number, "peer": peer, "setting": "default", "threads": 1, "batch": False}
    return common | {"scene": "spheres1000", "version": "1.0"} | more


STORED = {
    "machine": {"processor": "some", "processors": "2"},
    "rows": [
        row("physsim", 0, busy=4e-3, rest=2e-3, depth_rest=3e-6),
        row("physsim", 1, busy=6e-3, rest=2e-3, depth_rest=3e-6),
        row("physsim", 1, busy=1e-3, rest=1e-3, depth_rest=2e-4, setting="sweeps4"),
        row("other", 0, busy=2e-3, rest=4e-3, depth_rest=1e-3),
        row("other", 1, busy=2e-3, rest=4e-3, depth_rest=1e-3),
        row("slow", 0, busy=8e-3, rest=None, last=9e-3, reached=1.5, depth_rest=1e-2),
        row("absent", 0, unable="not installed"),
        row("physsim", 0, scene="small", batch=True, world_steps=64_000.0),
    ],
}


@pytest.fixture
def stored(tmp_path: Path) -> Path:
    path = tmp_path / "rows.json"
    path.write_text(json.dumps(STORED))
    return path


def test_what_the_pages_name_is_there() -> None:
    pages = [REPOSITORY / "README.md", REPOSITORY / "CONTRIBUTING.md", *(REPOSITORY / "docs").glob("*.md")]
    named = {name for page in pages for name in NAMED.findall(page.read_text(encoding="utf-8"))}
    assert {
        "benchmarks",
        "benchmarks.scaling",
        "benchmarks.threads",
        "benchmarks.recording",
        "benchmarks.instructions",
    } <= named
    for module in sorted(named):
        assert said(module, "--help").startswith(f"usage: python -m {module}")


class TestStoredRows:
    def test_as_tables(self, stored: Path) -> None:
        text = said("benchmarks", "--table", str(stored))
        assert text.splitlines()[:2] == [
            "processor: some; processors: 2",
            "versions: physsim 1.0, other 1.0, slow 1.0, absent 1.0",
        ]
        assert cells(text) == [
            ["engine", "busy ms", "rest ms", "physsim / it: busy", "rest", "depth mm"],
            ["physsim", "5", "2", "", "", "0.003"],
            ["physsim:sweeps4", "1", "1", "", "", "0.2"],
            ["other", "2", "4", "2.50 (2.00 - 3.00)", "0.50 (0.50 - 0.50)", "1"],
            ["slow", "8", "> 9 (cut off at 1.5 s)", "0.50", "", "10"],
            ["absent", "not installed"],
            ["engine", "world-steps/s"],
            ["physsim", "64000"],
        ]

    def test_as_a_picture(self, stored: Path, tmp_path: Path) -> None:
        pytest.importorskip("matplotlib")
        said("benchmarks", "--table", str(stored), "--picture", str(tmp_path / "plot.svg"))
        assert "<svg" in (tmp_path / "plot.svg").read_text()


def test_physsim_alone(tmp_path: Path) -> None:
    """A body that flies, and worlds one after the other."""
    rows = tmp_path / "rows.json"
    arguments = ["--peers", "physsim", "--scenes", "free1,small", "--limit", "1", "--json", str(rows)]
    text = said("benchmarks", *arguments)
    assert [line[0] for line in cells(text)] == ["engine", "physsim", "engine", "physsim"]
    flight, batch = json.loads(rows.read_text())["rows"]
    assert flight["energy_error"] < 1e-3
    assert batch["worlds"] >= 1
    assert said("benchmarks", "--table", str(rows)) == text


def test_growth(tmp_path: Path) -> None:
    lines = tmp_path / "lines.json"
    said("benchmarks.scaling", "--scenes", "free", "--counts", "10", "--json", str(lines))
    (line,) = json.loads(lines.read_text())
    assert (line["scene"], line["bodies"], line["contacts"]) == ("free", 10, 0)


def test_recording() -> None:
    heads, line = cells(
        said("benchmarks.recording", "--scenes", "small", "--duration", "0.1", "--rounds", "1")
    )
    assert heads[:3] == ["scene", "on the wall", "processor"]
    assert (len(line), line[0]) == (len(heads), "small")


def test_threads_have_the_same_bits() -> None:
    """The command fails where they differ."""
    heads, line = cells(said("benchmarks.threads", "--scenes", "small"))
    assert heads == ["scene", "1 thread [ms a step]", "2 threads [ms a step]", "gain of 2 (quartiles)"]
    assert line[0] == "small"
