"""runs.h5: all kept trajectories as one, by virtual datasets: `position` is (run, time, body, axis).

Nothing is copied. Runs that ended early have fewer frames: what they lack reads as NaN, and `frames` says how
many each has. A file that is missing would read as NaN, too: `run` lists those that are there.
"""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np

from physsim.batch.table import Table
from physsim.batch.workshop import COMPLETE
from physsim.errors import FileTrouble
from physsim.recording import Trajectory, open_trajectory
from physsim.recording.layout import BY_PATH

NAME = "runs.h5"
GROUPS = ("", "energy", "momentum", "joints", "springs", "solver")


def gather(table: Table, folder: Path) -> Path:
    """Writes runs.h5 for the complete runs of a table, beside the folder `runs`.

    Raises FileTrouble when there is no run, or when they do not have the same bodies, joints and springs.
    """
    rows = [row for row, status in enumerate(table.column("status")) if status == COMPLETE]
    files = [table.column("file")[row] for row in rows]
    if not files:
        raise FileTrouble(f"{folder}: no run is complete, so there is nothing to gather")
    counts = [_frames(folder / file) for file in files]
    path = folder / NAME
    with open_trajectory(folder / files[0]) as first, h5py.File(path, "w", libver="v110") as whole:
        whole.attrs["format"] = "physsim-runs"
        for column in table.columns:
            if column.kind != "text":
                values = [
                    np.nan if (cell := table.column(column.name)[row]) is None else cell for row in rows
                ]
                found = whole.create_dataset(f"table/{column.name}", data=np.array(values))
                found.attrs["units"] = column.unit
        whole.create_dataset("run", data=np.array([table.column("run")[row] for row in rows]))
        whole.create_dataset("frames", data=np.array(counts))
        names = {axis: list(first.values(axis)) for axis in ("body", "axis", "quaternion")}
        for axis, texts in names.items():
            whole.create_dataset(axis, data=texts, dtype=h5py.string_dtype())
        _lay_out(whole, first, folder, files, counts)
    return path


def _lay_out(whole: h5py.File, first: Trajectory, folder: Path, files: list[str], counts: list[int]) -> None:
    """One virtual dataset per dataset over time."""
    bodies = first.body_names
    for file in files[1:]:
        with open_trajectory(folder / file) as other:
            if (other.body_names, other.joint_names, other.spring_names) != (
                bodies,
                first.joint_names,
                first.spring_names,
            ):
                raise FileTrouble(f"{folder / file}: has other bodies than {files[0]}: cannot be gathered")
    for path, column in BY_PATH.items():
        if column.dims[:1] != ("time",) or not first.has(path):
            continue
        shape = first.series(path).shape[1:]
        kind = np.dtype("f8")
        layout = h5py.VirtualLayout((len(files), max(counts), *shape), kind)
        for k, (file, frames) in enumerate(zip(files, counts, strict=True)):
            source = h5py.VirtualSource(file, path, (frames, *shape), first.series(path).dtype)
            layout[k, :frames] = source
        found = whole.create_virtual_dataset(path, layout, fillvalue=np.nan)
        found.attrs["units"] = column.units
        found.attrs["dimensions"] = ", ".join(("run", *column.dims))


def _frames(path: Path) -> int:
    with open_trajectory(path) as trajectory:
        return trajectory.frames
