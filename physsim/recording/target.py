"""Where a trajectory goes: may this name be written, is there room, and when does the new file take the name.

A run writes to NAME.part beside NAME. When nothing stands under NAME the part takes it as soon as frame 0
is on disk, so that a killed run is found where it was asked for. An old file keeps the name until the new
run has ended.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
import sys
from dataclasses import dataclass
from pathlib import Path

from physsim.errors import FileTrouble

# What a file takes before its first frame.
SMALLEST_BYTES = 1 << 20
# No run measured so far compressed better than this (all bodies at rest: about 10).
BEST_COMPRESSION = 10.0


@dataclass(frozen=True)
class Target:
    """A name for a trajectory, and the working file beside it."""

    path: Path

    @property
    def part(self) -> Path:
        return part_of(self.path)

    def check(self, *, force: bool) -> None:
        """Raises FileTrouble when the name cannot be written, or is taken and `force` is not given."""
        folder = self.path.parent
        if not folder.is_dir():
            raise FileTrouble(f"{self.path}: the folder {folder} does not exist")
        if self.path.is_dir():
            raise FileTrouble(f"{self.path}: is a folder; name a file in it")
        if self.path.exists() and not stat.S_ISREG(self.path.stat().st_mode):
            raise FileTrouble(f"{self.path}: is not a regular file")
        if self.path.exists() and not force:
            raise FileTrouble(
                f"{self.path}: exists already; "
                "--force replaces it, --resume continues it, -o names another file"
            )
        if not os.access(folder, os.W_OK):
            raise FileTrouble(f"{self.path}: the folder {folder} cannot be written to")
        for file in (self.path, self.part):
            if is_being_written(file):
                raise FileTrouble(f"{file}: another run is writing to it")

    def check_space(self, expected_bytes: int) -> None:
        """Raises FileTrouble when `expected_bytes` of numbers cannot fit, however well they compress."""
        free = shutil.disk_usage(self.path.parent).free
        needed = int(expected_bytes / BEST_COMPRESSION) + SMALLEST_BYTES
        if free < needed:
            raise FileTrouble(
                f"{self.path}: not enough room on the disk: "
                f"at least {in_words(needed)} are needed, {in_words(free)} are free"
            )

    def publish(self) -> None:
        """Gives the working file the name; an old file of that name is gone from then on."""
        try:
            self.part.replace(self.path)
        except OSError as error:
            raise FileTrouble(f"{self.path}: {plain(error)}; the new run is in {self.part}") from error


def part_of(path: Path) -> Path:
    """The working file beside `path`."""
    return path.with_name(path.name + ".part")


def is_being_written(path: Path) -> bool:
    """Whether a living process holds the file for writing (by the lock that HDF5 puts on it)."""
    if sys.platform == "win32":
        return False
    import fcntl  # noqa: PLC0415, not on every system

    with contextlib.suppress(FileNotFoundError, PermissionError), path.open("rb") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        except OSError:
            return False
    return False


def plain(error: BaseException) -> str:
    """The reason in words: the system's own for an OSError with a number, else the first line of the
    message.
    """
    number = getattr(error, "errno", None)
    if number:
        return os.strerror(number).lower()
    for word, reason in _KNOWN_REASONS.items():
        if word in str(error):
            return reason
    lines = str(error).splitlines()
    return lines[0] if lines else type(error).__name__


_KNOWN_REASONS = {
    "No space left": "no space left on the disk",
    "File too large": "the file may not grow further (size limit)",
    "Disk quota": "the disk quota is used up",
    "Permission denied": "permission denied",
    "Read-only file system": "the disk is read-only",
    "unable to lock file": "another program is using the file",
}


def in_words(count: float) -> str:
    """`3500000` -> `3.5 MB`."""
    for unit in ("bytes", "kB", "MB", "GB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"
