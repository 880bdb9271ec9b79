"""What the page of a large recording weighs, and how fast it is made, loaded and played.

    python benchmarks/page.py [FOLDER]        (needs Chromium, Chrome or Edge, and pip install -e '.[test]')

For recordings of a thousand bodies and a thousand frames: seconds of `physsim view`, size of the page,
seconds until the page has loaded, and pictures per second over five seconds of playing in a headless browser
that draws in software, 1280 x 720, with the quality that the page chose for itself. FOLDER keeps the
recordings for the next time.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "view"))

from view_chromium import PATIENCE, find_browser, started

Result = TypeVar("Result")

SIZE = {"width": 1280, "height": 720}
WARM_UP = 5.0
"""Seconds of playing before it is measured: the page finds out what the machine can draw."""
MEASURED = 5.0

HEAD = """\
physsim: 1
title: {title}
world: {{gravity: [0, 0, {gravity}]}}
simulation: {{duration: 10 s, timestep: 5 ms, iterations: 20}}
bodies:
  floor: {{fixed: true, shape: {{type: halfspace, normal: [0, 0, 1]}}, material: concrete}}
"""
WALLS = """\
  ceiling: {fixed: true, shape: {type: halfspace, normal: [0, 0, -1], offset: -6 m}, material: concrete}
  west: {fixed: true, shape: {type: halfspace, normal: [1, 0, 0], offset: -3 m}, material: concrete}
  east: {fixed: true, shape: {type: halfspace, normal: [-1, 0, 0], offset: -3 m}, material: concrete}
  south: {fixed: true, shape: {type: halfspace, normal: [0, 1, 0], offset: -3 m}, material: concrete}
  north: {fixed: true, shape: {type: halfspace, normal: [0, -1, 0], offset: -3 m}, material: concrete}
"""
BODY = """\
  {kind}_{number}:
    shape: {shape}
    material: {material}
    position: {position}
    orientation: {{quaternion: {quaternion}}}
    velocity: {velocity}
    angular_velocity: {spin}
"""
SHAPES = {
    "sphere": ("{type: sphere, radius: 6 cm}", "steel"),
    "box": ("{type: box, size: [12 cm, 8 cm, 5 cm]}", "oak"),
    "cylinder": ("{type: cylinder, radius: 5 cm, height: 10 cm}", "copper"),
    "capsule": ("{type: capsule, radius: 4 cm, height: 8 cm}", "rubber"),
    "cone": ("{type: cone, radius: 5 cm, height: 10 cm}", "glass"),
}


def scene(title: str, gravity: float, spacing: float, walls: str, *kinds: str) -> str:
    """A scene of a thousand bodies of these kinds, thrown about at random: no two move alike."""
    draw = np.random.default_rng(1)
    bodies = []
    for number, cell in enumerate(np.ndindex(10, 10, 10)):
        kind = kinds[number % len(kinds)]
        bodies.append(
            BODY.format(
                kind=kind,
                number=number,
                shape=SHAPES[kind][0],
                material=SHAPES[kind][1],
                position=((np.array(cell) - [4.5, 4.5, 0]) * spacing + [0, 0, 0.2]).tolist(),
                quaternion=draw.normal(size=4).tolist(),
                velocity=draw.normal(scale=0.7, size=3).tolist(),
                spin=draw.normal(scale=5, size=3).tolist(),
            )
        )
    return HEAD.format(title=title, gravity=gravity) + walls + "".join(bodies)


RECORDINGS = {
    "spheres": scene("A thousand balls bounce and roll", -9.81, 0.25, "", "sphere"),
    "boxes": scene("A thousand boxes fall into a heap", -9.81, 0.25, "", "box"),
    "mixed": scene("A thousand bodies of five shapes in a room", 0, 0.5, WALLS, *SHAPES),
}

# Counts what the browser draws, whatever the page says of itself: a picture counts when the moment it shows
# differs from that of the picture before.
COUNT_PICTURES = """seconds => new Promise(done => {
    const began = performance.now();
    let pictures = 0, last = -1;
    const tick = now => {
        const time = window.physsim.state().time;
        if (time !== last) { pictures += 1; last = time; }
        if (now - began < 1000 * seconds) requestAnimationFrame(tick);
        else done(1000 * pictures / (now - began));
    };
    requestAnimationFrame(tick);
})"""


def main() -> None:
    """Prints one line per recording."""
    program = find_browser()
    if program is None:
        sys.exit("needs Chromium, Chrome or Edge; PHYSSIM_BROWSER names one")
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(sys.argv[1] if len(sys.argv) > 1 else scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for name, scene in RECORDINGS.items():
            recording = recorded(folder, name, scene)
            build, page = timed(partial(built, recording))
            with started(program) as browser:
                print(
                    f"{name}: file {megabytes(recording)}, page {megabytes(page)} in {build:.1f} s, "
                    f"{played(browser, page)}",
                    flush=True,
                )


def recorded(folder: Path, name: str, scene: str) -> Path:
    """The trajectory of a scene, from an earlier time where there is one."""
    path = folder / f"{name}.h5"
    if not path.exists():
        (folder / f"{name}.yaml").write_text(scene)
        physsim("run", str(folder / f"{name}.yaml"), "-o", str(path), "--quiet")
    return path


def built(recording: Path) -> Path:
    """The page of a trajectory."""
    page = recording.with_suffix(".html")
    physsim("view", str(recording), "-o", str(page), "--force")
    return page


def physsim(*arguments: str) -> None:
    """The command line, in a process of its own."""
    subprocess.run([sys.executable, "-m", "physsim", *arguments], check=True)


def played(browser: Any, path: Path) -> str:
    """Loading and playing, in words."""
    page = browser.new_page(viewport=SIZE)
    page.set_default_timeout(PATIENCE)
    loading, _ = timed(lambda: (page.goto(path.as_uri()), page.evaluate("window.physsim.ready")))
    page.evaluate("window.physsim.play()")
    page.wait_for_timeout(1000 * WARM_UP)
    page.evaluate("window.physsim.seek(0)")
    pictures = page.evaluate(COUNT_PICTURES, MEASURED)
    says = page.evaluate("window.physsim.fps()")
    return f"loaded in {loading:.1f} s, {pictures:.1f} pictures/s (the page says {says:.1f})"


def timed(what: Callable[[], Result]) -> tuple[float, Result]:
    """Seconds by the clock on the wall, and what came of it."""
    began = time.perf_counter()
    result = what()
    return time.perf_counter() - began, result


def megabytes(path: Path) -> str:
    return f"{path.stat().st_size / 1e6:.1f} MB"


if __name__ == "__main__":
    main()
