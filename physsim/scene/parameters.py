"""The `parameters` of a scene: named numbers that may refer to each other, computed when first asked for."""

from __future__ import annotations

import re
from collections.abc import Mapping

from physsim.scene.expressions import Result, evaluate
from physsim.scene.grammar import ExpressionError
from physsim.scene.units import PLAIN, Measure, UnitError, dimension_text, parse_measure, parse_unit, same

NAME = re.compile(r"[^\W\d]\w{0,59}\Z")
MAX_CHAIN = 50
_EXPRESSION = re.compile(r"\s*\$\{(?P<inside>[^{}]*)\}(?P<unit>[^${}]*)\Z")


class BrokenParameter(ValueError):
    """A parameter that is used is wrong itself; that is told where it stands."""


class TangleError(ExpressionError):
    """Parameters refer to each other in a circle, or through too many others; told at the first of them."""

    def __init__(self, message: str, names: list[str]) -> None:
        super().__init__(message)
        self.names = names


class Parameters:
    """Values of parameters by name, and of every text that uses them."""

    def __init__(self, given: Mapping[str, object]) -> None:
        self._given = given
        self._known: dict[str, Measure] = {}
        self._broken: set[str] = set()
        self._asking: list[str] = []
        self._chain_told = False
        self.used: set[str] = set()

    def read(self, text: str) -> Result:
        """The value of `5 cm`, `${2*drop}` or `${count} cm`.

        Raises UnitError or ExpressionError for what cannot be read, BrokenParameter for a fault elsewhere.
        """
        if "${" not in text:
            return Result(parse_measure(text), as_written=True)
        match = _EXPRESSION.match(text)
        if not match:
            raise ExpressionError(
                "must be one ${...}, alone or with a unit behind it",
                "put all of the arithmetic inside ${...}",
            )
        result = evaluate(match["inside"], self.find)
        return self._with_unit(result, match["unit"].strip())

    def _with_unit(self, result: Result, unit: str) -> Result:
        """`${count} cm`: only a plain number can be given a unit."""
        if not unit:
            return result
        if not same(result.measure.dimension, PLAIN):
            had = dimension_text(result.measure.dimension)
            raise ExpressionError(f"gives the unit {unit} to an expression that is in {had} already")
        parsed = parse_unit(unit)
        return Result(Measure(parsed.in_si(result.measure.value), parsed.dimension), as_written=True)

    def find(self, name: str) -> Measure | None:
        """The value of a parameter, None when there is none of that name. Raises BrokenParameter."""
        if name not in self._given:
            return None
        self.used.add(name)
        if name in self._known:
            return self._known[name]
        if name in self._broken:
            raise BrokenParameter(name)
        return self._compute(name)

    def _compute(self, name: str) -> Measure:
        try:
            self._known[name] = self.value(name)
        except (UnitError, ExpressionError, BrokenParameter) as error:
            self._broken.add(name)
            if isinstance(error, TangleError) and self._asking:
                raise
            raise BrokenParameter(name) from None
        return self._known[name]

    def value(self, name: str) -> Measure:
        """The parameter's own value. Raises like `read`; ExpressionError when it refers to itself."""
        if name in self._asking:
            circle = [*self._asking[self._asking.index(name) :], name]
            raise TangleError(f"refers to itself: {' -> '.join(circle[:8])}", circle)
        if len(self._asking) >= MAX_CHAIN:
            raise self._chained()
        self._asking.append(name)
        try:
            return measured(self._given[name], self).measure
        except TangleError as error:
            if name not in error.names:
                raise BrokenParameter(name) from None
            raise
        finally:
            self._asking.pop()

    def _chained(self) -> Exception:
        """The trouble of a chain that is too long, told once and not again for every part of it."""
        if self._chain_told:
            return BrokenParameter(self._asking[0])
        self._chain_told = True
        return TangleError(f"refers through more than {MAX_CHAIN} parameters", list(self._asking))


def measured(value: object, parameters: Parameters) -> Result:
    """A number or text as a measure. Raises UnitError, ExpressionError or BrokenParameter."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise UnitError("must be a number")
    if isinstance(value, str):
        return parameters.read(value)
    return Result(Measure(float(value)), as_written=True)
