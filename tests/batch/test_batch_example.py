"""The example sweep against the closed form that its head promises, and the schema of sweeps."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from small_sweeps import GRID, METRICS

import physsim
from physsim.batch.schema import schema_text
from physsim.scene.nodes import plain
from physsim.scene.yaml_reader import read_yaml

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "slope_sweep.yaml"
G = 9.81


def test_the_example_slides_where_it_says(tmp_path: Path) -> None:
    """Speed after 1 s: a t beyond the threshold, nothing below; measured: 6e-3 m/s off at most."""
    result = physsim.sweep(EXAMPLE, output=tmp_path / "out", workers=2)
    column = result.table.column
    assert result.failed == 0
    for friction, slope, speed in zip(
        column("pairs[1].static_friction"), column("parameters.slope"), column("speed"), strict=True
    ):
        slides = math.tan(slope) > friction
        wanted = G * (math.sin(slope) - 0.2 * math.cos(slope)) if slides else 0.0
        assert speed == pytest.approx(wanted, abs=0.02)


def test_the_schema_is_fresh_and_takes_what_is_valid() -> None:
    renew = "renew it: python -m physsim.batch.schema > schemas/sweep.schema.json"
    assert (ROOT / "schemas" / "sweep.schema.json").read_text() == schema_text(), renew
    schema = json.loads(schema_text())
    Draft202012Validator.check_schema(schema)
    root = read_yaml(EXAMPLE.read_text()).root
    assert root is not None
    valid = {"physsim_sweep": 1, "scene": "a.yaml", "grid": GRID, "metrics": METRICS}
    for sweep in (plain(root), valid):
        assert [error.message for error in Draft202012Validator(schema).iter_errors(sweep)] == []
    for wrong in ({"gird": {}}, {"keep": "al"}, {"grid": {"a": {"type": "rang"}}}, {"metrics": {"x": {}}}):
        assert list(Draft202012Validator(schema).iter_errors({**valid, **wrong}))
