"""The direction in which two convex shapes are least apart or least overlapped, found with FCL.

FCL's distance is dependable while two shapes are well apart; near touching it gives no direction, and what
its `collide` says of overlaps is often the wrong one (docs/contacts.md has the measurements). Two facts
lead around this.

* Overlap along any direction n is known exactly, depth(n) = h_B(n) + h_A(-n), and never less than the true
  depth, which is its minimum. So of several directions the one of least depth is the best, whoever proposed
  it.
* Moving A along the true normal changes the distance but not the nearest points. So A is moved by s along
  the best direction yet, n, until the shapes are apart, and FCL's distance there proposes the next, m. That
  can only gain: m has the greatest gap of all directions, s n.m - depth(m), hence depth(m) <= depth(n) - s
  (1 - n.m).

This descent ends in a local minimum. Apart there is only one; overlapping shapes have several, and descents
start from FCL's `collide` and from the least depths among directions all around.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from physsim.collision.extents import Vector
from physsim.collision.pairs import Pair, unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

CLEARANCE = 0.05
"""How far apart cores are moved before FCL's direction is believed, as a part of the smaller shape's size.
Less: FCL's error, about its tolerance over the distance, grows. More: on round shapes the descent converges
slower."""

LEAST_CLEARANCE = 1e-6
"""First the clearance is only twice the depth or gap, down to this part of the smaller shape's size: where
corners overlap or part a little, a larger one hides what is beside them, and the descent creeps."""

ROUNDS = 12
"""Rounds of a descent at most. Flat faces need two, round shapes three, overlapping corners up to ten."""

GAIN = 1e-9
"""A descent ends when a round gains less depth than this part of the smaller shape's size."""

DIRECTIONS = 200
"""Directions all around whose depths are compared, a quarter of a radian apart. With 60, 1 in 500 random
overlaps ends in a wrong minimum; with 200 none of 2500 did."""

STARTS = 3
"""Descents from there at most, beside the one from `collide`."""

SAME_BASIN = 0.95
"""Cosine above which two starts are taken for the same."""

SLACK = 0.3
"""Starts deeper than the best depth yet by more than this part of the smaller shape's size are not
descended from."""


class Contact(NamedTuple):
    """normal: unit, from B to A; depth along it [m]; a point midway between both surfaces, from B's origin
    [m]."""

    normal: Vector
    depth: float
    point: Vector


def search(pair: Pair, margin: float) -> Contact | None:
    """The contact of two convex shapes, or None when they are farther apart than `margin` [m].

    Cores that FCL calls apart, but that overlap along its own direction, touch to within its tolerance, and
    that direction means nothing.
    """
    contact = _apart(pair)
    if contact is None or contact.depth > pair.skin:
        contact = _overlapping(pair)
    elif contact.depth >= -margin:
        contact = _descent(pair, contact)
    return _leveled(pair, contact) if contact.depth >= -margin else None


def against_halfspace(pair: Pair, margin: float) -> Contact | None:
    """A against the half-space B, or None when they are farther apart than `margin` [m].

    FCL's closed forms speak only of overlaps, so A is moved into the half-space first, to a depth of its
    own size.
    """
    n = pair.orientation_b.axes()[2]
    gap = float(pair.low_a(*n))
    if gap > margin:
        return None
    shift = -gap - pair.size
    found = pair.contact(shift, n)
    normal = unit(*found[0]) if found else None
    if found is None or normal is None:
        return None
    contact = Contact(normal, float(-pair.low_a(*normal)), _moved(found[1], -shift, n))
    return _leveled(pair, contact)


def _apart(pair: Pair) -> Contact | None:
    """From the nearest points of the cores; None when even those overlap."""
    found = pair.nearest_points()
    return None if found is None else _from_points(pair, *found)


def _overlapping(pair: Pair) -> Contact:
    """The best of the descents from FCL's `collide` and from the least depths all around."""
    directions = _all_around(pair)
    depths = pair.depth(*directions)
    best = _descent(pair, _guess(pair, directions, depths))
    tried = best.normal
    for _ in range(STARTS):
        depths[tried @ directions > SAME_BASIN] = np.inf
        i = int(depths.argmin())
        if not depths[i] < best.depth + SLACK * pair.size:
            break
        tried = tuple(directions[:, i].tolist())
        other = _descent(pair, Contact(tried, float(depths[i]), best.point))
        best = min(best, other, key=lambda contact: contact.depth)
    return best


