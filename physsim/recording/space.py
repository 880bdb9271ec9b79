"""Room on the disk, claimed before it is needed.

HDF5 goes on after a failed write: it leaves a file that points past its own end, cannot be closed any more,
and the interpreter crashes when it exits (seen with HDF5 2.0). So every block claims its room from
the system first.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from physsim.recording.superblock import tell_end

RESERVE_BYTES = 256 * 1024

Flush = Callable[[], None]


class NoRoom(OSError):
    """The system has no room for the next block. HDF5 has not been touched."""


@contextlib.contextmanager
def room_for(file: Any, more_bytes: int) -> Iterator[Flush]:
    """The system sets aside `more_bytes` beyond the end of an open HDF5 file; what is left is given back.

    Gives the function that flushes: nothing else may write inside the block, which must end with it.
    Raises NoRoom (disk full, quota, size limit) before the block is entered.
    """
    handle = file.id.get_vfd_handle()
    end = os.fstat(handle).st_size + more_bytes
    _claim(handle, end)

    def flush() -> None:
        tell_end(handle, end)
        file.flush()

    yield flush
    end = file.id.get_filesize()
    tell_end(handle, end)
    os.ftruncate(handle, end)


def _claim(handle: int, end: int) -> None:
    size = os.fstat(handle).st_size
    try:
        if hasattr(os, "posix_fallocate"):
            os.posix_fallocate(handle, size, end - size)
        else:
            os.ftruncate(handle, end)
    except OSError as error:
        with contextlib.suppress(OSError):
            os.ftruncate(handle, size)
        raise NoRoom(error.errno, error.strerror) from error


def close_in_place(file: Any, attributes: Mapping[str, Any]) -> None:
    """Sets root attributes and closes, if that can be done without making the file longer; else only
    closes.
    """
    for name, value in attributes.items():
        file.attrs[name] = value
    if file.id.get_filesize() > os.fstat(file.id.get_vfd_handle()).st_size:
        close_without_writing(file)
    else:
        file.close()


def close_without_writing(file: Any) -> None:
    """Closes an HDF5 file whose disk takes no more: what HDF5 still wants to write goes nowhere.

    The file on disk stays as the last flush left it.
    """
    if not file:
        return
    nowhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(nowhere, file.id.get_vfd_handle())
    os.close(nowhere)
    with contextlib.suppress(OSError, RuntimeError):
        file.close()
