"""Numbers with units, against pint as an independent reader."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physsim.scene.units import UNITS, UnitError, dimension_text, fits, parse_measure, parse_unit

# How pint spells what it spells otherwise or not at all.
PINT_NAMES = {
    "l": "liter",
    "L": "liter",
    "kph": "km/hour",
    "knot": "nautical_mile/hour",
    "rev": "turn",
    "g0": "standard_gravity",
    "kgf": "kilogram_force",
    "lbf": "pound_force",
    "lb": "pound",
    "h": "hour",
    "mi": "mile",
    "in": "inch",
    "ml": "milliliter",
    "mL": "milliliter",
    "min": "minute",
    "°": "degree",
    "deg": "degree",
    "%": "percent",
    "t": "tonne",
    "yd": "yard",
}
BASE = ("kilogram", "meter", "second", "radian")


@pytest.fixture(scope="module")
def pint_units() -> Any:
    pint = pytest.importorskip("pint")
    return pint.UnitRegistry()


@pytest.mark.parametrize("name", sorted(UNITS))
def test_every_unit_is_what_pint_says(name: str, pint_units: Any) -> None:
    theirs = pint_units.Quantity(1.0, PINT_NAMES.get(name, name)).to_base_units()
    ours = parse_measure(f"1 {name}")
    # Both are exact to rounding: largest relative difference seen 2e-16.
    assert ours.value == pytest.approx(theirs.magnitude, rel=1e-14)
    powers = {str(unit): float(power) for unit, power in theirs.unit_items()}
    assert dict(zip(BASE, ours.dimension, strict=True)) == {unit: powers.pop(unit, 0.0) for unit in BASE}
    assert not powers


FACTOR = st.tuples(
    st.sampled_from(["m", "cm", "kg", "g", "s", "ms", "N", "J", "rad", "deg", "Hz", "kN", "GPa"]),
    st.integers(-3, 3),
)


@settings(max_examples=150, deadline=None)
@given(st.floats(-1e6, 1e6), st.lists(FACTOR, min_size=1, max_size=4), st.sampled_from(["*", " ", "·"]))
def test_products_and_powers_are_what_pint_says(
    pint_units: Any, number: float, factors: list[tuple[str, int]], joint: str
) -> None:
    text = joint.join(f"{name}^{power}" for name, power in factors)
    ours = parse_measure(f"{number!r} {text}")
    theirs = pint_units.Quantity(1.0, "dimensionless")
    for name, power in factors:
        theirs = theirs * pint_units.Quantity(1.0, PINT_NAMES.get(name, name)) ** power
    assert ours.value == pytest.approx(number * theirs.to_base_units().magnitude, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "value", "dimension"),
    [
        ("5 cm", 0.05, "m"),
        ("57 cm", 0.57, "m"),
        ("5cm", 0.05, "m"),
        ("-30 deg", -math.pi / 6, "rad"),
        ("1200 rpm", 40 * math.pi, "rad/s"),
        ("7.85 g/cm^3", 7850.0, "kg/m^3"),
        ("9.81 m/s2", 9.81, "m/s^2"),
        ("9.81 m/s**2", 9.81, "m/s^2"),
        ("9.81 m s⁻²", 9.81, "m/s^2"),
        ("2 N*s/m", 2.0, "kg/s"),
        ("2 N·m/rad", 2.0, "kg m^2/s^2/rad"),
        ("6.674e-11 m^3/(kg s^2)", 6.674e-11, "m^3/kg/s^2"),
        ("5 1/s", 5.0, "1/s"),
        ("50 %", 0.5, "no unit"),
        (" 3 ", 3.0, "no unit"),
        ("3 µm", 3e-6, "m"),
        ("3 μm", 3e-6, "m"),
    ],
)
def test_what_users_write(text: str, value: float, dimension: str) -> None:
    measure = parse_measure(text)
    assert measure.value == value
    assert dimension_text(measure.dimension) == dimension


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("1,5 m", "is not a number", "write the decimals after a point, and digits without separators"),
        ("1_000 m", "is not a number", "write the decimals after a point, and digits without separators"),
        ("nan m", "is not a number", "every number in a scene is finite"),
        ("inf", "is not a number", "every number in a scene is finite"),
        ("five m", "is not a number", None),
        ("5 M", "has the unknown unit 'M'", "did you mean 'm'?"),
        ("5 KN", "has the unknown unit 'KN'", "did you mean 'kN'?"),
        ("5 m/", "has a unit that ends too early", None),
        ("5 m^99", "has a power of 99 in its unit, the most is 9", None),
        ("5 (m", "has a unit that ends too early", None),
        ("5 (m m", "has a unit that ends too early", None),
        ("5 m)", "has ')' too much in its unit", None),
        ("5 cm + 1 m", "has a unit that cannot be read at '+ 1 m'", None),
        ("9**9**9**9 m", "has a unit that cannot be read at '**9'", None),
        ("5 (((((((m)))))))", "has a unit that cannot be read at '('", None),
        ("1e308 km", "must be finite", None),
        ("1 " + "km^9" * 15, "must be finite", None),
        ("1" * 81, "is too long for a number with a unit (at most 80 characters)", None),
    ],
)
def test_what_is_refused(text: str, message: str, hint: str | None) -> None:
    with pytest.raises(UnitError) as caught:
        parse_measure(text)
    assert (str(caught.value), caught.value.hint) == (message, hint)


@given(st.text(alphabet="0123456789.eE+-*/^() µ°%mkgsNradHz²⁻,_", max_size=100))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        measure = parse_measure(text)
    except UnitError:
        return
    assert math.isfinite(measure.value)


@pytest.mark.parametrize(
    ("given", "wanted", "verdict"),
    [
        ("N*m", "N*m/rad", True),
        ("N*m*s", "N*m*s/rad", True),
        ("Hz", "rad/s", False),
        ("m", "m", True),
        ("J", "N*m", True),
    ],
)
def test_radians_may_be_left_out_beside_kilograms_only(given: str, wanted: str, verdict: bool) -> None:
    assert fits(parse_unit(given).dimension, parse_unit(wanted).dimension) is verdict
