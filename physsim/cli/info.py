"""`physsim info`: what a scene means, or what a trajectory holds."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path

import click

from physsim.cli import info_picture, info_scene, info_trajectory
from physsim.cli.drawing import Size
from physsim.cli.verb import Example, Verb, debug_option, json_option, set_option
from physsim.errors import FileTrouble

HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"
HEAD_BYTES = 4096


@click.command(
    cls=Verb,
    exits=(0, 2, 3),
    arguments=[("FILE", "a scene (YAML) or a trajectory (HDF5); told apart by content, not by name")],
    examples=[
        Example("masses, inertias, pairs of materials, overlaps at the start", "physsim info my_scene.yaml"),
        Example(
            "what a change would do to them", "physsim info my_scene.yaml --set bodies.crate.mass='3 kg'"
        ),
        Example(
            "the same, and a picture in which a wrong pose is seen at once",
            "physsim info my_scene.yaml --picture my_scene_declared.png",
        ),
        Example("how far a run came, and its energy", "physsim info my_scene.h5"),
        Example(
            "the mass of one body, for a program",
            "physsim info --json my_scene.yaml | "
            """python3 -c 'import json, sys; print(json.load(sys.stdin)["bodies"][1]["mass"])'""",
        ),
    ],
)
@click.argument("file", type=click.Path())
@click.option(
    "--picture",
    is_flag=False,
    flag_value=info_picture.BESIDE_THE_SCENE,
    metavar="[FILE.png]",
    help="Draw the scene as declared: bodies with their frames and centres of mass, joints with their axes, "
    "springs, overlaps. Default: the scene's name, here.",
)
@click.option("--size", type=Size(), default="1280x800", metavar="WxH", help="Pixels of the picture.")
@click.option("--force", is_flag=True, help="Replace an existing picture.")
@set_option
@json_option
@debug_option
def command(
    *,
    file: str,
    picture: str | None,
    size: tuple[int, int],
    force: bool,
    overrides: tuple[str, ...],
    as_json: bool,
) -> None:
    """Show what physsim makes of a scene, or what a trajectory holds.

    Of a scene: each body with its mass, centre of mass, principal moments and axes, and by which method they
    were found; each spring with natural frequency, damping ratio and critical damping; each joint with what
    it holds and what drives it; forces; the resolved pair matrix, with the row or rule that each number came
    from; overlaps at the start. Of a trajectory: status, frames, time range, bodies, joints, springs, energy,
    versions and where it came from; also while it is still being written.
    """
    if is_trajectory(Path(file)):
        if picture is not None:
            raise click.UsageError(
                "--picture draws scenes; of a trajectory `physsim export --to png` makes pictures"
            )
        if overrides:
            raise click.UsageError("--set changes scenes; a trajectory is what it is")
        info_trajectory.show(file, as_json)
    else:
        draw = None
        if picture is not None:
            draw = partial(info_picture.draw, info_picture.target_of(picture, file, force=force), size)
        info_scene.show(file, overrides, as_json, draw)


def is_trajectory(path: Path) -> bool:
    """Whether the content is HDF5, or the file is still in its making (NAME.part).

    Raises FileTrouble for what is no regular file, cannot be read, or is neither HDF5 nor text.
    """
    head = first_bytes(path)
    if head is None or head.startswith(HDF5_SIGNATURE):
        return True
    if b"\0" in head:
        raise FileTrouble(f"{path}: is neither a scene (YAML text) nor a trajectory (HDF5)")
    return False


def first_bytes(path: Path) -> bytes | None:
    """The first bytes of a regular file; None when only its NAME.part is there. Raises FileTrouble."""
    if path.is_dir():
        raise FileTrouble(f"{path}: is a folder; name a scene or a trajectory in it")
    if not path.exists():
        if path.with_name(path.name + ".part").exists():
            return None
        raise FileTrouble(f"{path}: there is no such file")
    if not path.is_file():
        raise FileTrouble(f"{path}: is not a regular file")
    try:
        with path.open("rb") as file:
            return file.read(HEAD_BYTES)
    except OSError as error:
        raise FileTrouble(f"{path}: {os.strerror(error.errno or 0).lower()}") from None
