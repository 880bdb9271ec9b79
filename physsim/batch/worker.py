"""The worker process: `python -m physsim.batch.worker`, driven by `local` through its stdin and stdout.

It reads a job and folders, says that it is ready, and then answers each block with a list of results, or
with the exception that ends the sweep. Nothing but pickles between the two processes of one user passes.
"""

from __future__ import annotations

import os
import pickle
import sys
import threading
from pathlib import Path
from queue import SimpleQueue
from typing import IO, Any

from physsim.batch.workshop import Workshop
from physsim.errors import PhyssimError
from physsim.simulation import Interrupted

READY = "ready"


def main() -> None:
    """Until stdin closes."""
    orders, answers = sys.stdin.buffer, _take_stdout()
    try:
        job, scenes, results = pickle.load(orders)
        workshop = Workshop(job, Path(scenes), Path(results))
    except PhyssimError as error:
        _send(answers, error)
        return
    _send(answers, READY)
    blocks: SimpleQueue[Any] = SimpleQueue()
    threading.Thread(target=_listen, args=(orders, blocks), daemon=True).start()
    while True:
        try:
            _send(answers, [workshop.do(task) for task in blocks.get()])
        except Interrupted:
            return  # told to stop by somebody else: the block is given to another worker
        except PhyssimError as error:
            _send(answers, error)


def _take_stdout() -> IO[bytes]:
    """The stream of answers; whatever else prints to stdout is sent to stderr."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return answers


def _send(answers: IO[bytes], answer: Any) -> None:
    pickle.dump(answer, answers)
    answers.flush()


def _listen(orders: IO[bytes], blocks: SimpleQueue[Any]) -> None:
    """When whoever gave the orders is gone, so is the worker, even in the middle of a run."""
    try:
        while True:
            blocks.put(pickle.load(orders))
    except (EOFError, OSError, pickle.UnpicklingError):
        os._exit(0)


if __name__ == "__main__":
    main()
