"""Frames that can be recognised: every number tells which frame, body and axis it belongs to.

position[t, n, k] = 1000 t + 10 n + k; frame t has t % 3 contacts; an impact happens in every fourth frame.
Joints and springs have 1000 t + 10 row (+ axis).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from physsim.recording import Block, Recorder, Target, layout, recorded

TIMESTEP = 0.001
STEPS_PER_FRAME = 10
ATTRIBUTES = {"physsim_version": "0.0.0", "title": "Made up", "seed": np.int64(7)}
COLUMNS = recorded(("energy", "contacts", "joints", "springs"))


def names(bodies: int) -> list[str]:
    return ["floor", *(f"ball[{index},0,0]" for index in range(bodies - 1))]


JOINTS = ["door", "wheel"]
SPRINGS = ["tether"]


def fixed_values(bodies: int) -> dict[str, Any]:
    texts = [c.path for c in layout.EVERYTHING if c.group == "provenance" and c.kind == "str"]
    return {
        "body": names(bodies),
        "mass": np.arange(bodies) + 1.0,
        "inertia": np.eye(3) * (np.arange(bodies) + 0.5)[:, None, None],
        "center_of_mass": np.zeros((bodies, 3)),
        "material": ["steel"] * bodies,
        "fixed": [1] + [0] * (bodies - 1),
        "pairs/pair": ["steel, steel"],
        "pairs/material_a": ["steel"],
        "pairs/material_b": ["steel"],
        "pairs/restitution": [0.6],
        "pairs/static_friction": [0.74],
        "pairs/kinetic_friction": [0.57],
        "pairs/rolling_friction": [0.001],
        "pairs/spinning_friction": [0.0],
        "pairs/source": ["library"],
        **dict.fromkeys(texts, "{}"),
        "provenance/wall_time": 0.0,
        **_who("joints", "joint", JOINTS),
        **_who("springs", "spring", SPRINGS),
        "joints/coordinate_unit": ["rad"] * len(JOINTS),
        "springs/length_unit": ["m"] * len(SPRINGS),
        "springs/force_unit": ["N"] * len(SPRINGS),
    }


def _who(group: str, axis: str, labels: list[str]) -> dict[str, Any]:
    """Between the world and body 1, tied at (1, 2, 3) of the latter."""
    count = len(labels)
    return {
        f"{group}/{axis}": labels,
        f"{group}/type": ["made up"] * count,
        f"{group}/body_a": [-1] * count,
        f"{group}/body_b": [1] * count,
        f"{group}/anchor_a": np.zeros((count, 3)),
        f"{group}/anchor_b": np.tile([1.0, 2.0, 3.0], (count, 1)),
    }


def frame(number: int, bodies: int) -> dict[str, Any]:
    body, axis = np.mgrid[:bodies, :3]
    position = 1000.0 * number + 10 * body + axis
    rows: dict[str, Any] = {
        "position": position,
        "orientation": np.tile([1.0, 0, 0, 0], (bodies, 1)),
        "velocity": position / 2,
        "angular_velocity": -position,
        "momentum/linear": np.full(3, float(number)),
        "momentum/angular": np.full(3, -float(number)),
    }
    for column in layout.EVERYTHING:
        if column.group in {"energy", "solver"}:
            rows[column.path] = number
        elif column.group in {"joints", "springs"} and column.grows_along:
            row, axis = np.mgrid[: len(JOINTS if column.group == "joints" else SPRINGS), :3]
            values = 1000.0 * number + 10 * row + axis
            rows[column.path] = values if column.dims[-1] == "axis" else values[:, 0]
    return rows | {"joints/broken": np.full(len(JOINTS), number % 2)}


def contacts(number: int) -> dict[str, Any]:
    return _rows("contacts", number % 3, number, ("contacts/frame", "contacts/offset"))


def events(number: int) -> dict[str, Any]:
    rows = _rows("events", int(number % 4 == 3), number, ())
    return rows | {"events/time": rows["events/time"] * 0 + time_of(number)}


def time_of(number: int) -> float:
    return number * STEPS_PER_FRAME * TIMESTEP


def _rows(group: str, count: int, number: int, leave_out: tuple[str, ...]) -> dict[str, Any]:
    """`count` rows holding the frame's number; body columns say 1 (A) and 0 (B)."""
    rows = {}
    for column in layout.EVERYTHING:
        if column.group == group and column.path not in leave_out:
            value = {"body_a": 1, "body_b": 0, "pair": 0, "sliding": 1}.get(column.name, number)
            rows[column.path] = np.full((count, *[3] * (len(column.dims) - 1)), value)
    return rows


def start(path: Path, bodies: int) -> Recorder:
    return Recorder.create(Target(path), COLUMNS, ATTRIBUTES, fixed_values(bodies))


def feed(recorder: Recorder, number: int, bodies: int) -> None:
    one = {"time": time_of(number), "step": number * STEPS_PER_FRAME, **frame(number, bodies)}
    rows = {path: np.asarray(row)[None] for path, row in one.items()}
    recorder.append(Block(rows, contacts(number), np.array([number % 3]), events(number)))


def record(path: Path, frames: int = 40, bodies: int = 3, first: int = 0, blocks: int = 7) -> Path:
    """A finished file, written in blocks of `blocks` frames."""
    recorder = start(path, bodies)
    for number in range(first, frames):
        feed(recorder, number, bodies)
        if number % blocks == 0:
            recorder.write_block()
    return recorder.finish(
        "complete", "", b"engine", frames * STEPS_PER_FRAME, {"provenance/finished": "now"}
    )
