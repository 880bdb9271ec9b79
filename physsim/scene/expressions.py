"""Arithmetic in scenes: `${2*drop + 10 cm}`. Read by the small parser below, never by `eval`.

Grammar, loosest first (`^` and `**` are the same, bind to the right, and stand above a sign: -2^2 = -4):

    sum     = product { ("+" | "-") product }
    product = sign { ("*" | "/") sign }
    sign    = ("+" | "-") sign | power
    power   = atom [ ("^" | "**") sign ]
    atom    = NUMBER [UNIT] | NAME | NAME "(" sum { "," sum } ")" | "(" sum ")"

NAME is a parameter of the scene or a constant (`pi`, `tau`); a parameter of the same name wins. UNIT is one
unit name (`10 cm`, `30 deg`); compound units are written as arithmetic: `${3 m / (1 s)}`.

Dimensions are carried along: `${drop}` for a mass is refused when `drop` is a length. A number without a unit
takes the dimension that it meets, in SI, as everywhere in a scene: `${drop + 0.1}` adds 0.1 m. Radians count
as plain numbers inside arithmetic, so that `${v / r}` is an angular speed. A single name, `${drop}`, stands
for the parameter exactly as it was written. Numbers are floats and every stage is bounded: text 500
characters, nesting 40.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass

from physsim.scene.suggest import did_you_mean
from physsim.scene.units import (
    PLAIN,
    Dimension,
    Measure,
    UnitError,
    dimension_text,
    multiply,
    parse_unit,
    same,
    without_angle,
)

MAX_LENGTH = 500
MAX_NESTING = 40
CONSTANTS = {"pi": Measure(math.pi), "tau": Measure(math.tau)}
_ANGLE: Dimension = (0.0, 0.0, 0.0, 1.0)
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d]\w*|[°%])|(?P<sign>\*\*|[-+*/^(),]))"
)


class ExpressionError(ValueError):
    """The expression cannot be read or computed; `hint` names the likely slip."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


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
    if len(text) > MAX_LENGTH:
        raise ExpressionError(f"is too long for an expression (at most {MAX_LENGTH} characters)")
    tokens = _tokens(text)
    parser = _Parser(tokens, lookup)
    measure = parser.sum(0)
    if parser.kind() is not None:
        raise ExpressionError(f"has '{parser.take()}' where an operator was expected")
    return Result(measure, len(tokens) == 1 and tokens[0][0] == "name")


def _tokens(text: str) -> list[tuple[str, str]]:
    tokens, at, end = [], 0, len(text.rstrip())
    while at < end:
        match = _TOKEN.match(text, at)
        if not match:
            raise ExpressionError(f"cannot be read at '{text[at:].strip()[:20]}'")
        tokens.append((str(match.lastgroup), match[0].strip()))
        at = match.end()
    return tokens


class _Parser:
    """Recursive descent that computes as it reads; one method per line of the grammar."""

    def __init__(self, tokens: list[tuple[str, str]], lookup: Lookup) -> None:
        self.tokens = tokens
        self.at = 0
        self.lookup = lookup

    def kind(self) -> str | None:
        """number, name, the sign itself, or None at the end."""
        if self.at >= len(self.tokens):
            return None
        kind, text = self.tokens[self.at]
        return text if kind == "sign" else kind

    def take(self) -> str:
        """The next token, which is passed."""
        if self.at >= len(self.tokens):
            raise ExpressionError("ends too early")
        self.at += 1
        return self.tokens[self.at - 1][1]

    def sum(self, depth: int) -> Measure:
        total = self.product(depth)
        while self.kind() in ("+", "-"):
            sign = 1.0 if self.take() == "+" else -1.0
            term = self.product(depth)
            total = _finite(total.value + sign * term.value, _common(total, term))
        return total

    def product(self, depth: int) -> Measure:
        total = self.sign(depth)
        while self.kind() in ("*", "/"):
            power = 1 if self.take() == "*" else -1
            total = _times(total, self.sign(depth), power)
        return total

    def sign(self, depth: int) -> Measure:
        if depth > MAX_NESTING:
            raise ExpressionError(f"is nested deeper than {MAX_NESTING}")
        if self.kind() not in ("+", "-"):
            return self.power(depth)
        factor = -1.0 if self.take() == "-" else 1.0
        inner = self.sign(depth + 1)
        return Measure(factor * inner.value, inner.dimension)

    def power(self, depth: int) -> Measure:
        base = self.atom(depth)
        if self.kind() not in ("^", "**"):
            return base
        self.take()
        exponent = _plain(self.sign(depth + 1), "an exponent")
        return _finite(_real_power(base.value, exponent), multiply(PLAIN, base.dimension, exponent))

    def atom(self, depth: int) -> Measure:
        kind, token = self.kind(), self.take()
        if kind == "number":
            return self.number(token)
        if kind == "name":
            return self.call(token, depth) if self.kind() == "(" else self.named(token)
        if kind == "(":
            inner = self.sum(depth + 1)
            self.close()
            return inner
        raise ExpressionError(f"has '{token}' where a number or a name was expected")

    def number(self, token: str) -> Measure:
        unit = self.take() if self.kind() == "name" else None
        if unit is None:
            return _finite(float(token), PLAIN)
        try:
            parsed = parse_unit(unit)
        except UnitError as error:
            raise ExpressionError(str(error), error.hint) from None
        return _finite(parsed.in_si(float(token)), parsed.dimension)

    def named(self, name: str) -> Measure:
        value = self.lookup(name)
        if value is None:
            value = CONSTANTS.get(name)
        if value is None:
            hint = f"'{name}' is a function: write {name}(...)" if name in FUNCTIONS else None
            raise ExpressionError(f"uses '{name}', which is no parameter of this scene", hint)
        return value

    def call(self, name: str, depth: int) -> Measure:
        arguments = self.arguments(depth)
        if name not in FUNCTIONS:
            raise ExpressionError(f"uses the unknown function '{name}'", did_you_mean(name, FUNCTIONS))
        function = FUNCTIONS[name]
        if not function.fewest <= len(arguments) <= function.most:
            raise ExpressionError(
                f"gives {len(arguments)} argument(s) to {name}, which takes {function.takes()}"
            )
        try:
            return function.apply(arguments)
        except (ValueError, OverflowError, ZeroDivisionError) as error:
            if isinstance(error, ExpressionError):
                raise
            raise ExpressionError(f"asks {name} for a value that does not exist") from None

    def arguments(self, depth: int) -> list[Measure]:
        self.take()
        found = [self.sum(depth + 1)]
        while self.kind() == ",":
            self.take()
            found.append(self.sum(depth + 1))
        self.close()
        return found

    def close(self) -> None:
        if self.kind() != ")":
            raise ExpressionError("has an open parenthesis")
        self.take()


