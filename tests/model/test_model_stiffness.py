"""What is told to be too stiff for the timestep is what blows up: the bounds against the engine itself."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from small_scenes import compiled

from physsim._engine import Diverged, World
from physsim.errors import Problem, dotted
from physsim.model import compile_scene, stability
from physsim.model.joint_mobility import mobility
from physsim.model.modes import fastest_mode
from physsim.scene import load_scene_text

TIMESTEP = 1e-3
INTEGRATORS = ("explicit_euler", "semi_implicit_euler", "verlet", "velocity_verlet", "leapfrog", "rk4")
BLOCK = "shape: {type: box, size: [1, 1, 1]}, mass: 1 kg, collides: false"


def scene(integrator: str, rest: str) -> str:
    return (
        "physsim: 1\nworld: {gravity: [0, 0, 0]}\n"
        f"simulation: {{duration: 1 s, timestep: {TIMESTEP}, integrator: {integrator}}}\n{rest}"
    )


def oscillator(integrator: str, omega_dt: float, zeta: float) -> str:
    """1 kg on a spring, stretched by a micrometre."""
    omega = omega_dt / TIMESTEP
    return scene(
        integrator,
        f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n"
        "springs: {s: {type: linear, between: [world, a], rest_length: 1.999999, "
        f"stiffness: {omega**2}, damping: {2 * zeta * omega}}}}}\n",
    )


def growth(text: str, steps: int = 400) -> float:
    """Largest swing over the first one."""
    world = World(compile_scene(load_scene_text(text)).engine_input())
    widest = 0.0
    for _ in range(steps):
        try:
            world.advance(1)
        except Diverged:
            return np.inf
        widest = max(widest, abs(world.state()["position"][0, 0] - 1.999999))
    return widest / 1e-6


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("zeta", [0, 0.1, 0.5, 1, 3])
def test_below_the_bound_nothing_grows(integrator: str, zeta: float) -> None:
    """2 % below it; without damping semi-implicit Euler swings up to 1 / sqrt(1 - (omega dt / 2)^2) = 5.03
    times as wide as it began. At a double real rate the swing may first grow: 18.1 times at zeta = 1.
    """
    bound = 0.98 * stability.largest_step(integrator, zeta)
    if bound > 0:
        assert growth(oscillator(integrator, bound, zeta)) < 20


@pytest.mark.parametrize(
    ("integrator", "zeta"),
    [
        (name, zeta)
        for name in INTEGRATORS
        for zeta in (0, 0.5, 3)
        if zeta == 0 or "euler" in name or name == "rk4"
    ],
)
def test_above_the_bound_everything_grows(integrator: str, zeta: float) -> None:
    """2 % above it by 65 times at least (explicit Euler at zeta = 0.5) in 400 steps."""
    bound = max(1.02 * stability.largest_step(integrator, zeta), 0.2)
    assert growth(oscillator(integrator, bound, zeta)) > 50


def warnings(text: str) -> tuple[Problem, ...]:
    return compile_scene(load_scene_text(text)).warnings


@pytest.mark.parametrize("integrator", INTEGRATORS[1:])
def test_too_stiff_is_told_with_the_numbers(integrator: str) -> None:
    bound = stability.largest_step(integrator, 0)
    assert warnings(oscillator(integrator, 0.99 * bound, 0)) == ()
    (warning,) = warnings(oscillator(integrator, 3, 0))
    assert dotted(warning.path) == "springs.s"
    assert "omega dt = 3 (omega = 3000 rad/s, damping ratio 0)" in warning.message
    assert f"{integrator} grows beyond {bound:.3g}" in warning.message
    assert f"below {bound / 3000:.2g} s" in str(warning.hint)


def test_explicit_euler_is_told_by_how_much_it_grows() -> None:
    """sqrt(1 + (omega dt)^2)^1000 = 1.649 at omega dt = sqrt(0.001)."""
    (warning,) = warnings(oscillator("explicit_euler", sqrt(1e-3), 0))
    assert "gains energy at every step of explicit_euler" in warning.message
    assert "grows 1.65 times over the run" in warning.message
    assert warnings(oscillator("explicit_euler", sqrt(1e-3), 0.1)) == ()
    assert warnings(oscillator("explicit_euler", 1e-3, 0)) == ()


def test_a_damper_alone() -> None:
    """c dt / m = 3; the engine agrees that it runs away."""
    damper = "springs: {s: {type: linear, between: [world, a], damping: 3000}}\n"
    text = scene("semi_implicit_euler", f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n{damper}")
    (warning,) = warnings(text)
    assert "damps too strongly for the timestep: c dt / m = 3" in warning.message


def test_steepest_part_of_a_curve_counts() -> None:
    """Soft near rest, 9e6 N/m at its end: omega dt = 3."""
    curve = "force_curve: [[-1, -1], [1, 1], [1.001, 9001]]"
    body = f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n"
    text = scene("verlet", f"{body}springs: {{s: {{type: linear, between: [world, a], {curve}}}}}\n")
    (warning,) = warnings(text)
    assert "omega dt = 3 " in warning.message


def chain(count: int, stiffness: float) -> str:
    bodies = "".join(f"  b{i}: {{{BLOCK}, position: [{i + 1}, 0, 0]}}\n" for i in range(count))
    before = ["world", *(f"b{i}" for i in range(count - 1))]
    springs = "".join(
        f"  s{i}: {{type: linear, between: [{name}, b{i}], stiffness: {stiffness}}}\n"
        for i, name in enumerate(before)
    )
    return scene("semi_implicit_euler", f"bodies:\n{bodies}springs:\n{springs}")


def test_the_fastest_mode_of_a_chain() -> None:
    """n masses, one end tied: omega_j = 2 sqrt(k/m) sin((2 j - 1) pi / (2 (2 n + 1))), the last of them is
    2 sqrt(k/m) cos(pi / (2 n + 1)); measured error at n = 20: 2e-7, from below.
    """
    count, k = 20, 100.0
    mode = fastest_mode(compile_scene(load_scene_text(chain(count, k))).mechanics.springs.rows)
    assert mode is not None
    expected = 2 * sqrt(k) * np.cos(pi / (2 * count + 1))
    assert mode.angular_frequency == pytest.approx(expected, rel=1e-4)
    assert mode.angular_frequency <= expected * (1 + 1e-12)


def test_springs_that_are_too_stiff_only_together() -> None:
    """Alone sqrt(2 k / m) dt = 1.7, together up to 2.4: it blows up, and is told."""
    text = chain(20, (1.2 / TIMESTEP) ** 2)
    (warning,) = warnings(text)
    assert warning.message.startswith(
        "together with its neighbours is too stiff for the timestep: omega dt = 2.3"
    )


def test_damping_of_a_mode() -> None:
    """Two equal masses between walls with dampers like springs: every mode has zeta = c omega / (2 k)."""
    k, c = 100.0, 2.0
    springs = [("world", "a"), ("a", "b")]
    text = "".join(
        f"  s{i}: {{type: linear, between: [{one}, {other}], stiffness: {k}, damping: {c}}}\n"
        for i, (one, other) in enumerate(springs)
    )
    bodies = f"  a: {{{BLOCK}, position: [1, 0, 0]}}\n  b: {{{BLOCK}, position: [2, 0, 0]}}\n"
    mode = fastest_mode(compiled(f"bodies:\n{bodies}springs:\n{text}").mechanics.springs.rows)
    assert mode is not None
    assert mode.damping_ratio == pytest.approx(c * mode.angular_frequency / (2 * k), rel=1e-12)


@pytest.mark.parametrize(
    ("joint", "coordinate", "expected"),
    [
        # A pendulum about y: I = m (1 + 1) / 12 + m 2^2.
        ("type: hinge, anchor: [0, 0, 0], axis: [0, 1, 0], friction: 1", 0, 1 / (1 / 6 + 4)),
        # About the line through its centre: its own moment.
        ("type: hinge, anchor: [0, 0, 0], axis: [1, 0, 0], friction: 1", 0, 6),
        ("type: slider, anchor: [0, 0, 0], axis: [1, 0, 0], friction: 1", 0, 1),
        ("type: cylindrical, anchor: [2, 0, 0], axis: [0, 1, 0]", 0, 1),
        ("type: cylindrical, anchor: [2, 0, 0], axis: [0, 1, 0]", 1, 6),
        ("type: planar, anchor: [2, 0, 0], normal: [0, 1, 0]", 2, 6),
        # Turning by 1 advances by 3 / 2 pi: I + m pitch^2.
        ("type: screw, anchor: [2, 0, 0], axis: [0, 1, 0], pitch: 3", 0, 1 / (1 / 6 + (3 / (2 * pi)) ** 2)),
        # Its second axis is free, so the arm along it does not count.
        ("type: universal, anchor: [2, 0, 0], axes: [[0, 1, 0], [1, 0, 0]]", 1, 6),
    ],
)
def test_mobility_of_coordinates(joint: str, coordinate: int, expected: float) -> None:
    """A cube of 1 kg and 1 m at (2, 0, 0), its moments 1/6; measured error 4e-16."""
    kind, _, rest = joint.partition(",")
    model = compiled(
        f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n"
        f"joints: {{j: {{{kind}, between: [world, a],{rest}}}}}\n"
    )
    assert mobility(model.mechanics.joints.rows[0], coordinate) == pytest.approx(expected, rel=1e-12)


def test_a_servo_too_stiff_for_the_timestep() -> None:
    """A pendulum of I = 25/6 kg m^2; omega dt = sqrt(k / I) dt = 3 is told at the joint."""
    k = 9e6 * 25 / 6
    hinge = (
        "joints: {j: {type: hinge, between: [world, a], anchor: [0, 0, 0], axis: [0, 1, 0], "
        f"motor: {{angle: 0, stiffness: {k}}}}}}}\n"
    )
    text = scene("semi_implicit_euler", f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n{hinge}")
    (warning,) = warnings(text)
    assert dotted(warning.path) == "joints.j"
    assert "omega dt = 3 (" in warning.message


def test_stops_of_springs_are_joints_without_names() -> None:
    spring = "springs: {s: {type: linear, between: [world, a], limits: [1, 3]}}\n"
    assert warnings(scene("rk4", f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n{spring}")) == ()


@pytest.mark.parametrize("kind", ["ball", "cone"])
def test_damping_of_turning_too_strong_for_the_timestep(kind: str) -> None:
    """Nothing was said of the damping of ball and cone joints, and a chain shook itself to pieces.

    A cube of 1 kg and 1 m turns hardest about its centre: c dt / I = 6 c dt = 3 is told at the joint.
    """
    cone = "axis: [1, 0, 0], max_angle: 1, " if kind == "cone" else ""
    joint = f"joints: {{j: {{type: {kind}, between: [world, a], anchor: [0, 0, 0], {cone}damping: C}}}}\n"
    text = scene("semi_implicit_euler", f"bodies: {{a: {{{BLOCK}, position: [2, 0, 0]}}}}\n{joint}")
    (warning,) = warnings(text.replace("C}", f"{0.5 / TIMESTEP}}}"))
    assert dotted(warning.path) == "joints.j"
    assert "c dt / m = 3, " in warning.message
    assert not warnings(text.replace("C}", f"{0.3 / TIMESTEP}}}"))
