"""The file under HDF5: writes wait in memory until a flush, and then reach the disk in an order that is safe.

Left to itself HDF5 writes new blocks, indexes and headers in the order of their place. A kill in between
leaves headers that point to indexes not yet written (seen in 1 of 200 kills of a writer that did nothing
but flush), and after a failed write it leaves a file that cannot be opened, cannot be closed, and crashes
the interpreter at exit.

Here, at each flush, the room is claimed first, then everything beyond the old end is written, then what
replaces older bytes, from the start of the file on. Nothing on the disk ever points to what is not there.
Long pieces beyond the old end (chunks) need not wait for the flush: nothing on the disk points to them yet.

An error is kept in `error` and never shown to HDF5, which can then close the file in peace; the file on
disk stays as the last flush left it.
"""

from __future__ import annotations

import contextlib
import errno
import io
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

PAGE = 4096
# Pieces beyond the old end of at least so many bytes are written at once.
LONG = 4 * PAGE

_NO_SUCH_CALL = (errno.EOPNOTSUPP, errno.EINVAL, errno.ENOSYS)


class Disk(io.RawIOBase):
    """A file object for `h5py.File`. Raises OSError when the file cannot be opened or another process has
    it.
    """

    def __init__(self, path: Path, *, create: bool) -> None:
        super().__init__()
        self.error: Exception | None = None
        self._handle = os.open(path, os.O_RDWR | (os.O_CREAT if create else 0), 0o666)
        try:
            _lock(self._handle)
            if create:
                os.ftruncate(self._handle, 0)
        except OSError:
            os.close(self._handle)
            raise
        self._end = self._size = self._claimed = os.fstat(self._handle).st_size
        self._at = 0
        self._pages: dict[int, bytearray] = {}

    def readable(self) -> bool:
        return True

    def writable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        start = {os.SEEK_SET: 0, os.SEEK_CUR: self._at, os.SEEK_END: self._size}[whence]
        self._at = start + offset
        return self._at

    def tell(self) -> int:
        return self._at

    def readinto(self, buffer: Any) -> int:
        """Always fills the buffer, with zeros beyond the end."""
        view = memoryview(buffer).cast("B")
        view[:] = os.pread(self._handle, len(view), self._at).ljust(len(view), b"\0")
        for number, first, last in _pieces(self._at, len(view)):
            if number in self._pages:
                begin = number * PAGE - self._at
                view[begin + first : begin + last] = self._pages[number][first:last]
        self._at += len(view)
        return len(view)

    def write(self, data: Any) -> int:
        view = memoryview(data).cast("B")
        if len(view) >= LONG and self._at >= self._end:
            self._write_through(view, self._at)
        else:
            self._keep(view, self._at)
        self._at += len(view)
        self._size = max(self._size, self._at)
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        self._size = self._at if size is None else size
        return self._size

    def flush(self) -> None:
        """To the system, in the safe order. After an error nothing is written any more."""
        if self.error is None and not self.closed:
            with self._giving_up():
                self._commit()
        self._pages.clear()

    def give_up(self, error: Exception) -> None:
        """From now on nothing is written."""
        self.error = self.error or error

    def sync(self) -> None:
        """To the disk itself. Raises OSError."""
        os.fsync(self._handle)

    def close(self) -> None:
        if not self.closed:
            super().close()
            os.close(self._handle)

    def _keep(self, view: memoryview, at: int) -> None:
        """Lets bytes wait for the flush."""
        for number, first, last in _pieces(at, len(view)):
            begin = number * PAGE - at
            self._page(number)[first:last] = view[begin + first : begin + last]

    def _write_through(self, view: memoryview, at: int) -> None:
        """Writes beyond the old end, and into pages that wait there already."""
        for number in self._pages.keys() & range(at // PAGE, -(-(at + len(view)) // PAGE)):
            begin = number * PAGE - at
            first, last = max(-begin, 0), min(len(view) - begin, PAGE)
            self._pages[number][first:last] = view[begin + first : begin + last]
        if self.error is None:
            with self._giving_up():
                self._claim(at + len(view))
                _write_all(self._handle, view, at)

    def _page(self, number: int) -> bytearray:
        if number not in self._pages:
            beyond = number * PAGE >= self._claimed
            there = b"" if beyond else os.pread(self._handle, PAGE, number * PAGE)
            self._pages[number] = bytearray(there.ljust(PAGE, b"\0"))
        return self._pages[number]

    def _commit(self) -> None:
        old, new = self._end, self._size
        self._claim(new)
        runs = [(start, memoryview(data)[: max(new - start, 0)]) for start, data in self._runs()]
        for start, data in runs:
            _write_all(self._handle, data[max(old - start, 0) :], max(start, old))
        for start, data in runs:
            _write_all(self._handle, data[: max(old - start, 0)], start)
        if new < self._claimed:
            os.ftruncate(self._handle, new)
        self._end = self._claimed = new

    def _claim(self, new: int) -> None:
        """Room up to there."""
        if new > self._claimed:
            _claim(self._handle, self._claimed, new)
            self._claimed = new

    @contextlib.contextmanager
    def _giving_up(self) -> Iterator[None]:
        """An error ends all writing, and what is beyond the old end is given back."""
        try:
            yield
        except OSError as error:
            self.error = error
            with contextlib.suppress(OSError):
                os.ftruncate(self._handle, self._end)

    def _runs(self) -> Iterator[tuple[int, bytes]]:
        """Waiting pages that follow each other, together, in the order of their place."""
        numbers = sorted(self._pages)
        first = 0
        for index, number in enumerate(numbers):
            if index + 1 == len(numbers) or numbers[index + 1] != number + 1:
                together = b"".join(self._pages[some] for some in numbers[first : index + 1])
                yield numbers[first] * PAGE, together
                first = index + 1


def _pieces(start: int, length: int) -> Iterator[tuple[int, int, int]]:
    """`(page, first, last)`: the parts of pages that a range of the file covers."""
    end = start + length
    while start < end:
        number, first = divmod(start, PAGE)
        last = min(PAGE, first + end - start)
        yield number, first, last
        start += last - first


def _claim(handle: int, old: int, new: int) -> None:
    """Where the system cannot set room aside, the file is only made longer."""
    try:
        os.posix_fallocate(handle, old, new - old)
    except AttributeError:
        os.ftruncate(handle, new)
    except OSError as error:
        if error.errno not in _NO_SUCH_CALL:
            raise
        os.ftruncate(handle, new)


def _write_all(handle: int, data: memoryview, at: int) -> None:
    while data:
        written = os.pwrite(handle, data, at)
        data, at = data[written:], at + written


def _lock(handle: int) -> None:
    """The lock that HDF5 itself would take. File systems without locks go without."""
    if sys.platform == "win32":
        return
    import fcntl  # noqa: PLC0415, not on every system

    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:
        return
