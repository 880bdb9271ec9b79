"""Threads change how long a run takes and nothing else."""

from __future__ import annotations

import os
import threading
import time
from pathlib import Path
from typing import Any

import pytest
from contents import differing

import physsim
from physsim.model import compile_scene
from physsim.scene import load_scene
from physsim.simulation.world import build

# Enough bodies that the engine uses its threads: a heap, stacks, flying capsules, rolling friction.
CROWD = """\
physsim: 1
title: A crowd
simulation: {duration: 100 ms, timestep: 5 ms, threads: 2}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball:
    repeat: {count: [6, 6, 4], spacing: [10.1 cm, 10.1 cm, 10.2 cm]}
    shape: {type: sphere, radius: 5 cm}
    material: steel
    position: [0, 0, 5.1 cm]
    velocity: [0.1, 0.05, 0]
  brick:
    repeat: {count: [8, 1, 3], spacing: [25 cm, 0, 7 cm]}
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
    position: [0, 2, 35 mm]
  link:
    repeat: {count: [6, 1, 1], spacing: [20 cm, 0, 0]}
    shape: {type: capsule, radius: 2 cm, height: 10 cm}
    material: steel
    position: [0, 0.2, 1]
pairs:
  - {between: [steel, concrete], rolling_friction: 1 mm}
record: {every: 10 ms}
"""


@pytest.fixture
def crowd(tmp_path: Path) -> Path:
    path = tmp_path / "crowd.yaml"
    path.write_text(CROWD, encoding="utf-8")
    return path


def world_of(path: Path, threads: int) -> Any:
    scene = load_scene(path, overrides=[f"simulation.threads={threads}"])
    return build(compile_scene(scene)).world


@pytest.mark.parametrize("impacts", ["stepped", "located"])
def test_a_run_has_the_same_bits_on_any_number_of_threads(crowd: Path, tmp_path: Path, impacts: str) -> None:
    settings = [f"simulation.impacts={impacts}", "simulation.integrator=velocity_verlet"]
    for threads in (1, 2, 3):
        overrides = [*settings, f"simulation.threads={threads}"]
        physsim.run(crowd, output=tmp_path / f"{threads}.h5", set=overrides).close()
    for threads in (2, 3):
        assert differing(tmp_path / "1.h5", tmp_path / f"{threads}.h5") == []


def test_a_run_goes_on_with_another_number_of_threads(crowd: Path, tmp_path: Path) -> None:
    physsim.run(crowd, output=tmp_path / "through.h5").close()
    physsim.run(crowd, output=tmp_path / "pieces.h5", duration="40 ms").close()
    alone = ["simulation.threads=1"]
    physsim.run(crowd, output=tmp_path / "pieces.h5", set=alone, resume=True).close()
    assert differing(tmp_path / "through.h5", tmp_path / "pieces.h5") == []


def test_the_interpreter_is_free_while_threads_step(crowd: Path) -> None:
    """Another thread of Python goes on counting while the engine steps."""
    world = world_of(crowd, threads=2)
    stepping = threading.Thread(target=world.advance, args=(200,))
    stepping.start()
    counted = 0
    while stepping.is_alive():
        counted += 1
        time.sleep(1e-4)
    assert counted > 20


def test_a_forked_process_has_threads_of_its_own(crowd: Path) -> None:
    """The threads of the parent are not in the child, which must not wait for them."""
    world = world_of(crowd, threads=2)
    world.advance(2)
    child = os.fork()
    if child == 0:
        world.advance(2)
        os._exit(0)
    patience = 1000
    while patience and os.waitpid(child, os.WNOHANG) == (0, 0):
        patience -= 1
        time.sleep(0.05)
    assert patience
