"""Processes as a shell starts them: with a clean environment, in a pipe or on a terminal."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
PHYSSIM = [sys.executable, "-m", "physsim"]


def clean_environment(**more: str) -> dict[str, str]:
    """The environment without what changes our output, and with this checkout importable from any folder."""
    ours = ("NO_COLOR", "FORCE_COLOR", "PHYSSIM_DEBUG", "COLUMNS", "DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    kept = {name: value for name, value in os.environ.items() if name not in ours}
    return kept | {"PYTHONPATH": str(REPOSITORY)} | more


@contextmanager
def running(
    command: list[str],
    folder: Path,
    *,
    stdout: int = subprocess.PIPE,
    stderr: int = subprocess.PIPE,
    **environment: str,
) -> Iterator[subprocess.Popen[str]]:
    """A command in a process of its own, killed at the end if it is still there."""
    with subprocess.Popen(
        command,
        cwd=folder,
        env=clean_environment(**environment),
        stdin=subprocess.DEVNULL,
        stdout=stdout,
        stderr=stderr,
        text=True,
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def deaf_to_ctrl_c(command: list[str]) -> list[str]:
    """The command, started as a shell starts what runs in the background: with SIGINT ignored."""
    return ["/bin/sh", "-c", "trap '' INT; exec \"$@\"", "-", *command]


def on_a_terminal(arguments: list[str], folder: Path, **environment: str) -> tuple[str, str]:
    """stdout, in a pipe, and what a terminal behind stderr got to see."""
    master, slave = pty.openpty()
    environment = {"TERM": "xterm-256color"} | environment
    with running([*PHYSSIM, *arguments], folder, stderr=slave, **environment) as child:
        os.close(slave)
        seen = read_until_closed(master)
        out, _ = child.communicate(timeout=60)
    return out, seen


def read_until_closed(master: int) -> str:
    """Everything from a terminal; Linux says EIO when the other end has closed."""
    seen = b""
    try:
        while chunk := os.read(master, 65536):
            seen += chunk
    except OSError:
        pass
    os.close(master)
    return seen.decode()
