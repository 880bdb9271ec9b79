"""The recorder: takes frames as they come and writes them in blocks.

A block is written in two flushes: first everything but `/time`, then `/time`. So the shortest dataset is
always `/time`, and what it counts is whole, whenever the process is killed.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import Any

import h5py

from physsim.errors import FileTrouble
from physsim.recording import checkpoint as slots
from physsim.recording.checkpoint import Checkpoint
from physsim.recording.create import LIBVER, block_frames, create_file
from physsim.recording.growth import Growing
from physsim.recording.layout import Column, Status
from physsim.recording.pending import Pending, Rows
from physsim.recording.safe import guarded
from physsim.recording.space import (
    RESERVE_BYTES,
    Flush,
    NoRoom,
    close_in_place,
    close_without_writing,
    room_for,
)
from physsim.recording.target import Target, is_being_written, plain

# A checkpoint, with the frames in hand, after this many seconds, so that a kill costs little work ...
SECONDS_BETWEEN_CHECKPOINTS = 5.0
# ... but only when this adds such a share to the open chunk: the chunk is stored anew each time.
LEAST_GROWTH = 0.25


class Recorder:
    """Appends to one trajectory file.

    Made by `Recorder.create` or `Recorder.resume`. Every method that writes raises FileTrouble when the
    disk takes no more; the file is closed then and holds all blocks written before.
    """

    def __init__(
        self, file: h5py.File, path: Path, columns: tuple[Column, ...], waiting: Target | None
    ) -> None:
        """`waiting`: the target whose name the file does not have yet."""
        self.path = path
        self.frames = int(file["time"].shape[0])
        self._file = file
        self._growing = Growing(file, columns)
        self._waiting = waiting
        self._pending = Pending()
        self._block = block_frames(file["body"].shape[0])
        self._last_checkpoint = time.monotonic()

    @classmethod
    def create(
        cls, target: Target, columns: tuple[Column, ...], attributes: Mapping[str, Any], values: Rows
    ) -> Recorder:
        """A new file; what stands under the target's name is left alone until `finish`.

        values: the fixed datasets by path; attributes: of the root. Raises FileTrouble when it cannot be
        made.
        """
        running = {**attributes, "status": "running", "status_detail": ""}
        return cls(create_file(target.part, columns, running, values), target.part, columns, target)

    @classmethod
    def resume(
        cls, path: Path, target: Target, columns: tuple[Column, ...], frames: int, events: int
    ) -> Recorder:
        """Goes on with the file at `path`, cut back to `frames` frames and `events` impacts.

        Raises FileTrouble when it cannot be opened for writing, or another process writes to it.
        """
        file = _reopened(path)
        with _told_plainly(path, file), guarded(path):
            room = Growing(file, columns).open_chunk_bytes + RESERVE_BYTES
        with _told_plainly(path, file), room_for(file, room) as flush, guarded(path):
            _cut(file, columns, frames, events, flush)
            file.attrs["status"], file.attrs["status_detail"] = "running", ""
            flush()
        return cls(file, path, columns, None if path == target.path else target)

    def append(self, step: int, frame_time: float, frame: Rows, contacts: Rows | None = None) -> None:
        """One frame. frame, contacts: rows by dataset path; None for contacts when they are not recorded."""
        number = self.frames + self._pending.frames
        if contacts is not None:
            self._pending.add_contacts(contacts, number, self._growing.rows("contacts/frame"))
        self._pending.add_frame({"time": frame_time, "step": step, **frame})

    def append_events(self, events: Rows) -> None:
        """Impacts since the last call, rows by dataset path."""
        self._pending.add_rows(events)

    @property
    def block_is_full(self) -> bool:
        """Whether the frames in hand fill a chunk and should be written now."""
        return self._pending.frames + self.frames % self._block >= self._block

    @property
    def checkpoint_is_due(self) -> bool:
        """Whether it is time to save the engine, and the frames in hand with it."""
        waited = time.monotonic() - self._last_checkpoint
        worth_it = self._pending.frames >= LEAST_GROWTH * (self.frames % self._block)
        return waited > SECONDS_BETWEEN_CHECKPOINTS and worth_it

    def write_block(self) -> None:
        """Writes the frames in hand."""
        with _told_plainly(self.path, self._file), self._room() as flush:
            self._commit(flush)
        self._take_free_name()

    def write_checkpoint(self, engine: bytes, step: int) -> None:
        """Writes the frames in hand and the engine's state after `step` steps, down to the disk itself."""
        with _told_plainly(self.path, self._file), self._room(len(engine)) as flush:
            self._commit(flush)
            slots.save(self._file, self._checkpoint(engine, step))
            self._sync(flush)
        self._last_checkpoint = time.monotonic()
        self._take_free_name()

    def finish(
        self, status: Status, detail: str, engine: bytes | None, step: int, provenance: Mapping[str, Any]
    ) -> Path:
        """Writes what is in hand, the last checkpoint, the status; closes; gives the file its name.

        engine: None leaves the checkpoints as they are (after a failure). Returns where the file is: under
        the target's name, unless a failed run with nothing but its first frame would replace an old file.
        """
        with _told_plainly(self.path, self._file), self._room(len(engine or b"")) as flush:
            self._commit(flush)
            if engine is not None:
                slots.save_last(self._file, self._checkpoint(engine, step), flush)
            for path, value in provenance.items():
                self._file[path][()] = value
            self._file.attrs["status"], self._file.attrs["status_detail"] = status, detail
            self._sync(flush)
        with _told_plainly(self.path, self._file):
            self._file.close()
        self._take_free_name()
        if self._waiting and (status == "complete" or self.frames > 1):
            self._publish(self._waiting)
        return self.path

    def _room(self, engine_bytes: int = 0) -> AbstractContextManager[Flush]:
        """Twice the rows and the engine: compression may fail to shrink, and HDF5 has its own bookkeeping."""
        rows = 2 * (self._pending.bytes + engine_bytes)
        return room_for(self._file, self._growing.open_chunk_bytes + rows + RESERVE_BYTES)

    def _commit(self, flush: Flush) -> None:
        self._growing.append_all_but_time(self._pending)
        flush()
        self._growing.append_time(self._pending)
        flush()
        self.frames += self._pending.frames
        self._pending = Pending()

    def _sync(self, flush: Flush) -> None:
        flush()
        os.fsync(self._file.id.get_vfd_handle())

    def _checkpoint(self, engine: bytes, step: int) -> Checkpoint:
        return Checkpoint(engine, step, self.frames, self._growing.rows("events/time"))

    def _take_free_name(self) -> None:
        if self._waiting and not self._waiting.path.exists():
            self._publish(self._waiting)

    def _publish(self, target: Target) -> None:
        target.publish()
        self.path, self._waiting = target.path, None


