"""`physsim export --to glb`: an animated scene for Blender, model viewers and game engines."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from physsim.cli import output
from physsim.cli.export_format import END, FPS, SPEED, START, Finite, Format, Order
from physsim.cli.verb import Example

if TYPE_CHECKING:
    from physsim.view.gltf.gltf import Written

TOLERANCE = click.Option(
    ["--tolerance"],
    type=Finite(min=0),
    metavar="M",
    help="How far any point of a body may be off at any frame [m]; 0 leaves out only what is superfluous to "
    "the last bit. Default: 1/1000 of the radius of the smallest body that moves.",
)
CAMERA = click.Option(["--camera"], is_flag=True, help="Add a camera that sees everything, and a sun.")


def write_scene(
    order: Order,
    *,
    fps: float | None,
    speed: float,
    start: float | None,
    end: float | None,
    tolerance: float | None,
    camera: bool,
) -> str:
    """One file with meshes, materials and key frames."""
    from physsim.recording import open_trajectory
    from physsim.recording.whole_file import check_name
    from physsim.view.gltf.gltf import Wishes, write_gltf

    check_name(order.target, force=order.force)
    with open_trajectory(order.file) as trajectory:
        wishes = Wishes(start, end, fps, speed, tolerance, camera)
        written = write_gltf(trajectory, order.target, wishes)
    tell_rounding(written)
    return f"{order.target}: {summary(written)}"


def summary(written: Written) -> str:
    """What is in the file, and how exact it is."""
    from physsim.recording.target import in_words

    bodies = output.counted(written.bodies, "body", "bodies")
    instants = output.counted(written.instants, "frame", "frames")
    thinned = "nothing moves"
    if written.samples:
        error = f"no point is off by more than {length(written.tolerance)}"
        thinned = f"{written.kept} of {written.samples} key frames, {error}"
    return f"{bodies}, {instants}, {in_words(written.size)}; {thinned}"


def tell_rounding(written: Written) -> None:
    """Far from the origin the 32-bit numbers of glTF are what limits."""
    if written.samples and written.rounding > written.visible:
        output.message(
            f"so far from the origin the 32-bit numbers of glTF round positions by {length(written.rounding)}"
        )


def length(metres: float) -> str:
    """`2.5e-05` -> `0.025 mm`."""
    for factor, unit in ((1.0, "m"), (1e3, "mm"), (1e6, "µm")):
        if metres * factor >= 0.1 or metres == 0:
            return f"{metres * factor:.2g} {unit}"
    return f"{metres * 1e9:.2g} nm"


GLB = Format(
    names=("glb",),
    write=write_scene,
    options=(FPS, SPEED, START, END, TOLERANCE, CAMERA),
    examples=(
        Example(
            "a file for Blender and other 3-D programs: my_scene.glb", "physsim export my_scene.h5 --to glb"
        ),
        Example(
            "the second half, 30 key frames a second, with a camera",
            "physsim export my_scene.h5 --to glb --from 0.5 --fps 30 --camera -o end.glb",
        ),
    ),
)
