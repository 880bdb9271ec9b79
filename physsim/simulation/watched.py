"""What `watch` kept of a run: read like a trajectory, as far as it was asked for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from physsim.recording import BodyTrack
from physsim.recording.block import Rows
from physsim.recording.series import Array, Table
from physsim.simulation.measure import origins

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.recording import Trajectory
    from physsim.recording.layout import Status

_ENDS = ("body_a", "body_b")


@dataclass(frozen=True)
class Watched:
    """A run in memory.

    time (T) [s]; status, status_detail: as in a file. names: the bodies that were watched; columns: what was
    measured over time, by dataset path; touching: columns of /contacts by name, of all frames one after the
    other; counts: contact points of each frame; impacts: columns of /events by name.
    What was not wanted is not there (KeyError).
    """

    time: Array
    status: Status
    status_detail: str
    names: tuple[str, ...]
    model: Model
    columns: Rows
    touching: Rows
    counts: Array
    impacts: Rows

    def as_trajectory(self) -> Trajectory:
        """This run for functions that read trajectories: quantities, expectations, metrics."""
        return cast("Trajectory", self)

    @property
    def frames(self) -> int:
        return len(self.time)

    def index_of(self, name: str) -> int:
        """The row of a watched body."""
        return self.names.index(name)

    def body(self, name: str) -> BodyTrack:
        """A watched body."""
        return BodyTrack(self.as_trajectory(), name)

    def joint(self, name: str) -> Any:
        """The columns of a joint over time."""
        return self._connection("joints", self.model.mechanics.joints.names.index(name))

    def spring(self, name: str) -> Any:
        """The columns of a spring over time."""
        return self._connection("springs", self.model.mechanics.springs.names.index(name))

    def series(self, path: str, row: int | None = None) -> Array:
        """A dataset over time, of one watched body when `row` says so."""
        if row is not None and path == "position":
            return self._origin(row)
        found = self.columns[path]
        return np.asarray(found if row is None else found[:, row])

    def values(self, path: str) -> Array:
        """What does not change with time, one row per watched body: mass, inertia, fixed, ..."""
        return np.asarray(getattr(self.model, path))[self._rows]

    def columns_in(self, group: str) -> list[SimpleNamespace]:
        """Names of the columns of a group."""
        return [SimpleNamespace(name=name) for name in self._group(group)]

    @cached_property
    def events(self) -> Table:
        """Every impact in the order of time, bodies by name."""
        return self._table(self.impacts)

    def contact_rows(self, first: int, last: int, columns: Iterable[str] = _ENDS) -> Table:
        """The contact points of the frames first to last, the last not included: their frame, and columns of
        /contacts by name, bodies by name.
        """
        counts = self.counts[first:last]
        start = int(self.counts[:first].sum())
        own = slice(start, start + int(counts.sum()))
        found = {name: self.touching[name][own] for name in columns if name != "frame"}
        return self._table({**found, "frame": np.repeat(np.arange(first, last), counts)})

    @cached_property
    def _rows(self) -> list[int]:
        return [self.model.body_names.index(name) for name in self.names]

    def _table(self, columns: Rows) -> Table:
        names = np.asarray(self.model.body_names)
        named = {name: names[columns[name]] for name in _ENDS if name in columns}
        return Table({**columns, **named})

    def _group(self, group: str) -> Rows:
        inside = ((path.partition("/"), found) for path, found in self.columns.items())
        return {name: found for (room, _, name), found in inside if room == group}

    def _connection(self, group: str, row: int) -> SimpleNamespace:
        return SimpleNamespace(**{name: found[:, row] for name, found in self._group(group).items()})

    def _origin(self, row: int) -> Array:
        """Where the centre of mass is the origin its position is taken as it is."""
        center, offset = self.columns["position"][:, row], self.values("center_of_mass")[row]
        if not offset.any():
            return np.asarray(center)
        return origins(center, self.columns["orientation"][:, row], np.tile(offset, (len(center), 1)))
