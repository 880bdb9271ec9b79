"""Fit file -> Fit: read and checked like a scene, measured data included; every mistake has its place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from physsim.batch.document import Document
from physsim.batch.fit_data import Floats, NoColumn, Source, open_data
from physsim.batch.fit_spec import DataSpec, FitSpec, FreeSpec, unit_of
from physsim.batch.spec.values import unit_text
from physsim.errors import FileTrouble, PathPart, Problem
from physsim.scene import Original, Scene
from physsim.scene.quantity import Quantity
from physsim.scene.units import PLAIN, same

Changes = dict[str, Any]


@dataclass(frozen=True)
class Measured:
    """One quantity of one experiment: times [s] of the simulation, values and sigma in SI."""

    quantity: Quantity
    time: Floats
    values: Floats
    sigma: float | None


@dataclass(frozen=True)
class Experiment:
    """One file: its name, what it changes in the scene, and what was measured."""

    file: str
    changes: Changes
    measured: tuple[Measured, ...]


@dataclass(frozen=True)
class Free:
    """A value that is sought, in SI. unit: as a scene would write it; log: whether steps are factors."""

    path: str
    start: float
    least: float
    most: float
    unit: str
    log: bool


@dataclass(frozen=True)
class Fit:
    """What the user wrote, found valid, with its data in memory."""

    spec: FitSpec
    name: str
    base: Original
    free: tuple[Free, ...]
    experiments: tuple[Experiment, ...]

    @property
    def title(self) -> str:
        """The fit's title, or the name of its file."""
        return self.spec.title or Path(self.name).stem


def load_fit(path: str | PathLike[str]) -> Fit:
    """Reads a fit file, its scene and its data.

    Raises FileTrouble when the fit file cannot be read, SceneError with every problem when the fit, its data,
    or the scene is not valid.
    """
    return _Loader(Document.read(Path(path), "a fit")).fit()


class _Loader:
    """One fit on its way from nodes to its spec."""

    def __init__(self, document: Document) -> None:
        self.document = document

    def fit(self) -> Fit:
        """Raises SceneError with everything that was found."""
        document = self.document
        base = document.base()
        scene = self._scene(base) if base is not None else None
        spec = document.spec(FitSpec, scene)
        experiments: list[Experiment] = []
        if spec is not None and base is not None and scene is not None:
            experiments = [
                one for k in range(len(spec.data)) if (one := self._experiment(spec, base, k)) is not None
            ]
        document.raise_what_was_found()
        assert spec is not None
        assert base is not None
        free = tuple(_free(path, value) for path, value in spec.parameters.items())
        return Fit(spec, document.name, base, free, tuple(experiments))

    def _tell(self, path: tuple[PathPart, ...], message: str, hint: str | None = None) -> None:
        self.document.tell(Problem(path, message, hint=hint))

    def _scene(self, base: Original) -> Scene | None:
        """The scene without what is sought; a SceneError of the scene itself is raised as it is."""
        changes = self.document.shared_changes()
        return self._changed(base, changes, {path: ("set", path) for path in changes})

    def _changed(
        self, base: Original, changes: Changes, places: dict[str, tuple[PathPart, ...]]
    ) -> Scene | None:
        """The scene with changes, as `Document.changed`; what it expects of its own run is left out."""
        return self.document.changed(base, {**changes, "expect": []}, places)

    def _experiment(self, spec: FitSpec, base: Original, k: int) -> Experiment | None:
        """One entry of `data`, read; None when something is wrong with it, which is told."""
        data = spec.data[k]
        changes = {**spec.set, **data.set}
        places: dict[str, tuple[PathPart, ...]] = {path: ("set", path) for path in spec.set}
        places |= {path: ("data", k, "set", path) for path in data.set}
        places |= {path: ("parameters", path, "start") for path in spec.parameters}
        started = {path: _written(free.start.value, free) for path, free in spec.parameters.items()}
        scene = self._changed(base, {**changes, **started}, places)
        if scene is None:
            return None
        for path, trouble in _unknown(data, scene):
            self._tell(("data", k, "quantities", path), trouble)
        try:
            source = open_data(self.document.folder / data.file)
        except FileTrouble as trouble:
            self._tell(
                ("data", k, "file"), str(trouble).removeprefix(f"{self.document.folder / data.file}: ")
            )
            return None
        measured = self._measured(data, source, k, float(scene.spec.simulation.duration))
        return Experiment(data.file, changes, tuple(measured))

    def _measured(self, data: DataSpec, source: Source, k: int, duration: float) -> list[Measured]:
        try:
            time = _in_si(source.column(data.time), data.time_unit) - data.start
        except NoColumn as error:
            self._tell(("data", k, "time"), str(error), error.hint)
            return []
        found = []
        for quantity, (name, spec) in zip(data.parsed, data.quantities.items(), strict=True):
            at = ("data", k, "quantities", name)
            try:
                values = _in_si(source.column(spec.column or name), spec.unit)
            except NoColumn as error:
                self._tell((*at, "column") if spec.column else at, str(error), error.hint)
                continue
            good = np.isfinite(time) & np.isfinite(values) & (time >= 0)
            trouble = _time_trouble(time, good, len(values), duration)
            if trouble:
                self._tell(at, trouble)
            sigma = None if spec.sigma is None else spec.sigma.value
            found.append(Measured(quantity, time[good], values[good], sigma)) if not trouble else None
        return found


def _time_trouble(time: Floats, good: np.ndarray, count: int, duration: float) -> str | None:
    if len(time) != count:
        return f"has {count} values for {len(time)} times"
    if not good.any():
        return "has no value at a time from 0 on"
    last = float(time[good].max())
    if last > duration * (1 + 1e-9):
        return f"was measured until {last:g} s, but the simulation ends at {duration:g} s"
    return None


def _in_si(values: Floats, unit: str) -> Floats:
    return values * unit_of(unit).in_si(1.0) if unit else values


def _free(path: str, spec: FreeSpec) -> Free:
    least = -np.inf if spec.min is None else spec.min.value
    most = np.inf if spec.max is None else spec.max.value
    return Free(path, spec.start.value, least, most, unit_text(spec.dimension), spec.scale == "log")


def _written(value: float, free: FreeSpec) -> Any:
    """The value with its unit, so that the scene checks the dimension."""
    return value if same(free.dimension, PLAIN) else f"{value!r} {unit_text(free.dimension)}"


def _unknown(data: DataSpec, scene: Scene) -> list[tuple[str, str]]:
    """Quantities of bodies, joints and springs that the scene has not."""
    known: dict[str, Callable[[], Any]] = {
        "bodies": lambda: scene.bodies,
        "joints": lambda: scene.spec.joints,
        "springs": lambda: scene.spec.springs,
    }
    return [
        (quantity.text, f"the scene has no {quantity.group} {quantity.name!r}")
        for quantity in data.parsed
        if quantity.group in known and quantity.name not in known[quantity.group]()
    ]
