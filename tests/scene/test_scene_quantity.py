"""Names of quantities: what they mean, and the likely slips."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physsim.scene.quantity import ENERGY_TERMS, QuantityError, parse_quantity


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("time", ("time", None, "time", None, "s")),
        ("bodies.crate.position.z", ("bodies", "crate", "position", "z", "m")),
        ("bodies.brick[0,0,3].position.z", ("bodies", "brick[0,0,3]", "position", "z", "m")),
        ("bodies.Cube.001.velocity.x", ("bodies", "Cube.001", "velocity", "x", "m/s")),
        ("bodies.position.position.y", ("bodies", "position", "position", "y", "m")),
        ("bodies.a.angular_velocity.x", ("bodies", "a", "angular_velocity", "x", "rad/s")),
        ("bodies.a.orientation.w", ("bodies", "a", "orientation", "w", "")),
        ("bodies.a.speed", ("bodies", "a", "speed", None, "m/s")),
        ("bodies.a.angular_speed", ("bodies", "a", "angular_speed", None, "rad/s")),
        ("energy.total", ("energy", None, "total", None, "J")),
        ("energy.lost_friction", ("energy", None, "lost_friction", None, "J")),
        ("momentum.linear.x", ("momentum", None, "linear", "x", "kg*m/s")),
        ("momentum.angular.z", ("momentum", None, "angular", "z", "kg*m^2/s")),
        ("contacts.count", ("contacts", None, "count", None, "")),
        ("solver.residual", ("solver", None, "residual", None, "m/s")),
    ],
)
def test_scalars(text: str, parts: tuple[str | None, ...]) -> None:
    quantity = parse_quantity(text)
    found = (quantity.group, quantity.body, quantity.field, quantity.component, quantity.kind.unit)
    assert found == parts
    assert quantity.is_scalar
    assert quantity.text == text


@pytest.mark.parametrize(
    ("text", "components"),
    [("bodies.a.position", "xyz"), ("bodies.a.orientation", "wxyz"), ("momentum.linear", "xyz")],
)
def test_whole_vectors(text: str, components: str) -> None:
    quantity = parse_quantity(text)
    assert "".join(quantity.components) == components
    assert not quantity.is_scalar
    assert quantity.index is None
    assert parse_quantity(f"{text}.{components[-1]}").index == len(components) - 1


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("tim", "names no quantity", "did you mean 'time'?"),
        ("energies.total", "names no quantity", "did you mean 'energy'?"),
        ("bodies", "names no quantity of a body", None),
        ("bodies.crate", "names no quantity of a body", None),
        ("bodies.crate.velocty", "names no quantity of a body", "did you mean 'velocity'?"),
        ("bodies..position", "names no quantity of a body", None),
        ("bodies.crate.position.w", "names no component of position", None),
        ("bodies.crate.speed.x", "names a part of speed, which is a single number", None),
        ("energy", "names no quantity of energy", None),
        ("energy.totl", "names no quantity of energy", "did you mean 'total'?"),
        ("energy.total.x", "names a part of total, which is a single number", None),
        ("", "names no quantity", None),
    ],
)
def test_slips(text: str, message: str, hint: str | None) -> None:
    with pytest.raises(QuantityError) as caught:
        parse_quantity(text)
    assert (str(caught.value), caught.value.hint) == (message, hint)


def test_every_term_of_the_ledger_has_a_name() -> None:
    assert all(parse_quantity(f"energy.{term}").is_scalar for term in ENERGY_TERMS)


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        quantity = parse_quantity(f"bodies.{text}")
    except QuantityError:
        return
    assert quantity.body
