"""The journal: one line per run that is done, appended as results come, so that a kill costs a block at most.

A line that a kill has torn is cut off when the journal is opened again. Results are found by the key of
their run, so that a sweep that has grown does only what is new.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import IO

from physsim.batch.workshop import CRASHED, Result
from physsim.errors import FileTrouble


class Journal:
    """An open journal, locked against other sweeps. results: by key of the run."""

    def __init__(self, path: Path) -> None:
        """Raises FileTrouble when it cannot be written, or another sweep writes to it."""
        self.path = path
        self.results: dict[str, Result] = {}
        try:
            self._file = path.open("a+b")
        except OSError as error:
            raise FileTrouble(f"{path}: cannot be written: {error.strerror}") from None
        _lock(self._file, path)
        self._file.truncate(self._read())

    def append(self, results: Iterable[Result]) -> None:
        """Results of runs, down to the disk itself. Raises FileTrouble when it takes no more."""
        found = list(results)
        lines = "".join(f"{json.dumps(result.as_dict())}\n" for result in found)
        try:
            self._file.write(lines.encode())
            self._file.flush()
            os.fsync(self._file.fileno())
        except OSError as error:
            raise FileTrouble(f"{self.path}: writing failed: {error.strerror}") from None
        self.results |= {result.key: result for result in found}

    def close(self) -> None:
        """Lets go of the file."""
        self._file.close()

    def is_done(self, key: str) -> bool:
        """Whether the run of this key has a result that stands, and its trajectory is there if it had one.

        A run that took its worker with it is tried again: the machine may have been short of memory.
        """
        result = self.results.get(key)
        if result is None or result.status == CRASHED:
            return False
        return not result.file or (self.path.parent / result.file).exists()

    def _read(self) -> int:
        """Reads all whole lines and returns where they end."""
        self._file.seek(0)
        end = 0
        for line in self._file:
            try:
                result = Result(**json.loads(line))
            except (ValueError, TypeError):
                break
            if not line.endswith(b"\n"):
                break
            self.results[result.key] = result
            end += len(line)
        return end


def _lock(file: IO[bytes], path: Path) -> None:
    if sys.platform == "win32":
        return
    import fcntl  # noqa: PLC0415, not on every system

    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise FileTrouble(f"{path.parent}: another sweep is writing to this folder") from None
