"""Measured data: columns of CSV files, quantities of trajectories, datasets of other HDF5 files."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from physsim.errors import FileTrouble
from physsim.recording import NotInFile, Trajectory, open_trajectory
from physsim.recording.target import plain
from physsim.scene.suggest import did_you_mean

Floats = NDArray[np.float64]
HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"
MOST_BYTES = 1 << 30
_DELIMITERS = ",;\t"


class NoColumn(ValueError):
    """The file has no such column, or it holds no numbers; `hint` names the likely slip."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


class Source(Protocol):
    """A file of measured data."""

    def column(self, name: str) -> Floats:
        """Its values. Raises NoColumn."""


def open_data(path: Path) -> Source:
    """The file, whatever its kind. Raises FileTrouble."""
    try:
        with path.open("rb") as file:
            head = file.read(len(HDF5_SIGNATURE))
        if path.stat().st_size > MOST_BYTES:
            raise FileTrouble(f"{path}: is larger than {MOST_BYTES >> 30} GiB, the most for measured data")
    except OSError as error:
        raise FileTrouble(f"{path}: {plain(error)}") from None
    if head != HDF5_SIGNATURE:
        return read_csv(path)
    try:
        return Recorded(open_trajectory(path))
    except FileTrouble as trouble:
        if "not a physsim trajectory" not in str(trouble):
            raise
    return Datasets(path)


@dataclass(frozen=True)
class Columns:
    """A CSV file: a header, then numbers. Lines that begin with # are left out; empty cells are NaN."""

    cells: dict[str, list[str]]

    def column(self, name: str) -> Floats:
        """The values; NaN for empty cells."""
        if name not in self.cells:
            hint = did_you_mean(name, self.cells) or f"there are {', '.join(list(self.cells)[:10])}"
            raise NoColumn(f"the file has no column '{name}'", hint)
        try:
            return np.array([float(cell) if cell.strip() else np.nan for cell in self.cells[name]])
        except ValueError as error:
            raise NoColumn(f"the column '{name}' does not hold numbers: {error}") from None


def read_csv(path: Path) -> Columns:
    """Columns by name; the delimiter is a comma, a semicolon or a tab. Raises FileTrouble."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise FileTrouble(f"{path}: cannot be read as CSV: {plain(error)}") from None
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if len(lines) < 2:
        raise FileTrouble(f"{path}: holds no data: a line of names and lines of numbers are wanted")
    delimiter = max(_DELIMITERS, key=lines[0].count)
    names, *rows = csv.reader(lines, delimiter=delimiter)
    for number, row in enumerate(rows, start=1):
        if len(row) != len(names):
            raise FileTrouble(f"{path}: row {number} has {len(row)} cells, the header {len(names)}")
    return Columns({name.strip(): [row[k] for row in rows] for k, name in enumerate(names)})


@dataclass(frozen=True)
class Recorded:
    """A trajectory of physsim: columns are quantities."""

    trajectory: Trajectory

    def column(self, name: str) -> Floats:
        """The quantity over all frames."""
        try:
            found = self.trajectory.quantity(name)
        except NotInFile as error:
            raise NoColumn(str(error)) from None
        if found.ndim > 1:
            raise NoColumn(f"'{name}' is a vector, one number per frame is wanted")
        return np.asarray(found, np.float64)


@dataclass(frozen=True)
class Datasets:
    """Any other HDF5 file: columns are datasets of one axis, by path."""

    path: Path

    def column(self, name: str) -> Floats:
        """The dataset as double precision."""
        import h5py  # noqa: PLC0415, only for such files

        try:
            with h5py.File(self.path, "r") as file:
                found: Any = file.get(name)
                if not isinstance(found, h5py.Dataset) or found.ndim != 1 or found.dtype.kind not in "fiu":
                    raise NoColumn(f"the file has no dataset '{name}' with one axis of numbers")
                return np.asarray(found[:], np.float64)
        except (OSError, RuntimeError) as error:
            raise FileTrouble(f"{self.path}: cannot be read: {plain(error)}") from None
