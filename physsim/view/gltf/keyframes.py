"""Which samples of a motion are needed: those that straight lines between the others do not reproduce."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.view.stage import FloatArray

Rows = npt.NDArray[np.intp]


@dataclass(frozen=True)
class Keys:
    """Samples that are kept, in the order of time: of which rows, which sample, and their values."""

    rows: Rows
    samples: Rows
    values: FloatArray


class Thinner:
    """Takes the samples of many motions, one instant after the other, and hands out those to keep.

    A line from the last kept sample may run on as long as there is a velocity that passes every sample since
    within the tolerance: an interval of velocities for each axis, which each sample narrows. When the line to
    the newest sample is outside, the one before it is kept. Every sample is looked at once (the cone of
    Sklansky and Gonzalez, "Fast polygonal approximation of digitized curves", Pattern Recognition 12, 1980).

    difference: (from (R, k), to (R, k)) -> (R, 3), in which the interpolation between kept samples is a
    straight line; tolerance (R) in its unit; reach (R): no two kept samples with others between them are
    farther apart than that.
    """

    def __init__(
        self,
        difference: Callable[[FloatArray, FloatArray], FloatArray],
        tolerance: FloatArray,
        reach: FloatArray,
    ) -> None:
        self._difference = difference
        self._room = tolerance[:, None] / np.sqrt(3)
        self._reach = reach
        self._low = np.full((len(tolerance), 3), -np.inf)
        self._high = np.full((len(tolerance), 3), np.inf)
        self._since = np.zeros((len(tolerance), 1))
        self._start = self._newest = np.empty((0, 0))
        self._sample = -1
        self._time = 0.0

    def add(self, times: FloatArray, values: FloatArray) -> Iterator[Keys]:
        """times (m) [s], increasing also from call to call; values (m, R, k)."""
        for time, value in zip(times, values, strict=True):
            if self._sample < 0:
                self._since[:] = time
                self._start = value.copy()
                yield self._keys(np.arange(len(value)), 0, value)
            else:
                yield from self._next(float(time), value)
            self._sample, self._time, self._newest = self._sample + 1, float(time), value

    def last(self) -> Iterator[Keys]:
        """The newest sample of every motion that has moved on since its last kept one."""
        rows = np.flatnonzero(self._since[:, 0] < self._time)
        if rows.size:
            yield self._keys(rows, self._sample, self._newest)

    def _next(self, time: float, value: FloatArray) -> Iterator[Keys]:
        ahead = self._difference(self._start, value)
        velocity = ahead / (time - self._since)
        fits = ((velocity >= self._low) & (velocity <= self._high)).all(axis=1)
        fits &= np.einsum("ri,ri->r", ahead, ahead) <= self._reach**2
        over = np.flatnonzero(~fits & (self._since[:, 0] < self._time))
        if over.size:
            yield self._keys(over, self._sample, self._newest)
            self._start[over], self._since[over] = self._newest[over], self._time
            self._low[over], self._high[over] = -np.inf, np.inf
            velocity[over] = self._difference(self._start[over], value[over]) / (time - self._time)
        room = self._room / (time - self._since)
        np.maximum(self._low, velocity - room, out=self._low)
        np.minimum(self._high, velocity + room, out=self._high)

    @staticmethod
    def _keys(rows: Rows, sample: int, values: FloatArray) -> Keys:
        return Keys(rows, np.full(len(rows), sample), values[rows])


def shift(first: FloatArray, second: FloatArray) -> FloatArray:
    """From one position to another, (R, 3) [m]."""
    return second - first


def turn(first: FloatArray, second: FloatArray) -> FloatArray:
    """The rotation vector (R, 3) [rad], in body axes, that takes one orientation (R, 4) into another the
    short way: conj(p) q = (cos a/2, sin a/2 u) gives a u.

    The arc (slerp) from p to q is p exp(f a u), a straight line in this measure. A difference d between two
    vectors is a turn of no more than |d|.
    """
    w, u = first[:, :1], first[:, 1:]
    other_w, other_u = second[:, :1], second[:, 1:]
    cosine = w * other_w + np.einsum("ri,ri->r", u, other_u)[:, None]
    sine = w * other_u - other_w * u - np.cross(u, other_u)
    size = np.linalg.norm(sine, axis=1, keepdims=True)
    half = np.arctan2(size, np.abs(cosine))
    stretch = 2 * np.divide(half, size, out=np.ones_like(size), where=size > 0)
    vector: FloatArray = sine * np.where(cosine < 0, -stretch, stretch)
    return vector


def in_one_hemisphere(orientations: FloatArray, before: FloatArray | None) -> FloatArray:
    """Quaternions (m, R, 4), each with the sign that is nearer to its predecessor's; `before` (R, 4) is that
    of the first.
    """
    steps = np.einsum("mri,mri->mr", orientations[1:], orientations[:-1])
    first = (
        np.ones(orientations.shape[1])
        if before is None
        else _signs(np.einsum("ri,ri->r", orientations[0], before))
    )
    signs = np.cumprod(np.concatenate([first[None], _signs(steps)]), axis=0)
    return orientations * signs[..., None]


def _signs(values: FloatArray) -> FloatArray:
    return np.where(values < 0, -1.0, 1.0)
