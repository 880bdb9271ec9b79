"""Expressions of time: programs against Python's own arithmetic, dimensions, bounds."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physsim.scene.expressions import FUNCTIONS
from physsim.scene.grammar import ExpressionError
from physsim.scene.program import (
    ADD,
    CONSTANT,
    FUNCTION_CODES,
    MAX_OPERATIONS,
    MAX_STACK,
    MULTIPLY,
    TIME,
    compiled,
    run,
)
from physsim.scene.units import Measure, parse_measure

PARAMETERS = {
    "period": parse_measure("2 s"),
    "omega": parse_measure("3 rad/s"),
    "drop": parse_measure("50 cm"),
    "v": parse_measure("3 m/s"),
    "n": Measure(4.0),
}


def program(text: str) -> tuple[float, ...]:
    """The expression with the parameters above, compiled."""
    return compiled(text, PARAMETERS.get)


def deepest(program: Sequence[float]) -> int:
    """The most values that ever stand on the stack."""
    takes = {CONSTANT: 0, TIME: 0, 7: 1, **dict.fromkeys(FUNCTION_CODES.values(), 1)}
    takes |= {FUNCTION_CODES[name]: 2 for name in ("atan2", "min", "max", "hypot")}
    depth = most = 0
    for code in program[::2]:
        depth += 1 - takes.get(int(code), 2)
        most = max(most, depth)
    assert depth == 1
    return most


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("t", 0.3),
        ("-t ^ 2", -0.09),
        ("2 ^ t", 2**0.3),
        ("1 - 2 * t / 3", 1 - 0.2),
        ("sin(2*pi*t)*exp(-t)", math.sin(0.6 * math.pi) * math.exp(-0.3)),
        ("sin(2*pi*t / period)", math.sin(0.3 * math.pi)),
        ("sin(omega * t)", math.sin(0.9)),
        ("exp(-t / (200 ms))", math.exp(-1.5)),
        ("v * t / drop", 1.8),
        ("cos(30 deg * t)", math.cos(math.pi * 0.05)),
        ("min(t, 1, n)", 0.3),
        ("max(t)", 0.3),
        ("max(1, t, 2)", 2.0),
        ("hypot(3 * t, 4 * t, 0)", 1.5),
        ("hypot(-t)", 0.3),
        ("atan2(t, t)", math.pi / 4),
        ("round(10 * t / 2 - 1) + floor(t) + ceil(t)", 1.0),
        ("abs(t - 1) + sqrt(t * t)", 1.0),
        ("log(exp(t)) + log10(10 ^ t)", 0.6),
        ("asin(sin(t)) + acos(cos(t)) + atan(tan(t))", 0.9),
        ("sinh(t) + cosh(t) + tanh(0 * t)", math.exp(0.3)),
        ("n", 4.0),
        ("2", 2.0),
    ],
)
def test_the_value_is_that_of_the_formula(text: str, expected: float) -> None:
    # Measured: at most 1.2e-16 off, one rounding.
    assert run(program(text), 0.3) == pytest.approx(expected, rel=1e-15, abs=1e-15)


def test_every_function_of_expressions_has_its_operation() -> None:
    assert set(FUNCTION_CODES) == set(FUNCTIONS)
    assert len(set(FUNCTION_CODES.values())) == len(FUNCTIONS)


def test_what_does_not_depend_on_time_is_computed_beforehand() -> None:
    assert program("2 * pi * t + n / 2") == (
        CONSTANT, 2 * math.pi, TIME, 0, MULTIPLY, 0, CONSTANT, 2.0, ADD, 0,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("drop * t", "gives a value in m, not a plain number"),
        ("drop", "gives a value in m, not a plain number"),
        ("sin(drop * t)", "has m in a function, which takes a plain number"),
        ("t + drop * n / (1 kg)", "gives a value in m/kg, not a plain number"),
        ("t * drop + t * (1 kg)", "mixes m with kg"),
        ("t ^ drop", "has m in an exponent, which takes a plain number"),
        ("(drop * t) ^ t", "has m in a power of time, which takes a plain number"),
        ("t / 0", "divides by zero"),
        ("t + 1e308 * 10", "gives a number that is not finite"),
        ("t + q", "uses 'q', which is no parameter of this scene"),
        ("t(2)", "uses the unknown function 't'"),
        ("sin(t, t)", "gives 2 argument(s) to sin, which takes 1"),
        ("t t", "has 't' where an operator was expected"),
        ("t *", "ends too early"),
        ("__import__('os')", "cannot be read at ''os')'"),
        ("t" + " + t" * 200, "is too long for an expression"),
    ],
)
def test_what_has_no_meaning_is_refused(text: str, message: str) -> None:
    with pytest.raises(ExpressionError) as caught:
        program(text)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize("text", ["1 / t", "sqrt(t - 1)", "log(t)", "exp(1e4 * (t + 1))", "(t - 1) ^ 0.5"])
def test_where_there_is_no_value_it_is_no_number(text: str) -> None:
    assert math.isnan(run(program(text), 0.0))


def test_programs_are_bounded() -> None:
    longest = "+".join("t" * 250)
    assert len(program(longest)) / 2 == 499 <= MAX_OPERATIONS
    nested = "(t+" * 39 + "t" + ")" * 39
    assert deepest(program(nested)) == 40 <= MAX_STACK
    with pytest.raises(ExpressionError, match="nested deeper"):
        program("(t+" * 41 + "t" + ")" * 41)
    tower = "(t+t*" * 39 + "t" + ")" * 39
    with pytest.raises(ExpressionError, match="too long for an expression of time"):
        program(tower)


leaves = st.sampled_from(["t", "n", "2", "0.5", "period / (1 s)"])
formulas = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*"), inner).map(lambda p: f"({p[0]} {p[1]} {p[2]})"),
        st.tuples(st.sampled_from(["sin", "cos", "tanh", "abs", "atan"]), inner).map("{0[0]}({0[1]})".format),
        st.tuples(st.sampled_from(["min", "max", "hypot", "atan2"]), inner, inner).map(
            "{0[0]}({0[1]}, {0[2]})".format
        ),
        inner.map(lambda text: f"-{text}"),
    ),
    max_leaves=12,
)


@given(formulas, st.floats(0, 10))
def test_a_program_computes_what_python_computes(text: str, t: float) -> None:
    if len(text) > 500:
        return
    names = {name: getattr(math, name) for name in ("sin", "cos", "tanh", "atan", "hypot", "atan2")}
    source = text.replace("period / (1 s)", "2.0")
    known = {**names, "abs": abs, "min": min, "max": max, "t": t, "n": 4.0}
    expected = eval(source, {"__builtins__": {}}, known)
    made = program(text)
    assert run(made, t) == pytest.approx(expected, rel=1e-12, abs=1e-12)
    assert deepest(made) <= MAX_STACK


@given(st.text(alphabet="t0123456789.+-*/^(), sincoexp", max_size=80))
def test_any_text_is_compiled_or_refused(text: str) -> None:
    try:
        made = program(text)
    except ExpressionError:
        return
    assert deepest(made) <= MAX_STACK
    assert isinstance(run(made, 1.0), float)