def _reopened(path: Path) -> h5py.File:
    if is_being_written(path):
        raise FileTrouble(f"{path}: another run is writing to it")
    try:
        return h5py.File(path, "r+", libver=LIBVER, locking="best-effort")
    except (OSError, RuntimeError) as error:
        raise FileTrouble(f"{path}: cannot be continued: {plain(error)}") from error


def _cut(file: h5py.File, columns: tuple[Column, ...], frames: int, events: int, flush: Flush) -> None:
    """Shortens every growing dataset, `/time` first: the shortest tells what is whole."""
    file["time"].resize(frames, axis=0)
    flush()
    contacts = int(file["contacts/offset"][frames]) if "contacts" in file else 0
    lengths = {"time": frames, "event": events, "boundary": frames + 1, "contact": contacts}
    Growing(file, columns).cut(lengths)


@contextmanager
def _told_plainly(path: Path, file: h5py.File) -> Iterator[None]:
    """Turns a failed write into FileTrouble, with the file closed as the last flush left it."""
    try:
        yield
    except NoRoom as error:
        close_in_place(file, {"status": "interrupted", "status_detail": plain(error)})
        raise FileTrouble(_writing_failed(path, error)) from error
    except (OSError, RuntimeError) as error:
        close_without_writing(file)
        raise FileTrouble(_writing_failed(path, error)) from error
    except FileTrouble:
        close_without_writing(file)
        raise


def _writing_failed(path: Path, error: Exception) -> str:
    kept = "the frames written before are kept, --resume goes on from there"
    return f"{path}: writing failed: {plain(error)}; {kept}"
