"""Checks across a sweep and its scene; functions that yield problems by path."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from physsim.batch.arithmetic import check_expression
from physsim.batch.design import SEED_PATH, Values, design_of, length_of
from physsim.batch.spec import SweepSpec
from physsim.batch.spec.axes import MOST_RUNS
from physsim.batch.spec.metrics import EnergyLostMetric, FirstContactMetric, ValueMetric
from physsim.errors import PathPart, Problem, SceneError, dotted
from physsim.scene.checks.expect import trouble_of
from physsim.scene.draft import Draft, draft_of
from physsim.scene.grammar import ExpressionError
from physsim.scene.suggest import did_you_mean

if TYPE_CHECKING:
    from physsim.scene import Original, Scene

Path = tuple[PathPart, ...]
SECTIONS = ("grid", "zip", "sample")
MOST_VALUES_TRIED = 20
PARAMETERS = "parameters."


def all_problems(spec: SweepSpec, base: Original, scene: Scene) -> Iterator[Problem]:
    """Everything that is wrong between the parts of the sweep, and between it and its scene."""
    amiss = [*_twice(spec), *_lengths(spec), *_nothing_to_do(spec)]
    yield from amiss
    yield from _metrics(spec, scene)
    if not amiss:
        yield from _paths(spec, base, scene)


def all_warnings(spec: SweepSpec) -> Iterator[Problem]:
    """What is allowed but probably not meant."""
    sample = spec.sample
    if sample is not None and sample.method == "sobol" and sample.count & (sample.count - 1):
        better = 1 << sample.count.bit_length()
        message = f"Sobol points are balanced for powers of 2 only: {better // 2} or {better}"
        yield Problem(("sample", "count"), message, str(sample.count), severity="warning")


def places_of(spec: SweepSpec) -> Iterator[tuple[Path, str]]:
    """Where each varied path stands, and the path."""
    yield from ((("grid", path), path) for path in spec.grid)
    yield from ((("zip", path), path) for path in spec.zip)
    if spec.sample is not None:
        yield from ((("sample", "values", path), path) for path in spec.sample.values)


def _twice(spec: SweepSpec) -> Iterator[Problem]:
    seen: Counter[str] = Counter(spec.set)
    if spec.replicates > 1:
        seen[SEED_PATH] += 1
    for place, path in places_of(spec):
        seen[path] += 1
        if seen[path] > 1:
            by = "replicates" if path == SEED_PATH and spec.replicates > 1 else "another part of the sweep"
            yield Problem(place, f"is set by {by} already")


def _lengths(spec: SweepSpec) -> Iterator[Problem]:
    counts = {path: length_of(axis) for path, axis in spec.zip.items()}
    first = next(iter(counts.values()), 0)
    for path, count in counts.items():
        if count != first:
            yield Problem(("zip", path), f"has {count} values, the first of zip has {first}")
    if _total(spec) > MOST_RUNS:
        yield Problem((), f"asks for {_total(spec)} runs, the most is {MOST_RUNS}", line=1, column=1)


def _total(spec: SweepSpec) -> int:
    total = spec.replicates * (spec.sample.count if spec.sample else 1)
    for axis in spec.grid.values():
        total *= length_of(axis)
    return total * (length_of(next(iter(spec.zip.values()))) if spec.zip else 1)


def _nothing_to_do(spec: SweepSpec) -> Iterator[Problem]:
    if not spec.metrics and spec.keep == "none":
        hint = "give metrics, or keep: all"
        yield Problem((), "nothing is kept of any run", hint=hint, line=1, column=1)
    if spec.gather and spec.keep != "all":
        yield Problem(("gather",), "needs keep: all", given="true")


def _metrics(spec: SweepSpec, scene: Scene) -> Iterator[Problem]:
    draft = draft_of(scene.spec, None)
    names = list(scene.spec.parameters)
    for name, metric in spec.metrics.items():
        yield from _metric(metric, ("metrics", name), draft, names)
        names.append(name)


def _metric(metric: Any, place: Path, draft: Draft, names: list[str]) -> Iterator[Problem]:
    if isinstance(metric, ValueMetric):
        try:
            check_expression(metric.value, names)
        except ExpressionError as error:
            yield Problem((*place, "value"), str(error), metric.value, hint=error.hint)
    if hasattr(metric, "parsed"):
        trouble = trouble_of(metric.parsed, draft)
        if trouble is not None:
            yield Problem((*place, "quantity"), trouble[0], metric.quantity, hint=trouble[1])
    for key, pattern in _patterns(metric):
        if next(draft.body_names.fitting(pattern), None) is None:
            hint = did_you_mean(pattern, draft.body_names.every())
            yield Problem((*place, *key), "fits no body", pattern, hint=hint)
    yield from _not_recorded(metric, place, draft)


def _patterns(metric: Any) -> Iterator[tuple[Path, str]]:
    """Patterns of bodies, with the keys below the metric at which they stand."""
    for i, pattern in enumerate(getattr(metric, "between", ())):
        yield ("between", i), pattern
    if hasattr(metric, "bodies"):
        yield ("bodies",), metric.bodies


def _not_recorded(metric: Any, place: Path, draft: Draft) -> Iterator[Problem]:
    record = draft.record
    if record is not None and isinstance(metric, FirstContactMetric) and not record.contacts:
        yield Problem(place, "needs contacts, which are not recorded: record.contacts is false")
    if record is not None and isinstance(metric, EnergyLostMetric) and not record.energy:
        yield Problem(place, "needs energies, which are not recorded: record.energy is false")


def _paths(spec: SweepSpec, base: Original, scene: Scene) -> Iterator[Problem]:
    """Paths that lead nowhere: no value that was tried can stand there, alone or in a run.

    Single values that the scene refuses are no mistake of the sweep: their runs say so in their rows.
    """
    design = design_of(spec)
    if any(_accepted(base, {**spec.set, **dict(design.run(k).changes)}) for k in _ends(len(design))):
        yield from _unknown_parameters(spec, scene)
        return
    for (place, path), axis in zip(places_of(spec), design.columns, strict=True):
        yield from _path(place, path, axis, spec, base)


def _unknown_parameters(spec: SweepSpec, scene: Scene) -> Iterator[Problem]:
    known = scene.spec.parameters
    for place, path in places_of(spec):
        name = path.removeprefix(PARAMETERS)
        if path.startswith(PARAMETERS) and name not in known:
            hint = did_you_mean(name, known)
            yield Problem(place, f"the scene has no parameter '{name}'", hint=hint)


def _path(place: Path, path: str, axis: Values, spec: SweepSpec, base: Original) -> Iterator[Problem]:
    found: list[Problem] = []
    for value in axis.written[:MOST_VALUES_TRIED]:
        refused = _refusals(base, {**spec.set, path: value})
        if not refused:
            return
        found = found or refused
    for problem in found:
        message = f"{dotted(problem.path)}: {problem.message}" if problem.path else problem.message
        yield Problem(place, message, problem.given, problem.allowed, problem.hint)


def _accepted(base: Original, changes: dict[str, Any]) -> bool:
    return not _refusals(base, changes)


def _refusals(base: Original, changes: dict[str, Any]) -> list[Problem]:
    try:
        base.scene(changes)
    except SceneError as error:
        return list(error.problems)
    return []


def _ends(count: int) -> tuple[int, ...]:
    return (0, count // 2, count - 1)
