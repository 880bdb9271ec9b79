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
import numpy as np

from physsim.errors import FileTrouble
from physsim.recording import checkpoint as slots
from physsim.recording import layout
from physsim.recording.checkpoint import Checkpoint
from physsim.recording.create import axis_dataset, block_frames, create_file
from physsim.recording.layout import Column, Status
from physsim.recording.safe import guarded
from physsim.recording.space import RESERVE_BYTES, NoRoom, close_in_place, close_without_writing, room_for
from physsim.recording.target import Target, is_being_written, plain

# A checkpoint, with the frames in hand, after this many seconds, so that a kill costs little work ...
SECONDS_BETWEEN_CHECKPOINTS = 5.0
# ... but only when this adds such a share to the open chunk: the chunk is stored anew each time.
LEAST_GROWTH = 0.25

Rows = Mapping[str, Any]


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
        self._growing = [column for column in columns if column.grows_along and column.path != "time"]
        self._waiting = waiting
        self._pending: dict[str, list[Any]] = {}
        self._pending_frames = 0
        self._pending_bytes = 0
        self._lengths = {
            dim: axis_dataset(file, column.group, dim).shape[0]
            for column in self._growing
            if (dim := column.grows_along)
        }
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
        file = create_file(
            target.part, columns, {**attributes, "status": "running", "status_detail": ""}, values
        )
        return cls(file, target.part, columns, target)

    @classmethod
    def resume(
        cls, path: Path, target: Target, columns: tuple[Column, ...], frames: int, events: int
    ) -> Recorder:
        """Goes on with the file at `path`, cut back to `frames` frames and `events` impacts.

        Raises FileTrouble when it cannot be opened for writing, or another process writes to it.
        """
        if is_being_written(path):
            raise FileTrouble(f"{path}: another run is writing to it")
        try:
            file = h5py.File(path, "r+", libver=("earliest", "v110"), locking="best-effort")
        except (OSError, RuntimeError) as error:
            raise FileTrouble(f"{path}: cannot be continued: {plain(error)}") from error
        growing = [column for column in columns if column.grows_along]
        with _told_plainly(path, file), room_for(file, _open_chunks_bytes(file, growing)), guarded(path):
            _cut(file, columns, frames, events)
            file.attrs["status"] = "running"
            file.attrs["status_detail"] = ""
            file.flush()
        return cls(file, path, columns, None if path == target.path else target)

    def append(self, step: int, frame_time: float, frame: Rows, contacts: Rows | None = None) -> None:
        """One frame. frame, contacts: rows by dataset path; None for contacts when they are not recorded."""
        number = self.frames + self._pending_frames
        self._keep("time", frame_time)
        self._keep("step", step)
        for path, row in frame.items():
            self._keep(path, row)
        if contacts is not None:
            self._keep_contacts(number, contacts)
        self._pending_frames += 1

    def append_events(self, events: Rows) -> None:
        """Impacts since the last call, rows by dataset path."""
        for path, rows in events.items():
            self._keep(path, rows)

    @property
    def block_is_full(self) -> bool:
        """Whether the frames in hand fill a chunk and should be written now."""
        return self._pending_frames + self.frames % self._block >= self._block

    @property
    def checkpoint_is_due(self) -> bool:
        """Whether it is time to save the engine, and the frames in hand with it."""
        waited = time.monotonic() - self._last_checkpoint
        worth_it = self._pending_frames >= LEAST_GROWTH * (self.frames % self._block)
        return waited > SECONDS_BETWEEN_CHECKPOINTS and worth_it

    def write_block(self) -> None:
        """Writes the frames in hand."""
        with _told_plainly(self.path, self._file), self._room():
            self._commit()
        self._take_free_name()

    def write_checkpoint(self, engine: bytes, step: int) -> None:
        """Writes the frames in hand and the engine's state after `step` steps, down to the disk itself."""
        with _told_plainly(self.path, self._file), self._room(len(engine)):
            self._commit()
            slots.save(self._file, self._checkpoint(engine, step))
            self._sync()
        self._last_checkpoint = time.monotonic()
        self._take_free_name()

    def finish(
        self, status: Status, detail: str, engine: bytes | None, step: int, provenance: Mapping[str, Any]
    ) -> Path:
        """Writes what is in hand, the last checkpoint, the status; closes; gives the file its name.

        engine: None leaves the checkpoints as they are (after a failure). Returns where the file is: under
        the target's name, unless a failed run with nothing but its first frame would replace an old file.
        """
        with _told_plainly(self.path, self._file), self._room(len(engine or b"")):
            self._commit()
            if engine is not None:
                slots.save_last(self._file, self._checkpoint(engine, step))
            for path, value in provenance.items():
                self._file[path][()] = value
            self._file.attrs["status"] = status
            self._file.attrs["status_detail"] = detail
            self._sync()
        with _told_plainly(self.path, self._file):
            self._file.close()
        self._take_free_name()
        if self._waiting and (status == "complete" or self.frames > 1):
            self._publish(self._waiting)
        return self.path

    def _keep(self, path: str, rows: Any) -> None:
        kept = np.array(rows)
        self._pending.setdefault(path, []).append(kept)
        self._pending_bytes += kept.nbytes

    def _keep_contacts(self, number: int, contacts: Rows) -> None:
        count = len(contacts["contacts/body_a"])
        self._keep("contacts/frame", np.full(count, number, np.int64))
        for path, rows in contacts.items():
            self._keep(path, rows)
        before = self._pending.get("contacts/offset")
        start = int(before[-1][-1]) if before else self._lengths["contact"]
        first = [start] if number == 0 else []
        self._keep("contacts/offset", np.array([*first, start + count], np.int64))

    def _room(self, engine_bytes: int = 0) -> AbstractContextManager[None]:
        rows = 2 * self._pending_bytes
        return room_for(self._file, _open_chunks_bytes(self._file, self._growing) + rows + 2 * engine_bytes)

    def _commit(self) -> None:
        """Two flushes: all but `/time`, then `/time`."""
        for column in self._growing:
            if rows := self._pending.get(column.path):
                self._extend(column, rows)
        self._file.flush()
        if times := self._pending.get("time"):
            self._grow(self._file["time"], np.array(times))
            self._file.flush()
        self.frames += self._pending_frames
        self._pending, self._pending_frames, self._pending_bytes = {}, 0, 0

    def _extend(self, column: Column, rows: list[Any]) -> None:
        added = np.array(rows) if column.grows_along == "time" else np.concatenate(rows)
        dataset = self._file[column.path]
        self._grow(dataset, added)
        dim = column.grows_along
        if dim and dim != "time":
            axis_dataset(self._file, column.group, dim).resize((dataset.shape[0],))
            self._lengths[dim] = dataset.shape[0]

    @staticmethod
    def _grow(dataset: h5py.Dataset, rows: np.ndarray[Any, Any]) -> None:
        if len(rows):
            start = dataset.shape[0]
            dataset.resize(start + len(rows), axis=0)
            dataset[start:] = rows

    def _sync(self) -> None:
        self._file.flush()
        os.fsync(self._file.id.get_vfd_handle())

    def _checkpoint(self, engine: bytes, step: int) -> Checkpoint:
        return Checkpoint(engine, step, self.frames, self._lengths.get("event", 0))

    def _take_free_name(self) -> None:
        if self._waiting and not self._waiting.path.exists():
            self._publish(self._waiting)

    def _publish(self, target: Target) -> None:
        target.publish()
        self.path, self._waiting = target.path, None


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


def _open_chunks_bytes(file: h5py.File, columns: list[Column]) -> int:
    """How much the file can grow by storing every dataset's last chunks anew, twice over, and some for HDF5
    itself.
    """
    total = RESERVE_BYTES
    for column in columns:
        dataset = file[column.path]
        across = -(-int(np.prod(dataset.shape[1:])) // int(np.prod(dataset.chunks[1:])))
        total += 2 * across * int(np.prod(dataset.chunks)) * dataset.dtype.itemsize
    return total


def _cut(file: h5py.File, columns: tuple[Column, ...], frames: int, events: int) -> None:
    """Shortens every growing dataset, `/time` first: the shortest tells what is whole."""
    growing = [column for column in columns if column.grows_along]
    file["time"].resize(frames, axis=0)
    file.flush()
    lengths = {"time": frames, "event": events, "boundary": frames + 1}
    if "contacts" in file:
        lengths["contact"] = int(file["contacts/offset"][frames])
    for column in growing:
        file[column.path].resize(lengths[column.dims[0]], axis=0)
    for group, dim in layout.bare_axes(columns):
        if dim in lengths:
            file[f"{group}/{dim}"].resize(lengths[dim], axis=0)
