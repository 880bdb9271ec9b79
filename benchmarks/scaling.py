"""How the cost of a body changes with their number: engine, loading, memory.

    python -m benchmarks.scaling [--scenes spheres,columns] [--counts 1000,3000,10000,30000] [--json FILE]

Times are CPU time, so that neighbours on the machine show little. Each line is measured in a process of its
own: memory that an earlier one used would be found again.
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import physsim
from benchmarks.peers.physsim import described
from benchmarks.scene import Scene
from benchmarks.scenes import columns, free, spheres
from physsim.model import Model, compile_scene
from physsim.scene import load_scene
from physsim.simulation.world import build

TIMESTEP = 1 / 240
HEIGHT = 10
# Steps before the measurement: balls have come down by then; columns stand, free bodies fly.
STEPS_BEFORE = {"spheres": 240, "columns": 12, "free": 12}
ROUNDS = 5
BODY_STEPS_A_ROUND = 30_000
PAGE = 4096

Line = dict[str, float | str]


def scene_of(kind: str, count: int) -> Scene:
    """About so many bodies."""
    if kind == "columns":
        return columns(round((count / HEIGHT) ** 0.5), HEIGHT)
    return {"spheres": spheres, "free": free}[kind](count)


def measured(kind: str, count: int) -> Line:
    """One line: microseconds per body and contact, bytes per body."""
    scene = scene_of(kind, count)
    bodies = len(scene.bodies)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.yaml"
        path.write_text(described(scene, {"timestep": TIMESTEP, "duration": TIMESTEP}))
        loading = -time.process_time()
        model = compile_scene(load_scene(path))
        loading += time.process_time()
        stepping, contacts, memory = _stepped(kind, model, bodies)
        whole = -time.process_time()
        physsim.run(path, output=Path(folder) / "run.h5").close()
        whole += time.process_time()
    return {
        "scene": kind,
        "bodies": bodies,
        "contacts": contacts,
        "step_us_per_body": 1e6 * stepping / bodies,
        "step_us_per_contact": 1e6 * stepping / max(contacts, 1),
        "load_us_per_body": 1e6 * loading / bodies,
        "run_of_one_step_us_per_body": 1e6 * whole / bodies,
        "engine_bytes_per_body": memory / bodies,
    }


def _stepped(kind: str, model: Model, bodies: int) -> tuple[float, int, int]:
    """Seconds of a step, its contacts, and by how much the process has grown [bytes]."""
    before = _resident()
    simulated = build(model)
    world, answer = simulated.world, simulated.answer
    world.advance(STEPS_BEFORE[kind], answer)
    memory = _resident() - before
    steps = max(BODY_STEPS_A_ROUND // bodies, 1)
    rounds = []
    for _ in range(ROUNDS):
        began = time.process_time()
        world.advance(steps, answer)
        rounds.append((time.process_time() - began) / steps)
    return statistics.median(rounds), int(world.solver()["contact_count"]), memory


def _resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * PAGE


def main() -> None:
    """Prints a table, and writes the lines."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scaling", description=__doc__)
    parser.add_argument("--scenes", default="spheres,columns,free")
    parser.add_argument("--counts", default="1000,3000,10000,30000")
    parser.add_argument("--json", type=Path, help="where the lines are written")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)
    asked = parser.parse_args()
    if asked.one:
        print(json.dumps(measured(asked.one[0], int(asked.one[1]))))
        return
    lines: list[Line] = []
    for kind in asked.scenes.split(","):
        for count in asked.counts.split(","):
            command = [sys.executable, "-m", "benchmarks.scaling", "--one", kind, count]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
            lines.append(json.loads(done.stdout))
            print("  ".join(_shown(name, value) for name, value in lines[-1].items()), flush=True)
            if asked.json:
                asked.json.write_text(json.dumps(lines, indent=1))


def _shown(name: str, value: float | str) -> str:
    return f"{name} {value:.4g}" if isinstance(value, float) else f"{name} {value}"


if __name__ == "__main__":
    main()
