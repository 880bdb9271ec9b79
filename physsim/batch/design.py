"""From the axes of a sweep to its runs: what each changes in the scene, and what its row says of it."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from physsim.batch.distributions import Floats, points, values_at
from physsim.batch.spec.axes import ListAxis, LogRangeAxis, RangeAxis
from physsim.batch.spec.sweep import SampleSpec, SweepSpec
from physsim.batch.spec.values import common, unit_text
from physsim.scene.grammar import ExpressionError
from physsim.scene.parameters import BrokenParameter, Parameters, measured
from physsim.scene.units import PLAIN, Dimension, Measure, UnitError

Cell = float | str
SEED_PATH = "simulation.seed"


@dataclass(frozen=True)
class Values:
    """One varied path: what is written into the scene, value by value, and what the table says.

    unit: SI unit of the cells; "" for plain numbers and for text.
    """

    path: str
    written: tuple[Any, ...]
    cells: tuple[Cell, ...]
    unit: str

    @property
    def is_number(self) -> bool:
        """Whether the cells are numbers."""
        return not isinstance(self.cells[0], str)


@dataclass(frozen=True)
class Run:
    """One run: its number from 0, the replicate it belongs to, changes to the scene, cells of its row."""

    number: int
    replicate: int
    changes: tuple[tuple[str, Any], ...]
    cells: tuple[Cell, ...]

    @cached_property
    def key(self) -> str:
        """What tells this run from others of the scene, whatever its number."""
        return hashlib.sha256(json.dumps(self.changes).encode()).hexdigest()[:16]

    @property
    def file(self) -> str:
        """Where its trajectory goes, if it is kept."""
        return f"runs/{self.number:06}-{self.key[:8]}.h5"


@dataclass(frozen=True)
class Design:
    """All runs of a sweep, made when asked for: replicates outside, then grid, zip and sample."""

    spec: SweepSpec
    grid: tuple[Values, ...]
    zip: tuple[Values, ...]
    _samples: dict[int, tuple[Values, ...]] = field(default_factory=dict, repr=False, compare=False)

    @property
    def columns(self) -> tuple[Values, ...]:
        """What varies, in the order of the table."""
        return (*self.grid, *self.zip, *self.sample(0))

    def __len__(self) -> int:
        return self.spec.replicates * math.prod(self._lengths)

    def __iter__(self) -> Iterator[Run]:
        return (self.run(number) for number in range(len(self)))

    def run(self, number: int) -> Run:
        """The run of that number."""
        replicate, rest = divmod(number, math.prod(self._lengths))
        picked = [(axis, i) for axis, i in self._picked(replicate, rest)]
        changes = [(axis.path, axis.written[i]) for axis, i in picked]
        if self.spec.replicates > 1:
            changes.append((SEED_PATH, self.spec.seed + replicate))
        return Run(number, replicate, tuple(changes), tuple(axis.cells[i] for axis, i in picked))

    def sample(self, replicate: int) -> tuple[Values, ...]:
        """The sampled values of one replicate."""
        if self.spec.sample is None:
            return ()
        if replicate not in self._samples:
            self._samples[replicate] = _sampled(self.spec.sample, [self.spec.seed, replicate])
        return self._samples[replicate]

    def _picked(self, replicate: int, rest: int) -> Iterator[tuple[Values, int]]:
        rest, drawn = divmod(rest, self._lengths[-1])
        rest, paired = divmod(rest, self._lengths[-2])
        for axis, step in zip(self.grid, _steps([len(axis.cells) for axis in self.grid]), strict=True):
            index, rest = divmod(rest, step)
            yield axis, index
        yield from ((axis, paired) for axis in self.zip)
        yield from ((axis, drawn) for axis in self.sample(replicate))

    @cached_property
    def _lengths(self) -> tuple[int, ...]:
        sample = self.spec.sample
        grid = (len(axis.cells) for axis in self.grid)
        return (*grid, len(self.zip[0].cells) if self.zip else 1, sample.count if sample else 1)


def design_of(spec: SweepSpec) -> Design:
    """The design of a sweep whose axes are right in themselves."""
    grid = tuple(values_of(path, axis) for path, axis in spec.grid.items())
    return Design(spec, grid, tuple(values_of(path, axis) for path, axis in spec.zip.items()))


def length_of(axis: ListAxis | RangeAxis) -> int:
    """Number of values of an axis."""
    return len(axis.values) if isinstance(axis, ListAxis) else axis.count


def values_of(path: str, axis: ListAxis | RangeAxis) -> Values:
    """The values of an axis in order."""
    if isinstance(axis, ListAxis):
        return _listed(path, axis)
    dimension = common([axis.start, axis.stop]) or PLAIN
    return _numbers(path, [_between(axis, i) for i in range(axis.count)], dimension)


def _between(axis: RangeAxis, i: int) -> float:
    """Value i of a range; both ends come out exactly."""
    start, stop = axis.start.value, axis.stop.value
    if i == 0:
        return start
    if i == axis.count - 1:
        return stop
    share = i / (axis.count - 1)
    if isinstance(axis, LogRangeAxis):
        return start * math.exp(share * math.log(stop / start))
    return start + share * (stop - start)


def _listed(path: str, axis: ListAxis) -> Values:
    """Numbers where all are numbers of one dimension, in SI; otherwise text as written."""
    measures = [_measure(value) for value in axis.values]
    known = [one for one in measures if one is not None]
    dimension = common(known) if len(known) == len(measures) else None
    if dimension is None:
        return Values(path, axis.values, tuple(_text(value) for value in axis.values), "")
    return Values(path, axis.values, tuple(one.value for one in known), unit_text(dimension))


def _measure(value: object) -> Measure | None:
    try:
        return measured(value, Parameters({})).measure
    except (UnitError, ExpressionError, BrokenParameter):
        return None


def _text(value: object) -> str:
    return value if isinstance(value, str) else json.dumps(value)


def _numbers(path: str, numbers: Sequence[float], dimension: Dimension) -> Values:
    """Numbers with their unit: a parameter keeps its dimension, and every digit arrives."""
    unit = unit_text(dimension)
    written = tuple(f"{number!r} {unit}" if unit else number for number in numbers)
    return Values(path, written, tuple(numbers), unit)


def _sampled(spec: SampleSpec, seed: list[int]) -> tuple[Values, ...]:
    u = points(spec.method, spec.count, len(spec.values), seed)
    return tuple(_drawn(path, of, u[:, k]) for k, (path, of) in enumerate(spec.values.items()))


def _drawn(path: str, distribution: Any, u: Floats) -> Values:
    given = [value for name in distribution.ALIKE if (value := getattr(distribution, name)) is not None]
    return _numbers(path, values_at(distribution, u).tolist(), common(given) or PLAIN)


def _steps(lengths: Sequence[int]) -> list[int]:
    """How many combinations of the later axes go by before an axis moves on."""
    return [math.prod(lengths[k + 1 :]) for k in range(len(lengths))]
