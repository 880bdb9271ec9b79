"""Expressions: arithmetic against Python's own, dimensions, bounds, and parameters that use each other."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physsim.scene import Scene, load_scene_text
from physsim.scene.expressions import FUNCTIONS, evaluate
from physsim.scene.grammar import MAX_NESTING, ExpressionError
from physsim.scene.units import Measure, dimension_text, parse_measure

PARAMETERS = {
    "drop": parse_measure("50 cm"),
    "v": parse_measure("3 m/s"),
    "f": parse_measure("5 Hz"),
    "n": Measure(4.0),
    "e": Measure(0.5),
    "pi2": Measure(2.0),
    "μ": Measure(0.3),
}


def value(text: str) -> Measure:
    """The expression with the parameters above."""
    return evaluate(text, PARAMETERS.get).measure


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1 + 2 * 3", 7),
        ("(1 + 2) * 3", 9),
        ("2 ^ 3 ^ 2", 512),
        ("2 ** 3 ** 2", 512),
        ("-2 ^ 2", -4),
        ("2 ^ -1", 0.5),
        ("2 * -3", -6),
        ("--3", 3),
        ("8 / 4 / 2", 1),
        ("8 - 4 - 2", 2),
        ("1e3 + .5", 1000.5),
        ("pi", math.pi),
        ("tau / 2", math.pi),
        ("n * e", 2.0),
        ("μ", 0.3),
        ("sin(pi / 6)", math.sin(math.pi / 6)),
        ("sin(30 deg)", math.sin(math.pi / 6)),
        ("atan2(1, -1)", 0.75 * math.pi),
        ("sqrt(2)", math.sqrt(2)),
        ("max(1, n, 3)", 4.0),
        ("min(2, 1)", 1.0),
        ("hypot(3, 4)", 5.0),
        ("abs(-3)", 3.0),
        ("floor(2.7) + ceil(2.1) + round(2.4)", 7.0),
        ("exp(log(3))", math.exp(math.log(3))),
        ("100 * 5 %", 5.0),
    ],
)
def test_arithmetic(text: str, expected: float) -> None:
    assert value(text).value == expected


@pytest.mark.parametrize(
    ("text", "expected", "dimension"),
    [
        ("2 * drop", 1.0, "m"),
        ("drop + 10 cm", 0.6, "m"),
        ("drop + 0.1", 0.6, "m"),
        ("0.1 + drop", 0.6, "m"),
        ("drop * drop", 0.25, "m^2"),
        ("drop / drop", 1.0, "no unit"),
        ("drop ^ 2", 0.25, "m^2"),
        ("sqrt(drop * drop)", 0.5, "m"),
        ("sqrt(2 * 9.81 m / (1 s)^2 * drop)", math.sqrt(9.81), "m/s"),
        ("v / drop", 6.0, "1/s"),
        ("max(drop, 20 cm, 0)", 0.5, "m"),
        ("abs(-drop)", 0.5, "m"),
        ("atan2(drop, drop)", math.pi / 4, "rad"),
        ("asin(1)", math.pi / 2, "rad"),
        ("90 deg + 1 rad", math.pi / 2 + 1, "rad"),
        ("2 * pi * f", 10 * math.pi, "1/s"),
    ],
)
def test_dimensions_are_carried_along(text: str, expected: float, dimension: str) -> None:
    assert value(text).value == pytest.approx(expected, rel=1e-15)
    assert dimension_text(value(text).dimension) == dimension


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "ends too early"),
        ("1 +", "ends too early"),
        ("1 2", "has '2' where an operator was expected"),
        ("* 2", "has '*' where a number or a name was expected"),
        ("(1", "has an open parenthesis"),
        ("sin(1", "has an open parenthesis"),
        ("1)", "has ')' where an operator was expected"),
        ("1 % 2", "has '2' where an operator was expected"),
        ("a.b", "cannot be read at '.b'"),
        ("__import__('os')", "cannot be read at ''os')'"),
        ("[1]", "cannot be read at '[1]'"),
        ("1 / 0", "divides by zero"),
        ("0 ^ -1", "gives a number that is not finite"),
        ("(-8) ^ 0.5", "takes a root of a negative number"),
        ("sqrt(-1)", "asks sqrt for a value that does not exist"),
        ("log(0)", "asks log for a value that does not exist"),
        ("exp(1e6)", "asks exp for a value that does not exist"),
        ("floor(1e300) * 1e300", "gives a number that is not finite"),
        ("9**9**9**9", "gives a number that is not finite"),
        ("1e999", "gives a number that is not finite"),
        ("drop + v", "mixes m with m/s"),
        ("max(drop, v)", "mixes m with m/s"),
        ("sin(drop)", "has m in a function, which takes a plain number"),
        ("2 ^ drop", "has m in an exponent, which takes a plain number"),
        ("nothing", "uses 'nothing', which is no parameter of this scene"),
        ("sin", "uses 'sin', which is no parameter of this scene"),
        ("sine(1)", "uses the unknown function 'sine'"),
        ("n(1)", "uses the unknown function 'n'"),
        ("sin(1, 2)", "gives 2 argument(s) to sin, which takes 1"),
        ("atan2(1)", "gives 1 argument(s) to atan2, which takes 2"),
        ("sin()", "has ')' where a number or a name was expected"),
        ("5 furlongs", "has the unknown unit 'furlongs'"),
        ("(" * 50 + "1" + ")" * 50, "is nested deeper than 40"),
        ("-" * 50 + "1", "is nested deeper than 40"),
        ("2^" * 60 + "1", "is nested deeper than 40"),
        ("1" * 501, "is too long for an expression (at most 500 characters)"),
    ],
)
def test_what_is_refused(text: str, message: str) -> None:
    with pytest.raises(ExpressionError) as caught:
        value(text)
    assert str(caught.value) == message


def python_text(text: str) -> str:
    return text.replace("^", "**")


ARITHMETIC = st.recursive(
    st.floats(0.1, 100).map(lambda x: f"{x:.6g}") | st.sampled_from(["n", "e"]),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda t: f"({t[0]} {t[1]} {t[2]})"),
        inner.map(lambda t: f"-{t}"),
        st.tuples(st.sampled_from(["sin", "cos", "abs", "atan"]), inner).map(lambda t: f"{t[0]}({t[1]})"),
    ),
    max_leaves=12,
)


@settings(max_examples=200, deadline=None)
@given(ARITHMETIC)
def test_arithmetic_is_python_s(text: str) -> None:
    names = {"n": 4.0, "e": 0.5, "sin": math.sin, "cos": math.cos, "abs": abs, "atan": math.atan}
    try:
        expected = eval(text, {"__builtins__": {}}, names)  # our own text, in a test only
    except (ZeroDivisionError, OverflowError):
        return
    try:
        assert value(text).value == expected
    except ExpressionError:
        assert text.count("(") + text.count("-") > MAX_NESTING or not math.isfinite(expected)


@settings(max_examples=200)
@given(st.text(alphabet="0123456789.e+-*/^() ,ndropvfsincoaxt$°%'", max_size=60))
def test_any_text_is_computed_or_refused(text: str) -> None:
    with contextlib.suppress(ExpressionError):
        assert math.isfinite(value(text).value)


def test_every_function_is_covered_by_the_tests_above() -> None:
    assert len(FUNCTIONS) == 21


def with_parameters(parameters: str, line: str) -> str:
    return (
        f"physsim: 1\nparameters: {parameters}\nsimulation: {{duration: 1 s, timestep: 1 ms}}\n"
        f"bodies:\n  ball:\n    shape: {{type: sphere, radius: 5 cm}}\n    material: steel\n    {line}\n"
    )


def test_parameters_refer_to_each_other_in_any_order() -> None:
    scene = load_scene_text(
        with_parameters('{a: "${2*b}", b: "${c + 1 cm}", c: 4 cm}', "position: [0, 0, '${a}']")
    )
    assert scene.spec.bodies["ball"].position == (0.0, 0.0, 0.1)
    assert scene.spec.parameters == {"a": 0.1, "b": 0.05, "c": 0.04}


def test_a_plain_result_may_be_given_a_unit() -> None:
    scene = load_scene_text(with_parameters("{n: 3}", "position: [0, 0, '${2*n} cm']"))
    assert scene.spec.bodies["ball"].position[2] == 0.06


def test_an_arc_over_a_radius_is_an_angle_but_hertz_is_no_angular_speed(
    headlines: Callable[[str], list[str]],
) -> None:
    good = with_parameters("{v: 3 m/s, r: 5 cm, f: 5 Hz}", "angular_velocity: ['${v/r}', '${2*pi*f}', 0]")
    assert load_scene_text(good).spec.bodies["ball"].angular_velocity[:2] == pytest.approx((60, 10 * math.pi))
    assert headlines(with_parameters("{f: 5 Hz}", "angular_velocity: ['${f}', 0, 0]"))[0].startswith(
        "s.yaml:8:24: bodies.ball.angular_velocity[0]: must be an angular speed, not a value in 1/s"
    )


def test_a_parameter_wins_over_a_constant() -> None:
    scene = load_scene_text(with_parameters("{pi: 3 kg}", "mass: '${pi}'"))
    assert scene.spec.bodies["ball"].mass == 3.0


@pytest.mark.parametrize(
    ("parameters", "line", "expected"),
    [
        (
            '{a: "${b}", b: "${c}", c: "${a}"}',
            "mass: ${a}",
            ["s.yaml:2:17: parameters.a: refers to itself: a -> b -> c -> a, got ${b}"],
        ),
        (
            '{a: "${a}", b: "${a}"}',
            "mass: ${b}",
            ["s.yaml:2:17: parameters.a: refers to itself: a -> a, got ${a}"],
        ),
        (
            "{a: 5 cubits}",
            "mass: ${a}",
            ["s.yaml:2:17: parameters.a: has the unknown unit 'cubits', got 5 cubits"],
        ),
        (
            "{a: [1]}",
            "mass: ${a}",
            ["s.yaml:2:17: parameters.a: must be a number, got [1]"],
        ),
        (
            "{a: 1 m}",
            "position: [0, 0, '${a} cm']",
            [
                "s.yaml:8:22: bodies.ball.position[2]: gives the unit cm to an expression "
                "that is in m already, got ${a} cm "
                "(allowed: a length in m (or mm, cm, km, in, ft))"
            ],
        ),
        (
            "{a: 1 m}",
            "position: [0, 0, '3 * ${a}']",
            [
                "s.yaml:8:22: bodies.ball.position[2]: must be one ${...}, alone or with a unit behind it, "
                "got 3 * ${a}; put all of the arithmetic inside ${...} "
                "(allowed: a length in m (or mm, cm, km, in, ft))"
            ],
        ),
    ],
)
def test_a_wrong_parameter_is_told_once_and_where_it_stands(
    parameters: str, line: str, expected: list[str], headlines: Callable[[str], list[str]]
) -> None:
    assert headlines(with_parameters(parameters, line)) == expected


def test_a_long_chain_of_parameters_is_refused(headlines: Callable[[str], list[str]]) -> None:
    chain = ", ".join(f'p{i}: "${{p{i + 1}}}"' for i in range(200))
    told = headlines(with_parameters(f"{{{chain}, p200: 1}}", "mass: ${p0}"))
    assert len(told) == 1
    assert told[0].endswith("refers through more than 50 parameters, got ${p1}")


def test_a_parameter_that_nothing_uses_is_a_warning() -> None:
    told = []
    scene = load_scene_text(with_parameters("{a: 1, b: '${a}'}", "mass: 1"), warn=told.append)
    assert [(p.path, p.message, p.line, p.column) for p in told] == [
        (("parameters", "b"), "is used nowhere in the scene", 2, 23)
    ]
    assert scene.warnings == tuple(told)


def test_spec_holds_numbers_not_expressions(ball: Callable[[str], Scene]) -> None:
    assert ball("mass: ${1 + 1} g").spec.bodies["ball"].mass == 0.002
