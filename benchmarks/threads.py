"""What threads bring: python -m benchmarks.threads --scenes spheres1000,free10000 --threads 1,2 --rounds 3

Each scene is stepped side by side on every number of threads, a tenth of a second of its time on each in
turn, by the clock on the wall: a slow moment of the machine meets them all. Fails when their bits differ.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from statistics import median

import numpy as np

from benchmarks.cell import BLOCK_SECONDS
from benchmarks.peers.physsim import World
from benchmarks.scenes import SCENES

LARGE = ("spheres1000", "mixed1000", "columns1000", "pyramid30", "free10000")


def compared(scene_name: str, counts: Sequence[int], timestep: float) -> list[list[float]]:
    """Seconds a step: a row for each stretch of the scene, a column for each number of threads."""
    scene = SCENES[scene_name]()
    size = max(1, round(BLOCK_SECONDS / timestep))
    worlds = [World(scene, timestep, threads=count) for count in counts]
    rows = []
    for _ in range(round(scene.duration / timestep) // size):
        row = []
        for world in worlds:
            start = time.perf_counter()
            world.step(size)
            row.append((time.perf_counter() - start) / size)
        rows.append(row)
        first, *others = [b"".join(np.asarray(part).tobytes() for part in w.state()) for w in worlds]
        if any(other != first for other in others):
            sys.exit(f"{scene_name}: the bits depend on the number of threads")
    return rows


def line_of(scene_name: str, rows: Sequence[Sequence[float]]) -> str:
    """Medians of the times, and of the gains with their quartiles, as a line of a table."""
    cells = [scene_name, *(f"{1e3 * median(column):.2f}" for column in zip(*rows, strict=True))]
    for other in range(1, len(rows[0])):
        low, middle, high = np.quantile([row[0] / row[other] for row in rows], [0.25, 0.5, 0.75])
        cells.append(f"{middle:.2f} ({low:.2f} - {high:.2f})")
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    """Prints a table in Markdown."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.threads", description=__doc__)
    parser.add_argument("--scenes", default=",".join(LARGE))
    parser.add_argument("--threads", default="1,2", help="numbers of threads; the first is compared with")
    parser.add_argument("--rounds", type=int, default=1)
    asked = parser.parse_args()
    counts = [int(count) for count in asked.threads.split(",")]
    times = [f"{count} thread{'s' if count > 1 else ''} [ms a step]" for count in counts]
    gains = [f"gain of {count} (quartiles)" for count in counts[1:]]
    heads = ["scene", *times, *gains]
    print("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    for name in asked.scenes.split(","):
        rows = [row for _ in range(asked.rounds) for row in compared(name, counts, 1 / 240)]
        print(line_of(name, rows), flush=True)


if __name__ == "__main__":
    main()
