"""Metrics that are computed from other metrics: which names an expression uses, and its value."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from physsim.scene.expressions import CONSTANTS, evaluate, function_of
from physsim.scene.grammar import ExpressionError, Parser, tokens_of
from physsim.scene.suggest import did_you_mean
from physsim.scene.units import Measure


def check_expression(text: str, known: Iterable[str]) -> None:
    """Raises ExpressionError when the text is no expression of the known names."""
    Parser(tokens_of(text), _Names(tuple(known))).whole()


def value_of(text: str, values: Mapping[str, float]) -> float:
    """The value of an expression, all names being plain numbers; not a number where it has no value."""
    if any(not math.isfinite(value) for value in values.values()):
        values = {name: value for name, value in values.items() if math.isfinite(value)}
    try:
        return evaluate(text, lambda name: Measure(values[name]) if name in values else None).measure.value
    except ExpressionError:
        return math.nan


class _Names:
    """An algebra that computes nothing: names and functions are looked up, and that is all."""

    def __init__(self, known: tuple[str, ...]) -> None:
        self._known = known

    def number(self, value: Measure) -> None:
        """Any number will do."""

    def named(self, name: str) -> None:
        if name not in self._known and name not in CONSTANTS:
            hint = did_you_mean(name, self._known)
            raise ExpressionError(f"uses '{name}', which is no metric above this one and no parameter", hint)

    def add(self, a: None, b: None, sign: float) -> None:
        """Any sum will do."""

    def multiply(self, a: None, b: None, power: int) -> None:
        """Any product will do."""

    def negate(self, a: None) -> None:
        """Anything has a negative."""

    def power(self, base: None, exponent: None) -> None:
        """Any power will do."""

    def call(self, name: str, arguments: list[None]) -> None:
        function_of(name, len(arguments))
