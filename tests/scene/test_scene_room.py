"""What the scene room does not do: pull in heavy libraries, or hide what it knows."""

from __future__ import annotations

import subprocess
import sys

HEAVY = ("numpy", "trimesh", "scipy", "fcl", "h5py", "rich")


def test_reading_a_scene_imports_nothing_heavy() -> None:
    program = (
        "import sys; from physsim.scene import load_scene_text, format_problems\n"
        "text = 'physsim: 1\\nsimulation: {duration: 1, timestep: 1}\\n'\n"
        "text += 'bodies: {b: {material: steel, shape: {type: sphere, radius: 1}}}'\n"
        "load_scene_text(text).resolved_yaml()\n"
        f"print([name for name in {HEAVY} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_the_schema_is_printed_by_the_module() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "physsim.scene.schema"], capture_output=True, encoding="utf-8", check=True
    )
    assert done.stdout.startswith('{\n  "$schema": "https://json-schema.org/draft/2020-12/schema"')
