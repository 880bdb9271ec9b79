"""The pair table of a model: which numbers, from where, and which pairs are asked for."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_scenes import compiled, problems

from physsim.errors import dotted
from physsim.model.pair_table import NEVER, can_touch


def ball(name: str, material: str, more: str = "") -> str:
    return f"  {name}: {{shape: {{type: sphere, radius: 0.1}}, mass: 1 kg, material: {material}{more}}}\n"


def test_the_table_is_symmetric_and_says_where_from() -> None:
    model = compiled(
        "pairs: [{between: [rubber, steel], restitution: 0.4, static_friction: 0.7, kinetic_friction: 0.6}]\n"
        "bodies:\n" + ball("a", "steel") + ball("b", "rubber") + ball("c", "concrete")
    )
    pairs, names = model.pairs, model.material_names
    steel, rubber, concrete = (names.index(name) for name in ("steel", "rubber", "concrete"))
    assert pairs.restitution[rubber, steel] == pairs.restitution[steel, rubber] == 0.4
    assert pairs.source[steel][rubber] == pairs.source[rubber][steel] == "scene, pairs[0]"
    assert pairs.source[concrete][steel].startswith(
        "restitution mixing: minimum; static_friction library: Rabbat"
    )
    for matrix in (pairs.restitution, pairs.static_friction, pairs.kinetic_friction):
        assert (matrix == matrix.T).all()
    assert (pairs.static_friction >= pairs.kinetic_friction).all()


def test_assumed_numbers_are_told_where_the_material_is_used() -> None:
    model = compiled("bodies:\n" + ball("a", "ice") + ball("b", "ice"))
    (problem,) = model.warnings
    assert dotted(problem.path) == "bodies.a.material"
    assert problem.line == 4
    assert problem.message == "no restitution known between 'ice' and 'ice', 0 is assumed"
    assert problem.hint == "declare it: pairs: [{between: [ice, ice], restitution: ...}]"
    assert model.pairs.restitution[0, 0] == 0
    assert "assumed 0" in model.pairs.source[0][0]


def test_pairs_that_never_meet_are_not_asked_for() -> None:
    """Fixed against fixed, `collides: false`, `no_contact`, and one body against itself."""
    fixed = ", fixed: true"
    model = compiled("bodies:\n" + ball("a", "ice", fixed) + ball("b", "oak", fixed))
    assert set(sum(model.pairs.source, ())) <= {NEVER}
    assert compiled("bodies:\n" + ball("a", "ice", ", collides: false") + ball("b", "oak"))
    assert compiled("bodies:\n" + ball("a", "ice") + ball("b", "oak") + "no_contact: [[a, b]]\n")
    assert compiled("bodies:\n" + ball("a", "ice") + ball("b", "oak", fixed)).warnings


def test_mixing_error_refuses_what_no_table_has() -> None:
    text = "mixing: {restitution: error, friction: error}\nbodies:\n"
    (problem,) = problems(text + ball("a", "glass") + ball("b", "rubber"))
    assert "mixing is 'error'" in problem.message
    assert compiled(text + ball("a", "steel") + ball("b", "steel")).pairs.restitution[0, 0] == 0.65


@given(st.integers(0, 2**32 - 1), st.integers(1, 6), st.integers(1, 4))
def test_counting_agrees_with_trying_every_pair(seed: int, bodies: int, materials: int) -> None:
    random = np.random.default_rng(seed)
    made_of = random.random((bodies, materials)) < 0.5
    fixed = random.random(bodies) < 0.4
    i, j = np.triu_indices(bodies, k=1)
    chosen = random.random(len(i)) < 0.4
    no_contact = np.column_stack([i, j])[chosen].astype(np.int32)
    expected = np.zeros((materials, materials), dtype=bool)
    for a, b, apart in zip(i, j, chosen, strict=True):
        if not apart and not (fixed[a] and fixed[b]):
            expected |= np.outer(made_of[a], made_of[b]) | np.outer(made_of[b], made_of[a])
    assert (can_touch(made_of, fixed, no_contact) == expected).all()


@pytest.mark.parametrize("rule", ["minimum", "maximum", "mean", "geometric_mean", "harmonic_mean", "product"])
def test_every_rule_may_be_asked_for(rule: str) -> None:
    text = f"mixing: {{restitution: {rule}, friction: {rule}}}\nbodies:\n"
    model = compiled(text + ball("a", "glass") + ball("b", "rubber"))
    assert f"mixing: {rule}" in model.pairs.source[0][1]
