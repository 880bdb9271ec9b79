"""The runs of `physsim verify` on all processors, before they are looked at: a matter of speed, nothing else.

Whatever fails here is left out; who needs the run does it again, and is told why it fails.
"""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from physsim.errors import PhyssimError

Job = tuple[str, dict[str, Any], Path]
"""Scene, changes, and the folder of the trajectory."""
WORTH_IT = 20
"""Fewer runs are over before a second process has started."""


def run_ahead(jobs: Sequence[Job], advance: Callable[[], object]) -> None:
    """Does the jobs in as many processes as there are processors; `advance` is called after each."""
    from concurrent.futures import ProcessPoolExecutor, as_completed
    from multiprocessing import get_context

    processors = os.cpu_count() or 1
    if processors == 1 or len(jobs) < WORTH_IT:
        return
    with ProcessPoolExecutor(processors, get_context("spawn")) as pool:
        waiting = [pool.submit(try_run, job) for job in jobs]
        try:
            for done in as_completed(waiting):
                done.result()
                advance()
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def try_run(job: Job) -> None:
    """One job in a process of its own."""
    from physsim.cli.verify_run import run

    with suppress(PhyssimError):
        run(*job).close()
