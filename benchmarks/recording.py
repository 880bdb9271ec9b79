"""What recording costs: python -m benchmarks.recording --scenes spheres1000,columns1000 --rounds 3

Whole runs, loading included, in which every step is recorded, against runs with the first and the last frame
only, in turn. Printed are medians of the ratios: time by the clock on the wall, processor time of the process
(frames are packed in a thread of their own), that of the thread which steps; and a frame's place on the disk.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from pathlib import Path
from statistics import median

import physsim
from benchmarks.peers.physsim import described
from benchmarks.scenes import SCENES

TIMESTEP = 1 / 240
CLOCKS = (time.perf_counter, time.process_time, time.thread_time)


def measured(scene_name: str, duration: float, rounds: int) -> tuple[list[float], float]:
    """Ratios by each clock, and bytes a frame."""
    told = json.loads(described(SCENES[scene_name](), {"timestep": TIMESTEP, "duration": duration}))
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(rounds):
            ends, _ = _run(told | {"record": {"every": duration}}, Path(folder) / f"{number}-ends")
            every, size = _run(told | {"record": {"every": TIMESTEP}}, Path(folder) / f"{number}-every")
            ratios.append([a / b for a, b in zip(every, ends, strict=True)])
    return [median(column) for column in zip(*ratios, strict=True)], size / (duration / TIMESTEP)


def _run(scene: dict[str, object], place: Path) -> tuple[list[float], int]:
    """Seconds by each clock, and the size of the file."""
    path, output = place.with_suffix(".yaml"), place.with_suffix(".h5")
    path.write_text(json.dumps(scene))
    began = [clock() for clock in CLOCKS]
    physsim.run(path, output=output).close()
    took = [clock() - start for clock, start in zip(CLOCKS, began, strict=True)]
    size = output.stat().st_size
    output.unlink()
    return took, size


def main() -> None:
    """Prints a table in Markdown."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.recording", description=__doc__)
    parser.add_argument("--scenes", default="spheres1000,columns1000,free1000")
    parser.add_argument("--duration", type=float, default=2.0, help="simulated seconds")
    parser.add_argument("--rounds", type=int, default=3)
    asked = parser.parse_args()
    print(
        "| scene | on the wall | processor | of the thread that steps | MB a frame |\n|---|---|---|---|---|"
    )
    for name in asked.scenes.split(","):
        ratios, size = measured(name, asked.duration, asked.rounds)
        cells = [name, *(f"{ratio:.2f} x" for ratio in ratios), f"{size / 1e6:.2f}"]
        print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
