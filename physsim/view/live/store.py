"""What the server of a watched run keeps for pages that come late: frames, thinner the older they are."""

from __future__ import annotations

import threading
from dataclasses import dataclass

# Of frames; with 500 bodies that is 1200 frames, 40 s at full rate, before the first are thinned out.
MOST_BYTES = 64 * 1024 * 1024
# The newest part of what is kept, which is not thinned out.
RECENT = 0.25
# A page that is so many frames behind while the run goes on gets fewer of them, so that it catches up.
MOST_BEHIND = 60


@dataclass(frozen=True, slots=True)
class Kept:
    """A frame. number: as it was recorded, rising; arrival: as it came; data: its bytes as a message."""

    number: int
    arrival: int
    data: bytes


class Store:
    """Frames as messages, in the order they came, and the message of the end. Safe between threads."""

    def __init__(self, most_bytes: int = MOST_BYTES) -> None:
        self._most_bytes = most_bytes
        self._changed = threading.Condition()
        self._frames: list[Kept] = []
        self._bytes = 0
        self._arrivals = 0
        self._stride = 1
        self._end: bytes | None = None

    def add(self, number: int, data: bytes) -> None:
        """A new frame; older ones give way when there are too many bytes."""
        with self._changed:
            self._frames.append(Kept(number, self._arrivals, data))
            self._arrivals += 1
            self._bytes += len(data)
            if self._bytes > self._most_bytes:
                self._thin_out()
            self._changed.notify_all()

    def finish(self, data: bytes) -> None:
        """The message of the end: no frames will come any more."""
        with self._changed:
            self._end = data
            self._changed.notify_all()

    def has_all(self, frames: int) -> bool:
        """Whether nothing is missing of so many frames."""
        with self._changed:
            return len(self._frames) == frames

    def after(self, number: int, seconds: float) -> tuple[list[Kept], bytes | None]:
        """Frames later than `number`, and the end when there are no others to come.

        Waits for either, but no longer than `seconds`.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._later(number) or self._end is not None, seconds)
            return self._later(number), self._end

    def _later(self, number: int) -> list[Kept]:
        first = len(self._frames)
        while first > 0 and self._frames[first - 1].number > number:
            first -= 1
        return self._frames[first:]

    def _thin_out(self) -> None:
        """Drops older frames, evenly over time, until a tenth of the room is free.

        Of the older part stay the arrivals that a stride divides. The stride doubles when that is not enough;
        so the density is the same from the first frame to the recent ones, and the first frame always stays.
        """
        goal = 0.9 * self._most_bytes
        while self._bytes > goal and len(self._frames) > 2:
            recent = max(int((1 - RECENT) * len(self._frames)), 1)
            old = [kept for kept in self._frames[:recent] if kept.arrival % self._stride == 0]
            self._frames = old + self._frames[recent:]
            self._bytes = sum(len(kept.data) for kept in self._frames)
            if self._bytes > goal:
                self._stride *= 2


def caught_up(frames: list[Kept]) -> list[Kept]:
    """No more than `MOST_BEHIND` of them, evenly chosen, with the newest."""
    stride = max(-(-len(frames) // MOST_BEHIND), 1)
    return frames[::-1][::stride][::-1]
