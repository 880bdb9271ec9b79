"""Expectations: bodies, springs and joints that exist and have what is asked, times within the run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from physsim.errors import Problem
from physsim.scene.draft import Draft
from physsim.scene.quantity import COORDINATE_FIELDS, Quantity
from physsim.scene.spec.joints import COORDINATES
from physsim.scene.spec.simulation import ROUNDING
from physsim.scene.suggest import did_you_mean

Trouble = tuple[str, str | None]
_RECORDED_BY = {"energy": "energy", "joints": "joints", "springs": "joints"}
_OF_SPRING = {"length": "linear", "force": "linear", "angle": "torsional", "torque": "torsional"}


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `expect`."""
    for i, entry in enumerate(draft.expect):
        if entry is None:
            continue
        trouble = trouble_of(entry.parsed, draft)
        if trouble:
            yield Problem(("expect", i, "quantity"), trouble[0], hint=trouble[1])
        yield from _moment(i, entry.at, draft)


def trouble_of(quantity: Quantity, draft: Draft) -> Trouble | None:
    """Why a run of this scene will not have the quantity, and the likely slip; None when it will."""
    return _unnamed(quantity, draft) or _not_recorded(quantity, draft)


def _unnamed(quantity: Quantity, draft: Draft) -> Trouble | None:
    """What is wrong with the body, spring or joint that is named; None when nothing is."""
    name = quantity.name
    if name is None:
        return None
    if quantity.group == "springs":
        return _unknown(name, "spring", draft.springs) or _of_spring(quantity, draft.springs[name])
    if quantity.group == "joints":
        return _unknown(name, "joint", draft.joints) or _of_joint(quantity, draft.joints[name])
    return draft.body_names.trouble(name)


def _unknown(name: str, word: str, known: Mapping[str, Any]) -> Trouble | None:
    return None if name in known else (f"there is no {word} '{name}'", did_you_mean(name, known))


def _of_spring(quantity: Quantity, spring: Any) -> Trouble | None:
    if spring is None or spring.type == _OF_SPRING[quantity.field]:
        return None
    other = {"length": "angle", "force": "torque", "angle": "length", "torque": "force"}[quantity.field]
    return f"a {spring.type} spring has no {quantity.field}", f"it has {other}"


def _of_joint(quantity: Quantity, joint: Any) -> Trouble | None:
    if joint is None or quantity.field not in COORDINATE_FIELDS:
        return None
    has = COORDINATE_FIELDS[: len(COORDINATES.get(joint.type, ()))]
    if quantity.field in has:
        return None
    return f"a {joint.type} joint has no {quantity.field}", f"it has {', '.join(has)}" if has else None


def _not_recorded(quantity: Quantity, draft: Draft) -> Trouble | None:
    switch = "contacts" if quantity.field == "contact_force" else _RECORDED_BY.get(quantity.group)
    if switch is None or draft.record is None or getattr(draft.record, switch):
        return None
    return f"is not recorded: record.{switch} is false", None


def _moment(i: int, at: float | str, draft: Draft) -> Iterator[Problem]:
    if draft.simulation is None or isinstance(at, str):
        return
    if at > draft.simulation.duration * (1 + ROUNDING):
        yield Problem(
            ("expect", i, "at"), f"is after the end of the run ({draft.simulation.duration:g} s)", f"{at:g} s"
        )
