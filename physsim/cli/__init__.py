"""The command line: one file per verb, and the few things that all verbs share.

Nothing here imports numpy, pydantic or yaml before a verb that needs them is called: `--help` answers at
once.
"""

from __future__ import annotations

from physsim.cli.app import main

__all__ = ["main"]
