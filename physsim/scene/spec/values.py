"""Numbers, vectors, words and switches as they stand in scenes; each checks itself and describes itself in
the schema.

Used as annotations: `radius: Annotated[float, Number(LENGTH, above=0)]`. A value is a bare number (SI), a
number with its unit (`5 cm`) or an expression (`${2*drop}`); after validation it is a float in SI.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, ValidationInfo
from pydantic_core import core_schema

from physsim.scene.expressions import Result
from physsim.scene.grammar import ExpressionError
from physsim.scene.parameters import BrokenParameter, measured
from physsim.scene.spec import kinds
from physsim.scene.spec.kinds import Kind
from physsim.scene.spec.reader import ContextReader, Reader, Schema
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.slip import silent, slip
from physsim.scene.units import PLAIN, UnitError, dimension_text, fits, same, without_angle

_NUMBER_PATTERN = r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?"
_EXPRESSION_PATTERN = r"\s*\$\{[^{}]*\}"


@dataclass(frozen=True)
class Bounds:
    """The range of a number: above and below are excluded, at_least and at_most included."""

    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None

    def broken(self, value: float, unit: str = "") -> str | None:
        """What the value should have been, None when it is within bounds."""
        if self.above is not None and not value > self.above:
            return f"must be greater than {_told(self.above, unit)}"
        if self.at_least is not None and not value >= self.at_least:
            return f"must be at least {_told(self.at_least, unit)}"
        if self.below is not None and not value < self.below:
            return f"must be less than {_told(self.below, unit)}"
        if self.at_most is not None and not value <= self.at_most:
            return f"must be at most {_told(self.at_most, unit)}"
        return None

    def told(self) -> str:
        """The bounds in words; nothing when there are none."""
        names = ("above", "at least", "below", "at most")
        values = (self.above, self.at_least, self.below, self.at_most)
        return " ".join(
            f"{name} {value:g}" for name, value in zip(names, values, strict=True) if value is not None
        )

    def schema(self) -> Schema:
        """The bounds in JSON Schema."""
        names = ("exclusiveMinimum", "minimum", "exclusiveMaximum", "maximum")
        values = (self.above, self.at_least, self.below, self.at_most)
        return {name: value for name, value in zip(names, values, strict=True) if value is not None}


@dataclass(frozen=True)
class Number(ContextReader):
    """A physical value of one kind within bounds."""

    kind: Kind = kinds.NUMBER
    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None

    @property
    def bounds(self) -> Bounds:
        """The bounds, in SI."""
        return Bounds(self.above, self.at_least, self.below, self.at_most)

    def schema(self) -> Schema:
        return number_schema(self.kind, self.bounds)

    def read(self, value: object, info: ValidationInfo) -> float:
        """The value in SI."""
        if isinstance(value, int | float) and not isinstance(value, bool):
            return within(float(value), self.bounds, self.kind)
        return within(in_kind(measure(value, info, self.kind), self.kind), self.bounds, self.kind)


def measure(value: object, info: ValidationInfo, kind: Kind) -> Result:
    """The value with its dimension; anything that is none is refused, naming what is wanted."""
    parameters = reading_of(info).parameters
    try:
        return measured(value, parameters)
    except BrokenParameter:
        raise silent() from None
    except (UnitError, ExpressionError) as error:
        raise slip(str(error), allowed=kind.wanted(), hint=error.hint) from None


def in_kind(result: Result, kind: Kind) -> float:
    """The SI value, when its dimension is that of the kind or none at all (a bare number is SI)."""
    given, wanted = result.measure.dimension, kind.dimension
    angle_free = not result.as_written and same(without_angle(given), without_angle(wanted))
    if kind.any_unit or same(given, PLAIN) or fits(given, wanted) or angle_free:
        return result.measure.value
    raise slip(f"must be {kind.name}, not a value in {dimension_text(given)}", allowed=kind.wanted())


def within(number: float, bounds: Bounds, kind: Kind) -> float:
    """The number itself when it is finite, within its bounds and of a magnitude that makes sense."""
    if not math.isfinite(number):
        raise slip("must be finite")
    trouble = bounds.broken(number, kind.unit)
    if trouble is None and abs(number) > kind.largest:
        trouble = f"must not exceed {_told(kind.largest, kind.unit)}"
    if trouble is None and bounds.above == 0 and number < kind.smallest:
        trouble = f"must be at least {_told(kind.smallest, kind.unit)}"
    if trouble is not None:
        raise slip(trouble)
    return number


def _told(bound: float, unit: str) -> str:
    """A bound for messages; zero is told without a unit."""
    return f"{bound:g} {unit}".rstrip() if bound else "0"


def number_schema(kind: Kind, bounds: Bounds) -> Schema:
    """A number, or text with a unit or an expression."""
    unit = r"\s*[A-Za-zµμ°%(1].*" if kind.unit or kind.any_unit else r"\s*%?"
    text = {
        "type": "string",
        "pattern": f"^({_NUMBER_PATTERN}({unit})?|{_EXPRESSION_PATTERN}.*)\\s*$",
        "description": f"{kind.wanted()}, or an expression in ${{...}}",
    }
    title = " ".join([kind.name.partition(" ")[2], bounds.told()]).strip()
    return {"title": title, "anyOf": [{"type": "number", **bounds.schema()}, text]}


@dataclass(frozen=True)
class Whole(ContextReader):
    """A whole number within bounds (included); an expression may give it."""

    at_least: int
    at_most: int

    def schema(self) -> Schema:
        whole = {"type": "integer", "minimum": self.at_least, "maximum": self.at_most}
        return {
            "title": f"whole number {self.at_least} to {self.at_most}",
            "anyOf": [
                whole,
                {"type": "string", "pattern": f"^({_NUMBER_PATTERN}|{_EXPRESSION_PATTERN})\\s*$"},
            ],
        }

    def read(self, value: object, info: ValidationInfo) -> int:
        """The value as an int; a float is taken when it is whole."""
        number = in_kind(measure(value, info, kinds.NUMBER), kinds.NUMBER)
        if not math.isfinite(number) or number != round(number):
            raise slip("must be a whole number")
        bounds = Bounds(at_least=self.at_least, at_most=self.at_most)
        trouble = bounds.broken(number)
        if trouble:
            raise slip(trouble)
        return value if type(value) is int else round(number)


def _switch(value: object) -> bool:
    if isinstance(value, bool):
        return value
    hint = {"yes": "write true", "on": "write true", "no": "write false", "off": "write false"}
    raise slip("must be true or false", hint=hint.get(str(value).lower()))


class _SwitchType(Reader):
    def schema(self) -> Schema:
        return {"type": "boolean"}

    def read(self, value: object) -> bool:
        return _switch(value)


@dataclass(frozen=True)
class Text(Reader):
    """A text of bounded length on one line; `empty` tells whether it may be empty."""

    longest: int = 200
    empty: bool = False

    def schema(self) -> Schema:
        return {"type": "string", "maxLength": self.longest, **({} if self.empty else {"minLength": 1})}

    def read(self, value: object) -> str:
        """The text itself."""
        if not isinstance(value, str):
            raise slip("must be text", hint=f'put it in quotes: "{str(value)[:40]}"')
        if not value and not self.empty:
            raise slip("must not be empty")
        if len(value) > self.longest:
            raise slip(f"must be at most {self.longest} characters long")
        if any(not (c.isprintable() or c == " ") for c in value):
            raise slip("must be on one line, without control characters")
        return value


class Direction:
    """A vector that is brought to length 1; only its direction counts. Zero is refused."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_after_validator_function(normalized, handler(source))


