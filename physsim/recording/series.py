"""What a trajectory hands out: series that read when sliced, and small tables."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
from numpy.typing import NDArray

from physsim.errors import FileTrouble
from physsim.recording.safe import guarded
from physsim.recording.target import in_words

if TYPE_CHECKING:
    import pandas

Array = NDArray[Any]


class Series:
    """One quantity over time, read only as far as it is asked for.

    `series[10]`, `series[10:20]`, `series[-1]`, `series[:, 2]` and `np.asarray(series)` give plain numpy
    arrays; the first axis is the frame. `units` is the unit in UDUNITS spelling.
    """

    def __init__(
        self, path: Path, dataset: h5py.Dataset, frames: int, units: str, row: int | None = None
    ) -> None:
        self.units = units
        self._path, self._dataset, self._row = path, dataset, row
        inner = dataset.shape[1:] if row is None else dataset.shape[2:]
        self.shape: tuple[int, ...] = (frames, *inner)
        self.dtype = dataset.dtype

    @property
    def ndim(self) -> int:
        return len(self.shape)

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, key: Any) -> Any:
        """As numpy would. Raises IndexError past the end, FileTrouble when the file is damaged there."""
        first, *rest = key if isinstance(key, tuple) else (key,)
        if first is Ellipsis:
            return self._read(0, len(self))[key]
        if isinstance(first, int | np.integer):
            frame = range(len(self))[first]
            return self._read(frame, frame + 1)[(0, *rest)]
        if isinstance(first, slice):
            wanted = range(len(self))[first]
            if len(wanted) == 0:
                return self._read(0, 0)[(slice(None), *rest)]
            start, stop = min(wanted[0], wanted[-1]), max(wanted[0], wanted[-1]) + 1
            return self._read(start, stop)[(slice(None, None, wanted.step), *rest)]
        return self._read(0, len(self))[key]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.asarray(self[:], dtype=dtype)

    def __repr__(self) -> str:
        return f"<{self._dataset.name}: {self.shape} in {self.units}, not read yet>"

    def _read(self, start: int, stop: int) -> Array:
        if not self._dataset:
            raise ValueError(f"{self._path}: the trajectory is closed")
        key = slice(start, stop) if self._row is None else (slice(start, stop), self._row)
        check_memory(self._path, (stop - start) * math.prod(self.shape[1:]) * self.dtype.itemsize)
        with guarded(self._path):
            return np.asarray(self._dataset[key])


class Table(Mapping[str, Array]):
    """Columns of equal length by name: `table["depth"]` or `table.depth`."""

    def __init__(self, columns: Mapping[str, Array]) -> None:
        self._columns = dict(columns)

    def __getitem__(self, name: str) -> Array:
        return self._columns[name]

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_") or name not in self._columns:
            raise AttributeError(f"no column {name!r}; there are {', '.join(self._columns)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """How many rows every column has."""
        return len(next(iter(self._columns.values())))

    def where(self, chosen: Array) -> Table:
        """The rows that a mask (rows) or a list of row numbers picks."""
        return Table({name: column[chosen] for name, column in self._columns.items()})

    def flat(self) -> dict[str, Array]:
        """Columns of single values: a column of vectors becomes `force.x`, `force.y`, `force.z`."""
        columns: dict[str, Array] = {}
        for name, column in self._columns.items():
            parts = (
                {f"{name}.{axis}": column[:, k] for k, axis in enumerate("xyz")} if column.ndim > 1 else {}
            )
            columns |= parts or {name: column}
        return columns

    def to_pandas(self) -> pandas.DataFrame:
        """The columns of `flat`. Needs pandas (extra `analysis`)."""
        import pandas  # noqa: PLC0415, optional and slow to import

        return pandas.DataFrame(self.flat())

    def __repr__(self) -> str:
        return f"<{self.rows} rows of {', '.join(self._columns)}>"


def check_memory(path: Path, needed: int) -> None:
    """Raises FileTrouble when `needed` bytes are more than the machine's memory."""
    if hasattr(os, "sysconf") and needed > (
        total := os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    ):
        raise FileTrouble(
            f"{path}: reading this at once takes {in_words(needed)}, the machine has {in_words(total)}; "
            "read it in slices"
        )
