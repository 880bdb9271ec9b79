"""What stands on the stage: bodies with their solids, joints and springs, all that does not change with time.

Every way of seeing a trajectory (page, glTF, picture, film) starts here.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from itertools import cycle, pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.recording import Trajectory

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]
_COLOUR = re.compile("#[0-9a-fA-F]{6}")

KINDS = ("sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "rod", "halfspace", "surface")

PALETTE = ("#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#bbbbbb", "#ee8866")
"""Of materials that declare no colour: after Paul Tol's "bright" scheme (2021), for colour-blind eyes too."""

WORLD = -1
"""The body number of the world."""


@dataclass(frozen=True)
class Actor:
    """A body. mass in kg, infinite for a half-space; center (3,) of mass [m] from its origin, body axes;
    inertia (3, 3) [kg m^2] about the centre of mass, body axes.
    """

    name: str
    material: str
    mass: float
    fixed: bool
    center: FloatArray
    inertia: FloatArray


@dataclass(frozen=True)
class Surface:
    """A triangle mesh: vertices (V, 3) [m], triangles (T, 3) counter-clockwise seen from outside."""

    vertices: FloatArray
    triangles: IntArray


@dataclass(frozen=True)
class Solid:
    """One geometry of a body.

    kind: sphere, capsule, box, cylinder, cone, ellipsoid, rod, halfspace or surface; parameters (4,) [m] as
    the file's /geometry/parameters says. position (3,) [m] from the body's ORIGIN, orientation (4,) wxyz,
    both in body axes. colour: "#rrggbb". shown: what the user drew; collides: what stands for it in contacts.
    """

    body: int
    kind: str
    parameters: FloatArray
    position: FloatArray
    orientation: FloatArray
    material: str
    colour: str
    shown: bool
    collides: bool
    surface: Surface | None


@dataclass(frozen=True)
class Link:
    """A joint or a spring. bodies: A and B, `WORLD` for the world; anchors (2, 3) [m], each in its body's own
    frame, from its origin; axis (3,) in A's frame, NaN where the kind has none.
    """

    name: str
    kind: str
    bodies: tuple[int, int]
    anchors: FloatArray
    axis: FloatArray


@dataclass(frozen=True)
class Stage:
    """All that does not change with time, in the order of the file."""

    title: str
    actors: tuple[Actor, ...]
    solids: tuple[Solid, ...]
    joints: tuple[Link, ...]
    springs: tuple[Link, ...]


def stage_of(trajectory: Trajectory) -> Stage:
    """The stage of a trajectory. Raises FileTrouble when the file keeps no shapes, or is damaged."""
    if not trajectory.has("geometry/body"):
        raise FileTrouble(
            f"{trajectory.path}: was written before physsim kept shapes in its files; run the scene again"
        )

    def value(path: str) -> Any:
        return trajectory.values(path) if trajectory.has(path) else None

    try:
        return staged(trajectory.title, value)
    except (LookupError, TypeError, ValueError) as error:
        raise FileTrouble(f"{trajectory.path}: the shapes in the file are damaged ({error})") from error


def staged(title: str, value: Callable[[str], Any]) -> Stage:
    """The stage from the fixed datasets of a file: `value(path)` gives each, None where there is none.

    Raises ValueError when they do not fit together.
    """
    actors = _actors(value)
    return Stage(
        title=title,
        actors=actors,
        solids=_solids(value, len(actors)),
        joints=_links("joints", "joint", value, len(actors)),
        springs=_links("springs", "spring", value, len(actors)),
    )


def _actors(value: Callable[[str], Any]) -> tuple[Actor, ...]:
    paths = ("body", "material", "mass", "fixed", "center_of_mass", "inertia")
    return tuple(
        Actor(str(name), str(material), float(mass), bool(fixed), center, inertia)
        for name, material, mass, fixed, center, inertia in zip(*map(value, paths), strict=True)
    )


def _solids(value: Callable[[str], Any], bodies: int) -> tuple[Solid, ...]:
    def column(name: str) -> Any:
        return value(f"geometry/{name}")

    surfaces = _surfaces(column)
    colours = _colours(column("material"), column("color"))
    names = ("body", "kind", "parameters", "position", "orientation", "material", "shown", "collides")
    solids = []
    for body, kind, parameters, position, orientation, material, shown, collides, surface in zip(
        *map(column, (*names, "surface")), strict=True
    ):
        _check(0 <= body < bodies, f"no body {body}")
        _check(kind in KINDS, f"no kind {kind!r}")
        numbers = range(len(surfaces)) if kind == "surface" else (-1,)
        _check(surface in numbers, f"no surface {surface}")
        _check(all(np.isfinite(part).all() for part in (parameters, position, orientation)), "not finite")
        solids.append(
            Solid(
                body=int(body),
                kind=str(kind),
                parameters=parameters,
                position=position,
                orientation=orientation,
                material=str(material),
                colour=colours[str(material)],
                shown=bool(shown),
                collides=bool(collides),
                surface=surfaces[surface] if kind == "surface" else None,
            )
        )
    return tuple(solids)


def _surfaces(column: Callable[[str], Any]) -> list[Surface]:
    vertices, triangles = np.asarray(column("vertices")), np.asarray(column("triangles"))
    bounds = zip(
        _ranges(column("vertex_offset"), len(vertices)),
        _ranges(column("triangle_offset"), len(triangles)),
        strict=True,
    )
    surfaces = [Surface(vertices[own], np.asarray(triangles[corners], np.int32)) for own, corners in bounds]
    for surface in surfaces:
        inside = (surface.triangles >= 0) & (surface.triangles < len(surface.vertices))
        _check(bool(inside.all() and np.isfinite(surface.vertices).all()), "a surface without its vertices")
    return surfaces


def _ranges(offsets: Any, length: int) -> list[slice]:
    """From offset[k] to offset[k + 1]."""
    steps = np.diff(np.asarray(offsets))
    _check(
        len(offsets) > 0 and offsets[0] == 0 and offsets[-1] == length and bool((steps >= 0).all()), "offsets"
    )
    return [slice(int(first), int(last)) for first, last in pairwise(offsets)]


def _colours(materials: Any, declared: Any) -> dict[str, str]:
    """Colour of each material: as declared, else the next of the palette."""
    found = {str(material): str(color) for material, color in zip(materials, declared, strict=True)}
    palette = cycle(PALETTE)
    return {
        material: color if _COLOUR.fullmatch(color) else next(palette) for material, color in found.items()
    }


def _links(group: str, axis: str, value: Callable[[str], Any], bodies: int) -> tuple[Link, ...]:
    names = value(f"{group}/{axis}")
    if names is None:
        return ()
    axes = value(f"{group}/axis_a")
    if axes is None:
        axes = np.full((len(names), 3), np.nan)
    ends = [value(f"{group}/{part}_{end}") for part in ("body", "anchor") for end in ("a", "b")]
    links = []
    for name, kind, direction, body_a, body_b, anchor_a, anchor_b in zip(
        names, value(f"{group}/type"), axes, *ends, strict=True
    ):
        _check(min(body_a, body_b) >= WORLD and max(body_a, body_b) < bodies, f"{name!r} ties no body")
        anchors = np.array([anchor_a, anchor_b])
        links.append(Link(str(name), str(kind), (int(body_a), int(body_b)), anchors, np.asarray(direction)))
    return tuple(links)


def _check(holds: bool, what: str) -> None:
    if not holds:
        raise ValueError(what)
