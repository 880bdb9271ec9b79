"""What `physsim info` says of the joints and springs in a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.cli.table import number, table

if TYPE_CHECKING:
    from physsim.recording import Trajectory

Facts = dict[str, Any]
FRAMES_AT_ONCE = 4096
SHOWN = 40


def joint_facts(trajectory: Trajectory) -> list[Facts]:
    """Of each joint the largest reaction and violation, and the coordinates at the end."""
    names = trajectory.joint_names
    if not names or trajectory.frames == 0:
        return []
    largest = {
        name: _largest(trajectory, f"joints/{name}")
        for name in ("force", "torque", "violation", "angular_violation")
    }
    tracks = [trajectory.joint(name) for name in names]
    return [
        {
            "name": track.name,
            "type": track.type,
            "between": list(track.between),
            **{f"largest_{name}": float(values[row]) for name, values in largest.items()},
            "coordinates": [
                {"last": float(series[-1]), "unit": unit}
                for series, unit in zip(
                    (track.coordinate, track.coordinate_2, track.coordinate_3), track.units, strict=True
                )
                if unit
            ],
            "broken": bool(track.broken[-1]),
        }
        for row, track in enumerate(tracks)
    ]


def spring_facts(trajectory: Trajectory) -> list[Facts]:
    """Of each spring its length (or angle) at both ends of the run, and the largest force (or torque)."""
    names = trajectory.spring_names
    if not names or trajectory.frames == 0:
        return []
    largest = _largest(trajectory, "springs/force")
    first, last = trajectory.series("springs/length")[0], trajectory.series("springs/length")[-1]
    tracks = [trajectory.spring(name) for name in names]
    return [
        {
            "name": track.name,
            "type": track.type,
            "between": list(track.between),
            "first_length": float(first[row]),
            "last_length": float(last[row]),
            "largest_force": float(largest[row]),
            "units": list(track.units),
        }
        for row, track in enumerate(tracks)
    ]


def joints_text(joints: list[Facts]) -> str:
    """The first joints, one in a line."""
    rows = [
        [
            joint["name"],
            joint["type"] + (", broken" if joint["broken"] else ""),
            " - ".join(joint["between"]),
            ", ".join(f"{number(part['last'])} {part['unit']}" for part in joint["coordinates"]),
            number(joint["largest_force"]),
            number(joint["largest_torque"]),
            number(joint["largest_violation"], 2),
        ]
        for joint in joints[:SHOWN]
    ]
    head = ("joint", "", "between", "at the end", "most force [N]", "torque [N m]", "violation [m]")
    return table(head, rows, right=(4, 5, 6)) + _more(len(joints))


def springs_text(springs: list[Facts]) -> str:
    """The first springs, one in a line."""
    rows = [
        [
            spring["name"],
            spring["type"],
            " - ".join(spring["between"]),
            f"{number(spring['first_length'])} {spring['units'][0]}",
            f"{number(spring['last_length'])} {spring['units'][0]}",
            f"{number(spring['largest_force'])} {spring['units'][1]}",
        ]
        for spring in springs[:SHOWN]
    ]
    head = ("spring", "", "between", "first", "last", "most force")
    return table(head, rows, right=(3, 4, 5)) + _more(len(springs))


def _largest(trajectory: Trajectory, path: str) -> Any:
    """Largest magnitude over all frames of each joint or spring, read in slices; lengths of vectors."""
    series = trajectory.series(path)
    found = np.zeros(series.shape[1])
    for start in range(0, len(series), FRAMES_AT_ONCE):
        values = series[start : start + FRAMES_AT_ONCE]
        sizes = np.linalg.norm(values, axis=2) if values.ndim == 3 else np.abs(values)
        found = np.fmax(found, sizes.max(axis=0))
    return found


def _more(count: int) -> str:
    return f"\n... and {count - SHOWN} more (--json shows all)" if count > SHOWN else ""
