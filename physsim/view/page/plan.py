"""What of a trajectory goes into a page of a given size: decided from samples, before all is packed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import count

from physsim.recording import Trajectory
from physsim.view.page.coding import encoded
from physsim.view.page.contacts import Contacts, contacts_of, pack_contacts, points_in_file
from physsim.view.page.motion import BODY_TRACKS, Track, kept_frames, numbers_of_a_frame, tracks_of
from physsim.view.page.quantise import quantised
from physsim.view.page.sections import Sections
from physsim.view.stage import IntArray

# A browser keeps all numbers in memory, 4 bytes each, and this program 8 while it packs.
MOST_NUMBERS = 40_000_000
MOST_CONTACTS = 3_000_000
# Bytes of each number of a body, and the share of the room that a page as exact as that may take.
PRECISION = ((4, 0.5), (3, 1.0), (2, 1.0))
SCENE_PLANES = 4
# Frames are left out before contacts get less of the room than this.
CONTACT_SHARE = 0.25
# Sizes are estimated from about so many numbers; four times as many give the same to 1 %.
SAMPLE = 400_000


@dataclass(frozen=True)
class Content:
    """A trajectory in memory, at every stride-th frame."""

    stride: int
    kept: IntArray
    tracks: list[Track]
    contacts: Contacts | None


@dataclass(frozen=True)
class Plan:
    """Bytes of each number of a body, contacts of a frame at most; stride: which frames. When the stride is
    not that of the content, that has to be read again first.
    """

    stride: int
    planes: int
    most_contacts: int


def read(trajectory: Trajectory, stride: int) -> Content:
    """Every stride-th frame, as far as memory allows. Raises FileTrouble when the file is damaged."""
    frames = trajectory.frames
    stride = max(stride, math.ceil(frames * numbers_of_a_frame(trajectory) / MOST_NUMBERS), 1)
    kept = kept_frames(frames, stride)
    points = points_in_file(trajectory)
    most = points if points <= MOST_CONTACTS else max(1, MOST_CONTACTS // max(1, len(kept)))
    return Content(stride, kept, tracks_of(trajectory, kept), contacts_of(trajectory, kept, most))


def planned(content: Content, room: int) -> Plan:
    """The most exact plan that is likely to fit into `room` bytes."""
    bodies = [track for track in content.tracks if track.name in BODY_TRACKS]
    scene = sum(_estimate(track, SCENE_PLANES) for track in content.tracks if track not in bodies)
    all_contacts = content.contacts.most_in_a_frame if content.contacts else 0
    motion = 0.0
    for planes, share in PRECISION:
        motion = scene + sum(_estimate(track, planes) for track in bodies)
        if motion + _contacts(content.contacts, planes, all_contacts) <= share * room:
            return Plan(content.stride, planes, all_contacts)
    share_of_motion = 1 - CONTACT_SHARE if all_contacts else 1.0
    if motion > share_of_motion * room:
        stride = content.stride * max(2, math.ceil(motion / (share_of_motion * room)))
        return Plan(stride, planes, all_contacts)
    return Plan(content.stride, planes, _fitting(content.contacts, planes, room - motion, all_contacts))


def _estimate(track: Track, planes: int) -> float:
    """Bytes of a track, from some of its rows."""
    rows, length = track.values.shape
    if rows == 0 or length == 0:
        return 0.0
    sample = track.values[:: _spread(math.ceil(rows * length / SAMPLE))]
    bytes_of_sample = len(encoded(quantised(sample, planes, track.whole).codes, planes))
    return bytes_of_sample * float(rows) / len(sample)


def _spread(step: int) -> int:
    """The next step that meets all components of vectors and quaternions in turn."""
    return next(number for number in count(step) if number == 1 or math.gcd(number, 12) == 1)


def _contacts(contacts: Contacts | None, planes: int, most: int) -> float:
    """Bytes of the strongest `most` contacts of each frame, from some of the pairs of bodies."""
    if contacts is None or contacts.count == 0:
        return 0.0
    chosen = contacts.strongest(most)
    one_of = math.ceil(chosen.count / SAMPLE)
    sample = chosen.where((chosen.body_a * 7 + chosen.body_b * 13) % one_of == 0)
    sections = Sections()
    pack_contacts(sample, planes, sections)
    return sections.size * chosen.count / max(1, sample.count)


def _fitting(contacts: Contacts | None, planes: int, room: float, most: int) -> int:
    """How many contacts of each frame fit, by halving the span."""
    fits, too_many = 0, most
    while too_many - fits > max(1, fits // 32):
        middle = (fits + too_many) // 2
        if _contacts(contacts, planes, middle) <= room:
            fits = middle
        else:
            too_many = middle
    return fits
