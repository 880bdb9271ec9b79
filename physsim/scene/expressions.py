"""Arithmetic in scenes: `${2*drop + 10 cm}`, in the grammar of `grammar`.

A NAME is a parameter of the scene or a constant (`pi`, `tau`); a parameter of the same name wins. Dimensions
are carried along: `${drop}` for a mass is refused when `drop` is a length. A number without a unit takes the
dimension that it meets, in SI, as everywhere in a scene: `${drop + 0.1}` adds 0.1 m. Radians count as plain
numbers inside arithmetic, so that `${v / r}` is an angular speed. A single name, `${drop}`, stands for the
parameter exactly as it was written. Numbers are floats.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from physsim.scene.grammar import ExpressionError, Parser, tokens_of
from physsim.scene.suggest import did_you_mean
from physsim.scene.units import (
    PLAIN,
    Dimension,
    Measure,
    dimension_text,
    multiply,
    same,
    without_angle,
)

CONSTANTS = {"pi": Measure(math.pi), "tau": Measure(math.tau)}
_ANGLE: Dimension = (0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True)
class Result:
    """What an expression gives; `as_written` when it is a single name, which stands for its parameter."""

    measure: Measure
    as_written: bool


Lookup = Callable[[str], Measure | None]
"""Gives the value of a parameter, None when there is none of that name."""


def evaluate(text: str, lookup: Lookup) -> Result:
    """Compute the expression `text` (what stands between `${` and `}`).

    lookup: gives the value of a parameter, None when there is no such parameter.
    Raises ExpressionError for anything that is not the arithmetic described above, or not finite.
    """
    tokens = tokens_of(text)
    measure = Parser(tokens, Arithmetic(lookup)).whole()
    return Result(measure, len(tokens) == 1 and tokens[0][0] == "name")


class Arithmetic:
    """The algebra of numbers with dimensions: every part is computed as it is read."""

    def __init__(self, lookup: Lookup) -> None:
        self._lookup = lookup

    def number(self, value: Measure) -> Measure:
        return value

    def named(self, name: str) -> Measure:
        value = self._lookup(name)
        if value is None:
            value = CONSTANTS.get(name)
        if value is None:
            hint = f"'{name}' is a function: write {name}(...)" if name in FUNCTIONS else None
            raise ExpressionError(f"uses '{name}', which is no parameter of this scene", hint)
        return value

    def add(self, a: Measure, b: Measure, sign: float) -> Measure:
        return _finite(a.value + sign * b.value, common_dimension(a.dimension, b.dimension))

    def multiply(self, a: Measure, b: Measure, power: int) -> Measure:
        if power < 0 and b.value == 0:
            raise ExpressionError("divides by zero")
        value = a.value * b.value if power > 0 else a.value / b.value
        return _finite(value, multiply(a.dimension, b.dimension, power))

    def negate(self, a: Measure) -> Measure:
        return Measure(-a.value, a.dimension)

    def power(self, base: Measure, exponent: Measure) -> Measure:
        number = _plain(exponent, "an exponent")
        return _finite(_real_power(base.value, number), multiply(PLAIN, base.dimension, number))

    def call(self, name: str, arguments: list[Measure]) -> Measure:
        function = function_of(name, len(arguments))
        try:
            return function.apply(arguments)
        except (ValueError, OverflowError, ZeroDivisionError) as error:
            if isinstance(error, ExpressionError):
                raise
            raise ExpressionError(f"asks {name} for a value that does not exist") from None


def _finite(value: float, dimension: Dimension) -> Measure:
    if not math.isfinite(value):
        raise ExpressionError("gives a number that is not finite")
    return Measure(value, dimension)


def common_dimension(a: Dimension, b: Dimension) -> Dimension:
    """The dimension of a sum; a plain number takes the other's. Raises ExpressionError."""
    if same(without_angle(a), without_angle(b)) or same(b, PLAIN):
        return a if not same(a, PLAIN) else b
    if same(a, PLAIN):
        return b
    raise ExpressionError(f"mixes {dimension_text(a)} with {dimension_text(b)}")


