"""Newton's cradle without strings: five equal elastic balls on a line, no gravity."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import body, lab

RADIUS = 0.05
SPEED = 1.0


def cradle(moving: int, gap: float, *, mu: float = 0.0, e: float = 1.0, way: tuple[float, ...] = (1, 0, 0)):
    """`moving` balls come in together, 5 cm before the others, all other gaps `gap`. Speeds after."""
    line, places, along = "", [], 0.0
    for n in range(5):
        along += (2 * RADIUS + (0.05 if n == moving else gap)) if n else 0.0
        places.append(along)
    for n, place in enumerate(places):
        velocity = SPEED * np.array(way) if n < moving else (0, 0, 0)
        line += body(
            f"b{n}", f"type: sphere, radius: {RADIUS}", position=place * np.array(way), velocity=velocity
        )
    done = lab(line, gravity=0.0, e=e, mu=mu).run(0.3)
    v = done.all("velocity")
    assert np.linalg.norm(v - np.outer(v @ np.array(way), way)) < 1e-12
    return v @ np.array(way)


@pytest.mark.parametrize("gap", [0.0, 1e-4, 1e-2])
@pytest.mark.parametrize("moving", [1, 2, 3, 4])
def test_as_many_go_out_as_come_in(moving, gap):
    """Measured 1e-15, touching as with gaps."""
    wanted = [0.0] * (5 - moving) + [SPEED] * moving
    assert cradle(moving, gap) == pytest.approx(wanted, abs=1e-12)


def test_friction_between_the_balls_changes_nothing_in_a_central_impact():
    assert cradle(2, 0.0, mu=0.5) == pytest.approx([0, 0, 0, SPEED, SPEED], abs=1e-12)


def test_along_any_line():
    way = tuple(np.array([2.0, -1.0, 0.5]) / np.linalg.norm([2.0, -1.0, 0.5]))
    assert cradle(2, 0.0, way=way) == pytest.approx([0, 0, 0, SPEED, SPEED], abs=1e-12)


def test_one_in_against_heavier_and_heavier_balls():
    """Gaps make it a chain of two-body impacts: v' = 2 m / (m + M) v from ball to ball."""
    masses = [1.0, 2.0, 4.0]
    row = "".join(
        body(
            f"b{n}",
            f"type: sphere, radius: {RADIUS}",
            mass=m,
            position=(n * 0.11, 0, 0),
            velocity=(1.0 - min(n, 1), 0, 0),
        )
        for n, m in enumerate(masses)
    )
    v = lab(row, gravity=0.0, e=1.0).run(0.2).all("velocity")[:, 0]
    assert v == pytest.approx([-1 / 3, 2 / 3 * -1 / 3, 2 / 3 * 2 / 3], abs=1e-13)


def test_without_restitution_the_row_moves_as_one():
    """One fifth of the speed each, to the solver's tolerance of 1e-6 m/s."""
    assert cradle(1, 0.0, e=0.0) == pytest.approx([SPEED / 5] * 5, abs=1e-6)


def test_two_sides_at_once_bounce_back():
    """Balls from both sides against three that touch: each goes back as it came, the middle stays."""
    row = "".join(
        body(f"b{n}", f"type: sphere, radius: {RADIUS}", position=(x, 0, 0), velocity=(v, 0, 0))
        for n, (x, v) in enumerate([(-0.2, 1.0), (-0.1, 0.0), (0.0, 0.0), (0.1, 0.0), (0.2, -1.0)])
    )
    v = lab(row, gravity=0.0, e=1.0).run(0.1).all("velocity")[:, 0]
    assert v == pytest.approx([-1, 0, 0, 0, 1], abs=1e-12)
