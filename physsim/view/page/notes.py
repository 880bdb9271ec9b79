"""What a page says of itself: how exact its numbers are, and what was left out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

_WORDS = {
    "position": "positions",
    "orientation": "components of orientations",
    "velocity": "velocities",
    "angular_velocity": "angular velocities",
}
_UNITS = {"m s-1": "m/s", "rad s-1": "rad/s"}


@dataclass(frozen=True)
class Report:
    """frames, contacts: in the page; those in the file beside them (None: not recorded; those of left out
    frames are not counted). stride: every how many-th frame is there. most_contacts: of a frame, None where
    all are there. bits: of each number of a body. errors: the largest difference from the file's
    numbers, by dataset, in its own unit. force_error: relative, of each component of a contact force.
    """

    frames: int
    frames_in_file: int
    stride: int
    bodies: int
    bits: int
    contacts: int | None
    contacts_in_file: int | None
    most_contacts: int | None
    errors: Mapping[str, float]
    force_error: float | None
    units: Mapping[str, str]

    def as_data(self) -> dict[str, Any]:
        """For a JSON document."""
        return asdict(self)


def notes_of(report: Report) -> list[str]:
    """Sentences for people: precision first, then what was left out."""
    return [*_precision(report), *left_out(report)]


def left_out(report: Report) -> list[str]:
    """Sentences on what of the file is not in the page; none when all is."""
    return [*_contacts(report), *_frames(report)]


def _precision(report: Report) -> list[str]:
    if not report.bodies or not report.frames:
        return []
    parts = [
        f"{words} by at most {_size(report.errors[name], report.units[name])}"
        for name, words in _WORDS.items()
    ]
    if report.contacts:
        parts.append(f"contact forces by at most {100 * (report.force_error or 0):.2g} % a component")
    listed = f"{', '.join(parts[:-1])} and {parts[-1]}"
    return [f"Kept as {report.bits}-bit numbers: {listed} off those in the file."]


def _contacts(report: Report) -> list[str]:
    if report.most_contacts is None:
        return []
    return [
        f"Contacts: the strongest {report.most_contacts} of each frame are here, "
        f"{report.contacts} of {report.contacts_in_file} points."
    ]


def _frames(report: Report) -> list[str]:
    if report.frames == report.frames_in_file:
        return []
    return [
        f"Frames: every {report.stride}{_ending(report.stride)} and the last are here, "
        f"{report.frames} of {report.frames_in_file}."
    ]


def _size(error: float, unit: str) -> str:
    return f"{error:.2g} {_UNITS.get(unit, unit)}".rstrip()


def _ending(number: int) -> str:
    if number % 100 in {11, 12, 13}:
        return "th"
    return {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
