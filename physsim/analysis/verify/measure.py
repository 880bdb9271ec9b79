"""What is read out of a run beyond the quantities that have a name."""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array, Measure
from physsim.recording import Trajectory
from physsim.recording.quantities import over_time
from physsim.scene.quantity import parse_quantity

AXES = {"x": 0, "y": 1, "z": 2}


def vector(body: str, what: str) -> Measure:
    """(T, 3): `position`, `velocity` or `angular_velocity` of a body."""

    def measured(run: Trajectory) -> Array:
        return np.asarray(run.series(what, run.index_of(body))[:])

    return measured


def axis(body: str, name: str = "z") -> Measure:
    """(T, 3): the world direction of one of a body's own axes."""

    def measured(run: Trajectory) -> Array:
        return rotations(run, body)[:, :, AXES[name]]

    return measured


def spin(body: str) -> Measure:
    """(T, 3): angular velocity in the body's own axes [rad/s]."""

    def measured(run: Trajectory) -> Array:
        turning = run.body(body).angular_velocity[:]
        return np.asarray(np.einsum("tji,tj->ti", rotations(run, body), turning))

    return measured


def turned(body: str, about: str) -> Measure:
    """(T): unwrapped angle [rad] by which a body has turned about a world axis that it keeps turning
    about.
    """
    first, second = {"x": ("y", "z"), "y": ("z", "x"), "z": ("x", "y")}[about]

    def measured(run: Trajectory) -> Array:
        way = rotations(run, body)[:, :, AXES[first]]
        angle = np.unwrap(np.arctan2(way[:, AXES[second]], way[:, AXES[first]]))
        return np.asarray(angle - angle[0])

    return measured


def events(column: str) -> Measure:
    """A column of /events, one row per impact."""
    return lambda run: np.asarray(run.events[column], np.float64)


def at_start(quantity: str) -> Measure:
    """(1): the first value of a quantity with a name."""
    named = parse_quantity(quantity)
    return lambda run: over_time(run, named)[:1]


def length(quantity: str) -> Measure:
    """(T): length of a vector with a name."""
    named = parse_quantity(quantity)
    return lambda run: np.asarray(np.linalg.norm(over_time(run, named), axis=1))


def at_end(quantity: str) -> Measure:
    """(1): the last value of a quantity with a name."""
    named = parse_quantity(quantity)
    return lambda run: over_time(run, named)[-1:]


def rotations(run: Trajectory, body: str) -> Array:
    """(T, 3, 3): rotation matrices, body to world, of unit quaternions (Kuipers 1999, eq. 5.11)."""
    w, x, y, z = np.moveaxis(run.body(body).orientation[:], 1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def period(curve: Array, time: Array) -> float:
    """Mean time between zero crossings upwards of a smooth curve [s], each from the cubic through four
    frames.

    A line through two frames would be off by the curvature between them. Raises ValueError with fewer than
    two crossings.
    """
    at = [k for k in range(1, len(curve) - 2) if curve[k] < 0 <= curve[k + 1]]
    if len(at) < 2:
        raise ValueError("fewer than two zero crossings")
    crossings = [_root(curve[k - 1 : k + 3], time[k - 1 : k + 3]) for k in (at[0], at[-1])]
    return float((crossings[1] - crossings[0]) / (len(at) - 1))


def _root(values: Array, times: Array) -> float:
    """The time at which four samples pass zero between the second and the third: time as a cubic of the
    value.
    """
    return float(np.polynomial.Polynomial(_newton(values, times))(0.0))


def _newton(x: Array, y: Array) -> Array:
    """Coefficients, rising, of the polynomial through (x, y)."""
    return np.asarray(np.linalg.solve(np.vander(x, increasing=True), y), np.float64)
