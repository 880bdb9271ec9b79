"""The recorder: takes frames as they come and has them written while the run goes on."""

from __future__ import annotations

import time
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from physsim.recording.behind import Behind
from physsim.recording.block import Block, Rows
from physsim.recording.column import Column
from physsim.recording.create import block_frames, part_frames
from physsim.recording.layout import Status
from physsim.recording.pending import Pending
from physsim.recording.target import Target
from physsim.recording.writer import Writer

# A checkpoint, with the frames in hand, after this many seconds, so that a kill costs little work ...
SECONDS_BETWEEN_CHECKPOINTS = 5.0
# ... but only when this adds such a share to the open chunk: the chunk is stored anew each time.
LEAST_GROWTH = 0.25
# Just below 32 MiB, glibc's DEFAULT_MMAP_THRESHOLD_MAX.
LARGEST_KEPT = (32 << 20) - (64 << 10)


def _keep_memory() -> None:
    """Blocks of tens of megabytes come and go, and having the system clear their memory anew for each takes
    longer than filling it. A buffer of the greatest size that glibc learns from, taken and given back, makes
    it keep such memory; see mallopt(3), M_MMAP_THRESHOLD. Elsewhere it does nothing.
    """
    np.empty(LARGEST_KEPT, np.uint8)


class Recorder:
    """Records one run. Packing and writing go on in a thread of their own, one block at a time, which the run
    waits for when it is a block ahead.

    Made by `Recorder.create` or `Recorder.resume`. What the disk does not take is told by the next call that
    looks for it (`check`, `settle`, and all that write) as FileTrouble; the file is closed then and holds all
    blocks written before.
    """

    def __init__(self, writer: Writer) -> None:
        _keep_memory()
        self._writer = writer
        self._behind = Behind("physsim-recorder")
        self._pending = Pending()
        self._handed_over = self._safe = writer.frames
        self._block, self._part = block_frames(writer.bodies), part_frames(writer.bodies)
        self._last_checkpoint = time.monotonic()

    @classmethod
    def create(
        cls, target: Target, columns: tuple[Column, ...], attributes: Mapping[str, Any], values: Rows
    ) -> Recorder:
        """Into a new file, see `Writer.create`."""
        return cls(Writer.create(target, columns, attributes, values))

    @classmethod
    def resume(
        cls, path: Path, target: Target, columns: tuple[Column, ...], frames: int, events: int
    ) -> Recorder:
        """Goes on with a file, see `Writer.resume`."""
        return cls(Writer.resume(path, target, columns, frames, events))

    @property
    def path(self) -> Path:
        """Where the file is."""
        return self._writer.path

    @property
    def frames(self) -> int:
        """How many are on the disk."""
        return self._writer.frames

    @property
    def room(self) -> int:
        """How many more frames make a part, and should be packed then."""
        return self._part - self._handed_over % self._part - self._pending.frames

    def append(self, block: Block) -> None:
        """Frames that follow on those before."""
        self._pending.add(block)

    def checkpoint_is_due(self, coming: int) -> bool:
        """Whether it is time to save the engine, and the frames in hand with it.

        coming: frames that are about to be handed over besides.
        """
        waited = time.monotonic() - self._last_checkpoint
        new = self._handed_over - self._safe + self._pending.frames + coming
        worth_it = new == 0 or new >= LEAST_GROWTH * (self._safe % self._block)
        return waited > SECONDS_BETWEEN_CHECKPOINTS and worth_it

    def write_part(self) -> None:
        """Has the frames in hand packed, and written with those before them when they end a chunk."""
        if (self._handed_over + self._pending.frames) % self._block == 0:
            self.write_block()
        else:
            self._behind.do(partial(self._writer.write_part, self._taken()))

    def write_block(self) -> None:
        """Has the frames in hand written."""
        self._behind.do(partial(self._writer.write_block, self._taken()))
        self._safe = self._handed_over

    def write_checkpoint(self, engine: bytes, step: int) -> None:
        """The same with the engine's state after `step` steps, down to the disk itself."""
        self._behind.do(partial(self._writer.write_checkpoint, self._taken(), engine, step))
        self._safe = self._handed_over
        self._last_checkpoint = time.monotonic()

    def finish(
        self, status: Status, detail: str, engine: bytes | None, step: int, provenance: Mapping[str, Any]
    ) -> Path:
        """Writes what is in hand and ends the file, see `Writer.finish`. Returns where it is."""
        try:
            rest = self._taken()
            end = partial(self._writer.finish, rest, status=status, detail=detail, provenance=provenance)
            self._behind.do(partial(end, engine=engine, step=step))
            self._behind.settle()
        finally:
            self._behind.close()
        return self.path

    def check(self) -> None:
        """Raises FileTrouble when something could not be written so far."""
        self._behind.check()

    def settle(self) -> None:
        """Waits until what was handed over is on the disk. Raises FileTrouble when it cannot be written."""
        self._behind.settle()

    def _taken(self) -> Pending:
        taken, self._pending = self._pending, Pending()
        self._handed_over += taken.frames
        return taken
