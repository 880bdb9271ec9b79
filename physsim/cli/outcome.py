"""How a call ends: every error becomes a message in plain words and one of the promised exit codes."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import os
import sys
from contextlib import suppress
from typing import IO

import click

from physsim.cli import output, problems
from physsim.cli.verb import Settings
from physsim.errors import FileTrouble, PhyssimError, SceneError

INTERRUPTED = 130


def tell(error: BaseException, wishes: Settings) -> int:
    """Say what went wrong, on stderr or as the JSON document, and return the exit code."""
    if isinstance(error, BrokenPipeError):
        output.silence(sys.stdout)
        output.silence(sys.stderr)
        return 0
    if isinstance(error, click.ClickException):
        return _tell_usage(error)
    if wishes.debug and not isinstance(error, PhyssimError | click.Abort | KeyboardInterrupt):
        _show_traceback(error)
    code, text = explain(error)
    if wishes.json:
        found = problems.as_data(error.problems, error.file) if isinstance(error, SceneError) else []
        output.document(wishes.command, code, **wishes.known, error=text, problems=found)
    elif isinstance(error, SceneError):
        output.message(problems.as_text(error.problems, error.file))
    else:
        output.message(click.style("physsim: ", bold=True) + text)
    return code


def explain(error: BaseException) -> tuple[int, str]:
    """Exit code and one line for any exception."""
    if isinstance(error, PhyssimError):
        return error.exit_code, str(error)
    if isinstance(error, KeyboardInterrupt | click.Abort):
        return INTERRUPTED, "interrupted"
    if isinstance(error, MemoryError):
        return 1, "out of memory"
    if isinstance(error, OSError):
        return FileTrouble.exit_code, _file_trouble(error)
    first_line = (str(error).splitlines() or [""])[0]
    return 1, (
        f"internal error, a mistake in physsim and not in your scene: {type(error).__name__}: {first_line} "
        "(--debug shows the traceback)"
    )


def leave(code: int) -> None:
    """Flush both streams, and end the process here where the interpreter's own exit cannot be trusted.

    After a failed write h5py cannot close its file, and its clean-up at interpreter exit ends in a
    segmentation fault (seen with h5py 3.16 on a full disk), which would hide our exit code.
    """
    _flush(sys.stdout)
    _flush(sys.stderr)
    if code == FileTrouble.exit_code and "h5py" in sys.modules:
        os._exit(code)


def _tell_usage(error: click.ClickException) -> int:
    with suppress(BrokenPipeError):
        error.show()
    return FileTrouble.exit_code if isinstance(error, click.FileError) else SceneError.exit_code


def _file_trouble(error: OSError) -> str:
    name = f"{error.filename}: " if error.filename else ""
    return name + (os.strerror(error.errno) if error.errno else str(error))


def _flush(stream: IO[str] | None) -> None:
    try:
        if stream is not None:
            stream.flush()
    except OSError:
        output.silence(stream)


def _show_traceback(error: BaseException) -> None:
    import traceback

    output.message("".join(traceback.format_exception(error)).rstrip())
