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
        ("bodies.a.kinetic_energy", ("bodies", "a", "kinetic_energy", None, "J")),
        ("bodies.a.momentum.x", ("bodies", "a", "momentum", "x", "kg*m/s")),
        ("bodies.a.angular_momentum.y", ("bodies", "a", "angular_momentum", "y", "kg*m^2/s")),
        ("bodies.a.contact_force.z", ("bodies", "a", "contact_force", "z", "N")),
        ("energy.total", ("energy", None, "total", None, "J")),
        ("energy.lost_friction", ("energy", None, "lost_friction", None, "J")),
        ("momentum.linear.x", ("momentum", None, "linear", "x", "kg*m/s")),
        ("momentum.angular.z", ("momentum", None, "angular", "z", "kg*m^2/s")),
        ("contacts.count", ("contacts", None, "count", None, "")),
        ("solver.residual", ("solver", None, "residual", None, "m/s")),
        ("solver.fallbacks", ("solver", None, "fallbacks", None, "")),
        ("energy.gravitation", ("energy", None, "gravitation", None, "J")),
        ("springs.tether.length", ("springs", "tether", "length", None, "m")),
        ("springs.tether.force", ("springs", "tether", "force", None, "N")),
        ("springs.wind.up.angle", ("springs", "wind.up", "angle", None, "rad")),
        ("springs.wind_up.torque", ("springs", "wind_up", "torque", None, "N*m")),
        ("joints.hinge.force.x", ("joints", "hinge", "force", "x", "N")),
        ("joints.hinge.torque.z", ("joints", "hinge", "torque", "z", "N*m")),
        ("joints.force.reaction", ("joints", "force", "reaction", None, "N")),
        ("joints.hinge.coordinate", ("joints", "hinge", "coordinate", None, "")),
        ("joints.hinge.coordinate_3", ("joints", "hinge", "coordinate_3", None, "")),
        ("joints.hinge.violation", ("joints", "hinge", "violation", None, "m")),
        ("joints.hinge.angular_violation", ("joints", "hinge", "angular_violation", None, "rad")),
    ],
)
def test_scalars(text: str, parts: tuple[str | None, ...]) -> None:
    quantity = parse_quantity(text)
    found = (quantity.group, quantity.name, quantity.field, quantity.component, quantity.kind.unit)
    assert found == parts
    assert quantity.is_scalar
    assert quantity.text == text


@pytest.mark.parametrize(
    ("text", "components"),
    [
        ("bodies.a.position", "xyz"),
        ("bodies.a.orientation", "wxyz"),
        ("momentum.linear", "xyz"),
        ("joints.a.force", "xyz"),
        ("joints.a.torque", "xyz"),
    ],
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
        ("springs.s.lenth", "names no quantity of a spring", "did you mean 'length'?"),
        ("joints.j.position", "names no quantity of a joint", None),
        ("joints.j.coordinate.x", "names a part of coordinate, which is a single number", None),
        ("joints.force.x", "names no quantity of a joint", None),
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


@pytest.mark.parametrize(
    ("joint", "units"),
    [
        ("distance", ("m", "", "")),
        ("hinge", ("rad", "", "")),
        ("slider", ("m", "", "")),
        ("screw", ("rad", "", "")),
        ("cylindrical", ("m", "rad", "")),
        ("universal", ("rad", "rad", "")),
        ("planar", ("m", "m", "rad")),
        ("ball", ("", "", "")),
        ("no such type", ("", "", "")),
    ],
)
def test_coordinates_are_angles_or_lengths_as_the_joint_has_them(joint: str, units: tuple[str, ...]) -> None:
    fields = ("coordinate", "coordinate_2", "coordinate_3")
    found = tuple(parse_quantity(f"joints.j.{field}", {"j": joint}).kind.unit for field in fields)
    assert found == units


def test_every_term_of_the_ledger_has_a_name() -> None:
    assert all(parse_quantity(f"energy.{term}").is_scalar for term in ENERGY_TERMS)


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        quantity = parse_quantity(f"bodies.{text}")
    except QuantityError:
        return
    assert quantity.name
