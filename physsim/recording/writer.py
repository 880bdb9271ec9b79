"""The writer of a trajectory file: frames in hand become a block on the disk.

A block is written in two flushes: first everything but `/time`, then `/time`. So the shortest dataset is
always `/time`, and what it counts is whole, whenever the process is killed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import h5py

from physsim.errors import FileTrouble
from physsim.recording import checkpoint as slots
from physsim.recording.block import Rows
from physsim.recording.checkpoint import Checkpoint
from physsim.recording.column import Column
from physsim.recording.create import LIBVER, fill_new_file
from physsim.recording.disk import Disk
from physsim.recording.growth import Growing
from physsim.recording.layout import Status
from physsim.recording.pending import Pending
from physsim.recording.safe import guarded
from physsim.recording.target import Target, plain


class Writer:
    """Appends to one trajectory file.

    Made by `Writer.create` or `Writer.resume`. Every method that writes raises FileTrouble when the disk
    takes no more; the file is closed then and holds all blocks written before. path: where the file is;
    frames: how many are on the disk.
    """

    def __init__(
        self, file: h5py.File, disk: Disk, path: Path, columns: tuple[Column, ...], waiting: Target | None
    ) -> None:
        """`waiting`: the target whose name the file does not have yet."""
        self.path = path
        self.frames = int(file["time"].shape[0])
        self.bodies = int(file["body"].shape[0])
        self._file = file
        self._disk = disk
        self._growing = Growing(file, columns)
        self._waiting = waiting

    @classmethod
    def create(
        cls, target: Target, columns: tuple[Column, ...], attributes: Mapping[str, Any], values: Rows
    ) -> Writer:
        """A new file; what stands under the target's name is left alone until `finish`.

        values: the fixed datasets by path; attributes: of the root. Raises FileTrouble when it cannot be
        made.
        """
        try:
            disk = Disk(target.part, create=True)
        except OSError as error:
            raise FileTrouble(f"{target.part}: cannot be written: {plain(error)}") from error
        running = {**attributes, "status": "running", "status_detail": ""}
        return cls(fill_new_file(disk, columns, running, values), disk, target.part, columns, target)

    @classmethod
    def resume(
        cls, path: Path, target: Target, columns: tuple[Column, ...], frames: int, events: int
    ) -> Writer:
        """Goes on with the file at `path`, cut back to `frames` frames and `events` impacts.

        Raises FileTrouble when it cannot be opened for writing, or another process writes to it.
        """
        file, disk = _reopened(path)
        writer = cls(file, disk, path, columns, None if path == target.path else target)
        with writer._told_plainly(), guarded(path):
            writer._cut(frames, events)
        return writer

    def write_part(self, pending: Pending) -> None:
        """Packs the frames in hand. They do not count, and a kill loses them, until a block ends."""
        with self._told_plainly():
            self._growing.append(pending)

    def write_block(self, pending: Pending) -> None:
        """Writes the frames in hand."""
        with self._told_plainly():
            self._commit(pending)
        self._take_free_name()

    def write_checkpoint(self, pending: Pending, engine: bytes, step: int) -> None:
        """Writes the frames in hand and the engine's state after `step` steps, down to the disk itself."""
        with self._told_plainly():
            self._commit(pending)
            slots.save(self._file, self._checkpoint(engine, step))
            self._flush()
            self._disk.sync()
        self._take_free_name()

    def finish(
        self,
        pending: Pending,
        *,
        status: Status,
        detail: str,
        engine: bytes | None,
        step: int,
        provenance: Mapping[str, Any],
    ) -> None:
        """Writes what is in hand, the last checkpoint, the status; closes; gives the file its name.

        engine: None leaves the checkpoints as they are (after a failure). The file is then under the target's
        name, unless a failed run with nothing but its first frame would replace an old file.
        """
        with self._told_plainly():
            self._commit(pending)
            if engine is not None:
                slots.save_last(self._file, self._checkpoint(engine, step), self._flush)
            for path, value in provenance.items():
                self._file[path][()] = value
            _set_status(self._file, status, detail)
            self._flush()
            self._disk.sync()
            self._close()
        self._take_free_name()
        if self._waiting and (status == "complete" or self.frames > 1):
            self._publish(self._waiting)

    def _commit(self, pending: Pending) -> None:
        self._growing.append(pending)
        self._growing.settle()
        self._flush()
        self._growing.append_times()
        self._flush()
        self.frames = self._growing.rows("time")

    def _cut(self, frames: int, events: int) -> None:
        """Shortens every growing dataset, `/time` first: the shortest tells what is whole."""
        contacts = int(self._file["contacts/offset"][frames]) if "contacts" in self._file else 0
        self._file["time"].resize(frames, axis=0)
        self._flush()
        self._growing.cut({"time": frames, "event": events, "boundary": frames + 1, "contact": contacts})
        _set_status(self._file, "running", "")
        self._flush()
        self.frames = frames

    def _flush(self) -> None:
        self._file.flush()
        if self._disk.error is not None:
            raise self._disk.error

    def _close(self) -> None:
        self._file.close()
        self._disk.close()
        if self._disk.error is not None:
            raise self._disk.error

    @contextmanager
    def _told_plainly(self) -> Iterator[None]:
        """Turns a failed write into FileTrouble, with the file closed as the last flush left it."""
        try:
            yield
        except (OSError, RuntimeError, FileTrouble) as error:
            self._disk.give_up(error)
            with suppress(OSError, RuntimeError):
                self._close()
            _mark_interrupted(self.path, plain(error))
            if isinstance(error, FileTrouble):
                raise
            kept = "the frames written before are kept, --resume goes on from there"
            raise FileTrouble(f"{self.path}: writing failed: {plain(error)}; {kept}") from error

    def _checkpoint(self, engine: bytes, step: int) -> Checkpoint:
        return Checkpoint(engine, step, self.frames, self._growing.rows("events/time"))

    def _take_free_name(self) -> None:
        if self._waiting and not self._waiting.path.exists():
            self._publish(self._waiting)

    def _publish(self, target: Target) -> None:
        target.publish()
        self.path, self._waiting = target.path, None


def _reopened(path: Path) -> tuple[h5py.File, Disk]:
    try:
        disk = Disk(path, create=False)
    except BlockingIOError as error:
        raise FileTrouble(f"{path}: another run is writing to it") from error
    except OSError as error:
        raise FileTrouble(f"{path}: cannot be continued: {plain(error)}") from error
    try:
        return h5py.File(disk, "r+", libver=LIBVER), disk
    except (OSError, RuntimeError) as error:
        disk.close()
        raise FileTrouble(f"{path}: cannot be continued: {plain(error)}") from error


def _set_status(file: h5py.File, status: Status, detail: str) -> None:
    """In place, so that the root's header keeps its form: another way could leave it torn by a kill."""
    file.attrs.modify("status", status)
    file.attrs.modify("status_detail", detail)


def _mark_interrupted(path: Path, reason: str) -> None:
    """Says in the file why it ends, where the disk still takes that much."""
    with suppress(FileTrouble, OSError, RuntimeError):
        file, disk = _reopened(path)
        _set_status(file, "interrupted", reason)
        file.close()
        disk.close()
