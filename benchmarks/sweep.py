"""What a sweep costs beside stepping, and how it grows with workers.

    python benchmarks/sweep.py [RUNS]        (0: no whole sweeps)

For scenes of ten bodies: the time of pure stepping (the engine alone, one call per run, on worlds that are
built already), and what one worker of a sweep takes per run for the same steps, both with the clock of the
process, so that neighbours on the machine do not show; then whole sweeps by the clock on the wall.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from physsim.batch import load_sweep, sweep
from physsim.batch.job import job_of
from physsim.batch.workshop import Workshop
from physsim.model import compile_scene
from physsim.simulation.world import build

HEAD = """\
physsim: 1
parameters: {e: 0.3}
simulation: {duration: 2 s, timestep: 1 ms}
pairs:
  - {between: [steel, concrete], restitution: "${e}", static_friction: 0.5, kinetic_friction: 0.4}
  - {between: [steel, steel], restitution: "${e}", static_friction: 0.5, kinetic_friction: 0.4}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
"""
SCENES = {
    "9 dice that tumble into a heap": """\
  die:
    repeat: {count: [3, 3, 1], spacing: [4 cm, 4 cm, 0]}
    shape: {type: box, size: [3 cm, 3 cm, 3 cm]}
    material: steel
    position: [0, 0, 10 cm]
    orientation: {axis: [1, 2, 3], angle: 50 deg}
    velocity: [0.5, 0.3, 0]
""",
    "9 boxes, stacked": """\
  box: {repeat: {count: [1, 1, 9], spacing: [0, 0, 10 cm]}, shape: {type: box, size: [10 cm, 10 cm, 10 cm]},
        material: steel, position: [0, 0, 5 cm]}
""",
    "9 balls that bounce, each for itself": """\
  ball: {repeat: {count: [3, 3, 1], spacing: [15 cm, 15 cm, 0]}, shape: {type: sphere, radius: 5 cm},
         material: steel, position: [0, 0, 30 cm]}
""",
}
METRICS: dict[str, dict[str, Any]] = {
    "at the end": {"lost": {"type": "energy_lost"}, "impacts": {"type": "impacts"}},
    "of every frame": {
        "rest": {"type": "rest_time"},
        "top": {"type": "max", "quantity": "energy.gravitational"},
        "hit": {"type": "first_contact"},
    },
}


def main() -> None:
    """Prints a table per scene, and the scaling of the first."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    with tempfile.TemporaryDirectory() as folder:
        for name, bodies in SCENES.items():
            print(f"\n{name}, 2 s in steps of 1 ms")
            for kind, metrics in METRICS.items():
                path = written(Path(folder), bodies, metrics, 40)
                stepping, working = in_process(path, Path(folder))
                print(
                    f"  metrics {kind}: {1e3 * stepping:.2f} ms of stepping, {1e3 * working:.2f} ms in all: "
                    f"{working / stepping:.3f} x"
                )
        if count == 0:
            return
        first = next(iter(SCENES.values()))
        path = written(Path(folder), first, METRICS["at the end"], count)
        scaling(path, Path(folder), count)


def written(folder: Path, bodies: str, metrics: dict[str, Any], count: int) -> Path:
    """A sweep of `count` runs as a file."""
    (folder / "scene.yaml").write_text(HEAD + bodies)
    path = folder / "sweep.yaml"
    path.write_text(
        f"physsim_sweep: 1\nscene: scene.yaml\nmetrics: {metrics}\n"
        f"grid: {{parameters.e: {{type: range, from: 0.1, to: 0.8, count: {count}}}}}\n".replace("'", '"')
    )
    return path


def in_process(path: Path, folder: Path) -> tuple[float, float]:
    """Seconds of this process per run: stepping alone, and all that a worker does; medians over the runs."""
    loaded = load_sweep(path)
    workshop = Workshop(job_of(loaded), folder, folder)
    stepping, working = [], []
    for run in loaded.design:
        scene = loaded.base.scene(dict(run.changes))
        world = build(compile_scene(scene)).world
        began = time.process_time()
        world.advance(scene.spec.simulation.steps, None)
        stepping.append(time.process_time() - began)
        began = time.process_time()
        assert workshop.do(run).status == "complete"
        working.append(time.process_time() - began)
    return statistics.median(stepping), statistics.median(working)


def scaling(path: Path, folder: Path, count: int) -> None:
    """Whole sweeps with 1 and 2 workers: workers' time, and time by the clock with start and tables."""
    print(f"\nwhole sweeps of {count} runs")
    for workers in (1, 2):
        began = time.perf_counter()
        result = sweep(path, output=folder / f"out{workers}", workers=workers)
        took = time.perf_counter() - began
        inside = sum(result.table.column("wall_time")) / workers
        print(
            f"  {workers} workers: {took:.2f} s by the clock, {count / took:.0f} runs/s; "
            f"in the runs {inside:.2f} s per worker: {took / inside:.3f} x"
        )


if __name__ == "__main__":
    main()