class NonZero:
    """A number of either sign that is not 0."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_after_validator_function(_not_zero, handler(source))

    def __get_pydantic_json_schema__(
        self, core: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> Schema:
        return {**handler(core), "not": {"const": 0}}


def _not_zero(number: float) -> float:
    if number == 0:
        raise slip("must not be 0")
    return number


def normalized(vector: tuple[float, ...]) -> tuple[float, ...]:
    """The vector at length 1; left alone when it has that length, so that reading twice changes nothing."""
    largest = max(abs(component) for component in vector)
    if largest == 0:
        raise slip("must not be zero: it gives a direction")
    scaled = [component / largest for component in vector]
    length = math.hypot(*scaled)
    if abs(length * largest - 1) < 1e-12:
        return vector
    return tuple(component / length for component in scaled)


Switch = Annotated[bool, _SwitchType()]
PlainNumber = Annotated[float, Number()]
Length = Annotated[float, Number(kinds.LENGTH)]
Size = Annotated[float, Number(kinds.LENGTH, above=0)]
Angle = Annotated[float, Number(kinds.ANGLE)]
Time = Annotated[float, Number(kinds.TIME, at_least=0)]
Speed = Annotated[float, Number(kinds.SPEED)]
AngularSpeed = Annotated[float, Number(kinds.ANGULAR_SPEED)]
Acceleration = Annotated[float, Number(kinds.ACCELERATION)]
Force = Annotated[float, Number(kinds.FORCE)]
Torque = Annotated[float, Number(kinds.TORQUE)]
Stiffness = Annotated[float, Number(kinds.STIFFNESS, at_least=0)]
TurningStiffness = Annotated[float, Number(kinds.TURNING_STIFFNESS, at_least=0)]
Position = tuple[Length, Length, Length]
PlainVector = tuple[PlainNumber, PlainNumber, PlainNumber]
UnitVector = Annotated[PlainVector, Direction()]
"""A direction: three plain numbers, not all zero, brought to length 1."""
