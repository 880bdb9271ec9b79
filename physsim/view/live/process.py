"""The process that serves the page of a run that is watched: how it is started and what it says at first."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from contextlib import suppress
from typing import Any

MODULE = "physsim.view.live.server"


def start(port: int) -> subprocess.Popen[bytes]:
    """A fresh interpreter with the server in it; port 0: any that is free. Raises OSError.

    Messages go to its stdin, and it leaves when that ends; `address` reads what it says at first. Ctrl-C is
    not for it: it stands in a process group of its own, but in the same session, because where the kernel
    shares the processor between sessions first (autogroup) a lower priority would count for nothing.
    """
    own_group: dict[str, Any] = (
        {"creationflags": _windows_flags()} if sys.platform == "win32" else {"process_group": 0}
    )
    return subprocess.Popen(
        [sys.executable, "-P", "-m", MODULE, str(port)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(part for part in sys.path if part)},
        **own_group,
    )


def address(process: subprocess.Popen[bytes]) -> str:
    """Where the page is, once the server is there. Raises OSError with what it says when it is not."""
    said = _said(process)
    if "address" not in said:
        raise OSError(said.get("trouble", "the server of the page did not start"))
    return said["address"]


def last_words(process: subprocess.Popen[bytes]) -> str:
    """Why a server that told its address has ended."""
    return _said(process).get("trouble", "the server of the page has ended")


def end_of_messages(process: subprocess.Popen[bytes]) -> None:
    """Nothing more will be told."""
    assert process.stdin is not None
    with suppress(OSError):
        process.stdin.close()


def stop(process: subprocess.Popen[bytes]) -> None:
    """Ends the server, if it is still there."""
    process.kill()
    process.wait()


def hang_up(process: subprocess.Popen[bytes]) -> None:
    """Closes what leads to the server and from it."""
    end_of_messages(process)
    assert process.stdout is not None
    process.stdout.close()


def _said(process: subprocess.Popen[bytes]) -> dict[str, str]:
    """The next line of the server; empty when it ended without a word."""
    assert process.stdout is not None
    try:
        return dict(json.loads(process.stdout.readline()))
    except ValueError:
        return {}


def _windows_flags() -> int:
    names = ("CREATE_NEW_PROCESS_GROUP", "BELOW_NORMAL_PRIORITY_CLASS", "CREATE_NO_WINDOW")
    return sum(getattr(subprocess, name) for name in names)
