"""One number per metric of a run, from a trajectory file or from a run watched in memory: the same bits.

Sums are exactly rounded (`math.fsum`), so that no processor's way of adding shows in the table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from physsim.batch.arithmetic import value_of
from physsim.batch.spec.metrics import (
    AtMetric,
    CrossingMetric,
    EnergyLostMetric,
    FirstContactMetric,
    HardestImpactMetric,
    ImpactsMetric,
    ReducedMetric,
    RestTimeMetric,
    ValueMetric,
)
from physsim.recording.quantities import over_time
from physsim.scene.patterns import matches
from physsim.scene.quantity import parse_quantity
from physsim.scene.spec.simulation import ROUNDING
from physsim.simulation import Wanted

if TYPE_CHECKING:
    from physsim.recording import Table, Trajectory
    from physsim.scene.spec.expect import ExpectSpec

Floats = NDArray[np.float64]
Metrics = Mapping[str, Any]
LOSSES = tuple(parse_quantity(f"energy.lost_{cause}") for cause in ("damping", "friction", "impact"))
_OF_THE_ENDS = ("initial", "final")
_OF_IMPACTS = (FirstContactMetric, ImpactsMetric, HardestImpactMetric)


def wanted_of(metrics: Metrics, expect: Sequence[ExpectSpec], moving: Sequence[str]) -> Wanted:
    """What of a run the metrics and the expectations look at. moving: names of the bodies that can move."""
    kinds = list(metrics.values())
    resting = [kind for kind in kinds if isinstance(kind, RestTimeMetric)]
    quantities = [kind.parsed for kind in kinds if hasattr(kind, "parsed")]
    losses = LOSSES if any(isinstance(kind, EnergyLostMetric) for kind in kinds) else ()
    return Wanted(
        quantities=(*quantities, *losses, *(entry.parsed for entry in expect)),
        bodies=frozenset(name for kind in resting for name in moving if matches(kind.bodies, name)),
        events=any(isinstance(kind, _OF_IMPACTS) for kind in kinds),
        contacts=any(isinstance(kind, FirstContactMetric) for kind in kinds),
        ends_only=all(map(_needs_ends_only, kinds)) and all(entry.at == "end" for entry in expect),
    )


def metrics_of(
    trajectory: Trajectory, metrics: Metrics, parameters: Mapping[str, float], moving: Sequence[str]
) -> dict[str, float]:
    """Every metric by name, in order; not a number where a run has none."""
    found: dict[str, float] = {}
    for name, metric in metrics.items():
        if isinstance(metric, ValueMetric):
            found[name] = value_of(metric.value, {**parameters, **found})
        elif isinstance(metric, RestTimeMetric):
            found[name] = _rest_time(trajectory, metric, moving)
        else:
            found[name] = float(_VALUES[type(metric)](trajectory, metric))
    return found


def _needs_ends_only(metric: Any) -> bool:
    if isinstance(metric, ReducedMetric):
        return metric.type in _OF_THE_ENDS and metric.since == 0 and metric.until is None
    return isinstance(metric, ImpactsMetric | HardestImpactMetric | EnergyLostMetric | ValueMetric)


def _reduced(trajectory: Trajectory, metric: ReducedMetric) -> float:
    time, values = trajectory.time, over_time(trajectory, metric.parsed)
    slack = ROUNDING * float(time[-1])
    inside = time >= metric.since - slack
    if metric.until is not None:
        inside &= time <= metric.until + slack
    if not inside.any():
        return math.nan
    return float(_REDUCTIONS[metric.type](time[inside], values[inside]))


def _mean(values: Floats) -> float:
    return math.fsum(values.tolist()) / len(values)


def _deviation(values: Floats) -> float:
    return math.sqrt(_mean((values - _mean(values)) ** 2))


_REDUCTIONS: dict[str, Callable[[Floats, Floats], Any]] = {
    "initial": lambda _, values: values[0],
    "final": lambda _, values: values[-1],
    "min": lambda _, values: values.min(),
    "max": lambda _, values: values.max(),
    "mean": lambda _, values: _mean(values),
    "rms": lambda _, values: math.sqrt(_mean(values**2)),
    "deviation": lambda _, values: _deviation(values),
    "range": lambda _, values: values.max() - values.min(),
    "time_of_min": lambda time, values: time[values.argmin()],
    "time_of_max": lambda time, values: time[values.argmax()],
}


def _at(trajectory: Trajectory, metric: AtMetric) -> float:
    return float(np.interp(metric.time, trajectory.time, over_time(trajectory, metric.parsed)))


def _crossing(trajectory: Trajectory, metric: CrossingMetric) -> float:
    """The zero of the straight line between the two frames around the first change of sign."""
    time, above = trajectory.time, over_time(trajectory, metric.parsed) - metric.level
    up, down = (above[:-1] < 0) & (above[1:] >= 0), (above[:-1] > 0) & (above[1:] <= 0)
    passed = np.flatnonzero({"up": up, "down": down, "either": up | down}[metric.direction])
    if len(passed) == 0:
        return math.nan
    k = int(passed[0])
    share = above[k] / (above[k] - above[k + 1])
    return float(time[k] + share * (time[k + 1] - time[k]))


def _first_contact(trajectory: Trajectory, metric: FirstContactMetric) -> float:
    """The earlier of the first impact and the first frame with a contact point: what comes to lie softly, or
    lies there from the start, makes no impact.
    """
    impacts = trajectory.events["time"][_between(trajectory.events, metric)]
    impact = float(impacts[0]) if len(impacts) else math.nan
    known = not math.isnan(impact)
    before = max(1, int(np.searchsorted(trajectory.time, impact))) if known else trajectory.frames
    contacts = trajectory.contact_rows(0, before, ("frame", "body_a", "body_b"))
    frames = contacts["frame"][_between(contacts, metric)]
    return float(trajectory.time[frames[0]]) if len(frames) else impact


def _impacts(trajectory: Trajectory, metric: ImpactsMetric) -> int:
    return int(_between(trajectory.events, metric).sum())


def _hardest_impact(trajectory: Trajectory, metric: HardestImpactMetric) -> float:
    return max(trajectory.events["impulse"][_between(trajectory.events, metric)].tolist(), default=0.0)


def _between(table: Table, metric: FirstContactMetric | ImpactsMetric | HardestImpactMetric) -> Any:
    """Rows whose bodies fit the two patterns, whichever is which."""
    first, second = metric.between
    ends = table["body_a"], table["body_b"]
    a, b = ([_fits(end, pattern) for end in ends] for pattern in (first, second))
    return (a[0] & b[1]) | (a[1] & b[0])


def _fits(names: Any, pattern: str) -> Any:
    listed = names.tolist()
    fitting = {name: matches(pattern, name) for name in set(listed)}
    return np.fromiter((fitting[name] for name in listed), bool, len(listed))


def _rest_time(trajectory: Trajectory, metric: RestTimeMetric, moving: Sequence[str]) -> float:
    """The time at which the last of the bodies comes to rest."""
    names = [name for name in moving if matches(metric.bodies, name)]
    times = [trajectory.body(name).rest_time(metric.speed, metric.angular_speed) for name in names]
    return max((math.nan if time is None else time for time in times), key=_nan_last, default=0.0)


def _nan_last(time: float) -> float:
    return math.inf if math.isnan(time) else time


def _energy_lost(trajectory: Trajectory, _: EnergyLostMetric) -> float:
    return math.fsum(float(over_time(trajectory, loss)[-1]) for loss in LOSSES)


_VALUES: dict[type, Callable[[Trajectory, Any], float]] = {
    ReducedMetric: _reduced,
    AtMetric: _at,
    CrossingMetric: _crossing,
    FirstContactMetric: _first_contact,
    ImpactsMetric: _impacts,
    HardestImpactMetric: _hardest_impact,
    EnergyLostMetric: _energy_lost,
}
