"""Dry friction: what holds, what slides, how far."""

from __future__ import annotations

import numpy as np
import pytest
from laboratory import FLOOR, GRAVITY, body, lab

BLOCK = "type: box, size: [0.4, 0.3, 0.2]"
HEADINGS = [0.0, 0.35, 0.7854, 1.3, 2.5]


def on_incline(mu: float, slope: float, mu_k: float | None = None, timestep: float = 2e-3):
    """A block that lies on a plane tilted by `slope` [rad] about y: downhill is +x turned down."""
    normal = (float(np.sin(slope)), 0.0, float(np.cos(slope)))
    plane = f"  plane: {{fixed: true, shape: {{type: halfspace, normal: {list(normal)}}}, material: stuff}}\n"
    block = body(
        "block", BLOCK, position=0.1 * np.array(normal), orientation={"axis": (0, 1, 0), "angle": slope}
    )
    return lab(plane + block, mu=mu, mu_k=mu_k, timestep=timestep)


@pytest.mark.parametrize("slope", [10.0, 29.0])
def test_below_the_threshold_a_block_does_not_creep(slope):
    """60 s on a slope below atan(0.56) = 29.2 degrees. Measured 3e-10 m."""
    block = on_incline(0.56, np.radians(slope))
    start = block.get("position", "block")
    block.run(60.0)
    assert np.linalg.norm(block.get("position", "block") - start) < 1e-6
    assert np.linalg.norm(block.get("velocity", "block")) < 1e-9


@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
@pytest.mark.parametrize("mu_k", [0.56, 0.3])
def test_above_the_threshold_it_slides_with_the_kinetic_coefficient(mu_k, timestep):
    """a = g (sin s - mu_k cos s) once it slides. It starts under mu_s; it passes `slip_speed` at once."""
    slope = np.radians(32.0)
    block = on_incline(0.56, slope, mu_k, timestep)
    block.run(0.1)
    v0 = np.linalg.norm(block.get("velocity", "block"))
    block.run(0.9)
    gained = np.linalg.norm(block.get("velocity", "block")) - v0
    # measured 1e-13
    assert gained == pytest.approx(0.9 * GRAVITY * (np.sin(slope) - mu_k * np.cos(slope)), rel=1e-9)


@pytest.mark.parametrize("heading", HEADINGS)
@pytest.mark.parametrize("timestep", [2e-3, 1e-3])
def test_stopping_distance_in_any_heading(heading, timestep):
    """d = v^2 / (2 mu g), along the heading and not beside it: the friction disc is a disc.

    Semi-implicit Euler brakes at the start of each step: short by v dt / 2.
    """
    v, mu = 2.0, 0.4
    way = np.array([np.cos(heading), np.sin(heading), 0])
    block = lab(
        FLOOR + body("block", BLOCK, position=(0, 0, 0.1), velocity=v * way), mu=mu, timestep=timestep
    )
    block.run(1.0)
    x = block.get("position", "block") - [0, 0, 0.1]
    assert x @ way == pytest.approx(v**2 / (2 * mu * GRAVITY) - v * timestep / 2, abs=1e-5)
    assert np.linalg.norm(x - (x @ way) * way) < 1e-6
    assert np.linalg.norm(block.get("velocity", "block")) < 1e-9


def test_kinetic_friction_is_exactly_mu_k_of_the_normal_impulse_while_it_slides():
    block = lab(FLOOR + body("block", BLOCK, position=(0, 0, 0.1), velocity=(2, 1, 0)), mu=0.5, mu_k=0.3).run(
        0.1
    )
    found = block.world.contacts()
    assert found["sliding"].all()
    assert np.linalg.norm(found["tangential_impulse"], axis=1) == pytest.approx(0.3 * found["normal_impulse"])
    weight = 24.0 * GRAVITY * 1e-3
    assert found["normal_impulse"].sum() == pytest.approx(weight, rel=1e-9)
    on_block = np.where(found["body_a"] == block.index("block"), 1.0, -1.0)
    against = np.array([-2, -1, 0]) / 5**0.5
    friction = on_block @ found["tangential_impulse"]
    assert friction == pytest.approx(0.3 * weight * against, rel=1e-6)


def test_work_of_friction_is_booked():
    """All of m v^2 / 2 goes into friction; the books close to rounding."""
    block = lab(FLOOR + body("block", BLOCK, position=(0, 0, 0.1), velocity=(2, 0, 0)), mu=0.4).run(1.0)
    books = block.world.energies()
    assert books["lost_friction"] == pytest.approx(24.0 * 4 / 2, rel=1e-6)
    assert abs(books["residual"]) < 1e-9