def _guess(pair: Pair, directions: NDArray[np.float64], depths: NDArray[np.float64]) -> Contact:
    """What FCL's `collide` says, or the least depth of the directions where it is silent or says nothing."""
    found = pair.contact()
    normal = unit(*found[0]) if found else None
    if found and normal:
        return Contact(normal, float(pair.depth(*normal)), found[1])
    x, y, z = pair.offset
    i = int(depths.argmin())
    return Contact(tuple(directions[:, i].tolist()), float(depths[i]), (0.5 * x, 0.5 * y, 0.5 * z))


def _all_around(pair: Pair) -> NDArray[np.float64]:
    """f64[3, K]: directions all around, and the axes of both shapes to either side, along which faces are
    flat."""
    axes = np.array(pair.orientation_a.axes() + pair.orientation_b.axes()).T
    return np.concatenate((_SPHERE, axes, -axes), axis=1)


def _descent(pair: Pair, contact: Contact) -> Contact:
    """Rounds of moving A away and asking FCL: by little while that gains, then by enough for precision."""
    for _ in range(ROUNDS):
        before = contact.depth
        clearance = max(2.0 * abs(before - pair.skin), LEAST_CLEARANCE * pair.size)
        contact = _step(pair, contact, min(clearance, CLEARANCE * pair.size))
        if before - contact.depth > 1e-3 * abs(before):
            continue
        before = contact.depth
        contact = _wide_step(pair, contact)
        if before - contact.depth <= GAIN * pair.size:
            break
    return contact


def _wide_step(pair: Pair, contact: Contact) -> Contact:
    return _step(pair, contact, CLEARANCE * pair.size)


def _step(pair: Pair, contact: Contact, clearance: float) -> Contact:
    """The best direction found with A moved away until the cores are apart by the clearance; never a worse
    one."""
    n = contact.normal
    shift = contact.depth - pair.skin + clearance
    found = pair.nearest_points(shift, n)
    if shift <= 0.0 or found is None:
        return contact
    proposed = unit(*_minus(*found))
    if proposed is None:
        return contact
    points = (_moved(found[0], -shift, n), found[1])
    best = _beyond(pair, n, Contact(proposed, float(pair.depth(*proposed)), _middle(pair, points, proposed)))
    # Between corners the points stay where they are when A moves, and the line between them is the normal.
    direct = _from_points(pair, *points) if best.depth < pair.skin else None
    if direct and direct.depth < best.depth:
        best = direct
    return best if best.depth <= contact.depth else contact


def _beyond(pair: Pair, start: Vector, contact: Contact) -> Contact:
    """Goes on along the turn from `start` to the contact's normal, four times as far each time, while that
    gains."""
    x, y, z = contact.normal
    dx, dy, dz = _minus(contact.normal, start)
    reach = 4.0
    best = contact
    while reach < 1e9:
        normal = unit(x + reach * dx, y + reach * dy, z + reach * dz)
        if normal is None or not (depth := float(pair.depth(*normal))) < best.depth:
            break
        best = Contact(normal, depth, contact.point)
        reach *= 4.0
    return best


def _from_points(pair: Pair, a: Vector, b: Vector) -> Contact | None:
    """The contact along the line between points of both cores that are apart; None where they coincide."""
    normal = unit(*_minus(a, b))
    if normal is None:
        return None
    return Contact(normal, float(pair.depth(*normal)), _middle(pair, (a, b), normal))


def _middle(pair: Pair, points: tuple[Vector, Vector], normal: Vector) -> Vector:
    """Midway between the surfaces, from points of A's and B's core."""
    a, b = points
    s = pair.b.extent.skin - pair.a.extent.skin
    return (
        0.5 * (a[0] + b[0] + s * normal[0]),
        0.5 * (a[1] + b[1] + s * normal[1]),
        0.5 * (a[2] + b[2] + s * normal[2]),
    )


def _leveled(pair: Pair, contact: Contact) -> Contact:
    """The contact with its point moved along the normal to lie midway between both surfaces."""
    n, p = contact.normal, contact.point
    middle = 0.5 * float(pair.high_b(*n) + pair.low_a(*n))
    return contact._replace(point=_moved(p, middle - (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]), n))


def _moved(point: Vector, by: float, n: Vector) -> Vector:
    return (point[0] + by * n[0], point[1] + by * n[1], point[2] + by * n[2])


def _minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _spiral(count: int) -> NDArray[np.float64]:
    """f64[3, count]: directions spread evenly on a spiral (R. Swinbank and R. J. Purser, 2006, "Fibonacci
    grids")."""
    i = np.arange(count) + 0.5
    z = 1.0 - 2.0 * i / count
    turn = np.pi * (1.0 + 5.0**0.5) * i
    r = np.sqrt(1.0 - z * z)
    return np.stack([r * np.cos(turn), r * np.sin(turn), z])


_SPHERE = _spiral(DIRECTIONS)
