"""What stands, stands: stacks, a wall, light under heavy."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import FLOOR, GRAVITY, Lab, body, lab

BRICK = np.array([0.2, 0.1, 0.07])


def drift(stack: Lab, seconds: float) -> float:
    """How far anything has moved [m]."""
    start = stack.all("position")
    stack.run(seconds)
    return float(np.linalg.norm(stack.all("position") - start, axis=1).max())


def ten_boxes(mu: float, timestep: float) -> Lab:
    boxes = [
        body(f"b{n}", "type: box, size: [0.4, 0.3, 0.2]", position=(0, 0, 0.1 + 0.2 * n)) for n in range(10)
    ]
    return lab(FLOOR + "".join(boxes), mu=mu, timestep=timestep)


@pytest.mark.parametrize("timestep", [4e-3, 2e-3])
def test_ten_boxes_stand_for_ten_seconds(timestep):
    """Measured at most 2e-6 m."""
    stack = ten_boxes(0.5, timestep)
    assert drift(stack, 10.0) < 1e-4
    assert np.abs(stack.all("velocity")).max() < 1e-4


def test_each_box_carries_what_is_above_it():
    """10, 9, ... 1 times m g dt between floor and boxes, to the solver's tolerance."""
    stack = ten_boxes(0.5, 2e-3).run(1.0)
    found = stack.world.contacts()
    weight = 24.0 * GRAVITY * 2e-3
    lower = np.minimum(found["body_a"], found["body_b"])
    loads = [found["normal_impulse"][lower == n].sum() / weight for n in range(10)]
    assert loads == pytest.approx(range(10, 0, -1), rel=1e-3)


def wall() -> str:
    """Ten courses of ten bricks in running bond, half bricks at the ends of every other course."""
    bricks = ""
    for course in range(10):
        whole = [(0.2 * n, 0.2) for n in range(10)]
        shifted = [(-0.05, 0.1), *((0.1 + 0.2 * n, 0.2) for n in range(9)), (1.85, 0.1)]
        for n, (x, length) in enumerate(shifted if course % 2 else whole):
            place = (x, 0, BRICK[2] * (course + 0.5))
            bricks += body(
                f"b{course}_{n}", f"type: box, size: [{length}, {BRICK[1]}, {BRICK[2]}]", position=place
            )
    return FLOOR + bricks


@pytest.mark.parametrize(("timestep", "seconds"), [(2e-3, 10.0), (1e-3, 1.0)])
def test_a_brick_wall_stands(timestep, seconds):
    """105 bricks, some 1300 contact points. Measured 1e-6 m in ten seconds."""
    assert drift(lab(wall(), mu=0.6, e=0.1, timestep=timestep), seconds) < 1e-4


@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
@pytest.mark.parametrize("ratio", [10.0, 1000.0])
def test_a_light_box_holds_a_heavy_one(ratio, timestep):
    """Measured 3e-8 m."""
    light = body("light", "type: box, size: [0.2, 0.2, 0.2]", mass=1, position=(0, 0, 0.1))
    heavy = body("heavy", "type: box, size: [0.4, 0.4, 0.4]", mass=ratio, position=(0, 0, 0.4))
    assert drift(lab(FLOOR + light + heavy, mu=0.5, timestep=timestep), 10.0) < 1e-6


@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
def test_a_gram_holds_a_tonne(timestep):
    """What holds the load is a millionth of what holds the plate: too soft a solve threw it over.

    Measured 8e-8 m.
    """
    plate = body("plate", "type: box, size: [1, 1, 0.1]", mass=1e-3, position=(0, 0, 0.05))
    block = body("block", "type: box, size: [1, 1, 1]", mass=1000, position=(0, 0, 0.6))
    assert drift(lab(FLOOR + plate + block, mu=0.5, timestep=timestep), 2.0) < 1e-6


