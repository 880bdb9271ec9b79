"""A trajectory as the data of a page: as exact as fits into the room there is.

All that moves is kept as 32-bit numbers when that leaves the page small, else in 24 or 16 bits. When even 16
are too many, contacts are thinned to the strongest of each frame; when that is not enough, frames are left
out. What belongs to the scene, its joints and springs (energies above all, whose small changes people want
to see) always has 32 bits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from physsim.errors import FileTrouble
from physsim.recording import Trajectory
from physsim.recording.connections import JOINTS, SPRINGS
from physsim.recording.target import in_words
from physsim.view.page.contacts import pack_contacts, relative_error
from physsim.view.page.head import still_part
from physsim.view.page.motion import BODY_TRACKS, Track
from physsim.view.page.notes import Report, notes_of
from physsim.view.page.plan import SCENE_PLANES, Content, Plan, planned, read
from physsim.view.page.quantise import quantised
from physsim.view.page.sections import Sections
from physsim.view.stage import stage_of

FORMAT_VERSION = 1
# An estimate that was too low makes the next plan aim so much lower.
MARGIN = 0.96
ATTEMPTS = 8


@dataclass(frozen=True)
class Packed:
    """head: the JSON of the page; data: its sections; report: what was done."""

    head: dict[str, Any]
    data: list[bytes]
    report: Report

    @property
    def size(self) -> int:
        """Bytes of the sections."""
        return sum(map(len, self.data))


def packed(trajectory: Trajectory, room: int) -> Packed:
    """The data of a page whose sections take at most `room` bytes.

    Memory: 8 bytes for each of at most `plan.MOST_NUMBERS` numbers, and as much again. Raises FileTrouble
    when the file is damaged or keeps no shapes, or when nothing of it fits.
    """
    still = Sections()
    shapes = still_part(stage_of(trajectory), still)
    content, aim = read(trajectory, 1), room - still.size
    for _ in range(ATTEMPTS):
        if aim <= 0:
            break
        plan = planned(content, aim)
        if plan.stride != content.stride:
            content = read(trajectory, plan.stride)
            continue
        made = _made(trajectory, content, plan, still.copy(), shapes)
        if made.size <= room:
            return made
        aim = int(aim * MARGIN * room / made.size)
    raise FileTrouble(
        f"{trajectory.path}: does not fit into {in_words(room)}, of which shapes alone take "
        f"{in_words(still.size)}; --max-size allows more"
    )


def _made(
    trajectory: Trajectory, content: Content, plan: Plan, sections: Sections, shapes: dict[str, Any]
) -> Packed:
    errors: dict[str, float] = {}
    tracks = [_track(track, plan.planes, sections, errors) for track in content.tracks]
    chosen = content.contacts.strongest(plan.most_contacts) if content.contacts else None
    contacts = pack_contacts(chosen, plan.planes, sections) if chosen else None
    in_file = int(chosen.in_file.sum()) if chosen else None
    report = Report(
        frames=len(content.kept),
        frames_in_file=trajectory.frames,
        stride=content.stride,
        bodies=len(trajectory.body_names),
        bits=8 * plan.planes,
        contacts=chosen.count if chosen else None,
        contacts_in_file=in_file,
        most_contacts=chosen.most_in_a_frame if chosen and chosen.count != in_file else None,
        errors=errors,
        force_error=relative_error(plan.planes) if chosen else None,
        units={track.name: track.unit for track in content.tracks},
    )
    head = {
        "version": FORMAT_VERSION,
        "about": _about(trajectory, report),
        "frames": len(content.kept),
        "times": sections.add("f8", trajectory.time[content.kept]),
        **shapes,
        "units": _units(trajectory),
        "tracks": tracks,
        "contacts": contacts,
        "sections": sections.heads,
    }
    return Packed(head, sections.data, report)


def _about(trajectory: Trajectory, report: Report) -> dict[str, Any]:
    return {
        "title": trajectory.title,
        "file": trajectory.path.name,
        "status": trajectory.status,
        "detail": trajectory.status_detail,
        "physsim_version": trajectory.physsim_version,
        "frames_in_file": report.frames_in_file,
        "notes": notes_of(report),
    }


def _track(track: Track, planes: int, sections: Sections, errors: dict[str, float]) -> dict[str, Any]:
    """The track as sections; `scale` holds base, step and error of each row and component, one after the
    other.
    """
    planes = planes if track.name in BODY_TRACKS else SCENE_PLANES
    numbers = quantised(track.values, planes, track.whole)
    errors[track.name] = float(numbers.error.max(initial=0.0))
    return {
        "name": track.name,
        "unit": track.unit,
        "rows": track.rows,
        "components": track.components,
        "codes": sections.add_codes(numbers.codes, planes),
        "scale": sections.add("f8", np.concatenate([numbers.base, numbers.step, numbers.error])),
    }


def _units(trajectory: Trajectory) -> dict[str, list[str]]:
    """Units that differ from row to row: of coordinates of joints, of length and force of springs."""
    paths = [
        column.path
        for column in (*JOINTS, *SPRINGS)
        if column.kind == "str" and column.name.endswith("_unit")
    ]
    return {
        path.removesuffix("_unit"): [str(unit) for unit in trajectory.values(path)]
        for path in paths
        if trajectory.has(path)
    }