def _finite(value: float, dimension: Dimension) -> Measure:
    if not math.isfinite(value):
        raise ExpressionError("gives a number that is not finite")
    return Measure(value, dimension)


def _common(a: Measure, b: Measure) -> Dimension:
    """The dimension of a sum; a plain number takes the other's."""
    if same(without_angle(a.dimension), without_angle(b.dimension)) or same(b.dimension, PLAIN):
        return a.dimension if not same(a.dimension, PLAIN) else b.dimension
    if same(a.dimension, PLAIN):
        return b.dimension
    raise ExpressionError(f"mixes {dimension_text(a.dimension)} with {dimension_text(b.dimension)}")


def _times(a: Measure, b: Measure, power: int) -> Measure:
    if power < 0 and b.value == 0:
        raise ExpressionError("divides by zero")
    value = a.value * b.value if power > 0 else a.value / b.value
    return _finite(value, multiply(a.dimension, b.dimension, power))


def _plain(value: Measure, what: str) -> float:
    if not same(without_angle(value.dimension), PLAIN):
        raise ExpressionError(f"has {dimension_text(value.dimension)} in {what}, which takes a plain number")
    return value.value


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
    """A function of scenes: how many arguments it takes and what it does with values and dimensions."""

    fewest: int
    most: int
    apply: Callable[[list[Measure]], Measure]

    def takes(self) -> str:
        """`1`, `2` or `at least 1`, for messages."""
        return str(self.fewest) if self.fewest == self.most else f"at least {self.fewest}"


def _pure(function: Callable[[float], float], result: Dimension = PLAIN) -> Function:
    """A function of one plain number (an angle counts as one)."""
    return Function(1, 1, lambda given: _finite(function(_plain(given[0], "a function")), result))


def _keeping(function: Callable[[float], float]) -> Function:
    """A function that keeps the dimension of its argument."""
    return Function(1, 1, lambda given: _finite(function(given[0].value), given[0].dimension))


def _shared(given: list[Measure]) -> Dimension:
    total = given[0]
    for value in given[1:]:
        total = Measure(0.0, _common(total, value))
    return total.dimension


def _among(function: Callable[[list[float]], float]) -> Function:
    """A function of values of one dimension that gives a value of that dimension."""
    return Function(1, 64, lambda given: _finite(function([v.value for v in given]), _shared(given)))


def _root(given: list[Measure]) -> Measure:
    return _finite(math.sqrt(given[0].value), multiply(PLAIN, given[0].dimension, 0.5))


def _atan2(given: list[Measure]) -> Measure:
    _shared(given)
    return Measure(math.atan2(given[0].value, given[1].value), _ANGLE)


FUNCTIONS: dict[str, Function] = {
    "sin": _pure(math.sin),
    "cos": _pure(math.cos),
    "tan": _pure(math.tan),
    "asin": _pure(math.asin, _ANGLE),
    "acos": _pure(math.acos, _ANGLE),
    "atan": _pure(math.atan, _ANGLE),
    "atan2": Function(2, 2, _atan2),
    "sinh": _pure(math.sinh),
    "cosh": _pure(math.cosh),
    "tanh": _pure(math.tanh),
    "exp": _pure(math.exp),
    "log": _pure(math.log),
    "log10": _pure(math.log10),
    "sqrt": Function(1, 1, _root),
    "abs": _keeping(abs),
    "hypot": _among(lambda values: math.hypot(*values)),
    "min": _among(min),
    "max": _among(max),
    "floor": _pure(lambda value: float(math.floor(value))),
    "ceil": _pure(lambda value: float(math.ceil(value))),
    "round": _pure(lambda value: float(round(value))),
}
