"""The engine's question to FCL, pair by pair: which direction, how deep, where."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from physsim.collision.extents import Kind, Vector, extent
from physsim.collision.fcl_solids import Blueprint
from physsim.collision.pairs import Orientation, Pair, Shape
from physsim.collision.search import Contact, against_halfspace, search

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]
Answers = tuple[NDArray[np.bool_], Floats, Floats, Floats]

FARTHEST = 1e6
"""Pairs whose origins are farther apart than this many of their own radii are not looked at: no margin of
use spans that, and the numbers would not fit FCL."""

BEYOND = 1e15
"""Coordinates that are not looked at [m]: doubles are a tenth of a metre apart there."""

_BOTH_SIDES = ((0, 1, 2), (0, 2, 1))
"""A triangle as a flat convex body: FCL's own triangles have no distance to other shapes."""

Part = tuple[int, int]
"""Geom and triangle of an exact mesh (-1 for other geoms)."""


class Place(NamedTuple):
    """Where a geom is: position of its origin [m], orientation of its axes."""

    position: Vector
    orientation: Orientation


Placed = tuple[Part, Place]


class FclAnswers:
    """Answers for the geoms of one engine input.

    One call does not depend on those before it, so that a resumed run gets the same answers.
    Raises ValueError for a geom kind that does not exist.
    """

    def __init__(self, engine_input: Mapping[str, Any]) -> None:
        self._input = engine_input
        self._kinds = [Kind(int(kind)) for kind in engine_input["geom_kind"]]
        self._parameters = np.asarray(engine_input["geom_parameters"], dtype=np.float64).tolist()
        self._shapes: dict[tuple[int, int], Shape] = {}

    def __call__(  # noqa: PLR0917 -- the engine calls by position
        self,
        geom_a: Indices,
        geom_b: Indices,
        triangle_a: Indices,
        triangle_b: Indices,
        pose_a: Floats,
        pose_b: Floats,
        margin: Floats,
    ) -> Answers:
        """Answer P pairs.

        geom_a, geom_b i32[P]; triangle_a, triangle_b i32[P] (-1 where the geom is not an exact mesh); pose_a,
        pose_b f64[P, 7] (x y z [m], then w x y z); margin f64[P] [m].

        Returns found bool[P], normal f64[P, 3] (unit, from B to A), depth f64[P] [m] (positive overlap,
        minus the gap), position f64[P, 3] [m] midway between the surfaces. `found` is false where the pair
        is farther apart than its margin, or a pose is not usable (not finite, a zero quaternion).
        """
        count = len(geom_a)
        found = np.zeros(count, dtype=np.bool_)
        normal, depth, position = np.zeros((count, 3)), np.zeros(count), np.zeros((count, 3))
        parts_a = zip(geom_a.tolist(), triangle_a.tolist(), strict=True)
        parts_b = zip(geom_b.tolist(), triangle_b.tolist(), strict=True)
        rows = zip(parts_a, parts_b, pose_a.tolist(), pose_b.tolist(), margin.tolist(), strict=True)
        for i, (part_a, part_b, row_a, row_b, reach) in enumerate(rows):
            place_a, place_b = _place(row_a), _place(row_b)
            if place_a is None or place_b is None or not isfinite(reach):
                continue
            answer = self._answer((part_a, place_a), (part_b, place_b), reach)
            if answer is not None:
                found[i] = True
                normal[i], depth[i], position[i] = answer
        return found, normal, depth, position

    def _answer(self, a: Placed, b: Placed, margin: float) -> tuple[Vector, float, Vector] | None:
        """One pair, asked in one order of its shapes: exchanging A and B turns the normal and nothing
        else."""
        swapped = self._rank(a) > self._rank(b)
        (part_a, place_a), (part_b, place_b) = (b, a) if swapped else (a, b)
        x, y, z = place_b.position
        u, v, w = place_a.position
        pair = Pair(
            self._shape(part_a),
            self._shape(part_b),
            place_a.orientation,
            place_b.orientation,
            (u - x, v - y, w - z),
        )
        contact = _contact(pair, margin, self._kinds[part_b[0]])
        if contact is None:
            return None
        p, q, r = contact.normal
        s, t, c = contact.point
        return (-p, -q, -r) if swapped else (p, q, r), contact.depth, (s + x, t + y, c + z)

    def _rank(self, placed: Placed) -> tuple[bool, Kind, Part]:
        """Half-spaces last, as FCL and the search want them second."""
        kind = self._kinds[placed[0][0]]
        return kind is Kind.HALFSPACE, kind, placed[0]

    def _shape(self, part: Part) -> Shape:
        shape = self._shapes.get(part)
        if shape is None:
            shape = self._shapes[part] = _shape(self._blueprint(*part))
        return shape

    def _blueprint(self, geom: int, triangle: int) -> Blueprint:
        kind, parameters = self._kinds[geom], tuple(self._parameters[geom])
        index = int(parameters[0])
        if kind is Kind.HULL:
            faces = self._input["hull_faces"][index]
            return Blueprint(kind, parameters, self._input["hull_vertices"][index], faces)
        if kind is Kind.MESH:
            corners = self._input["mesh_triangles"][index][triangle]
            return Blueprint(kind, parameters, self._input["mesh_vertices"][index][corners], _BOTH_SIDES)
        return Blueprint(kind, parameters)


def _shape(blueprint: Blueprint) -> Shape:
    return Shape(blueprint, extent(blueprint.kind, blueprint.parameters, blueprint.vertices))


def _contact(pair: Pair, margin: float, kind_b: Kind) -> Contact | None:
    if kind_b is Kind.HALFSPACE:
        return against_halfspace(pair, margin)
    x, y, z = pair.offset
    apart = sqrt(x * x + y * y + z * z)
    radii = pair.a.extent.radius + pair.b.extent.radius
    if not apart <= min(radii + margin, FARTHEST * radii):
        return None
    return search(pair, margin)


def _place(pose: list[float]) -> Place | None:
    """The place of a pose (x y z, w x y z), None where the pose is not usable."""
    position, (w, x, y, z) = pose[:3], pose[3:]
    norm = sqrt(w * w + x * x + y * y + z * z)
    if not (all(abs(x) < BEYOND for x in position) and 1e-100 < norm < 1e100):
        return None
    w, x, y, z = w / norm, x / norm, y / norm, z / norm
    rotation = (
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        1.0 - 2.0 * (x * x + y * y),
    )
    return Place((position[0], position[1], position[2]), Orientation((w, x, y, z), rotation))