def _plain(value: Measure, what: str) -> float:
    demand_plain(value.dimension, what)
    return value.value


def demand_plain(dimension: Dimension, what: str) -> None:
    """Raises ExpressionError for anything but a plain number or an angle."""
    if not same(without_angle(dimension), PLAIN):
        raise ExpressionError(f"has {dimension_text(dimension)} in {what}, which takes a plain number")


def _real_power(base: float, exponent: float) -> float:
    try:
        value = base**exponent
    except (OverflowError, ZeroDivisionError):
        value = math.inf
    if isinstance(value, complex):
        raise ExpressionError("takes a root of a negative number")
    return float(value)


@dataclass(frozen=True, slots=True)
class Function:
    """A function of scenes: how many arguments it takes, its value, and the dimension of that value."""

    fewest: int
    most: int
    value: Callable[..., float]
    dimension: Callable[[list[Dimension]], Dimension]

    def takes(self) -> str:
        """`1`, `2` or `at least 1`, for messages."""
        return str(self.fewest) if self.fewest == self.most else f"at least {self.fewest}"

    def apply(self, arguments: list[Measure]) -> Measure:
        """The value with its dimension. Raises what the mathematics raise, or ExpressionError."""
        dimension = self.dimension([argument.dimension for argument in arguments])
        return _finite(self.value(*(argument.value for argument in arguments)), dimension)


def function_of(name: str, arguments: int) -> Function:
    """The function of that name, which takes that many arguments. Raises ExpressionError."""
    if name not in FUNCTIONS:
        raise ExpressionError(f"uses the unknown function '{name}'", did_you_mean(name, FUNCTIONS))
    function = FUNCTIONS[name]
    if not function.fewest <= arguments <= function.most:
        raise ExpressionError(f"gives {arguments} argument(s) to {name}, which takes {function.takes()}")
    return function


def _common(given: list[Dimension]) -> Dimension:
    total = given[0]
    for dimension in given[1:]:
        total = common_dimension(total, dimension)
    return total


def _pure(function: Callable[[float], float], result: Dimension = PLAIN) -> Function:
    """A function of one plain number (an angle counts as one)."""

    def dimension(given: list[Dimension]) -> Dimension:
        demand_plain(given[0], "a function")
        return result

    return Function(1, 1, function, dimension)


def _among(function: Callable[..., float]) -> Function:
    """A function of values of one dimension that gives a value of that dimension."""
    return Function(1, 64, function, _common)


def _angle_between(given: list[Dimension]) -> Dimension:
    _common(given)
    return _ANGLE


FUNCTIONS: dict[str, Function] = {
    "sin": _pure(math.sin),
    "cos": _pure(math.cos),
    "tan": _pure(math.tan),
    "asin": _pure(math.asin, _ANGLE),
    "acos": _pure(math.acos, _ANGLE),
    "atan": _pure(math.atan, _ANGLE),
    "atan2": Function(2, 2, math.atan2, _angle_between),
    "sinh": _pure(math.sinh),
    "cosh": _pure(math.cosh),
    "tanh": _pure(math.tanh),
    "exp": _pure(math.exp),
    "log": _pure(math.log),
    "log10": _pure(math.log10),
    "sqrt": Function(1, 1, math.sqrt, lambda given: multiply(PLAIN, given[0], 0.5)),
    "abs": Function(1, 1, abs, _common),
    "hypot": _among(math.hypot),
    "min": _among(lambda *values: min(values)),
    "max": _among(lambda *values: max(values)),
    "floor": _pure(lambda value: float(math.floor(value))),
    "ceil": _pure(lambda value: float(math.ceil(value))),
    "round": _pure(lambda value: float(round(value))),
}
