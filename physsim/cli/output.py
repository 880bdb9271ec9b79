"""The two streams: results go to stdout, progress and messages to stderr.

A reader that leaves early (`physsim materials | head -1`) is no error and changes no exit code: from then on
the rest is written to nowhere.
"""

from __future__ import annotations

import io
import json
import math
import os
import sys
from typing import IO, Any

import click

import physsim


def colour_wanted() -> bool | None:
    """What NO_COLOR (no-color.org) and FORCE_COLOR say; None: colour on a terminal only."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return False if os.environ.get("TERM") == "dumb" else None


def forgive_encodings() -> None:
    """Let a stream that cannot write a character (a title in Greek, say) write its number."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def counted(number: int, one: str, many: str) -> str:
    """`1 body`, `2 bodies`."""
    return f"{number} {one if number == 1 else many}"


def result(text: str) -> None:
    """Write what was asked for to stdout."""
    _write(text, sys.stdout, err=False)


def message(text: str) -> None:
    """Write what is worth knowing to stderr."""
    _write(text, sys.stderr, err=True)


def document(command: str, exit_code: int, **content: Any) -> None:
    """Write the one JSON document of a `--json` call; what JSON has no word for (inf, NaN) becomes null."""
    whole = {"command": command, "physsim_version": physsim.__version__, "exit_code": exit_code, **content}
    result(json.dumps(plain(whole), indent=2, ensure_ascii=False, allow_nan=False))


def plain(value: Any) -> Any:
    """Dictionaries, lists, text, numbers, booleans and None only; numpy arrays and scalars are opened."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, dict):
        return {str(key): plain(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [plain(part) for part in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if value is None or isinstance(value, str | int | bool):
        return value
    return str(value)


def silence(stream: IO[str] | None) -> None:
    """Point a stream without a reader at nowhere, so that nobody trips over it again."""
    if stream is None:
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, stream.fileno())
    finally:
        os.close(nowhere)


def _write(text: str, stream: IO[str] | None, *, err: bool) -> None:
    try:
        click.echo(text, err=err, color=colour_wanted())
    except BrokenPipeError:
        silence(stream)
