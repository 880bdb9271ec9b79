"""Seams between level bodies: what slides or rolls over does not notice; what stands in the way is hit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from laboratory import Lab, body

SCENE = """
physsim: 1
simulation: {{duration: 1 min, timestep: 1 ms, tolerance: 1e-12, integrator: {way[0]}, impacts: {way[1]}}}
world: {{gravity: [0, 0, -9.81]}}
mixing: {{restitution: minimum, friction: geometric_mean}}
materials:
  stuff: {{density: 1000, restitution: 0, static_friction: {mu}, kinetic_friction: {mu}}}
bodies:
"""
WAYS = [(i, m) for i in ("semi_implicit_euler", "velocity_verlet") for m in ("stepped", "located")]
BOX = "type: box, size: [0.3, 0.2, 0.2]"
START = -0.8
ON_SIDE = {"axis": [1, 0, 0], "angle": math.pi / 2}


def prism(profile: list[tuple[float, float]]) -> str:
    """A convex body 20 cm wide whose outline in x and z is given."""
    return f"type: convex, points: {[[x, y, z] for x, z in profile for y in (-0.1, 0.1)]}"


BOAT = prism([(-0.1, -0.1), (0.1, -0.1), (0.25, 0.1), (-0.25, 0.1)])
SKI = prism([(-0.1, -0.1), (0.1, -0.1), (0.4, -0.08), (0.4, 0.1), (-0.4, 0.1), (-0.4, -0.08)])
SPLIT = (
    "type: compound, parts: [{shape: {type: box, size: [0.15, 0.2, 0.2]}, position: [-0.075, 0, 0]}, "
    "{shape: {type: box, size: [0.15, 0.2, 0.2]}, position: [0.075, 0, 0]}]"
)


def tables(count: int, width: float = 4.0) -> str:
    """A row of boxes side by side from x = -2 to 2, their tops at z = 0."""
    length = 4.0 / count
    places = [(-2.0 + (n + 0.5) * length, 0, -0.5) for n in range(count)]
    shape = f"type: box, size: [{length}, {width}, 1]"
    return "".join(body(f"table{n}", shape, position=place, fixed=True) for n, place in enumerate(places))


def crossing(
    shape: str, speed: float, way: tuple[str, str], *, count: int = 2, heading: float = 0.0, **fields: object
) -> tuple[float, Lab]:
    """The greatest change of a component of the velocity [m/s] on 1.6 m over the seams, sunk in by 0.1 nm."""
    course = np.array([math.cos(heading), math.sin(heading), 0])
    height = fields.pop("height", 0.1)
    start = (START, START * math.tan(heading), height - 1e-10)
    sliding = body("sled", shape, position=start, velocity=speed * course, **fields)
    scene = Lab(SCENE.format(way=way, mu=0) + tables(count) + sliding)
    worst = 0.0
    for _ in range(round(400 / speed)):
        scene.step(4)
        worst = max(worst, float(np.abs(scene.get("velocity", "sled") - speed * course).max()))
    return worst, scene


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("count", [2, 10])
@pytest.mark.parametrize(("speed", "heading"), [(0.8, 0.0), (3.0, math.radians(30))])
def test_a_box_slides_over_seams_as_over_one_table(speed, heading, count, way):
    """Measured at most 1e-13 m/s."""
    turned = {"axis": [0, 0, 1], "angle": heading}
    change, scene = crossing(BOX, speed, way, count=count, heading=heading, orientation=turned)
    assert change < 1e-9
    assert len(scene.events()["time"]) == 0


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("speed", [0.8, 3.0])
@pytest.mark.parametrize("shape", ["type: sphere, radius: 0.1", "type: capsule, radius: 0.1, height: 0.3"])
def test_a_ball_and_a_capsule_roll_over_seams(shape, speed, way):
    """Measured at most 5e-15 m/s."""
    spin = (0, 10 * speed, 0)
    change, scene = crossing(shape, speed, way, count=10, orientation=ON_SIDE, angular_velocity=spin)
    assert change < 1e-6
    assert scene.get("angular_velocity", "sled") == pytest.approx(spin, abs=1e-9)


@pytest.mark.parametrize("shape", [BOAT, SKI, SPLIT], ids=["boat", "ski", "compound"])
@pytest.mark.parametrize("speed", [0.8, 3.0])
def test_hulls_with_bows_and_compounds_slide_over_seams(shape, speed):
    """A bow leads over the next table before the bottom is there. Measured at most 2e-13 m/s."""
    assert crossing(shape, speed, WAYS[0], count=10)[0] < 1e-9


@pytest.mark.parametrize(
    ("shape", "fields"),
    [
        ("type: cylinder, radius: 0.1, height: 0.2", {}),
        ("type: cylinder, radius: 0.1, height: 0.3", {"orientation": ON_SIDE}),
        ("type: cone, radius: 0.1, height: 0.2", {"height": 0.05}),
    ],
    ids=["standing", "lying", "cone"],
)
def test_what_fcl_answers_passes_seams_too(shape, fields):
    """Measured at most 1e-12 m/s."""
    assert crossing(shape, 3.0, WAYS[0], **fields)[0] < 1e-9


def test_a_box_slides_down_along_a_wall_of_two():
    """The seam is level, the wall upright: the box falls freely past the lower block."""
    wall = body("low", "type: box, size: [1, 1, 1]", position=(0.5, 0, -0.5), fixed=True)
    wall += body("high", "type: box, size: [1, 1, 1]", position=(0.5, 0, 0.5), fixed=True)
    box = body("box", "type: box, size: [0.2, 0.2, 0.2]", position=(-0.1 + 1e-10, 0, 0.3))
    scene = Lab(SCENE.format(way=WAYS[2], mu=0.3) + wall + box)
    scene.run(0.3)
    assert scene.get("position", "box")[2] == pytest.approx(0.3 - 0.5 * 9.81 * 0.3**2, abs=1e-6)
    assert len(scene.events()["time"]) == 0


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("step", [1e-6, 0.05])
def test_a_step_up_is_hit(step, way):
    """A table higher by a micrometre stops the plastic box at its side."""
    low = body("low", "type: box, size: [2, 4, 1]", position=(-1, 0, -0.5), fixed=True)
    high = body("high", "type: box, size: [2, 4, 1]", position=(1, 0, -0.5 + step), fixed=True)
    box = body("box", BOX, position=(-0.4, 0, 0.1), velocity=(0.8, 0, 0))
    scene = Lab(SCENE.format(way=way, mu=0) + low + high + box).run(0.32)
    events = scene.events()
    assert np.abs(np.array(events["normal"])[:, 0]).max() > 0.999
    assert min(events["time"]) == pytest.approx(0.25 / 0.8, abs=1e-6)
    assert scene.get("velocity", "box")[0] < 0.5
