"""The fastest swing that all springs of a scene make together, at the start."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from physsim.model.placement import Placed
from physsim.model.rotation import FloatArray
from physsim.model.springs import Spring, SpringKind

ITERATIONS = 300


@dataclass(frozen=True)
class FastestMode:
    """angular_frequency [rad/s]; damping_ratio; spring: the row of the one that takes most of its energy."""

    angular_frequency: float
    damping_ratio: float
    spring: int


def fastest_mode(springs: Sequence[Spring]) -> FastestMode | None:
    """The mode of the highest frequency; None when no spring swings.

    The squares of the frequencies are the eigenvalues of sqrt(k) J M^-1 J^T sqrt(k), one row and column for
    each spring, J the rate of its length or angle by the velocities of the bodies. The largest is found by
    power iteration, from below, to about 1 % where several lie close together. Joints, and the turning of
    springs under tension, are left out.
    """
    k = np.array([spring.largest_stiffness for spring in springs])
    if not np.any(k > 0):
        return None
    c = np.array([spring.largest_damping for spring in springs])
    ends = _Ends(springs)
    share = np.random.default_rng(0).uniform(0.5, 1.0, len(springs)) * np.sqrt(k)
    for _ in range(ITERATIONS):
        share /= np.linalg.norm(share)
        share = np.sqrt(k) * ends.rates(np.sqrt(k) * share)
        if not share.any():
            return None
    square = float(np.linalg.norm(share))
    shape = share / square
    rates = ends.rates(np.sqrt(k) * shape) / sqrt(square)  # of the mode at unit kinetic energy p . v = 1
    damping = float(np.sum(c * rates**2)) / (2 * sqrt(square))
    return FastestMode(sqrt(square), damping, int(np.argmax(shape**2)))


class _Ends:
    """J M^-1 J^T without writing it out: each spring pulls at two bodies."""

    def __init__(self, springs: Sequence[Spring]) -> None:
        moving = sorted({end.number: end for spring in springs for end in spring.ends}.items())
        rows = {number: row for row, (number, _) in enumerate(moving)}
        bodies = [end for _, end in moving]
        self._bodies = np.array([[rows[end.number] for end in spring.ends] for spring in springs])
        self._jacobian = np.array([_jacobian(spring) for spring in springs])
        self._inverse = np.array([_inverse_mass(body) for body in bodies])

    def rates(self, tension: FloatArray) -> FloatArray:
        """(S,) rates by which springs lengthen after unit times of these tensions [m/s or rad/s]."""
        momentum = np.zeros((len(self._inverse), 6))
        np.add.at(momentum, self._bodies, tension[:, None, None] * self._jacobian)
        velocity = np.einsum("nij,nj->ni", self._inverse, momentum)
        found: FloatArray = np.einsum("sei,sei->s", self._jacobian, velocity[self._bodies])
        return found


def _jacobian(spring: Spring) -> FloatArray:
    """(2, 6): rate of length or angle by velocity and angular velocity of A and B."""
    rows = np.zeros((2, 6))
    for row, end, arm, sign in zip(rows, spring.ends, spring.anchors, (-1, 1), strict=True):
        if spring.kind is SpringKind.LINEAR:
            row[:3] = sign * spring.axis
            row[3:] = sign * np.cross(end.turn @ arm, spring.axis)
        else:
            row[3:] = sign * spring.axis
    return rows


def _inverse_mass(body: Placed) -> FloatArray:
    inverse = np.zeros((6, 6))
    inverse[:3, :3] = body.inverse_mass * np.eye(3)
    inverse[3:, 3:] = body.inverse_inertia
    return inverse
