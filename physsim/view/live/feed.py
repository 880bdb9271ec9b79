"""Hands what a run records to those who watch it, without ever holding it up.

The run leaves the newest frame in a place and goes on. A thread looks there `FRAMES_PER_SECOND` times a
second and writes what is new down a pipe to a process of its own, which serves the page; when that
process is slow the thread waits, and the frames between are not seen. The thread works while the engine
steps, which does so without Python's lock. A thread, and not a pipe that never blocks: a frame may be larger
than a pipe, and this way is the same on all systems.
"""

from __future__ import annotations

import subprocess
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from physsim.view.live import process as live_process
from physsim.view.live.wire import Message, encoded

FRAMES_PER_SECOND = 30.0
# After the end of the run the server hands out what is left, and gives up by itself sooner than this.
LAST_SECONDS = 10.0
SECONDS_BETWEEN_LOOKS = 0.2

Rows = Mapping[str, Any]
_OF_CONTACTS = tuple(f"contacts/{name}" for name in ("body_a", "body_b", "position", "force", "sliding"))
_NOT_SHOWN = ("provenance/", "pairs/")


# Number, step, time, rows and contacts. A plain tuple, as a run may make many thousands of them a second.
_Frame = tuple[int, int, float, Rows, Rows | None]


class Feed:
    """An onlooker of `physsim.simulation.run`, and the server process behind it; a context to be left.

    announce: called with the page's address when the run begins; says whether a page is on its way there.
    trouble: called with one line when the server fails; the run goes on. Both are called in another thread.
    """

    def __init__(
        self, announce: Callable[[str], bool], trouble: Callable[[str], None], *, port: int = 0
    ) -> None:
        """Raises OSError when no process can be started. port: of the page; 0 for any that is free."""
        self._announce = announce
        self._trouble = trouble
        self._opening: Message | None = None
        self._first: _Frame | None = None
        self._newest: _Frame | None = None
        self._ending: Message | None = None
        self._complained = False
        self._begun, self._over = threading.Event(), threading.Event()
        self._settled = threading.Event()
        self._process = live_process.start(port)
        self._thread = threading.Thread(target=self._carry, name="physsim-watch", daemon=True)
        self._thread.start()

    def begin(self, title: str, file: Path, duration: float, fixed: Rows) -> None:
        """Who takes part. duration: simulated [s]; fixed: datasets that do not grow, by path."""
        found = {path: np.asarray(value) for path, value in fixed.items() if not path.startswith(_NOT_SHOWN)}
        texts = {path: array.tolist() for path, array in found.items() if array.dtype.kind in "OU"}
        numbers = {path: array for path, array in found.items() if path not in texts}
        facts = {"title": title, "file": str(file.absolute()), "duration": duration, "texts": texts}
        self._opening = Message("begin", facts, numbers)
        self._begun.set()

    def frame(self, number: int, step: int, time: float, rows: Rows, contacts: Rows | None) -> None:
        """A recorded frame: seen when it is the first, or still the newest when the thread looks."""
        self._newest = number, step, time, rows, contacts
        if self._first is None:
            self._first = self._newest

    def end(self, status: str, detail: str) -> None:
        """How the run ended; the last frame is always seen."""
        frames = 0 if self._newest is None else self._newest[0] + 1
        self._ending = Message("end", {"status": status, "detail": detail, "frames": frames})
        self._over.set()

    @property
    def _began(self) -> bool:
        return self._opening is not None

    def has_page(self) -> bool:
        """Whether there is anything to be seen. Waits until the server has said where, or has failed."""
        if self._began:
            self._settled.wait()
        return self._began and self._process.poll() is None

    def stay(self) -> None:
        """Serves what there is until the server ends or a KeyboardInterrupt is raised."""
        while self._process.poll() is None:
            time.sleep(SECONDS_BETWEEN_LOOKS)

    def close(self) -> None:
        """Pages get what is left, for a few seconds at most; then the server is gone."""
        self._over.set()
        self._begun.set()
        try:
            if self._began:
                self._say_goodbye()
        except (subprocess.TimeoutExpired, KeyboardInterrupt):
            pass
        finally:
            live_process.stop(self._process)
            self._thread.join()
            live_process.hang_up(self._process)

    def _say_goodbye(self) -> None:
        """The server leaves when its pipe ends, which must not be closed while the thread writes."""
        self._thread.join(LAST_SECONDS)
        if self._thread.is_alive():
            return
        live_process.end_of_messages(self._process)
        if self._process.wait(LAST_SECONDS):
            self._complain(live_process.last_words(self._process))

    def _carry(self) -> None:
        """The thread: everything that is told, in order."""
        try:
            address = live_process.address(self._process)
            self._begun.wait()
            if self._opening is not None:
                on_its_way = self._announce(address)
                self._settled.set()
                self._send(self._opening, on_its_way=on_its_way)
                self._send_frames()
        except BrokenPipeError:
            self._complain(live_process.last_words(self._process))
        except OSError as error:
            if self._began or not self._over.is_set():
                self._complain(str(error))
        finally:
            self._settled.set()

    def _complain(self, words: str) -> None:
        if not self._complained:
            self._complained = True
            self._trouble(words)

    def _send_frames(self) -> None:
        sent = None
        over = False
        while not over:
            over = self._over.wait(1 / FRAMES_PER_SECOND)
            for frame in (self._first, self._newest):
                if frame is not None and (sent is None or frame[0] > sent):
                    self._send(_message(frame))
                    sent = frame[0]
        if self._ending is not None:
            self._send(self._ending)

    def _send(self, message: Message, **more: Any) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(encoded(Message(message.kind, {**message.facts, **more}, message.arrays)))
        self._process.stdin.flush()


def _message(frame: _Frame) -> Message:
    number, step, time, rows, contacts = frame
    shown = {} if contacts is None else {path: contacts[path] for path in _OF_CONTACTS}
    return Message("frame", {"frame": number, "step": step, "time": time}, {**rows, **shown})
