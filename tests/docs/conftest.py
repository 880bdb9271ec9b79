"""A folder in which the commands of a page are run as a reader would, beside `scenes/` and `examples/`."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
SHIM = """#!/bin/sh
exec "{python}" {arguments} "$@"
"""


@pytest.fixture
def desk(tmp_path: Path) -> Path:
    """The folder; what one block of a page writes is there for the next."""
    for folder in ("scenes", "examples"):
        (tmp_path / folder).symlink_to(REPOSITORY / folder)
    programs = tmp_path / ".venv" / "bin"
    programs.mkdir(parents=True)
    for name, arguments in (("physsim", "-m physsim"), ("python", ""), ("python3", "")):
        shim = programs / name
        shim.write_text(SHIM.format(python=sys.executable, arguments=arguments))
        shim.chmod(0o755)
    return tmp_path


@pytest.fixture
def environment(desk: Path) -> dict[str, str]:
    """The environment of a reader who has activated the virtual environment."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if name not in ("NO_COLOR", "FORCE_COLOR", "PHYSSIM_DEBUG")
    }
    search = os.pathsep.join([str(desk / ".venv" / "bin"), os.environ.get("PATH", "")])
    return kept | {"PATH": search, "PYTHONPATH": str(REPOSITORY)}
