"""Makes every picture and film of scenes that README.md and these pages show, by the commands of users.

    python docs/pictures.py                    all of them, into docs/images
    python docs/pictures.py NAME ...           only these
    python docs/pictures.py --quick FOLDER     all of them tiny and short, into another folder: for a test

page.png, of the page in a browser, is left as it is where there is no Chromium, Chrome or Edge.

Plots are made elsewhere: images/integrators.svg by docs/integrators.py, docs/formulas by docs/formulas.py,
images/speed_and_quality.png by python -m benchmarks.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from physsim.view.picture.sheet import sheet_of, write_png

HERE = Path(__file__).parent
sys.path.append(str(HERE.parent / "tests" / "view"))
from view_chromium import find_browser, started  # noqa: E402, a module of the tests

IMAGES = HERE / "images"
SCENES = HERE.parent / "scenes"
SETTLED = 3000
"""Milliseconds after which a browser that draws in software has drawn a picture well."""
QUICK_RUN = ["--duration", "0.05 s", "--set", "expect=[]"]
QUICK_LOOK = ["--size", "96x60"]
GALLERY_TILE, GALLERY_COLUMNS = (320, 200), 4
GALLERY = {
    "billiards_break": 0.55,
    "brick_wall": 0.3,
    "bouncing_balls": 0.7,
    "dice_roll": 0.6,
    "dominoes": 0.35,
    "governor": 3.2,
    "heavy_on_light": 1.0,
    "marbles_in_a_funnel": 0.8,
    "pendulum_wave": 9.6,
    "quarter_car": 2.8,
    "rope_bridge": 3.2,
    "slider_crank": 0.2,
}
"""Scenes, and the time [s] at which each is shown."""


@dataclass(frozen=True)
class Shot:
    """One file of docs/images: the scene, and what `physsim export` (or `info`, for a scene that is not run)
    is asked for. quick: what is added for the quick form.
    """

    name: str
    scene: str
    arguments: str
    quick: str = ""

    @property
    def declared(self) -> bool:
        """Whether it shows a scene before it runs."""
        return self.arguments == "--picture"


FILM = "--until 0.05 --fps 25 --from 0 --speed 1"
SHOTS = (
    Shot(
        "nuts_and_brackets.gif",
        "nuts_and_brackets",
        "--to gif --size 520x320 --speed 0.5 --until 0.9 --view=-50,16,1 --look-at=-0.08,0.07,0.13",
        FILM,
    ),
    Shot(
        "wrecking_ball.gif", "wrecking_ball", "--to gif --size 440x280 --speed 0.5 --from 0.4 --fps 14", FILM
    ),
    Shot("mobile.gif", "mobile", "--to gif --size 480x340 --until 6 --fps 14", FILM),
    Shot("brick_wall.gif", "brick_wall", "--to gif --size 440x260 --speed 0.25 --until 0.6 --fps 12", FILM),
    Shot("governor.gif", "governor", "--to gif --size 400x300 --until 4 --fps 16", FILM),
    Shot("marbles_in_a_funnel.gif", "marbles_in_a_funnel", "--to gif --size 400x400 --fps 16", FILM),
    Shot(
        "contact_forces.png",
        "heavy_on_light",
        "--to png --size 900x560 --show contacts,springs --at 1",
        "--at 0.05",
    ),
    Shot("trails.png", "billiards_break", "--to png --size 900x560 --show trails --at 0.7", "--at 0.05"),
    Shot("sheet.png", "dice_roll", "--to png --sheet 4x3 --size 1200x750 --until 1.1", "--until 0.05"),
    Shot("declared.png", "four_bar", "--picture"),
)
PAGE = "page.png"
PAGE_SCENE, PAGE_OPENED_AT = "wrecking_ball", "#t=1.1&body=ball"
PAGE_SIZE = {"width": 1440, "height": 800}
NAMES = (*(shot.name for shot in SHOTS), "gallery.png", PAGE)


def main() -> None:
    """Make what the command line asks for."""
    quick = sys.argv[1:2] == ["--quick"]
    folder, wanted = (Path(sys.argv[2]), NAMES) if quick else (IMAGES, tuple(sys.argv[1:]) or NAMES)
    unknown = set(wanted) - set(NAMES)
    if unknown:
        sys.exit(f"no such picture: {', '.join(sorted(unknown))}; there are {', '.join(NAMES)}")
    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as runs:
        for shot in SHOTS:
            if shot.name in wanted:
                make(shot, folder, Path(runs), quick)
        if "gallery.png" in wanted:
            gallery(folder, Path(runs), quick)
        if PAGE in wanted:
            page(folder, Path(runs), quick)


def make(shot: Shot, folder: Path, runs: Path, quick: bool) -> None:
    """One file."""
    target = str(folder / shot.name)
    extra = [*QUICK_LOOK, *shot.quick.split()] if quick else []
    if shot.declared:
        physsim("info", scene_file(shot.scene), "--picture", target, "--size", "1000x640", "--force", *extra)
        return
    trajectory = run(shot.scene, runs, quick)
    physsim("export", trajectory, *shot.arguments.split(), "-o", target, "--force", *extra)


def gallery(folder: Path, runs: Path, quick: bool) -> None:
    """Many scenes on one sheet."""
    chosen = dict(list(GALLERY.items())[-2:]) if quick else GALLERY
    width, height = (96, 60) if quick else GALLERY_TILE
    tiles = []
    for scene, time in chosen.items():
        tile = runs / f"{scene}.png"
        moment = "0.05" if quick else str(time)
        size = ["--size", f"{width}x{height}", "--caption", "title"]
        physsim("export", run(scene, runs, quick), "--to", "png", "--at", moment, *size, "-o", str(tile))
        tiles.append(Image.open(tile).convert("RGB"))
    rows = -(-len(tiles) // GALLERY_COLUMNS)
    write_png(folder / "gallery.png", sheet_of(tiles, GALLERY_COLUMNS, rows, (width, height)))


def page(folder: Path, runs: Path, quick: bool) -> None:
    """The page of a trajectory as a browser shows it, with one body selected."""
    program = find_browser()
    if program is None:
        print(f"{PAGE}: left as it is, there is no Chromium, Chrome or Edge here")
        return
    html = runs / "page.html"
    physsim("view", run(PAGE_SCENE, runs, quick), "-o", str(html))
    with started(program) as browser:
        window = browser.new_page(viewport=PAGE_SIZE)
        window.goto(html.as_uri() + PAGE_OPENED_AT)
        window.evaluate("window.physsim.ready")
        window.wait_for_timeout(SETTLED)
        window.screenshot(path=folder / PAGE)
    print(f"{PAGE}: {PAGE_SIZE['width']}x{PAGE_SIZE['height']}")


def run(scene: str, runs: Path, quick: bool) -> str:
    """The trajectory of a scene, made once."""
    target = runs / f"{scene}.h5"
    if not target.exists():
        physsim("run", scene_file(scene), "-o", str(target), "--quiet", *(QUICK_RUN if quick else []))
    return str(target)


def scene_file(scene: str) -> str:
    """The path of an example."""
    return str(SCENES / f"{scene}.yaml")


def physsim(*arguments: str) -> None:
    """One command; the expectations of a run that was cut short may fail."""
    done = subprocess.run(
        [sys.executable, "-m", "physsim", *arguments], capture_output=True, text=True, check=False
    )
    if done.returncode not in (0, 4):
        sys.exit(f"physsim {' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")
    if arguments[0] != "run":
        print(done.stdout.strip().splitlines()[-1])


if __name__ == "__main__":
    main()
