"""One engine on one scene, in a process of its own: python -m benchmarks.cell REQUEST STATES.npz

Prints one line of JSON. Steps are timed in blocks of 0.1 s of simulated time: by the time that the process
was given (neighbours on the machine show little then), or by the clock on the wall, which more threads need.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from benchmarks.peers import Stepping, Unable, peer
from benchmarks.scene import Scene
from benchmarks.scenes import SCENES

BLOCK_SECONDS = 0.1
BATCH_STEPS = 1000


@dataclass(frozen=True)
class Request:
    """What to run. limit: seconds after which a run is cut off."""

    peer: str
    setting: str
    scene: str
    timestep: float
    threads: int
    limit: float
    batch: bool = False


def main(request: Request, states: str) -> dict[str, Any]:
    """What is printed."""
    if request.threads == 1:
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    try:
        module = peer(request.peer)
        scene = SCENES[request.scene]()
        make = _maker(module, scene, request)
        clock = time.process_time if request.threads == 1 else time.perf_counter
        told = {"version": module.version()}
        if request.batch:
            return told | _batch(make, clock, request.limit)
        return told | _run(make(), scene, request, states, clock)
    except Unable as reason:
        return {"unable": str(reason)}


def _maker(module: Any, scene: Scene, request: Request) -> Callable[[], Stepping]:
    setting = module.SETTINGS[request.setting]

    def make() -> Stepping:
        world: Stepping = module.World(scene, request.timestep, threads=request.threads, **setting)
        return world

    return make


def _run(
    world: Stepping, scene: Scene, request: Request, states: str, clock: Callable[[], float]
) -> dict[str, Any]:
    """Blocks until the scene's end or the limit."""
    size = max(1, round(BLOCK_SECONDS / request.timestep))
    blocks = round(scene.duration / request.timestep) // size
    took, samples = [], []
    began = time.perf_counter()
    for _ in range(blocks):
        start = clock()
        world.step(size)
        took.append((clock() - start) / size)
        samples.append(world.state())
        if time.perf_counter() - began > request.limit:
            break
    ends = (np.arange(len(took)) + 1) * size * request.timestep
    x, q, v, w = (np.array(column) for column in zip(*samples, strict=True))
    np.savez(states, time=ends, x=x, q=q, v=v, w=w)
    return {
        "busy": _median(took, ends, scene.busy),
        "rest": _median(took, ends, scene.rest) if len(took) == blocks else None,
        "last": took[-1],
        "reached": float(ends[-1]),
        "memory": _peak_memory(),
    }


def _median(took: list[float], ends: Any, window: tuple[float, float]) -> float | None:
    inside = [t for t, end in zip(took, ends, strict=True) if window[0] < end - 1e-9 <= window[1]]
    return float(np.median(inside)) if inside else None


def _batch(make: Callable[[], Stepping], clock: Callable[[], float], limit: float) -> dict[str, Any]:
    """Whole worlds one after the other, building included, for a third of the limit."""
    taken, worlds = 0.0, 0
    while taken < limit / 3:
        start = clock()
        world = make()
        world.step(BATCH_STEPS)
        if hasattr(world, "close"):
            world.close()
        taken += clock() - start
        worlds += 1
    return {"world_steps": worlds * BATCH_STEPS / taken, "worlds": worlds}


def _peak_memory() -> float:
    """[MB] of this process."""
    with open("/proc/self/status") as status:  # noqa: PTH123
        kilobytes = next(line.split()[1] for line in status if line.startswith("VmHWM"))
    return int(kilobytes) / 1024


if __name__ == "__main__":
    asked = Request(**json.loads(sys.argv[1]))
    answer = asdict(asked) | main(asked, sys.argv[2])
    print("\n" + json.dumps(answer), flush=True)
    os._exit(0)  # several engines do not survive their own clean-up
