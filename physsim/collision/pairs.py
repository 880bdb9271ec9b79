"""Two shapes at their places: how deep they overlap along a direction, and what FCL says of them.

B's origin is the origin of all coordinates here, so that precision does not depend on the distance from the
world's origin.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import sqrt
from typing import NamedTuple

from physsim.collision.extents import Extent, Numbers, Vector
from physsim.collision.fcl_solids import FCL_TOLERANCE, Blueprint, Solid, unit_exponent

FINE = 1e-9
"""FCL's tolerance as a part of the smaller shape's size: normals of round shapes are then good to about
1e-4 rad. A thousand times more, FCL's own 1e-6 for shapes of one metre, and they are off by up to 0.05
rad."""

LARGEST_NUMBER = 1e8
"""Lengths reach FCL below this many units: rounding, 1e-16 of it, then stays under FCL's tolerance of
1e-6."""

UP: Vector = (0.0, 0.0, 1.0)


class Shape:
    """A shape with its extent and its solids, built when first asked for."""

    def __init__(self, blueprint: Blueprint, extent: Extent) -> None:
        self.extent = extent
        self._blueprint = blueprint
        self._solids: dict[tuple[int, bool, bool], Solid] = {}

    def solid(self, exponent: int, core: bool, as_a: bool) -> Solid:
        """The solid in unit 8^exponent; A's and B's are different objects, as a shape may meet itself."""
        key = (exponent, core, as_a)
        solid = self._solids.get(key)
        if solid is None:
            solid = self._solids[key] = Solid(self._blueprint, exponent, core)
        return solid


class Orientation(NamedTuple):
    """quaternion (w, x, y, z), unit; rotation: its matrix by rows, nine numbers, body -> world."""

    quaternion: Sequence[float]
    rotation: Sequence[float]

    def axes(self) -> tuple[Vector, Vector, Vector]:
        """The body's x, y and z axes in the world."""
        r = self.rotation
        return (r[0], r[3], r[6]), (r[1], r[4], r[7]), (r[2], r[5], r[8])


class Pair:
    """Shapes A and B; `offset` is from B's origin to A's, in world axes [m]."""

    def __init__(
        self, a: Shape, b: Shape, orientation_a: Orientation, orientation_b: Orientation, offset: Vector
    ) -> None:
        self.a, self.b = a, b
        self.orientation_a, self.orientation_b = orientation_a, orientation_b
        self.offset = offset
        self.size = min(a.extent.size, b.extent.size)
        self.skin = a.extent.skin + b.extent.skin

    def low_a(self, x: Numbers, y: Numbers, z: Numbers) -> Numbers:
        """Lowest coordinate of A along the unit vector (x, y, z) [m]."""
        o = self.offset
        return x * o[0] + y * o[1] + z * o[2] - _reach(self.a, self.orientation_a, -x, -y, -z)

    def high_b(self, x: Numbers, y: Numbers, z: Numbers) -> Numbers:
        """Highest coordinate of B along the unit vector (x, y, z) [m]."""
        return _reach(self.b, self.orientation_b, x, y, z)

    def depth(self, x: Numbers, y: Numbers, z: Numbers) -> Numbers:
        """Overlap along the unit vector n = (x, y, z): h_B(n) + h_A(-n) [m].

        Its least value over all n is the depth of the pair (how far A must move to be free; minus the gap
        where they are apart), so that no direction understates it.
        """
        return self.high_b(x, y, z) - self.low_a(x, y, z)

    def nearest_points(self, shift: float = 0.0, n: Vector = UP) -> tuple[Vector, Vector] | None:
        """FCL's nearest points of the cores, A's where it lies moved by `shift` [m] along n; None:
        overlap."""
        solid_a, solid_b = self._placed(True, shift, n)
        return solid_b.nearest_points(solid_a)

    def contact(self, shift: float = 0.0, n: Vector = UP) -> tuple[Vector, Vector] | None:
        """Normal and point of FCL's `collide` with A moved by `shift` [m] along n; None where it is
        silent."""
        solid_a, solid_b = self._placed(False, shift, n)
        return solid_b.contact(solid_a)

    @cached_property
    def _exponent(self) -> int:
        """Of the unit in which this pair goes to FCL."""
        largest = max(self.a.extent.radius, self.b.extent.radius)
        return unit_exponent(max(FINE * self.size, FCL_TOLERANCE / LARGEST_NUMBER * largest))

    def _placed(self, core: bool, shift: float, n: Vector) -> tuple[Solid, Solid]:
        solid_a = self.a.solid(self._exponent, core, True)
        solid_b = self.b.solid(self._exponent, core, False)
        x, y, z = self.offset
        at = (x + shift * n[0], y + shift * n[1], z + shift * n[2])
        solid_a.place(at, self.orientation_a.quaternion, self.orientation_a.axes()[2])
        solid_b.place((0.0, 0.0, 0.0), self.orientation_b.quaternion, self.orientation_b.axes()[2])
        return solid_a, solid_b


def unit(x: float, y: float, z: float) -> Vector | None:
    """The unit vector along (x, y, z); None where that has no direction."""
    length = sqrt(x * x + y * y + z * z)
    if not 1e-150 < length < 1e150:
        return None
    return (x / length, y / length, z / length)


def _reach(shape: Shape, orientation: Orientation, x: Numbers, y: Numbers, z: Numbers) -> Numbers:
    r = orientation.rotation
    return shape.extent.reach(
        r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z
    )
