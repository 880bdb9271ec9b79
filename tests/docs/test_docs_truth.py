"""Pages say what is there: files exist, links lead somewhere, generated parts are fresh."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib

import pytest
from pages import PAGES, REPOSITORY

TOP_LEVEL = ("physsim/", "engine/", "docs/", "tests/", "scenes/", "schemas/", "benchmarks/", ".ci/")
NAMED = re.compile(r"`((?:[\w.-]+/)+[\w.-]*|engine|schemas|scenes|tests|docs|physsim)`")
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
