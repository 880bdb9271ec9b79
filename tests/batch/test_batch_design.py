"""Which runs a sweep asks for: orders, ends, units, and distributions against their closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from physsim.batch.design import Run, design_of, values_of
from physsim.batch.distributions import LEAST, points, standard_normal, values_at
from physsim.batch.spec import SweepSpec
from physsim.batch.spec.values import unit_text
from physsim.scene.units import parse_measure, parse_unit


def spec(**keys) -> SweepSpec:
    return SweepSpec.model_validate({"physsim_sweep": 1, "scene": "a.yaml", **keys})


def test_grid_zip_sample_and_replicates_make_every_combination_once() -> None:
    design = design_of(
        spec(
            grid={"a": [1, 2, 3], "b": ["x", "y"]},
            zip={"c": [10, 20], "d": ["1 m", "2 m"]},
            sample={"count": 4, "values": {"e": {"type": "uniform", "from": 0, "to": 1}}},
            replicates=2,
            seed=7,
        )
    )
    runs = list(design)
    assert len(runs) == len(design) == 2 * 3 * 2 * 2 * 4
    assert len({run.key for run in runs}) == len(runs)
    assert [run.number for run in runs] == list(range(len(runs)))
    assert [run.cells[:4] for run in runs[:9:4]] == [(1, "x", 10, 1), (1, "x", 20, 2), (1, "y", 10, 1)]
    assert {run.replicate for run in runs[:48]} == {0}
    assert dict(runs[0].changes)["simulation.seed"] == 7
    assert dict(runs[48].changes)["simulation.seed"] == 8
    assert runs[0].cells[4] != runs[48].cells[4]
    assert [run.cells[4] for run in runs[:4]] == [run.cells[4] for run in runs[4:8]]


def test_ranges_reach_both_ends_and_keep_their_unit() -> None:
    axes = spec(
        grid={
            "a": {"type": "range", "from": "10 cm", "to": 1, "count": 4},
            "b": {"type": "log_range", "from": "1 g", "to": "1 kg", "count": 4},
            "c": {"type": "range", "from": 3, "to": 9, "count": 1},
            "d": {"type": "log_range", "from": -1, "to": -100, "count": 3},
        }
    ).grid
    a, b, c, d = (values_of(path, axis) for path, axis in axes.items())
    assert a.cells == pytest.approx((0.1, 0.4, 0.7, 1.0), rel=1e-15)
    assert (a.cells[0], a.cells[-1], a.unit) == (0.1, 1.0, "m")
    assert b.cells == pytest.approx((1e-3, 1e-2, 1e-1, 1.0), rel=1e-14)
    assert (b.cells[0], b.cells[-1], b.unit) == (1e-3, 1.0, "kg")
    assert c.cells == (3.0,)
    assert d.cells == pytest.approx((-1, -10, -100), rel=1e-14)
    for axis in (a, b, c, d):
        assert [parse_measure(str(text)).value for text in axis.written] == list(axis.cells)


def test_lists_are_numbers_when_all_are_and_text_otherwise() -> None:
    axes = spec(grid={"a": ["10 cm", "1 m", 2], "b": ["1 m", "1 kg"], "c": [[0, 0, 1], {"type": "x"}]}).grid
    a, b, c = (values_of(path, axis) for path, axis in axes.items())
    assert (a.cells, a.unit, a.written) == ((0.1, 1.0, 2.0), "m", ("10 cm", "1 m", 2))
    assert (b.cells, b.unit) == (("1 m", "1 kg"), "")
    assert c.cells == ("[0, 0, 1]", '{"type": "x"}')


@given(st.tuples(*[st.integers(-3, 3)] * 4))
def test_units_are_written_as_scenes_read_them(powers: tuple[int, ...]) -> None:
    dimension = tuple(float(power) for power in powers)
    text = unit_text(dimension)
    assert (parse_unit(text).dimension if text else (0.0,) * 4) == dimension


DISTRIBUTIONS = {
    "uniform": ({"type": "uniform", "from": "1 m", "to": "3 m"}, stats.uniform(1, 2)),
    "log_uniform": ({"type": "log_uniform", "from": 0.01, "to": 10}, stats.loguniform(0.01, 10)),
    "normal": ({"type": "normal", "mean": -1, "deviation": 2}, stats.norm(-1, 2)),
    "truncated": (
        {"type": "normal", "mean": 1, "deviation": 2, "from": 0, "to": 2},
        stats.truncnorm(-0.5, 0.5, 1, 2),
    ),
    "tail": ({"type": "normal", "mean": 0, "deviation": 1, "from": 6}, stats.truncnorm(6, np.inf)),
    "log_normal": ({"type": "log_normal", "median": 3, "factor": 2}, stats.lognorm(math.log(2), scale=3)),
}


@pytest.mark.parametrize("name", DISTRIBUTIONS)
def test_values_have_the_distribution_that_was_asked_for(name: str) -> None:
    """Against the quantiles of scipy.stats; measured: 4e-16."""
    given_, wanted = DISTRIBUTIONS[name]
    (of,) = spec(sample={"count": 1, "values": {"x": given_}}).sample.values.values()
    u = np.array([LEAST, 0.001, 0.1, 0.5, 0.9, 0.999, 1 - LEAST])
    np.testing.assert_allclose(values_at(of, u), wanted.ppf(u), rtol=1e-13, atol=1e-14)


def test_a_cut_off_normal_stays_inside() -> None:
    u = np.array([LEAST, 0.5, 1 - LEAST])
    for low, high in ((-1.0, 1.0), (7.0, 8.0), (-40.0, -39.0)):
        z = standard_normal(u, low, high)
        assert np.isfinite(z).all()
        assert (np.diff(z) > 0).all()
        assert low - 1e-9 <= z[0] <= z[-1] <= high + 1e-9


@pytest.mark.parametrize("method", ["random", "latin_hypercube", "sobol"])
def test_points_are_the_same_for_the_same_seed_only(method: str) -> None:
    first, again, other = (points(method, 16, 3, [seed, 0]) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first, again)
    assert (first != other).any()
    assert ((first > 0) & (first < 1)).all()


def test_a_latin_hypercube_has_one_point_in_every_slice() -> None:
    u = points("latin_hypercube", 50, 4, [0, 0])
    for k in range(4):
        assert sorted((u[:, k] * 50).astype(int)) == list(range(50))


def test_sobol_points_are_balanced() -> None:
    """A scrambled (0, m, 2)-net in base 2: each of 8 x 8 boxes has one of 64 points (Sobol 1967)."""
    u = points("sobol", 64, 2, [3, 0])
    boxes = (u[:, 0] * 8).astype(int) * 8 + (u[:, 1] * 8).astype(int)
    assert len(set(boxes)) == 64


def test_the_key_of_a_run_is_that_of_its_changes() -> None:
    one = Run(0, 0, (("a", 1),), (1,))
    assert one.key == Run(5, 0, (("a", 1),), (1,)).key
    assert one.key != Run(0, 0, (("a", 2),), (2,)).key
