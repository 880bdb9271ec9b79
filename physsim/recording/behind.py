"""Work that goes on behind the caller's back, one piece after the other."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor


class Behind:
    """A thread that does what it is given, in order.

    One piece may be under way while the next is made; who is further ahead waits, so that memory holds two.
    """

    def __init__(self, name: str) -> None:
        self._thread = ThreadPoolExecutor(1, thread_name_prefix=name)
        self._last: Future[None] | None = None

    def do(self, work: Callable[[], None]) -> None:
        """Begins with it as soon as what came before is done. Raises what went wrong with that."""
        self.settle()
        self._last = self._thread.submit(work)

    def check(self) -> None:
        """Raises what has gone wrong so far."""
        if self._last is not None and self._last.done():
            self._last.result()

    def settle(self) -> None:
        """Waits until all is done. Raises what went wrong, and goes on doing so."""
        if self._last is not None:
            self._last.result()

    def close(self) -> None:
        """No more work."""
        self._thread.shutdown()
