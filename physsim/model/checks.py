"""Doubts about a whole model: steps too long for what is small, fast or stiff, meshes in the wrong unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from physsim.model.body import Body
from physsim.model.connections import check_placement
from physsim.model.findings import Findings, Path
from physsim.model.model import Model
from physsim.model.stiffness import Stepping, check_stiffness

STRIDE = 0.5
"""Part of its smallest dimension that a body may move in one step; beyond it contacts are found late or not
at all.
"""

TURN = 0.5
"""Radians that a body may turn in one step; the order of an integrator means nothing beyond."""

HUGE = 100.0
"""Metres; a mesh larger than this was probably drawn in millimetres."""

TINY = 1e-4
"""Metres; a mesh smaller than this was probably drawn in metres and scaled as millimetres."""

OUT_OF_SCALE = 500.0
"""Ratio to the middle size of the other bodies beyond which a mesh is probably in the wrong unit."""


def check_model(model: Model, bodies: Sequence[Body], paths: Sequence[Path], findings: Findings) -> None:
    """Write the doubts about `model` into `findings`, one per kind and declared body."""
    _check_stride(model, bodies, paths, findings)
    _check_turn(model, paths, findings)
    _check_scales(model, bodies, paths, findings)
    springs, joints = model.mechanics.springs, model.mechanics.joints
    check_placement(springs, joints, findings)
    simulation = model.spec.simulation
    stepping = Stepping(simulation.integrator, simulation.timestep, simulation.steps)
    check_stiffness(springs, joints, stepping, findings)


def _check_stride(model: Model, bodies: Sequence[Body], paths: Sequence[Path], findings: Findings) -> None:
    step = model.spec.simulation.timestep
    gained = float(np.linalg.norm(model.spec.world.gravity)) * step
    thickness = np.array([body.thickness for body in bodies])
    speed = np.linalg.norm(model.velocity, axis=1) + gained
    strides = np.where(model.fixed, 0.0, speed * step / thickness)
    for worst in _worst_of_each(strides, paths, STRIDE):
        longest = STRIDE * thickness[worst] / speed[worst]
        findings.warn(
            paths[worst],
            f"moves {strides[worst]:.3g} of its smallest dimension ({thickness[worst]:.3g} m) in one step at "
            f"{speed[worst]:.3g} m/s, so that contacts can be missed",
            hint=f"a timestep below {longest:.2g} s keeps it under {STRIDE:g}",
        )


def _check_turn(model: Model, paths: Sequence[Path], findings: Findings) -> None:
    step = model.spec.simulation.timestep
    rate = np.linalg.norm(model.angular_velocity, axis=1)
    turns = np.where(model.fixed, 0.0, rate * step)
    for worst in _worst_of_each(turns, paths, TURN):
        findings.warn(
            paths[worst],
            f"turns {turns[worst]:.3g} rad in one step at {rate[worst]:.3g} rad/s",
            hint=f"a timestep below {TURN / rate[worst]:.2g} s keeps it under {TURN:g} rad",
        )


def _worst_of_each(values: Any, paths: Sequence[Path], bound: float) -> list[int]:
    """Of the bodies beyond `bound` the worst of each declared body."""
    worst: dict[Path, int] = {}
    for index in np.flatnonzero(values > bound).tolist():
        known = worst.setdefault(paths[index], index)
        if values[index] > values[known]:
            worst[paths[index]] = index
    return list(worst.values())


def _check_scales(model: Model, bodies: Sequence[Body], paths: Sequence[Path], findings: Findings) -> None:
    extents = {
        path: body.extent for path, body in zip(paths, bodies, strict=True) if np.isfinite(body.extent)
    }
    for path, extent in extents.items():
        shape = model.spec.bodies[str(path[1])].shape
        if shape.type != "mesh":
            continue
        others = [other for name, other in extents.items() if name != path]
        doubt = _scale_doubt(extent, float(np.median(others)) if others else None)
        if doubt is not None:
            findings.warn((*path, "shape", "scale"), doubt[0], given=f"{shape.scale:g} m", hint=doubt[1])


def _scale_doubt(extent: float, usual: float | None) -> tuple[str, str] | None:
    """What is odd about a mesh `extent` metres across among bodies of `usual` size, and what to do about
    it.
    """
    smaller, larger = "was it drawn in millimetres? then scale: 1 mm", "scale is the length of one file unit"
    if usual is not None and extent > OUT_OF_SCALE * usual:
        return f"makes it {extent:.3g} m across, {extent / usual:.3g} times the other bodies", smaller
    if usual is not None and extent * OUT_OF_SCALE < usual:
        return (
            f"makes it {extent:.3g} m across, {usual / extent:.3g} times smaller than the other bodies",
            larger,
        )
    if extent > HUGE:
        return f"makes it {extent:.3g} m across", smaller
    if extent < TINY:
        return f"makes it {extent:.3g} m across", larger
    return None