@pytest.mark.parametrize("timestep", [2e-3, 1e-3, 5e-4])
@pytest.mark.parametrize("side", [0.4, 0.8])
def test_what_rests_does_not_bounce(side, timestep):
    """The same with restitution: what the solver leaves over must not be taken for an impact and thrown back.

    Measured 1e-7 m, and losses of 2e-4 J where one millimetre of height is worth 10 J.
    """
    light = body("light", "type: box, size: [0.2, 0.2, 0.2]", mass=1, position=(0, 0, 0.1))
    heavy = body("heavy", f"type: box, size: {[side] * 3}", mass=1000, position=(0, 0, 0.2 + side / 2))
    stack = lab(FLOOR + light + heavy, e=0.65, mu=0.6, timestep=timestep)
    assert drift(stack, 5.0) < 1e-6
    assert abs(stack.world.energies()["lost_impact"]) < 1e-2


@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
def test_stacks_that_do_not_touch_do_not_disturb_each_other(timestep):
    """A tonne on a kilogram stands, a tower of ten boxes stands: so must both, side by side."""
    light = body("light", "type: box, size: [0.2, 0.2, 0.2]", mass=1, position=(0, 0, 0.1))
    heavy = body("heavy", "type: box, size: [0.8, 0.8, 0.8]", mass=1000, position=(0, 0, 0.6))
    tower = "".join(
        body(f"b{n}", "type: box, size: [0.4, 0.3, 0.2]", mass=5, position=(1, 0, 0.1 + 0.2 * n))
        for n in range(10)
    )
    pair_alone = drift(lab(FLOOR + light + heavy, mu=0.5, timestep=timestep), 2.0)
    tower_alone = drift(lab(FLOOR + tower, mu=0.5, timestep=timestep), 2.0)
    both = drift(lab(FLOOR + light + heavy + tower, mu=0.5, timestep=timestep), 2.0)
    assert max(pair_alone, tower_alone, both) < 1e-5


@pytest.mark.parametrize("ratio", [1000.0, 1e-3])
def test_a_chain_of_boxes_of_unlike_masses_stands(ratio):
    """1, 1000, 1, 1000, 1 kg on top of one another, and the other way round. Measured 2e-7 m."""
    boxes = [
        body(
            f"b{n}",
            "type: box, size: [0.3, 0.3, 0.2]",
            mass=1 if n % 2 else ratio,
            position=(0, 0, 0.1 + 0.2 * n),
        )
        for n in range(5)
    ]
    assert drift(lab(FLOOR + "".join(boxes), mu=0.5), 3.0) < 1e-5


def test_a_heavy_ball_on_a_light_one_holds():
    """Balanced on its point, with all forces in one line: nothing may push it aside."""
    light = body("light", "type: sphere, radius: 0.1", mass=1, position=(0, 0, 0.1))
    heavy = body("heavy", "type: sphere, radius: 0.1", mass=1000, position=(0, 0, 0.3))
    assert drift(lab(FLOOR + light + heavy, mu=0.5), 2.0) < 1e-6


def test_bodies_that_start_in_the_floor_are_lifted_without_a_kick():
    """Split impulse: 1 mm is taken back within a second, and no speed comes of it."""
    box = lab(FLOOR + body("box", "type: box, size: [0.4, 0.3, 0.2]", position=(0, 0, 0.099)), mu=0.5)
    speeds = [abs(box.step().get("velocity", "box")[2]) for _ in range(1000)]
    assert max(speeds) < 1e-6
    assert box.get("position", "box")[2] == pytest.approx(0.1, abs=1e-7)
    assert abs(box.world.energies()["residual"]) < 1e-9


def test_a_pyramid_of_balls_stands_by_friction():
    """Three balls and one on top. The line from a lower ball's upper contact to its foot must lie in both
    friction cones: mu >= tan(s / 2) with sin s = 1 / sqrt(3), that is 0.318.
    """
    ring = [(0.2 / 3**0.5 * np.cos(a), 0.2 / 3**0.5 * np.sin(a), 0.1) for a in 2 * np.pi / 3 * np.arange(3)]
    top = (0, 0, 0.1 + 0.2 * (2 / 3) ** 0.5)
    balls = "".join(
        body(f"b{n}", "type: sphere, radius: 0.1", position=x) for n, x in enumerate([*ring, top])
    )
    assert drift(lab(FLOOR + balls, mu=0.0), 0.5) > 0.05
    assert drift(lab(FLOOR + balls, mu=0.29), 0.5) > 0.01
    assert drift(lab(FLOOR + balls, mu=0.35), 2.0) < 1e-5
