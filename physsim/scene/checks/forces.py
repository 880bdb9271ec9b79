"""Forces: bodies that exist and can move, exactly one kind, and no key that means nothing beside it."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import PathPart, Problem
from physsim.scene.checks.no_contact import MAX_COMPARISONS
from physsim.scene.checks.profiles import check_profile, check_window
from physsim.scene.draft import Draft
from physsim.scene.spec.forces import DragSpec, ForceSpec
from physsim.scene.suggest import did_you_mean

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `forces`."""
    patterns = {force.body for force in draft.forces.values() if force is not None and "*" in force.body}
    if len(patterns) * draft.body_names.total > MAX_COMPARISONS:
        yield Problem(("forces",), "has too many patterns for so many bodies")
        return
    for name, force in draft.forces.items():
        if force is not None:
            yield from _force(("forces", name), force, draft)


def _force(path: Path, force: ForceSpec, draft: Draft) -> Iterator[Problem]:
    yield from _kind(path, force)
    yield from _bodies((*path, "body"), force, draft)
    yield from _out_of_place(path, force)
    yield from check_window(path, force.from_, force.until)
    yield from check_profile((*path, "profile"), force.profile, draft, force.from_)
    if force.drag is not None:
        yield from _drag((*path, "drag"), force.drag)
    if force.region is not None and any(a >= b for a, b in zip(*force.region, strict=True)):
        yield Problem((*path, "region"), "must be the lower corner, then the upper one")


def _kind(path: Path, force: ForceSpec) -> Iterator[Problem]:
    given = [key for key in ("force", "torque", "drag", "acceleration") if getattr(force, key) is not None]
    if not given:
        yield Problem(path, "does nothing: give force, torque, drag or acceleration")
    elif len(given) > 1 and given != ["force", "torque"]:
        yield Problem(path, f"must be of one kind, not {' and '.join(given)} together")


def _bodies(path: Path, force: ForceSpec, draft: Draft) -> Iterator[Problem]:
    names = draft.body_names
    if "*" not in force.body:
        trouble = names.trouble(force.body)
        if trouble:
            yield Problem(path, trouble[0], hint=trouble[1])
        elif names.is_fixed(force.body):
            yield Problem(path, "is fixed: nothing moves it", force.body)
    elif force.force is not None or force.torque is not None:
        yield Problem(path, "must name one body; `*` is for drag and acceleration", force.body)
    elif not any(names.fitting(force.body)):
        hint = did_you_mean(force.body.strip("*"), draft.bodies)
        yield Problem(path, "fits the name of no body", force.body, hint=hint)
    elif all(names.is_fixed(name) for name in names.fitting(force.body)):
        yield Problem(path, "fits fixed bodies only: nothing moves them", force.body)


def _out_of_place(path: Path, force: ForceSpec) -> Iterator[Problem]:
    """Keys that mean nothing for the kind of force that is given."""
    pushes = force.force is not None or force.torque is not None
    if force.at is not None and force.force is None:
        yield Problem((*path, "at"), "does nothing without force")
    if force.frame == "body" and not pushes:
        yield Problem((*path, "frame"), "does nothing without force or torque", "body")
    if force.region is not None and force.acceleration is None:
        yield Problem((*path, "region"), "does nothing without acceleration")
    if force.drag is not None:
        timing = {"from": force.from_ or None, "until": force.until, "profile": force.profile}
        for key in (key for key, value in timing.items() if value is not None):
            yield Problem((*path, key), "cannot be given together with drag, which acts all the time")


def _drag(path: Path, drag: DragSpec) -> Iterator[Problem]:
    if not drag.model_fields_set:
        yield Problem(path, "does nothing: give linear, angular, or density, area and coefficient")
    together = ("density", "area", "coefficient")
    missing = [key for key in together if getattr(drag, key) is None]
    if 0 < len(missing) < len(together):
        for key in missing:
            beside = " and ".join(other for other in together if other not in missing)
            yield Problem((*path, key), f"is required beside {beside}")