@pytest.mark.parametrize("shape", ["type: sphere, radius: 0.1", "type: hollow_sphere, radius: 0.1"])
@pytest.mark.parametrize("heading", [0.0, 0.6])
@pytest.mark.parametrize("timestep", [1e-3, 5e-4])
def test_a_sliding_ball_comes_to_roll(shape, heading, timestep):
    """With I = k m r^2 it rolls with v0 / (1 + k) after k v0 / ((1 + k) mu g); 5/7 v0 at 2 v0 / (7 mu g) when
    solid (Coriolis 1835). Rolling starts at a whole step.
    """
    k = 2 / 3 if "hollow" in shape else 2 / 5
    v0, mu = 2.0, 0.2
    way = np.array([np.cos(heading), np.sin(heading), 0])
    when = k / (1 + k) * v0 / (mu * GRAVITY)
    ball = lab(
        FLOOR + body("ball", shape, mass=1.0, position=(0, 0, 0.1), velocity=v0 * way),
        mu=mu,
        timestep=timestep,
    )
    slips = []
    while ball.world.state()["step"] * timestep < when + 0.1:
        ball.step()
        contact = ball.get("velocity", "ball") + np.cross(ball.get("angular_velocity", "ball"), [0, 0, -0.1])
        slips.append(np.linalg.norm(contact))
    # measured 1e-9
    assert ball.get("velocity", "ball") == pytest.approx(v0 / (1 + k) * way, abs=1e-7)
    rolled = (1 + next(n for n, slip in enumerate(slips) if slip < 1e-6)) * timestep
    assert rolled == pytest.approx(when, abs=1.01 * timestep)
    path = ball.get("position", "ball")
    ball.run(1.0)
    assert ball.get("position", "ball") - path == pytest.approx(v0 / (1 + k) * way, abs=1e-6)


@pytest.mark.parametrize(
    ("shape", "k"),
    [
        ("type: sphere, radius: 0.1", 2 / 5),
        ("type: hollow_sphere, radius: 0.1", 2 / 3),
        ("type: cylinder, radius: 0.1, height: 0.1", 1 / 2),
    ],
)
def test_rolling_down_an_incline(shape, k):
    """a = g sin s / (1 + k), whatever mass and radius (Goldstein, sec. 2.4)."""
    slope = np.radians(15.0)
    normal = np.array([np.sin(slope), 0, np.cos(slope)])
    plane = (
        f"  plane: {{fixed: true, shape: {{type: halfspace, normal: {normal.tolist()}}}, material: stuff}}\n"
    )
    turn = {"axis": (1, 0, 0), "angle": np.pi / 2}
    roller = body("roller", shape, mass=2.0, position=0.1 * normal, orientation=turn)
    speed = np.linalg.norm(lab(plane + roller, mu=0.5).run(1.0).get("velocity", "roller"))
    assert speed == pytest.approx(GRAVITY * np.sin(slope) / (1 + k), rel=1e-5)


def test_a_spinning_block_comes_to_rest():
    """Friction takes spin as well; afterwards it neither turns nor wanders."""
    block = lab(FLOOR + body("block", BLOCK, position=(0, 0, 0.1), angular_velocity=(0, 0, 8)), mu=0.4).run(
        2.0
    )
    before = block.get("orientation", "block")
    assert np.linalg.norm(block.get("angular_velocity", "block")) < 1e-9
    assert np.linalg.norm(block.get("position", "block")[:2]) < 1e-6
    assert block.run(2.0).get("orientation", "block") == pytest.approx(before, abs=1e-9)


@pytest.mark.parametrize("push", [0.9, 1.1])
def test_a_tall_block_on_an_incline_topples_where_its_weight_passes_the_edge(push):
    """A block 0.1 wide and 0.4 high topples above atan(0.25), 14.04 degrees, whatever it weighs."""
    slope = push * np.arctan(0.25)
    normal = np.array([np.sin(slope), 0, np.cos(slope)])
    plane = (
        f"  plane: {{fixed: true, shape: {{type: halfspace, normal: {normal.tolist()}}}, material: stuff}}\n"
    )
    turn = {"axis": (0, 1, 0), "angle": slope}
    block = lab(
        plane + body("block", "type: box, size: [0.1, 0.2, 0.4]", position=0.2 * normal, orientation=turn),
        mu=2.0,
    )
    block.run(1.5)
    up = block.get("orientation", "block")
    tilt = 2 * np.arctan2(up[2], up[0]) - slope
    assert (abs(tilt) < 1e-6) if push < 1 else (tilt > 1.0)
