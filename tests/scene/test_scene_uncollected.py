"""Reading a scene makes many objects that stay: nobody looks for garbage among them."""

from __future__ import annotations

import gc
import json
from typing import Any

import pytest

from physsim.model import compile_scene
from physsim.scene import load_scene_text
from physsim.uncollected import uncollected


def many_bodies(count: int) -> str:
    ball = {"shape": {"type": "sphere", "radius": 0.1}, "material": "steel"}
    bodies = {f"ball{k}": {**ball, "position": [k, 0, 0]} for k in range(count)}
    return json.dumps({"physsim": 1, "simulation": {"duration": 1, "timestep": 0.01}, "bodies": bodies})


def test_no_collection_while_a_scene_is_read_and_compiled() -> None:
    collected: list[Any] = []

    def note(phase: str, info: dict[str, int]) -> None:
        collected.append((phase, info))

    text = many_bodies(300)
    gc.callbacks.append(note)
    try:
        compile_scene(load_scene_text(text))
    finally:
        gc.callbacks.remove(note)
    assert len(collected) <= 4  # a search has a beginning and an end, and there may be one between the two
    assert gc.isenabled()


def test_the_collector_is_as_it_was_after_an_error_too() -> None:
    seen: list[bool] = []

    @uncollected()
    def fail() -> None:
        seen.append(gc.isenabled())
        raise ValueError("x")

    with pytest.raises(ValueError, match="x"):
        fail()
    assert seen == [False]
    assert gc.isenabled()
    gc.disable()
    try:
        with uncollected():
            pass
        assert not gc.isenabled()
    finally:
        gc.enable()
