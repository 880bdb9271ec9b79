"""`physsim new`: a commented scene to start from."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import re
from pathlib import Path

import click

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option

STARTER = Path(__file__).with_name("starter.yaml")
# One file name that means the same on every system: no folder, no leading dot or dash, no blanks.
SAFE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]{0,99}")
# Windows opens a device under these names, whatever the extension.
DEVICES = {"con", "prn", "aux", "nul"} | {f"{port}{k}" for port in ("com", "lpt") for k in range(1, 10)}


@click.command(
    cls=Verb,
    arguments=[("NAME", "name of the scene: letters, digits, _ - + and dots; .yaml is added")],
    examples=[
        Example(
            "write my_scene.yaml into this folder and run it",
            "physsim new my_scene && physsim run my_scene.yaml",
        ),
        Example("start over", "physsim new my_scene --force"),
    ],
)
@click.argument("name")
@click.option("--force", is_flag=True, help="Overwrite a file of that name.")
@debug_option
def command(name: str, force: bool) -> None:
    """Write a commented starter scene NAME.yaml into the current directory.

    It runs as it stands: a ball bounces on a concrete floor, a wooden crate slides and tumbles to rest, and a
    hinged sign sways in the wind.
    An existing file is left alone unless --force is given.
    """
    target = Path(checked_name(name) + ".yaml")
    write_starter(target, force=force)
    output.result(str(target))
    output.message(f"Run it with: physsim run {target}")


def checked_name(name: str) -> str:
    """The name without .yaml; raises click.BadParameter for a name that is unsafe on some system."""
    stem = re.sub(r"\.ya?ml$", "", name)
    if not SAFE_NAME.fullmatch(stem) or stem.endswith("."):
        raise click.BadParameter(
            f"{name!r} is not a plain name: use letters, digits, _ - + and dots, and no folder",
            param_hint="NAME",
        )
    if stem.split(".")[0].lower() in DEVICES:
        raise click.BadParameter(f"{name!r} is the name of a device on Windows", param_hint="NAME")
    return stem


def write_starter(target: Path, *, force: bool) -> None:
    """Write the starter scene; raises FileTrouble when the file exists and may not be overwritten."""
    from physsim.errors import FileTrouble

    text = STARTER.read_text(encoding="utf-8")
    try:
        with target.open("w" if force else "x", encoding="utf-8") as file:
            file.write(text.replace("NAME", target.stem))
    except FileExistsError:
        raise FileTrouble(f"{target} exists already; --force overwrites it") from None
