"""What it costs a run to be watched.

    python benchmarks/watch.py [ROUNDS]       (the last line needs Chromium, Chrome or Edge, and '.[test]')

Every scene runs alone, with a page that nobody looks at, with a client that fetches the page and all its
frames as a browser does, and with a headless browser that draws it in software. In every round each of them
runs once, in an order that changes; medians are printed: seconds by the clock in the run loop, seconds
of processor that the process of the run took, and both as ratios to the same round alone. Client, server and
browser share the processors with the run: on a machine with few, the browser's drawing is what is felt.
"""

from __future__ import annotations

import json
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "view"))

from view_chromium import FLAGS, find_browser

import physsim
from physsim.view.live.feed import Feed

BALL = """\
physsim: 1
title: A ball bounces, and every step is a frame
simulation: {duration: 10 s, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1]}
record: {every: 1 ms}
"""
HEAP = """\
physsim: 1
title: A heap of 512 bodies
simulation: {duration: 800 ms, timestep: 2 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  brick:
    repeat: {count: [8, 8, 4], spacing: [25 cm, 25 cm, 30 cm]}
    shape: {type: box, size: [20 cm, 18 cm, 16 cm]}
    material: concrete
    position: [0, 0, 20 cm]
    orientation: {axis: [1, 1, 0], angle: 20 deg}
  ball:
    repeat: {count: [8, 8, 4], spacing: [25 cm, 25 cm, 30 cm]}
    shape: {type: sphere, radius: 7 cm}
    material: steel
    position: [3 cm, 5 cm, 1.4 m]
record: {every: 4 ms}
"""
SCENES = {"one ball, 10000 frames": BALL, "512 bodies, 200 frames": HEAP}
WAYS = ("alone", "watched by nobody", "fetched", "in a browser")

# Fetches the page and its frames to the end, as a browser does.
CLIENT = """
import sys, urllib.request as web
web.urlopen(sys.argv[1]).read()
stream = web.urlopen(sys.argv[1] + 'frames')
while stream.read1(1 << 16):
    pass
"""


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    ways = WAYS if find_browser() else WAYS[:-1]
    for title, text in SCENES.items():
        seconds: dict[str, list[tuple[float, float]]] = {way: [] for way in ways}
        for number in range(rounds):
            shift = number % len(ways)
            for way in (*ways[shift:], *ways[:shift]):
                seconds[way].append(measured(text, way))
        print(f"{title}, medians of {rounds} rounds")
        for way, found in seconds.items():
            print(f"  {way:18} {line(found, seconds['alone'])}")


def line(found: list[tuple[float, float]], alone: list[tuple[float, float]]) -> str:
    """Medians by the clock and of the processor, and of their ratios to the runs alone."""
    parts = []
    for kind, word in enumerate(("by the clock", "of the processor")):
        ratios = [one[kind] / other[kind] for one, other in zip(found, alone, strict=True)]
        median = statistics.median(one[kind] for one in found)
        parts.append(f"{median:6.2f} s {word} ({100 * (statistics.median(ratios) - 1):+5.1f} %)")
    return ", ".join(parts)


def measured(text: str, way: str) -> tuple[float, float]:
    """Seconds of one run, in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.yaml").write_text(text)
        command = [sys.executable, str(Path(__file__).resolve()), "--run", folder, way]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    wall, processor = json.loads(said)
    return wall, processor


def run(folder: Path, way: str) -> None:
    """One run in this process; prints its seconds by the clock and of the processor."""
    lookers: list[subprocess.Popen[bytes]] = []

    def look(address: str) -> bool:
        browser = [
            str(find_browser()),
            "--headless=new",
            "--no-sandbox",
            f"--user-data-dir={folder}/user",
            *FLAGS,
        ]
        commands = {
            "fetched": [sys.executable, "-c", CLIENT],
            "in a browser": [*browser, "--window-size=1280,720"],
        }
        if way in commands:
            nowhere = subprocess.DEVNULL
            lookers.append(subprocess.Popen([*commands[way], address], stdout=nowhere, stderr=nowhere))
        return bool(lookers)

    def lament(words: str) -> None:
        sys.exit(f"not watched: {words}")

    feed = None if way == "alone" else Feed(look, lament)
    before = resource.getrusage(resource.RUSAGE_SELF)
    with physsim.run(folder / "scene.yaml", output=folder / "run.h5", onlooker=feed) as trajectory:
        wall = float(trajectory.provenance["wall_time"])
    after = resource.getrusage(resource.RUSAGE_SELF)
    print(json.dumps([wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime]))
    if feed is not None:
        feed.close()
    for looker in lookers:
        looker.terminate()
        looker.wait()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--run"]:
        run(Path(sys.argv[2]), sys.argv[3])
    else:
        main()
