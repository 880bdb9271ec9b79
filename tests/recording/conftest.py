"""A recorder fed with made-up frames: the trajectory room knows no engine."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from made_up_run import record


@pytest.fixture
def recorded(tmp_path: Path) -> Callable[..., Path]:
    """`recorded(frames=100, bodies=3)` writes a finished file and gives its path."""

    def make(name: str = "run.h5", **options: int) -> Path:
        return record(tmp_path / name, **options)

    return make
