"""Contact points for a page: read, thinned to the strongest of each frame, ordered so that they pack well."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.recording import Trajectory
from physsim.view.page.coding import Codes
from physsim.view.page.quantise import quantised
from physsim.view.page.sections import Sections
from physsim.view.stage import FloatArray, IntArray

FRAMES_AT_ONCE = 64
_COLUMNS = ("frame", "body_a", "body_b", "position", "force", "sliding")
# Of float32: sign, exponent and the upper bits of the mantissa are kept.
_MANTISSA_BITS = 24


@dataclass(frozen=True)
class Contacts:
    """Contact points of the kept frames, in the order of the frames.

    frame (C,) counts kept frames; body_a, body_b (C,) rows of /body; position (C, 3) m; force (C, 3) N, on A;
    sliding (C,) 0 or 1; rank (C,): 0 for the largest force of its frame, then 1, ... in_file (T,): how many
    points each kept frame has in the file.
    """

    frame: IntArray
    body_a: IntArray
    body_b: IntArray
    position: FloatArray
    force: FloatArray
    sliding: npt.NDArray[np.int8]
    rank: IntArray
    in_file: IntArray

    @property
    def count(self) -> int:
        return len(self.frame)

    @property
    def most_in_a_frame(self) -> int:
        """Of the points that are still there."""
        return int(np.bincount(self.frame).max()) if self.count else 0

    def where(self, chosen: npt.NDArray[Any]) -> Contacts:
        """The points that a mask or a list of their numbers picks."""
        return replace(self, **{name: getattr(self, name)[chosen] for name in (*_COLUMNS, "rank")})

    def strongest(self, most: int) -> Contacts:
        """At most so many of each frame: those with the largest force."""
        return self.where(self.rank < most)


def contacts_of(trajectory: Trajectory, kept: IntArray, most: int) -> Contacts | None:
    """The contact points of the kept frames, at most `most` in each; None when they were not recorded."""
    if not trajectory.has("contacts/offset"):
        return None
    blocks, counts = [_nothing()], [np.zeros(0, np.int32)]
    for start in range(0, trajectory.frames, FRAMES_AT_ONCE):
        first, last = np.searchsorted(kept, (start, start + FRAMES_AT_ONCE))
        if first == last:
            continue
        block, in_file = _block(trajectory, kept[first:last], most)
        blocks.append({**block, "frame": block["frame"] + np.int32(first)})
        counts.append(in_file)
    columns = {name: np.concatenate([block[name] for block in blocks]) for name in (*_COLUMNS, "rank")}
    return Contacts(**columns, in_file=np.concatenate(counts))


def points_in_file(trajectory: Trajectory) -> int:
    """How many contact points the frames have together; 0 when they were not recorded."""
    if not trajectory.has("contacts/offset"):
        return 0
    starts = range(0, trajectory.frames, FRAMES_AT_ONCE)
    ends = (min(start + FRAMES_AT_ONCE, trajectory.frames) for start in starts)
    blocks = (
        trajectory.contact_rows(start, end, ("frame",)) for start, end in zip(starts, ends, strict=True)
    )
    return sum(block.rows for block in blocks)


def _nothing() -> dict[str, Any]:
    whole = dict.fromkeys(("frame", "body_a", "body_b", "rank"), np.zeros(0, np.int32))
    vectors = dict.fromkeys(("position", "force"), np.zeros((0, 3)))
    return {**whole, **vectors, "sliding": np.zeros(0, np.int8)}


def _block(trajectory: Trajectory, kept: IntArray, most: int) -> tuple[dict[str, Any], IntArray]:
    """Points of some kept frames, `frame` counted from the first of these; how many the file has in each."""
    table = trajectory.contact_rows(int(kept[0]), int(kept[-1]) + 1, _COLUMNS, by_name=False)
    columns = {name: table[name] for name in _COLUMNS}
    _check(trajectory, columns, kept)
    number = np.searchsorted(kept, columns["frame"]).astype(np.int32)
    there = np.flatnonzero(kept[number] == columns["frame"])
    number = number[there]
    rank = _rank(number, columns["force"][there])
    chosen = rank < most
    found = {name: column[there[chosen]] for name, column in columns.items()}
    return {**found, "frame": number[chosen], "rank": rank[chosen]}, np.bincount(
        number, minlength=len(kept)
    ).astype(np.int32)


def _check(trajectory: Trajectory, columns: dict[str, Any], kept: IntArray) -> None:
    bodies, frame = len(trajectory.body_names), columns["frame"]
    ends = np.concatenate([columns["body_a"], columns["body_b"]])
    outside = ends.size and not 0 <= ends.min() <= ends.max() < bodies
    if outside or (frame.size and not kept[0] <= frame.min() <= frame.max() <= kept[-1]):
        raise FileTrouble(f"{trajectory.path}: the file is damaged, its contacts belong to no body or frame")


def _rank(frame: IntArray, force: FloatArray) -> IntArray:
    """Of each point among those of its frame, 0 for the largest force. frame: rising."""
    order = np.lexsort((-np.einsum("ck,ck->c", force, force), frame))
    rank = np.empty(len(frame), np.int32)
    rank[order] = np.arange(len(frame)) - np.searchsorted(frame, frame, side="left")
    return rank


def pack_contacts(contacts: Contacts, planes: int, sections: Sections) -> dict[str, Any]:
    """The points as sections; returns their part of the page's head.

    In them the same two bodies stand together, frame after frame: a resting contact then changes little from
    one point to the next. Positions are quantised by axis; of forces the first `planes` bytes of float32
    stay, so their error is relative.
    """
    ordered = contacts.where(_by_pair(contacts))
    position = quantised(ordered.position.T, planes)
    return {
        "count": contacts.count,
        "frame": _whole(ordered.frame, sections),
        "body_a": _whole(ordered.body_a, sections),
        "body_b": _whole(ordered.body_b, sections),
        "sliding": _whole(ordered.sliding, sections),
        "in_file": _whole(contacts.in_file, sections),
        "position": sections.add_codes(position.codes, planes),
        "scale": sections.add("f8", np.concatenate([position.base, position.step, position.error])),
        "force": sections.add_codes(shortened(ordered.force.T, planes), planes),
        "force_error": relative_error(planes),
    }


def shortened(values: FloatArray, planes: int) -> Codes:
    """The first `planes` bytes of each value as float32, rounded to nearest."""
    with np.errstate(over="ignore"):
        bits = np.ascontiguousarray(values, np.float32).view(np.uint32)
    dropped = 32 - 8 * planes
    half = np.uint32((1 << dropped) >> 1)
    finite = np.isfinite(values)
    return np.where(finite, (bits + half) >> np.uint32(dropped), 0).astype(np.uint32)


def relative_error(planes: int) -> float:
    """Of each component of a force: half of the last bit that is kept, and the rounding to float32 (it knows
    no forces below 1e-38 N but 0).
    """
    kept = _MANTISSA_BITS - (32 - 8 * planes)
    return float(2.0**-kept + (2.0**-_MANTISSA_BITS if planes < 4 else 0))


def _by_pair(contacts: Contacts) -> IntArray:
    """The order of points by bodies, then by their number among the points of these two, then by frame."""
    order = np.lexsort((contacts.body_b, contacts.body_a, contacts.frame))
    keys = np.stack([contacts.frame, contacts.body_a, contacts.body_b])[:, order]
    new = np.ones(len(order), bool)
    new[1:] = (keys[:, 1:] != keys[:, :-1]).any(axis=0)
    starts = np.flatnonzero(new)
    ordinal = np.arange(len(order)) - np.repeat(starts, np.diff(np.append(starts, len(order))))
    frame, body_a, body_b = keys
    return order[np.lexsort((frame, ordinal, body_b, body_a))].astype(np.int32)


def _whole(numbers: npt.NDArray[Any], sections: Sections) -> int:
    """Whole numbers from 0 on, in as many bytes as the largest needs."""
    largest = int(numbers.max()) if numbers.size else 0
    return sections.add_codes(numbers.astype(np.uint32)[None, :], max(1, (largest.bit_length() + 7) // 8))
