"""`expect`: every quantity has a value, and every kind of bound is judged."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import physsim
from physsim.errors import ExpectationFailed
from physsim.recording import NotInFile, Trajectory
from physsim.recording.quantities import over_time
from physsim.scene.quantity import ENERGY_TERMS, parse_quantity
from physsim.scene.spec.expect import ExpectSpec
from physsim.simulation import check_expectations, demand


@pytest.fixture
def trajectory(scene: Callable[..., Path], tmp_path: Path) -> Trajectory:
    with physsim.run(scene(), output=tmp_path / "run.h5", duration="200 ms") as made:
        yield made


def value(trajectory: Trajectory, name: str) -> np.ndarray:
    return over_time(trajectory, parse_quantity(name))


def test_every_quantity_has_one_value_per_frame(trajectory: Trajectory) -> None:
    names = ["time", "contacts.count", "solver.residual", "solver.iterations"]
    names += [f"energy.{term}" for term in ENERGY_TERMS]
    names += [f"momentum.{kind}.{axis}" for kind in ("linear", "angular") for axis in "xyz"]
    for field, parts in {"position": "xyz", "orientation": "wxyz", "velocity": "xyz"}.items():
        names += [f"bodies.brick[0,0,1].{field}.{part}" for part in parts]
    names += ["bodies.ball.speed", "bodies.ball.angular_speed"]
    for name in names:
        found = value(trajectory, name)
        assert found.shape == (trajectory.frames,), name
        assert np.isfinite(found).all(), name


def test_derived_quantities(trajectory: Trajectory) -> None:
    """The ball in flight: speed from x and z, energy total constant but for g dt / 2 per step."""
    fall = 9.81 * trajectory.time
    np.testing.assert_allclose(value(trajectory, "bodies.ball.speed"), np.hypot(1, fall), rtol=1e-12)
    kinetic = value(trajectory, "energy.kinetic_translational") + value(
        trajectory, "energy.kinetic_rotational"
    )
    np.testing.assert_array_equal(value(trajectory, "energy.kinetic"), kinetic)
    total = value(trajectory, "energy.total")
    assert total.max() - total.min() < 1e-2 * total[0]
    assert value(trajectory, "bodies.ball.position").shape == (trajectory.frames, 3)


@pytest.mark.parametrize(
    ("entry", "held"),
    [
        ({"value": 0.3, "within": 1e-12}, True),
        ({"value": 0.301, "within": 9e-4}, False),
        ({"min": 0.3}, True),
        ({"min": 0.31}, False),
        ({"max": 0.3}, True),
        ({"max": 0.29}, False),
        ({"min": 0.2, "max": 0.29}, False),
    ],
)
def test_bounds(trajectory: Trajectory, entry: dict[str, float], held: bool) -> None:
    spec = expected({"quantity": "bodies.ball.position.z", "at": 0.0, **entry})
    result = check_expectations(trajectory, [spec])[0]
    assert (result.held, result.got, result.unit) == (held, 0.3, "m")
    if held:
        demand([result])
    else:
        with pytest.raises(ExpectationFailed, match=r"bodies.ball.position.z at 0 s"):
            demand([result])


def expected(entry: dict[str, object]) -> ExpectSpec:
    text = (
        "physsim: 1\nsimulation: {duration: 1, timestep: 0.001}\n"
        "bodies: {ball: {shape: {type: sphere, radius: 1}, material: steel}}\n"
        f"expect: [{entry}]\n"
    )
    from physsim.scene import load_scene_text  # noqa: PLC0415

    return load_scene_text(text).spec.expect[0]


@pytest.mark.parametrize(("at", "time"), [("end", 0.2), (0.105, 0.105), (0.9, 0.2)])
def test_moments(trajectory: Trajectory, at: float | str, time: float) -> None:
    """Between frames linear in time; after an early end the last frame. The ball moves 1 m/s along x."""
    result = check_expectations(
        trajectory, [expected({"quantity": "bodies.ball.position.x", "at": at, "min": 0})]
    )[0]
    assert result.time == pytest.approx(time, abs=1e-15)
    assert result.got == pytest.approx(time, abs=1e-12)


def test_asking_for_what_was_not_recorded(scene: Callable[..., Path], tmp_path: Path) -> None:
    nothing = ("record: {every: 10 ms}", "record: {every: 10 ms, energy: false}")
    with (
        physsim.run(scene(nothing), output=tmp_path / "none.h5", duration="10 ms") as trajectory,
        pytest.raises(NotInFile, match="energy not recorded"),
    ):
        check_expectations(trajectory, [expected({"quantity": "energy.total", "min": 0})])
