"""`physsim info SCENE --picture`: the scene as it is declared, drawn."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from physsim.cli import output
from physsim.cli.table import number

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene
    from physsim.simulation.overlaps import Overlap

BESIDE_THE_SCENE = ""
"""`--picture` without a name."""


def target_of(picture: str, file: str, *, force: bool) -> Path:
    """Where the picture goes: as named, else the scene's name here. Raises FileTrouble when it is taken."""
    from physsim.recording.whole_file import check_name

    path = Path(f"{Path(file).stem}.png" if picture == BESIDE_THE_SCENE else picture)
    check_name(path, force=force)
    return path


def draw(
    target: Path, size: tuple[int, int], scene: Scene, model: Model, overlaps: Sequence[Overlap]
) -> None:
    """Write the picture. Raises MissingExtra and FileTrouble."""
    import numpy as np

    from physsim.simulation.about import fixed_values
    from physsim.view.picture.draft import draft
    from physsim.view.picture.sheet import write_png
    from physsim.view.stage import staged

    stage = staged(scene.title, fixed_values(scene, model).get)
    wrong = [
        (np.asarray(one.position), f"{one.body_a} and {one.body_b} overlap by {number(one.depth)} m")
        for one in overlaps
    ]
    write_png(target, draft(stage, model.position, model.orientation, wrong, size))
    output.message(f"{target}: the scene, drawn")
