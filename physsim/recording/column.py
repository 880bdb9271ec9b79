"""One dataset of the trajectory file: its name, axes, type, unit and meaning."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["f8", "i8", "i4", "i1", "u1", "str"]

FIXED_AXES = {"axis": ("x", "y", "z"), "axis_2": ("x", "y", "z"), "quaternion": ("w", "x", "y", "z")}
GROWING_AXES = ("time", "contact", "boundary", "event")


@dataclass(frozen=True)
class Column:
    """One dataset of the file.

    path: its name from the root, without the leading slash.
    dims: names of its axes, outermost first; a growing one can only be the first. Empty for a single value.
    kind: numpy type, or "str" for UTF-8 text of variable length.
    units: UDUNITS spelling; "1" for what has no unit.
    later: added after the first release; a file without it is whole.
    """

    path: str
    dims: tuple[str, ...]
    kind: Kind
    units: str
    description: str
    later: bool = False

    @property
    def group(self) -> str:
        """The group it lives in, "" for the root."""
        return self.path.rpartition("/")[0]

    @property
    def name(self) -> str:
        return self.path.rpartition("/")[2]

    @property
    def grows_along(self) -> str | None:
        """The axis that gets longer during a run, or None."""
        return self.dims[0] if self.dims and self.dims[0] in GROWING_AXES else None

    @property
    def is_scale(self) -> bool:
        """Whether it holds the labels of its own axis (a dimension scale)."""
        return self.dims == (self.name,)
