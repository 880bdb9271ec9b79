"""Sweeps as files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from small_sweeps import DROP, GRID, METRICS

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """`write(grid={...})` writes drop.yaml and a sweep of it, and gives the path of the sweep."""

    def make(name: str = "trial.yaml", scene: str = DROP, **keys: Any) -> Path:
        (tmp_path / "drop.yaml").write_text(scene)
        content = {"physsim_sweep": 1, "scene": "drop.yaml", "metrics": METRICS, "grid": GRID, **keys}
        path = tmp_path / name
        path.write_text(yaml.safe_dump(content, sort_keys=False))
        return path

    return make
