"""Metrics against closed forms, and the same from a file as from a run that was only watched."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter

import physsim
from physsim.batch.metrics import metrics_of, wanted_of
from physsim.batch.spec.metrics import MetricSpec
from physsim.model import compile_scene
from physsim.scene import load_scene_text
from physsim.simulation import watch

# A ball that flies (x = t, z = 1 + 2 t - g t²/2), a brick that lies, one that falls 5 cm and does not bounce.
SCENE = """\
physsim: 1
simulation: {duration: 400 ms, timestep: 1 ms, integrator: velocity_verlet}
pairs: [{between: [concrete, concrete], restitution: 0, static_friction: 0.8, kinetic_friction: 0.7}]
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1], velocity: [1, 0, 2]}
  lying: {shape: {type: box, size: [20 cm, 20 cm, 10 cm]}, material: concrete, position: [2, 0, 5 cm]}
  falling:
    shape: {type: box, size: [20 cm, 20 cm, 10 cm]}
    mass: 2 kg
    material: concrete
    position: [3, 0, 10 cm]
record: {every: 1 ms}
"""
G = 9.81
FALL = math.sqrt(2 * 0.05 / G)
TIMES = np.arange(401) * 1e-3
HEIGHTS = 1 + 2 * TIMES - 0.5 * G * TIMES**2
Z = {"quantity": "bodies.ball.position.z"}
CASES = {
    "initial": ({"type": "initial", **Z}, 1.0),
    "final": ({"type": "final", **Z}, HEIGHTS[-1]),
    "until": ({"type": "final", "until": 0.1, **Z}, HEIGHTS[100]),
    "max": ({"type": "max", **Z}, HEIGHTS.max()),
    "min_later": ({"type": "min", "from": 0.05, "until": "0.3 s", **Z}, HEIGHTS[50]),
    "mean": ({"type": "mean", **Z}, HEIGHTS.mean()),
    "rms": ({"type": "rms", **Z}, np.sqrt((HEIGHTS**2).mean())),
    "deviation": ({"type": "deviation", **Z}, HEIGHTS.std()),
    "range": ({"type": "range", **Z}, np.ptp(HEIGHTS)),
    "when_highest": ({"type": "time_of_max", **Z}, 0.204),
    "when_lowest": ({"type": "time_of_min", **Z}, 0.0),
    "at": ({"type": "at", "time": "123.4 ms", **Z}, 0.6 * HEIGHTS[123] + 0.4 * HEIGHTS[124]),
    "up": ({"type": "crossing", "level": "1.1 m", **Z}, (2 - math.sqrt(4 - 0.2 * G)) / G),
    "down": ({"type": "crossing", "level": 1.1, "direction": "down", **Z}, (2 + math.sqrt(4 - 0.2 * G)) / G),
    "never": ({"type": "crossing", "level": 9, **Z}, math.nan),
    "touched": ({"type": "first_contact", "between": ["floor", "falling"]}, FALL),
    "lay_there": ({"type": "first_contact", "between": ["lying", "*"]}, 0.001),
    "never_touched": ({"type": "first_contact", "between": ["ball", "*"]}, math.nan),
    "none": ({"type": "impacts", "between": ["ball", "*"]}, 0.0),
    "soft": ({"type": "hardest_impact", "between": ["ball", "*"]}, 0.0),
    "still": ({"type": "rest_time", "bodies": "lying"}, 0.0),
    "stopped": ({"type": "rest_time", "bodies": "*ing"}, FALL),
    "not_all": ({"type": "rest_time"}, math.nan),
    "lost": ({"type": "energy_lost"}, 2 * G * 0.05),
    "sum": ({"type": "expression", "value": "max - initial + wind"}, HEIGHTS.max() - 1 + 3),
    "root": ({"type": "expression", "value": "sqrt(initial - 2)"}, math.nan),
    "of_nan": ({"type": "expression", "value": "never + 1"}, math.nan),
}
# Rounding for the smooth ones; a step for what waits for a step, one impact for what is lost in one.
TOLERANCES = {"up": 1e-6, "down": 1e-6, "touched": 1e-3, "stopped": 2e-3, "lost": 2e-2}


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, float], dict[str, float]]:
    """All metrics, from memory and from a file."""
    scene = load_scene_text(SCENE)
    metrics = {name: TypeAdapter(MetricSpec).validate_python(case) for name, (case, _) in CASES.items()}
    moving = ["ball", "lying", "falling"]
    watched = watch(scene, compile_scene(scene), wanted_of(metrics, (), moving)).as_trajectory()
    file: Path = tmp_path_factory.mktemp("metrics") / "run.h5"
    with physsim.run(scene, output=file) as trajectory:
        here, there = (metrics_of(source, metrics, {"wind": 3.0}, moving) for source in (watched, trajectory))
    return here, there


@pytest.mark.parametrize("name", CASES)
def test_metric_is_what_the_closed_form_says(measured, name: str) -> None:
    wanted = CASES[name][1]
    assert measured[0][name] == pytest.approx(wanted, rel=0, abs=TOLERANCES.get(name, 1e-12), nan_ok=True)


def test_metrics_of_a_file_and_of_a_watched_run_have_the_same_bits(measured) -> None:
    here, there = measured
    assert [value.hex() for value in here.values()] == [value.hex() for value in there.values()]
    assert list(here) == list(CASES)
