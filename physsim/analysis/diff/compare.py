"""Two trajectories, number by number, block by block."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from physsim.analysis.diff.pairs import Pair, Rows, common_frames, common_pairs, only_in
from physsim.errors import FileTrouble
from physsim.recording import Trajectory

Floats = NDArray[np.float64]
FRAMES_AT_ONCE = 256
# So many moments of the growth are told, from the first difference to the end.
MOMENTS = 10


@dataclass(frozen=True)
class Divergence:
    """A quantity that differs: where first, and where most.

    frame: row in A; time [s]; difference: length of the difference vector in `unit` (of orientations the
    angle between them, rad); greatest, greatest_time: the same where it is largest.
    """

    quantity: str
    unit: str
    frame: int
    time: float
    difference: float
    greatest: float
    greatest_time: float


@dataclass(frozen=True)
class Growth:
    """How far apart positions are: the body that is off most at a time [s], by how much [m]."""

    time: float
    quantity: str
    difference: float


@dataclass(frozen=True)
class Comparison:
    """What came of comparing two trajectories.

    frames: compared; end: time [s] of the last of them; divergences: every quantity that differs beyond
    `tolerance`, the earliest first; growth: of the distance of positions; doubling_time: in which that
    distance doubles, on the average while it grows [s], None when it does not. only_a, only_b: bodies, joints
    and springs that the other file has not.
    """

    tolerance: float
    frames: int
    end: float
    divergences: list[Divergence] = field(default_factory=list)
    growth: list[Growth] = field(default_factory=list)
    doubling_time: float | None = None
    only_a: list[str] = field(default_factory=list)
    only_b: list[str] = field(default_factory=list)

    @property
    def alike(self) -> bool:
        """Whether nothing differs beyond the tolerance."""
        return not (self.divergences or self.only_a or self.only_b)


def compare(a: Trajectory, b: Trajectory, tolerance: float = 0.0) -> Comparison:
    """Compares every frame whose time is in both files.

    tolerance: two values differ when their distance is more than tolerance * max(1, |a|, |b|), in SI: an
    absolute bound for what is small, a relative one for what is large. 0: bit for bit, but for the sign of
    a zero and of a quaternion. Raises FileTrouble when no frames have the same time.
    """
    frames_a, frames_b = common_frames(a, b)
    if len(frames_a) == 0:
        raise FileTrouble(f"{a.path}, {b.path}: no frame of one has the time of a frame of the other")
    times = a.time[frames_a]
    tracks = [_Track(pair, len(times)) for pair in common_pairs(a, b)]
    for start in range(0, len(times), FRAMES_AT_ONCE):
        block = slice(start, start + FRAMES_AT_ONCE)
        for track in tracks:
            track.take(block, *_values(a, b, track.pair, frames_a[block], frames_b[block]), tolerance)
    found = [one for track in tracks for one in track.divergences(times, frames_a)]
    distances = tracks[0] if tracks[0].pair.path == "position" else None
    return Comparison(
        tolerance,
        len(times),
        float(times[-1]),
        sorted(found, key=lambda one: one.frame),
        distances.growth(times) if distances else [],
        distances.doubling_time(times) if distances else None,
        only_in(a, b),
        only_in(b, a),
    )


def _values(
    a: Trajectory, b: Trajectory, pair: Pair, frames_a: Rows, frames_b: Rows
) -> tuple[Floats, Floats]:
    """Both (t, rows, components) in double precision."""
    return _block(a, pair.path, frames_a, pair.rows_a), _block(b, pair.path, frames_b, pair.rows_b)


def _block(trajectory: Trajectory, path: str, frames: Rows, rows: Rows | None) -> Floats:
    first = int(frames[0])
    values = np.asarray(trajectory.series(path)[first : int(frames[-1]) + 1], np.float64)[frames - first]
    values = values[:, None] if rows is None else values[:, rows]
    return values.reshape(len(frames), values.shape[1], -1)


class _Track:
    """What is kept of one dataset while blocks pass by."""

    def __init__(self, pair: Pair, frames: int) -> None:
        self.pair = pair
        count = len(pair.names)
        self._first = np.full(count, -1)
        self._first_difference = np.zeros(count)
        self._greatest = np.zeros(count)
        self._greatest_at = np.zeros(count, np.intp)
        self._worst = np.zeros(frames)
        self._worst_row = np.zeros(frames, np.intp)

    def take(self, block: slice, a: Floats, b: Floats, tolerance: float) -> None:
        """a, b: (t, rows, components) of the frames in `block`."""
        distance = _angles(a, b) if self.pair.path == "orientation" else _distances(a, b)
        with np.errstate(invalid="ignore", over="ignore"):
            size = np.fmax(1.0, np.fmax(np.linalg.norm(a, axis=2), np.linalg.norm(b, axis=2)))
            beyond = (distance > tolerance * np.where(np.isfinite(size), size, 1.0)) & (distance > 0)
        self._worst_row[block] = distance.argmax(axis=1)
        self._worst[block] = distance.max(axis=1)
        new = (self._first < 0) & beyond.any(axis=0)
        at = beyond.argmax(axis=0)[new]
        self._first[new] = block.start + at
        self._first_difference[new] = distance[at, np.flatnonzero(new)]
        here = distance.argmax(axis=0)
        value = distance.max(axis=0)
        more = value > self._greatest
        self._greatest[more] = value[more]
        self._greatest_at[more] = block.start + here[more]

    def divergences(self, times: Floats, frames: Rows) -> list[Divergence]:
        """The rows that differ beyond the tolerance; of those that begin in one frame the largest first."""
        rows = np.flatnonzero(self._first >= 0).tolist()
        order = sorted(rows, key=lambda row: (self._first[row], -self._first_difference[row]))
        unit = "rad" if self.pair.path == "orientation" else self.pair.unit
        return [
            Divergence(
                self.pair.names[row],
                unit,
                int(frames[self._first[row]]),
                float(times[self._first[row]]),
                float(self._first_difference[row]),
                float(self._greatest[row]),
                float(times[self._greatest_at[row]]),
            )
            for row in order
        ]

    def growth(self, times: Floats) -> list[Growth]:
        """The largest difference at some moments, evenly spread from the first that is not 0 to the end."""
        off = np.flatnonzero(self._worst > 0)
        if len(off) == 0:
            return []
        moments = np.unique(np.linspace(off[0], len(times) - 1, MOMENTS).round().astype(np.intp))
        return [
            Growth(float(times[k]), self.pair.names[self._worst_row[k]], float(self._worst[k]))
            for k in moments
        ]

    def doubling_time(self, times: Floats) -> float | None:
        """From a straight line through ln d over t, from the first difference to where d is a tenth of its
        largest; None when d grows less than a hundredfold.
        """
        off = np.flatnonzero(self._worst > 0)
        if len(off) == 0 or not np.isfinite(self._worst).all():
            return None
        stop = int(np.argmax(self._worst >= 0.1 * self._worst.max()))
        rising = off[off <= stop]
        if len(rising) < 3 or self._worst[stop] < 100 * self._worst[rising[0]]:
            return None
        rate = float(np.polyfit(times[rising], np.log(self._worst[rising]), 1)[0])
        return float(np.log(2) / rate) if rate > 0 else None


def _distances(a: Floats, b: Floats) -> Floats:
    """|a - b| of each row, (t, rows): 0 where the numbers are equal or both no numbers, infinite where only
    one is.
    """
    with np.errstate(invalid="ignore"):
        off = np.where((a == b) | (np.isnan(a) & np.isnan(b)), 0.0, np.abs(a - b))
    return np.asarray(np.linalg.norm(np.where(np.isnan(off), np.inf, off), axis=2), np.float64)


def _angles(a: Floats, b: Floats) -> Floats:
    """The angle between two orientations [rad]: 4 asin(|p - q| / 2), q of either sign."""
    chord = np.minimum(_distances(a, b), _distances(a, -b))
    return np.asarray(
        np.where(np.isfinite(chord), 4 * np.arcsin(np.clip(chord / 2, 0, 1)), np.inf), np.float64
    )
