"""The built-in library: complete, sourced, consistent."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from importlib import resources
from typing import Any

import pytest

from physsim.materials import NUMBERS, library
from physsim.materials.library import Number

ALL = ("density", *NUMBERS)


def numbers() -> Iterator[tuple[str, str, Number]]:
    """Every number of the library with its owner and name."""
    for name in sorted(library.material_names()):
        for key in ALL:
            value = getattr(library.material(name), key)
            if value is not None:
                yield name, key, value
    for pair in library.pairs():
        for key in NUMBERS:
            value = getattr(pair, key)
            if value is not None:
                yield " - ".join(pair.between), key, value


def test_every_number_has_a_source_and_lies_in_its_range() -> None:
    count = 0
    for owner, key, number in numbers():
        assert number.sources, (owner, key)
        assert all(len(source) > 20 for source in number.sources), (owner, key)
        assert number.low <= number.value <= number.high, (owner, key)
        count += 1
    assert count > 250


def test_every_number_can_be() -> None:
    """Restitution in [0, 1]; friction not negative, static at least kinetic; densities of matter."""
    for owner, key, number in numbers():
        if key == "restitution":
            assert 0 <= number.low <= number.high <= 1, owner
        elif key == "density":
            assert 50 < number.value < 23000, owner
        else:
            assert number.low >= 0, owner
    rows = [*(library.material(name) for name in library.material_names()), *library.pairs()]
    for row in rows:
        if row.static_friction is not None and row.kinetic_friction is not None:
            assert row.static_friction.value >= row.kinetic_friction.value, row


@pytest.mark.parametrize(
    ("a", "b", "low", "high"),
    [
        ("steel", "steel", 0.55, 0.75),
        ("rubber", "floor", 0.75, 0.85),
        ("superball", "floor", 0.90, 0.95),
        ("clay", "clay", 0.0, 0.0),
        ("glass", "glass", 0.95, 0.95),
        ("golf_ball", "floor", 0.68, 0.68),
        ("basketball", "floor", 0.70, 0.75),
    ],
)
def test_the_sheets_restitution_table(a: str, b: str, low: float, high: float) -> None:
    """Section 2 of the formula sheet, row by row."""
    pair = library.pair(a, b)
    assert pair is not None
    assert pair.restitution is not None
    assert low <= pair.restitution.value <= high
    assert pair.restitution.source == "formula sheet, table 2"


@pytest.mark.parametrize(
    ("a", "b", "static", "kinetic"),
    [
        ("steel", "steel", 0.74, 0.57),
        ("greased_steel", "steel", 0.15, 0.09),
        ("greased_steel", "greased_steel", 0.15, 0.09),
        ("rubber", "concrete", 0.8, 0.75),
        ("rubber", "floor", 0.8, 0.75),
        ("wood", "wood", 0.4, 0.2),
        ("ice", "ice", 0.03, 0.02),
        ("teflon", "teflon", 0.04, 0.04),
    ],
)
def test_the_sheets_friction_table(a: str, b: str, static: float, kinetic: float) -> None:
    """Section 3 of the formula sheet, row by row."""
    pair = library.pair(b, a)
    assert pair is not None
    assert pair.static_friction is not None
    assert pair.kinetic_friction is not None
    assert (pair.static_friction.value, pair.kinetic_friction.value) == (static, kinetic)
    assert pair.static_friction.source == "formula sheet, table 3"


def test_densities_that_everyone_knows() -> None:
    """Within 1 % of the usual figures."""
    known = {"steel": 7850, "aluminium": 2700, "copper": 8960, "lead": 11340, "ice": 917, "gold": 19300}
    for name, density in known.items():
        number = library.material(name).density
        assert number is not None
        assert number.value == pytest.approx(density, rel=0.01)


def raw() -> Any:
    return json.loads(resources.files("physsim.materials").joinpath("library.json").read_text("utf-8"))


def test_the_file_itself() -> None:
    """No row twice, only known keys, materials and sources, all sources used, honest marks."""
    data = raw()
    keys = [tuple(sorted(row["between"])) for row in data["pairs"]]
    assert len(keys) == len(set(keys))
    assert {name for key in keys for name in key} <= set(data["materials"])
    assert {source["checked"] for source in data["sources"].values()} <= {
        "read",
        "second hand",
        "handbook, not re-read",
    }
    rows = [*data["materials"].values(), *data["pairs"]]
    assert {key for row in rows for key in row} <= {*ALL, "between", "notes", "color"}
    entries = [entry for row in rows for key, entry in row.items() if key in ALL]
    assert {key for entry in entries for key in entry} <= {"value", "range", "sources", "conditions"}
    assert {source for entry in entries for source in entry["sources"]} == set(data["sources"])


def test_sources_that_were_not_read_are_marked() -> None:
    density = library.material("gold").density
    assert density is not None
    assert density.sources[0].endswith("[handbook, not re-read]")


def test_unknown_names_come_with_the_nearest() -> None:
    with pytest.raises(KeyError, match="did you mean 'aluminium'"):
        library.material("aluminum")
    assert library.pair("steel", "unobtainium") is None


def test_the_library_is_read_without_numpy() -> None:
    code = (
        "import sys; from physsim.materials import library; library.pairs(); "
        "sys.exit('numpy' in sys.modules or 'yaml' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
