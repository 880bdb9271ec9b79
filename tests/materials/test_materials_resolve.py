"""Which number holds between two materials."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physsim.materials import NUMBERS, UnknownPair, resolve_pair
from physsim.materials.mixing import RULES


@dataclass(frozen=True)
class Coefficients:
    """A material as a scene declares it."""

    restitution: float | None = None
    static_friction: float | None = None
    kinetic_friction: float | None = None


@dataclass(frozen=True)
class Row(Coefficients):
    """A row of a scene's pairs."""

    between: tuple[str, str] = ("a", "b")


@dataclass(frozen=True)
class Mixing:
    """The scene language's defaults."""

    restitution: str = "minimum"
    friction: str = "geometric_mean"


def test_the_scenes_pairs_come_first() -> None:
    row = Row(0.4, 0.7, 0.6, between=("steel", "rubber"))
    pair = resolve_pair("rubber", "steel", {}, [Row(between=("steel", "steel")), row], Mixing())
    assert [getattr(pair, name).value for name in NUMBERS] == [0.4, 0.7, 0.6]
    assert pair.source == "scene, pairs[1]"


def test_then_the_librarys_pairs() -> None:
    pair = resolve_pair("concrete", "rubber", {}, [], Mixing())
    assert (pair.restitution.value, pair.static_friction.value, pair.kinetic_friction.value) == (
        0.8,
        0.8,
        0.75,
    )
    assert (
        pair.source == "restitution library: formula sheet, table 2; friction library: formula sheet, table 3"
    )


def test_then_the_mixing_rule() -> None:
    scene = {"a": Coefficients(0.2, 0.9, 0.4), "b": Coefficients(0.6, 0.4, 0.1)}
    pair = resolve_pair("a", "b", scene, [], Mixing())
    assert pair.restitution.value == 0.2
    assert pair.static_friction.value == pytest.approx(0.6)
    assert pair.kinetic_friction.value == pytest.approx(0.2)
    assert pair.source == "restitution mixing: minimum; friction mixing: geometric_mean"


def test_each_number_is_looked_up_by_itself() -> None:
    """The scene's row states restitution only, the library's only friction."""
    row = Row(0.3, between=("wood", "steel"))
    pair = resolve_pair("steel", "wood", {}, [row], Mixing())
    assert pair.restitution.source == "scene, pairs[0]"
    assert pair.static_friction.source == "library: OpenStax"


def test_a_number_that_the_scene_restates_is_newer_than_the_table() -> None:
    """rubber with its own restitution: that one is mixed, friction still comes from the library's pair."""
    pair = resolve_pair("rubber", "concrete", {"rubber": Coefficients(restitution=0.5)}, [], Mixing())
    assert pair.restitution.value == 0.5
    assert pair.restitution.source == "mixing: minimum"
    assert pair.static_friction.source == "library: formula sheet, table 3"
    unchanged = resolve_pair("rubber", "concrete", {"rubber": Coefficients()}, [], Mixing())
    assert unchanged.restitution.value == 0.8


def test_one_coefficient_of_friction_serves_for_both() -> None:
    scene = {"a": Coefficients(0.1, static_friction=0.5)}
    pair = resolve_pair("a", "a", scene, [], Mixing())
    assert pair.kinetic_friction.value == pair.static_friction.value == 0.5
    row = Row(0.1, kinetic_friction=0.3)
    pair = resolve_pair("a", "b", {}, [row], Mixing())
    assert pair.static_friction.value == 0.3
    assert "value of kinetic_friction" in pair.static_friction.source


def test_static_friction_is_never_below_kinetic() -> None:
    """steel on steel has 0.74 / 0.57: a lower mu_s of the scene lowers mu_k, a higher mu_k lifts mu_s."""
    slippery = Row(static_friction=0.3, between=("steel", "steel"))
    pair = resolve_pair("steel", "steel", {}, [slippery], Mixing())
    assert (pair.static_friction.value, pair.kinetic_friction.value) == (0.3, 0.3)
    assert pair.kinetic_friction.source.endswith("lowered to static_friction")
    rough = Row(kinetic_friction=0.9, between=("steel", "steel"))
    pair = resolve_pair("steel", "steel", {}, [rough], Mixing())
    assert (pair.static_friction.value, pair.kinetic_friction.value) == (0.9, 0.9)
    assert pair.static_friction.source.endswith("raised to kinetic_friction")


def test_what_nobody_knows_is_assumed_and_named() -> None:
    pair = resolve_pair("oak", "golf_ball", {}, [], Mixing())
    assert pair.restitution.value == 0.68
    assert pair.restitution.source == "mixing: only 'golf_ball' has a number"
    pair = resolve_pair("platinum", "golf_ball", {}, [], Mixing())
    assert pair.assumed == ("static_friction", "kinetic_friction")
    assert pair.static_friction.value == pair.kinetic_friction.value == 0
    assert "'platinum' and 'golf_ball'" in pair.static_friction.source
    assert pair.hint.startswith("declare it: pairs: [{between: [platinum, golf_ball], static_friction: ...")


def test_error_refuses_to_mix() -> None:
    strict = Mixing("error", "error")
    with pytest.raises(UnknownPair, match="mixing is 'error'") as raised:
        resolve_pair("steel", "rubber", {}, [], strict)
    assert raised.value.exit_code == 2
    assert set(raised.value.missing) == set(NUMBERS)
    assert raised.value.hint.startswith("declare it: pairs: [{between: [steel, rubber], restitution: ...")
    assert resolve_pair("steel", "steel", {}, [], strict).restitution.value == 0.65


values = st.floats(0, 2)


@given(values, values)
def test_rules_are_symmetric_and_ordered(a: float, b: float) -> None:
    """minimum <= harmonic <= geometric <= arithmetic mean <= maximum (1e-12), exchange changes nothing."""
    mixed = {name: rule(a, b) for name, rule in RULES.items()}
    assert mixed == {name: rule(b, a) for name, rule in RULES.items()}
    order = [mixed[name] for name in ("minimum", "harmonic_mean", "geometric_mean", "mean", "maximum")]
    assert all(low <= high + 1e-12 for low, high in pairwise(order))
    assert mixed["product"] == a * b


@given(st.sampled_from(sorted(RULES)), values)
def test_equals_stay_as_they_are_but_for_the_product(rule: str, a: float) -> None:
    expected = a * a if rule == "product" else a
    assert RULES[rule](a, a) == pytest.approx(expected, rel=1e-15, abs=1e-150)


@given(st.tuples(values, values), st.tuples(values, values), st.sampled_from(sorted(RULES)))
def test_mixing_keeps_static_above_kinetic(a: tuple[float, float], b: tuple[float, float], rule: str) -> None:
    scene = {name: Coefficients(0.0, max(pair), min(pair)) for name, pair in (("a", a), ("b", b))}
    pair = resolve_pair("a", "b", scene, [], Mixing("minimum", rule))
    assert pair.static_friction.value >= pair.kinetic_friction.value
