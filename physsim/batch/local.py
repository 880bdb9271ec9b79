"""Worker processes on this machine.

Each is a fresh interpreter (nothing is inherited by fork: HDF5 and threads do not survive it, and a script
that sweeps needs no `if __name__ == "__main__"`), driven by a thread here. Workers are a session of their
own, so that Ctrl-C reaches only the process that knows what to do about it.
"""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from physsim import one_thread
from physsim.batch.backlog import Block
from physsim.batch.job import Job
from physsim.batch.place import Answer
from physsim.errors import PhyssimError


class LocalPlace:
    """`workers` processes. scenes: folder of the scene's files; results: folder of the sweep."""

    def __init__(
        self, job: Job, scenes: Path, results: Path, workers: int, answers: SimpleQueue[Answer]
    ) -> None:
        self.slots = workers
        self._blocks: SimpleQueue[Block | None] = SimpleQueue()
        start = pickle.dumps((job, str(scenes.absolute()), str(results.absolute())))
        self._hands = [_Hand(start, self._blocks, answers) for _ in range(workers)]
        for hand in self._hands:
            hand.start()

    def submit(self, block: Block) -> None:
        """For the first worker that is free."""
        self._blocks.put(block)

    def close(self) -> None:
        """Kills the workers."""
        for hand in self._hands:
            hand.stop()
        for _ in self._hands:
            self._blocks.put(None)
        for hand in self._hands:
            hand.join()


class _Hand(threading.Thread):
    """Drives one worker process; starts another when it dies."""

    def __init__(self, start: bytes, blocks: SimpleQueue[Block | None], answers: SimpleQueue[Answer]) -> None:
        super().__init__(daemon=True)
        self._start = start
        self._blocks, self._answers = blocks, answers
        self._process: subprocess.Popen[bytes] | None = None
        self._lock = threading.Lock()
        self._stopped = False

    def run(self) -> None:
        """Until there is no block any more. The worker is started before the first one is there."""
        trouble = self._make_ready()
        while (block := self._blocks.get()) is not None:
            trouble = trouble or self._make_ready()
            self._answers.put(Answer(block, trouble=trouble) if trouble else self._worked(block))
        self.stop()
        if self._process is not None:
            self._last_words()

    def stop(self) -> None:
        """Kills the worker, if there is one; none is started afterwards."""
        with self._lock:
            self._stopped = True
            if self._process is not None:
                self._process.kill()

    def _worked(self, block: Block) -> Answer:
        try:
            answer = self._exchange(block)
        except (OSError, EOFError, pickle.UnpicklingError):
            return Answer(block, reason=self._last_words())
        return Answer(block, trouble=answer) if isinstance(answer, Exception) else Answer(block, answer)

    def _make_ready(self) -> Exception | None:
        """A worker that is ready, or why there is none."""
        if self._process is not None:
            return None
        with self._lock:
            if self._stopped:
                return PhyssimError("the sweep is over")
            self._process = _started()
        try:
            self._write(self._start)
            answer = self._read()
        except (OSError, EOFError, pickle.UnpicklingError):
            return PhyssimError(f"a worker process could not be started: {self._last_words()}")
        return answer if isinstance(answer, Exception) else None

    def _exchange(self, block: Block) -> Any:
        self._write(pickle.dumps(block))
        return self._read()

    def _write(self, data: bytes) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        self._process.stdin.write(data)
        self._process.stdin.flush()

    def _read(self) -> Any:
        assert self._process is not None
        assert self._process.stdout is not None
        return pickle.load(self._process.stdout)

    def _last_words(self) -> str:
        """How the process ended; it is forgotten, so that the next block gets another."""
        assert self._process is not None
        process, self._process = self._process, None
        process.kill()
        with process:
            code = process.wait()
        return (
            f"its worker was killed by {_signal_name(-code)}" if code < 0 else f"its worker exited ({code})"
        )


def _started() -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-P", "-m", "physsim.batch.worker"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=_environment(),
        start_new_session=True,
    )


def _environment() -> dict[str, str]:
    """Ours, with the folder of this package first: `-P` keeps the working directory out of the search."""
    here = str(Path(__file__).resolve().parents[2])
    path = os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")]))
    return {**one_thread.environment(), "PYTHONPATH": path}


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"
