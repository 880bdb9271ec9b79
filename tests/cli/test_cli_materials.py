"""`physsim materials`: the list, one material, and what holds between two."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from physsim.materials import NUMBERS, library


def test_list_names_every_material_and_pair(physsim) -> None:
    said = physsim("materials")
    assert said.code == 0
    for name in library.material_names():
        assert f"\n{name} " in said.out
    for pair in library.pairs():
        assert f"\n{' - '.join(pair.between)} " in said.out


def test_one_material_shows_numbers_with_range_and_source(physsim) -> None:
    said = physsim("materials", "steel")
    density = library.material("steel").density
    assert said.code == 0
    assert f"density: {density.value:g} kg/m^3" in said.out
    assert density.sources[0] in said.out


def test_two_materials_show_the_resolved_pair_and_why(physsim) -> None:
    told = physsim("materials", "steel", "ice")
    row = library.pair("steel", "ice")
    assert told.code == 0
    assert told.out.startswith("steel - ice\n")
    assert (
        f"  kinetic_friction: {row.kinetic_friction.value:g}\n    library: {row.kinetic_friction.source}"
        in told.out
    )


def test_order_of_two_materials_does_not_matter(physsim) -> None:
    one, other = (
        json.loads(physsim("materials", *names, "--json").out)
        for names in (("steel", "ice"), ("ice", "steel"))
    )
    for name in NUMBERS:
        assert one["pairs"][0][name] == other["pairs"][0][name]


def test_where_one_material_has_no_number_the_other_s_is_taken(physsim, monkeypatch) -> None:
    steel = library.material("steel")
    bare = replace(steel, name="bare", restitution=None)
    monkeypatch.setattr(library, "_materials", lambda: {"steel": steel, "bare": bare})
    told = physsim("materials", "bare", "steel").out
    assert f"restitution: {steel.restitution.value:.4g}\n    mixing: only 'steel' has a number" in told
    assert f"kinetic_friction: {steel.kinetic_friction.value:.4g}\n    mixing: geometric_mean" in told


def test_friction_that_nobody_knows_is_said_so(physsim, monkeypatch) -> None:
    bare = replace(library.material("steel"), name="bare", static_friction=None, kinetic_friction=None)
    other = replace(bare, name="other")
    monkeypatch.setattr(library, "_materials", lambda: {"other": other, "bare": bare})
    told = physsim("materials", "bare", "other")
    assert "  static_friction: 0\n    assumed 0: is not given for 'bare' and 'other'" in told.out
    assert "pairs: [{between: [bare, other], static_friction: ..., kinetic_friction: ...}]" in told.err
    pair = json.loads(physsim("materials", "bare", "other", "--json").out)["pairs"][0]
    assert pair["assumed"] == ["static_friction", "kinetic_friction"]


def test_unknown_material_is_wrong_usage_with_the_nearest_name(physsim) -> None:
    said = physsim("materials", "steal")
    assert said.code == 2
    assert "did you mean 'steel'?" in said.err


@pytest.mark.parametrize("names", [[], ["steel"], ["steel", "ice", "wood"]])
def test_json_is_one_document(physsim, names: list[str]) -> None:
    document = json.loads(physsim("materials", *names, "--json").out)
    assert document["command"] == "materials"
    assert document["exit_code"] == 0
    assert len(document["pairs"]) >= 1
