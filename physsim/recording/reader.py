"""Reading a trajectory: by body name, lazily, and never more than the file has whole."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import h5py
import numpy as np
from numpy.typing import ArrayLike

from physsim.errors import FileTrouble, PhyssimError
from physsim.recording import contact_choice, layout, views
from physsim.recording.checkpoint import Checkpoint, newest
from physsim.recording.column import Column
from physsim.recording.connection_track import JointTrack, SpringTrack
from physsim.recording.contents import columns_of, find_datasets, whole_frames
from physsim.recording.quantities import over_time
from physsim.recording.resample import at_times
from physsim.recording.safe import (
    Damaged,
    guarded,
    number_attribute,
    open_for_reading,
    text_attribute,
)
from physsim.recording.series import Array, Series, Table, check_memory
from physsim.recording.target import part_of
from physsim.recording.track import BodyTrack

if TYPE_CHECKING:
    import pandas
    import xarray

    from physsim.scene.quantity import Quantity

_BODY_ROWS = ("body_a", "body_b")
_NAMES = {"body": "body", "joint": "joints/joint", "spring": "springs/spring"}
# A file that is being written can be caught between two writes: it is looked at again this often, so much
# later.
TRIES_WHILE_WRITTEN = 10
SECONDS_BETWEEN_TRIES = 0.05


class NotInFile(PhyssimError):
    """The trajectory has no such body, joint, spring or frame, or did not record what is asked for."""

    exit_code = 2


def open_trajectory(path: str | Path) -> Trajectory:
    """Opens a trajectory file for reading, also while its run is still writing or after it was killed.

    When only `path`.part is there (a run that was to replace a file and was killed), that is opened.
    Raises FileTrouble when the file is missing, damaged or no trajectory.
    """
    path = Path(path)
    if not path.exists() and part_of(path).exists():
        path = part_of(path)
    for _ in range(TRIES_WHILE_WRITTEN - 1):
        file, writing = open_for_reading(path)
        try:
            return Trajectory(path, file, writing)
        except FileTrouble:
            file.close()
            if not writing:
                raise
        time.sleep(SECONDS_BETWEEN_TRIES)
    file, writing = open_for_reading(path)
    return Trajectory(path, file, writing)


def open_own(path: Path) -> Trajectory:
    """Opens a file that this process has just finished: nobody has looked for damage in it.

    Raises FileTrouble when it cannot be opened.
    """
    return Trajectory(path, *open_for_reading(path, trusted=True))


class Trajectory:
    """An open trajectory file. A context manager: `with open_trajectory("run.h5") as t: ...`

    path: the file; frames: number of whole frames; status: running, complete, failed or interrupted;
    status_detail: why it ended; being_written: whether its run is still alive; title, seed,
    physsim_version: as in the scene that made it; body_names, joint_names, spring_names: in scene order,
    none where they were not recorded.
    """

    def __init__(self, path: Path, file: h5py.File, being_written: bool = False) -> None:
        self.path = path
        self.being_written = being_written
        self._file = file
        self._values: dict[str, Array] = {}
        with guarded(path):
            self._read_attributes()
            self._datasets = find_datasets(file)
            self.frames = whole_frames(self._datasets)
            names = {word: self._names(path) for word, path in _NAMES.items()}
            self.body_names, self.joint_names, self.spring_names = names.values()
            self._index = {word: {name: row for row, name in enumerate(some)} for word, some in names.items()}

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Trajectory {self.path}: {len(self.body_names)} bodies, {self.frames} frames, {self.status}>"

    def close(self) -> None:
        self._file.close()

    @property
    def time(self) -> Array:
        """(T) s."""
        return self._over_time("time")

    @property
    def step(self) -> Array:
        """(T) steps done."""
        return self._over_time("step")

    @property
    def position(self) -> Series:
        """Of every body's own origin, (T, N, 3) m."""
        return self.series("position")

    @property
    def orientation(self) -> Series:
        """Unit quaternions (w, x, y, z), body to world, (T, N, 4)."""
        return self.series("orientation")

    @property
    def velocity(self) -> Series:
        """Of the centres of mass, (T, N, 3) m/s."""
        return self.series("velocity")

    @property
    def angular_velocity(self) -> Series:
        """World axes, (T, N, 3) rad/s."""
        return self.series("angular_velocity")

    def body(self, name: str) -> BodyTrack:
        """One body by name. Raises NotInFile with the nearest name."""
        return BodyTrack(self, name)

    def joint(self, name: str) -> JointTrack:
        """One joint by name. Raises NotInFile with the nearest name."""
        return JointTrack(self, name)

    def spring(self, name: str) -> SpringTrack:
        """One spring by name. Raises NotInFile with the nearest name."""
        return SpringTrack(self, name)

    def index_of(self, name: str) -> int:
        """The row of a body. Raises NotInFile with the nearest name."""
        return self.row_of("body", name)

    def row_of(self, word: str, name: str) -> int:
        """The row of a `body`, `joint` or `spring`. Raises NotInFile with the nearest name."""
        rows = self._index[word]
        if name in rows:
            return rows[name]
        if not rows:
            raise NotInFile(f"{self.path}: has no {word}s: the scene has none, or they were not recorded")
        near = difflib.get_close_matches(name, rows, n=1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise NotInFile(f"{self.path}: has no {word} {name!r}{hint}")

    def frame_at(self, moment: float) -> int:
        """The frame nearest to a time [s]."""
        return int(np.argmin(np.abs(self.time - moment)))

    def bodies(self, pattern: str = "*") -> tuple[str, ...]:
        """Names of the bodies that fit the pattern, in scene order; `*` stands for any characters.

        Raises NotInFile, with the nearest name, when none does.
        """
        from physsim.scene.patterns import matches  # noqa: PLC0415, slow to import

        found = tuple(name for name in self.body_names if matches(pattern, name))
        if not found:
            self.index_of(pattern)
        return found

    def find_quantity(self, name: str) -> Quantity:
        """What a name such as `bodies.crate.position.z` stands for, with its unit. Raises NotInFile."""
        from physsim.scene.quantity import QuantityError, parse_quantity  # noqa: PLC0415, slow to import

        types = dict(zip(self.joint_names, self._names("joints/type"), strict=True))
        try:
            return parse_quantity(name, types)
        except QuantityError as error:
            hints = [text for text in (error.hint, error.allowed and f"allowed: {error.allowed}") if text]
            raise NotInFile("; ".join([f"{name}: {error}", *hints])) from None

    def quantity(self, name: str, frames: slice = slice(None)) -> Array:
        """A quantity by its name, as in `expect`: (T), or (T, 3) or (T, 4) for a whole vector; SI.

        frames: which of them; only these are read. Raises NotInFile.
        """
        return over_time(self, self.find_quantity(name), frames)

    def resample(self, name: str, times: ArrayLike) -> Array:
        """A quantity at `times` [s]: straight lines between frames, arcs for orientations.

        Raises NotInFile, and ValueError for times outside of the trajectory.
        """
        return at_times(self, self.find_quantity(name), times)

    def contacts(
        self, frame: int | None = None, *, body: str | None = None, other: str | None = None
    ) -> Table:
        """The contact points of one frame, or of all: the columns of /contacts, bodies by name.

        body, other: only those in which the two take part. `pair` is the row of `pairs`. Frame 0 has none: no
        step has been done. Raises NotInFile when the run did not record contacts, for a frame past the end,
        and for a body that is not there.
        """
        for name in (body, other):
            if name is not None:
                self.index_of(name)
        if frame is None:
            first, last = 0, self.frames
        elif -self.frames <= frame < self.frames:
            first = frame % self.frames
            last = first + 1
        else:
            raise NotInFile(f"{self.path}: has no frame {frame}; it has {self.frames} frames")
        return contact_choice.between(self.contact_rows(first, last), body, other)

    def contact_rows(
        self, first: int, last: int, columns: Iterable[str] | None = None, *, by_name: bool = True
    ) -> Table:
        """The contact points of the frames first to last, the last not included; only some columns when
        named. by_name: bodies as names, else as rows of /body, as the file has them (unchecked, and far
        faster where there are millions). Raises NotInFile when the run did not record contacts.
        """
        self._need_group("contacts")
        wanted = None if columns is None else set(columns)
        leave_out = [
            column.path
            for column in columns_of("contacts")
            if column.name == "offset" or (wanted is not None and column.name not in wanted)
        ]
        with guarded(self.path):
            start, stop = (int(self._datasets["contacts/offset"][row]) for row in (first, last))
            return self._rows("contacts", start, stop, leave_out, by_name)

    @property
    def events(self) -> Table:
        """Every impact in the order of time: the columns of /events, bodies by name."""
        with guarded(self.path):
            count = min(self._datasets[column.path].shape[0] for column in columns_of("events"))
            times = self._datasets["events/time"][:count]
            end = self.time[-1] if self.frames else -np.inf
            return self._rows("events", 0, int(np.searchsorted(times, end, side="right")))

    @property
    def energy(self) -> Table:
        """The columns of /energy, each (T) J. Raises NotInFile when the run did not record them."""
        self._need_group("energy")
        return self._table_over_time("energy")

    @property
    def momentum(self) -> Table:
        """`linear` (T, 3) kg m/s, and `angular` about the world's origin (T, 3) kg m2/s."""
        return self._table_over_time("momentum")

    @property
    def solver(self) -> Table:
        """`residual` (T) m/s, `iterations` (T), `contact_count` (T), `fallbacks` (T)."""
        return self._table_over_time("solver")

    @property
    def pairs(self) -> Table:
        """The resolved coefficients of every pair of materials, with where each came from."""
        return Table({column.name: self.values(column.path) for column in self.columns_in("pairs")})

    @property
    def provenance(self) -> dict[str, Any]:
        """Scene text, resolved scene, mesh hashes (JSON), versions (JSON), host, command and clock times."""
        return {column.name: self._provenance(column.path) for column in columns_of("provenance")}

    def _provenance(self, path: str) -> Any:
        try:
            return self.values(path).item()
        except FileTrouble:
            if path != "provenance/finished":
                raise
            return ""

    def checkpoint(self) -> Checkpoint | None:
        """The newest whole checkpoint, or None."""
        with guarded(self.path):
            return newest(self._file)

    def series(self, path: str, row: int | None = None) -> Series:
        """A dataset over time by its path in the file, of one body, joint or spring (by row) where it has
        such an axis. Raises NotInFile.
        """
        if path not in self._datasets:
            raise NotInFile(f"{self.path}: has no /{path}")
        return Series(self.path, self._datasets[path], self.frames, layout.BY_PATH[path].units, row)

    def values(self, path: str) -> Array:
        """A dataset that does not change with time, whole, texts as str."""
        if path not in self._values:
            found = self._datasets[path]
            with guarded(self.path):
                text = layout.BY_PATH[path].kind == "str"
                self._values[path] = np.asarray(found.asstr()[()] if text else found[()])
        return self._values[path]

    def has(self, path: str) -> bool:
        """Whether the file has a dataset of this path."""
        return path in self._datasets

    def columns_in(self, group: str) -> list[Column]:
        """The table's columns of a group ("" for the root) that the file has: an older one may lack some.

        Raises NotInFile when it has none of them.
        """
        if group:
            self._need_group(group)
        return [column for column in columns_of(group) if column.path in self._datasets]

    @property
    def attributes(self) -> dict[str, Any]:
        """The attributes of the root."""
        with guarded(self.path):
            return dict(self._file.attrs)

    def to_pandas(
        self, quantities: Sequence[str] | None = None, times: ArrayLike | None = None
    ) -> pandas.DataFrame:
        """One row per frame, one column per number, named like the quantities; the index is the time [s].

        quantities: names as in `expect`; the state of every body when not given. times: other times than
        those of the frames, as `resample` does it. Needs pandas (extra `analysis`).
        """
        return views.to_pandas(self, quantities, times)

    def to_xarray(self, bodies: str | None = None, frames: slice = slice(None)) -> xarray.Dataset:
        """The root of the file in memory, as `xarray.open_dataset(path)` gives it, but whole frames only.

        bodies: a pattern (`brick*`), all when not given; frames: which of them. Needs xarray (extra
        `analysis`); `xarray.open_dataset(path)` itself reads no more than it is asked for.
        """
        return views.to_xarray(self, bodies, frames)

    def _read_attributes(self) -> None:
        self.status = self._last_word("status") or "running"
        self.status_detail = self._last_word("status_detail")
        self.title = text_attribute(self._file, "title")
        self.seed = number_attribute(self._file, "seed")
        self.physsim_version = text_attribute(self._file, "physsim_version")
        if self.status not in layout.STATUSES:
            raise Damaged(f"has the status {self.status!r}, which is none of {', '.join(layout.STATUSES)}")

    def _last_word(self, name: str) -> str:
        """Of a run that was killed while it wrote how it ended, that text alone may be torn: then ""."""
        try:
            return text_attribute(self._file, name)
        except OSError:
            return ""

    def _over_time(self, path: str) -> Array:
        return np.asarray(self.series(path)[:])

    def _table_over_time(self, group: str) -> Table:
        return Table({column.name: self._over_time(column.path) for column in self.columns_in(group)})

    def _names(self, path: str) -> tuple[str, ...]:
        return tuple(str(name) for name in self.values(path)) if path in self._datasets else ()

    def _need_group(self, group: str) -> None:
        if columns_of(group)[0].path not in self._datasets:
            raise NotInFile(f"{self.path}: {group} not recorded (record: {{{group}: false}} in the scene)")

    def _rows(
        self, group: str, start: int, stop: int, leave_out: Iterable[str] = (), by_name: bool = True
    ) -> Table:
        rows = {}
        for column in columns_of(group):
            if column.path in leave_out:
                continue
            found = self._datasets[column.path]
            if not 0 <= start <= stop <= found.shape[0]:
                raise Damaged(f"/{column.path}: is shorter than /{group} says")
            check_memory(self.path, (stop - start) * math.prod(found.shape[1:]) * found.dtype.itemsize)
            data = np.asarray(found[start:stop])
            named = by_name and column.name in _BODY_ROWS
            rows[column.name] = np.asarray(self.body_names)[data] if named else data
        return Table(rows)
