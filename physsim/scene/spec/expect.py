"""Expectations: what must hold after the run, e.g. where a body has come to rest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import (
    Field,
    PrivateAttr,
    ValidationInfo,
    model_validator,
)

from physsim.scene.quantity import Quantity, QuantityError, parse_quantity
from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.reader import ContextReader, Schema
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Bounds, Number, Text, in_kind, measure, number_schema, within

END = "end"


@dataclass(frozen=True)
class QuantityText(Text):
    """The name of a quantity that is one number per frame."""

    def read(self, value: object) -> str:
        """The name itself."""
        text = super().read(value)
        try:
            quantity = parse_quantity(text)
        except QuantityError as error:
            raise slip(str(error), allowed=error.allowed, hint=error.hint) from None
        if not quantity.is_scalar:
            parts = ", ".join(f"{text}.{component}" for component in quantity.components)
            raise slip("names a vector, an expectation needs one number", allowed=parts)
        return text


@dataclass(frozen=True)
class OfQuantity(ContextReader):
    """A number in the unit of the entry's `quantity`, which stands before it in the model."""

    at_least: float | None = None

    def schema(self) -> Schema:
        return number_schema(kinds.ANYTHING, Bounds(at_least=self.at_least))

    def read(self, value: object, info: ValidationInfo) -> float:
        """The value in the SI unit of the quantity; of any dimension when the quantity itself is wrong."""
        name = (info.data or {}).get("quantity")
        kind = kinds.ANYTHING if name is None else parse_quantity(name, reading_of(info).joint_types).kind
        return within(in_kind(measure(value, info, kind), kind), Bounds(at_least=self.at_least), kind)


class Moment(Number):
    """A time of the run, or the word `end`."""

    def read(self, value: object, info: ValidationInfo) -> Any:
        """The time in seconds, or `end`."""
        return END if value == END else super().read(value, info)

    def schema(self) -> Schema:
        return {"anyOf": [{"const": END}, *super().schema()["anyOf"]]}


class ExpectSpec(Spec):
    """One expectation: a value within a tolerance, or bounds (min, max, or both)."""

    quantity: Annotated[str, QuantityText(300)] = Field(
        description="What is looked at: one number per frame.",
        examples=["bodies.crate.position.z", "joints.hinge.coordinate", "energy.total"],
    )
    at: Annotated[float | Literal["end"], Moment(kinds.TIME, at_least=0)] = Field(
        default="end",
        description="When [s], from 0 to duration; `end` is the last frame.",
        examples=["5 s", "end"],
    )
    value: Annotated[float, OfQuantity()] | None = Field(
        default=None, description="Expected value, in the unit of the quantity; with within."
    )
    within: Annotated[float, OfQuantity(at_least=0)] | None = Field(
        default=None, description="Largest deviation from value, at least 0, in the unit of the quantity."
    )
    min: Annotated[float, OfQuantity()] | None = Field(
        default=None, description="Least value that is accepted."
    )
    max: Annotated[float, OfQuantity()] | None = Field(
        default=None, description="Greatest value that is accepted."
    )

    _parsed: Quantity = PrivateAttr()

    @model_validator(mode="after")
    def _something_to_check(self, info: ValidationInfo) -> ExpectSpec:
        self._parsed = parse_quantity(self.quantity, reading_of(info).joint_types)
        if self.value is not None and self.within is None:
            raise slip("needs within beside value: how far off it may be", at=("value",), points_at_key=True)
        if self.within is not None and self.value is None:
            raise slip("needs value beside it", at=("within",), points_at_key=True)
        if self.value is None and self.min is None and self.max is None:
            raise slip("checks nothing: give value and within, or min, or max", points_at_key=True)
        if self.min is not None and self.max is not None and self.min > self.max:
            raise slip("must not exceed max", at=("min",))
        return self

    @property
    def parsed(self) -> Quantity:
        """The quantity, read; what a joint's coordinate measures is known from its type."""
        return self._parsed
