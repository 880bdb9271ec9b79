"""The grammar of arithmetic in scenes, read by the small parser below, never by `eval`.

Loosest first (`^` and `**` are the same, bind to the right, and stand above a sign: -2^2 = -4):

    sum     = product { ("+" | "-") product }
    product = sign { ("*" | "/") sign }
    sign    = ("+" | "-") sign | power
    power   = atom [ ("^" | "**") sign ]
    atom    = NUMBER [UNIT] | NAME | NAME "(" sum { "," sum } ")" | "(" sum ")"

UNIT is one unit name (`10 cm`, `30 deg`); compound units are written as arithmetic: `3 m / (1 s)`. What a sum
or a product *is* says the algebra that reads along: numbers with dimensions (`expressions`) or a program
(`program`). Every stage is bounded: text 500 characters, nesting 40.
"""

from __future__ import annotations

import math
import re
from typing import Generic, Protocol, TypeVar

from physsim.scene.units import Measure, UnitError, parse_unit

MAX_LENGTH = 500
MAX_NESTING = 40
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d]\w*|[°%])|(?P<sign>\*\*|[-+*/^(),]))"
)
V = TypeVar("V")


class ExpressionError(ValueError):
    """The expression cannot be read or computed; `hint` names the likely slip."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


class Algebra(Protocol[V]):
    """What the parts of an expression become; each raises ExpressionError for what has no meaning."""

    def number(self, value: Measure) -> V:
        """A number as it stands in the text, with its unit."""

    def named(self, name: str) -> V:
        """A parameter, a constant or a variable."""

    def add(self, a: V, b: V, sign: float) -> V:
        """a + b for sign 1, a - b for sign -1."""

    def multiply(self, a: V, b: V, power: int) -> V:
        """a * b for power 1, a / b for power -1."""

    def negate(self, a: V) -> V:
        """-a."""

    def power(self, base: V, exponent: V) -> V:
        """base ** exponent."""

    def call(self, name: str, arguments: list[V]) -> V:
        """A function of at least one argument."""


def tokens_of(text: str) -> list[tuple[str, str]]:
    """The expression in pieces: (number, name or sign, text). Raises ExpressionError."""
    if len(text) > MAX_LENGTH:
        raise ExpressionError(f"is too long for an expression (at most {MAX_LENGTH} characters)")
    tokens, at, end = [], 0, len(text.rstrip())
    while at < end:
        match = _TOKEN.match(text, at)
        if not match:
            raise ExpressionError(f"cannot be read at '{text[at:].strip()[:20]}'")
        tokens.append((str(match.lastgroup), match[0].strip()))
        at = match.end()
    return tokens


class Parser(Generic[V]):
    """Recursive descent; one method per line of the grammar."""

    def __init__(self, tokens: list[tuple[str, str]], algebra: Algebra[V]) -> None:
        self.tokens = tokens
        self.at = 0
        self.algebra = algebra

    def whole(self) -> V:
        """All of the expression. Raises ExpressionError."""
        value = self.sum(0)
        if self.kind() is not None:
            raise ExpressionError(f"has '{self.take()}' where an operator was expected")
        return value

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

    def sum(self, depth: int) -> V:
        total = self.product(depth)
        while self.kind() in ("+", "-"):
            sign = 1.0 if self.take() == "+" else -1.0
            total = self.algebra.add(total, self.product(depth), sign)
        return total

    def product(self, depth: int) -> V:
        total = self.sign(depth)
        while self.kind() in ("*", "/"):
            power = 1 if self.take() == "*" else -1
            total = self.algebra.multiply(total, self.sign(depth), power)
        return total

    def sign(self, depth: int) -> V:
        if depth > MAX_NESTING:
            raise ExpressionError(f"is nested deeper than {MAX_NESTING}")
        if self.kind() not in ("+", "-"):
            return self.power(depth)
        negative = self.take() == "-"
        inner = self.sign(depth + 1)
        return self.algebra.negate(inner) if negative else inner

    def power(self, depth: int) -> V:
        base = self.atom(depth)
        if self.kind() not in ("^", "**"):
            return base
        self.take()
        return self.algebra.power(base, self.sign(depth + 1))

    def atom(self, depth: int) -> V:
        kind, token = self.kind(), self.take()
        if kind == "number":
            return self.algebra.number(self.number(token))
        if kind == "name":
            return self.call(token, depth) if self.kind() == "(" else self.algebra.named(token)
        if kind == "(":
            inner = self.sum(depth + 1)
            self.close()
            return inner
        raise ExpressionError(f"has '{token}' where a number or a name was expected")

    def number(self, token: str) -> Measure:
        unit = self.take() if self.kind() == "name" else None
        if unit is None:
            return _finite(Measure(float(token)))
        try:
            parsed = parse_unit(unit)
        except UnitError as error:
            raise ExpressionError(str(error), error.hint) from None
        return _finite(Measure(parsed.in_si(float(token)), parsed.dimension))

    def call(self, name: str, depth: int) -> V:
        self.take()
        arguments = [self.sum(depth + 1)]
        while self.kind() == ",":
            self.take()
            arguments.append(self.sum(depth + 1))
        self.close()
        return self.algebra.call(name, arguments)

    def close(self) -> None:
        if self.kind() != ")":
            raise ExpressionError("has an open parenthesis")
        self.take()


def _finite(number: Measure) -> Measure:
    if not math.isfinite(number.value):
        raise ExpressionError("gives a number that is not finite")
    return number
