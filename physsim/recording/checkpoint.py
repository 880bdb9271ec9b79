"""Checkpoints: everything needed to go on bit for bit, in two slots that take turns.

A slot is only used when its digest is right, so a kill while one is being written leaves the other.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass

import h5py
import numpy as np

from physsim.recording.layout import SLOTS

_COUNTS = ("step", "frames", "events")
# The largest engine state that is read back: a million bodies take about 0.3 GB.
MAX_ENGINE_BYTES = 1 << 30


@dataclass(frozen=True)
class Checkpoint:
    """State of the engine after `step` steps, with the frames and impacts that the file held then."""

    engine: bytes
    step: int
    frames: int
    events: int

    @property
    def digest(self) -> int:
        counts = f"{self.step} {self.frames} {self.events} ".encode()
        return int.from_bytes(hashlib.sha256(counts + self.engine).digest()[:8], "little", signed=True)


def newest(file: h5py.File) -> Checkpoint | None:
    """The whole checkpoint with the most steps, or None when there is none."""
    whole = [found for found in (_read(file, slot) for slot in SLOTS) if found]
    return max(whole, key=lambda found: found.step, default=None)


def save(file: h5py.File, checkpoint: Checkpoint) -> None:
    """Writes into the slot that does not hold the newest checkpoint. The caller flushes."""
    _write(file, _oldest_slot(file), checkpoint)


def save_last(file: h5py.File, checkpoint: Checkpoint, flush: Callable[[], None]) -> None:
    """Leaves `checkpoint` in the first slot and the second empty, so that two runs of a scene end alike."""
    for slot in (SLOTS[1], SLOTS[0]) if _oldest_slot(file) == SLOTS[1] else (SLOTS[0],):
        _write(file, slot, checkpoint)
        flush()
    _write(file, SLOTS[1], Checkpoint(b"", -1, -1, -1))


def _oldest_slot(file: h5py.File) -> str:
    """Where the next checkpoint may go without touching the newest whole one."""
    steps = {slot: found.step if (found := _read(file, slot)) else -1 for slot in SLOTS}
    return min(SLOTS, key=lambda slot: steps[slot])


def _read(file: h5py.File, slot: str) -> Checkpoint | None:
    group = file[f"checkpoint/{slot}"]
    step, frames, events = (int(group[name][()]) for name in _COUNTS)
    if step < 0 or group["engine"].shape[0] > MAX_ENGINE_BYTES:
        return None
    found = Checkpoint(group["engine"][:].tobytes(), step, frames, events)
    return found if int(group["digest"][()]) == found.digest else None


def _write(file: h5py.File, slot: str, checkpoint: Checkpoint) -> None:
    group = file[f"checkpoint/{slot}"]
    size = (len(checkpoint.engine),)
    group["engine"].resize(size)
    group["byte"].resize(size)
    group["engine"][:] = np.frombuffer(checkpoint.engine, np.uint8)
    for name in _COUNTS:
        group[name][()] = getattr(checkpoint, name)
    group["digest"][()] = checkpoint.digest
