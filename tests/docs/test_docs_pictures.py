"""What README.md and the pages show is made by docs/pictures.py, from the scenes."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

REPOSITORY = Path(__file__).parents[2]
IMAGES = REPOSITORY / "docs/images"
SHOWN = re.compile(r"!\[[^\]]*\]\(([^)]*images/[^)]*)\)")
PLOTS = {"integrators.svg", "speed_and_quality.png"}
"""By docs/integrators.py and python -m benchmarks."""
MOST_BYTES, MOST_BYTES_TOGETHER = 1 << 20, 8 << 20

Image = pytest.importorskip("PIL.Image")
pytest.importorskip("av")


@pytest.fixture(scope="module")
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("docs_pictures", REPOSITORY / "docs/pictures.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


def shown() -> set[str]:
    """The images that README.md and the pages show."""
    pages = [REPOSITORY / "README.md", *(REPOSITORY / "docs").glob("*.md")]
    return {Path(target).name for page in pages for target in SHOWN.findall(page.read_text())}


def test_every_picture_is_made_by_the_script_and_shown_somewhere(script: ModuleType) -> None:
    there = {path.name for path in IMAGES.iterdir()}
    assert shown() <= there
    assert there - PLOTS == set(script.NAMES)
    assert set(script.NAMES) <= shown()


def test_pictures_are_small() -> None:
    sizes = {path.name: path.stat().st_size for path in IMAGES.iterdir()}
    assert max(sizes.values()) < MOST_BYTES
    assert sum(sizes.values()) < MOST_BYTES_TOGETHER


def test_the_script_makes_all_of_them(script: ModuleType, tmp_path: Path) -> None:
    """In its quick form: tiny and short."""
    done = subprocess.run(
        [sys.executable, str(REPOSITORY / "docs/pictures.py"), "--quick", str(tmp_path / "made")],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    made = {path.name for path in (tmp_path / "made").iterdir()}
    assert made == set(script.NAMES) - (set() if script.find_browser() else {script.PAGE})
    for name in made:
        with Image.open(tmp_path / "made" / name) as picture:
            assert min(picture.size) >= 40
            assert getattr(picture, "n_frames", 1) == (2 if name.endswith(".gif") else 1), name
            assert len(picture.convert("RGB").getcolors(1 << 20)) > 50
