"""Scenes as files, and what a trajectory file holds as plain bytes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

BOUNCE = """\
physsim: 1
title: A ball and two bricks
simulation: {duration: 600 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball:
    shape: {type: sphere, radius: 5 cm}
    material: steel
    position: [0, 0, 30 cm]
    velocity: [1, 0, 0]
    angular_velocity: [0, 3, 1]
  brick:
    repeat: {count: [1, 1, 2], spacing: [0, 0, 7 cm]}
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
    position: [40 cm, 0, 35 mm]
record: {every: 10 ms}
"""


@pytest.fixture
def scene(tmp_path: Path) -> Callable[..., Path]:
    """`scene(old=new, ...)` writes the scene with these pieces of text replaced, and gives its path."""

    def write(*changes: tuple[str, str], name: str = "scene.yaml", text: str = BOUNCE) -> Path:
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write
