"""Contacts and impacts of some bodies, and the force that contacts put on one of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from physsim.recording.series import Array, Table

if TYPE_CHECKING:
    from physsim.recording.reader import Trajectory

# Contacts of so many frames are in memory at a time.
FRAMES_AT_ONCE = 512


def between(table: Table, body: str | None, other: str | None) -> Table:
    """The rows of a table with columns body_a and body_b in which `body` is one of the two, and `other` the
    other; None stands for any.
    """
    a, b = table["body_a"], table["body_b"]
    if body is None:
        body, other = other, None
    if body is None:
        return table
    first = (a == body) if other is None else (a == body) & (b == other)
    second = (b == body) if other is None else (b == body) & (a == other)
    return table.where(first | second)


def force_on(trajectory: Trajectory, body: str, frames: slice) -> Array:
    """Sum of the contact forces on a body in the step that ends at each frame, world axes, (T, 3) N.

    Read block by block. Raises NotInFile when contacts were not recorded or there is no such body.
    """
    trajectory.index_of(body)
    wanted = range(trajectory.frames)[frames]
    lowest, highest = (min(wanted), max(wanted) + 1) if len(wanted) else (0, 0)
    found = np.zeros((highest - lowest, 3))
    for table in _blocks(trajectory, lowest, highest):
        for column, sign in (("body_a", 1.0), ("body_b", -1.0)):
            mine = table[column] == body
            np.add.at(found, table["frame"][mine] - lowest, sign * table["force"][mine])
    return found[[frame - lowest for frame in wanted]]


def _blocks(trajectory: Trajectory, start: int, stop: int) -> Iterator[Table]:
    for first in range(start, stop, FRAMES_AT_ONCE):
        yield trajectory.contact_rows(
            first, min(first + FRAMES_AT_ONCE, stop), ("frame", "body_a", "body_b", "force")
        )
    if start >= stop:
        trajectory.contact_rows(0, 0, ("frame",))
