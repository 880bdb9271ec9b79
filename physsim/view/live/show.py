"""A run that is shown: its page, its frames, and who is looking."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache

from physsim.view.live.store import Store

MOST_STREAMS = 16


class Show:
    """The page, once there is one, and the frames. Safe between threads."""

    def __init__(self) -> None:
        self.store = Store()
        self.rest: Callable[[], bytes] = bytes
        self._changed = threading.Condition()
        self._page: bytes | None = None
        self._closed = False
        self._expected = False
        self._visits = 0
        self._streams = 0

    def open(self, page: bytes, *, expected: bool) -> None:
        """There is a page now. expected: somebody is on the way to it."""
        with self._changed:
            self._page = page
            self._expected = expected and self._visits == 0
            self._changed.notify_all()

    def finish(self, end: bytes, rest: Callable[[], bytes]) -> None:
        """The run is over. end: the message that says so; rest: makes what is sent after it, when wanted."""
        made, lock = cache(rest), threading.Lock()

        def once() -> bytes:
            with lock:
                return made()

        self.rest = once
        self.store.finish(end)

    def close(self) -> None:
        """Nothing new will come."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def visit(self) -> bytes | None:
        """The page, when there is one, for somebody who will ask for its frames next; None: never."""
        with self._changed:
            self._expected = False
            self._visits += 1
            self._changed.wait_for(lambda: self._page is not None or self._closed)
            self._visits -= self._page is None
            return self._page

    @contextmanager
    def stream(self) -> Iterator[bool]:
        """While somebody fetches frames; gives whether there is room for one more."""
        with self._changed:
            self._visits = max(self._visits - 1, 0)
            self._streams += 1
            room = self._streams <= MOST_STREAMS
        try:
            yield room
        finally:
            with self._changed:
                self._streams -= 1
                self._changed.notify_all()

    def wait_until_seen(self, seconds: float) -> None:
        """Until everybody has what there is, but no longer than `seconds`."""
        with self._changed:
            self._changed.wait_for(lambda: not (self._expected or self._visits or self._streams), seconds)
