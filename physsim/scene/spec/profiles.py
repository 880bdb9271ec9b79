"""Factors that follow time: of forces, motors and prescribed motion."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, PrivateAttr, ValidationInfo, model_validator

from physsim.scene.grammar import MAX_LENGTH, ExpressionError
from physsim.scene.parameters import BrokenParameter
from physsim.scene.program import compiled
from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.slip import silent, slip
from physsim.scene.spec.values import Angle, Number, PlainNumber, Text, Time

MAX_SAMPLES = 100_000


class SineProfile(Spec):
    """Factor sin(2 pi frequency t + phase); t counts from the start of what it multiplies."""

    type: Literal["sine"]
    frequency: Annotated[float, Number(kinds.FREQUENCY, above=0)] = Field(
        description="Frequency [Hz], greater than 0.", examples=["2 Hz"]
    )
    phase: Angle = Field(default=0.0, description="Phase [rad].")


class RampProfile(Spec):
    """Factor that rises from 0 to 1 over a time and stays there, from the start of what it multiplies."""

    type: Literal["ramp"]
    over: Annotated[float, Number(kinds.TIME, above=0)] = Field(
        description="Time of the rise [s], greater than 0."
    )


class StepProfile(Spec):
    """Factor that is 0 before a time and 1 from then on, counted from the start of what it multiplies."""

    type: Literal["step"]
    at: Time = Field(description="Time of the step [s], at least 0.")


class TableProfile(Spec):
    """Factor from a table of (time from the start, factor): straight lines between, constant outside."""

    type: Literal["table"]
    samples: Annotated[tuple[tuple[Time, PlainNumber], ...], Field(min_length=1, max_length=MAX_SAMPLES)] = (
        Field(description="Pairs [time in s, factor], times rising.", examples=[[[0, 0], ["2 s", 1]]])
    )


class ExpressionProfile(Spec):
    """Factor as an expression of t [s], which counts from the start of what it multiplies.

    The arithmetic is that of ${...}, parameters included; seconds and radians count as plain numbers.
    """

    type: Literal["expression"]
    value: Annotated[str, Text(MAX_LENGTH)] = Field(
        description="The expression, a plain number for every t.", examples=["sin(2*pi*t)*exp(-t)"]
    )
    _program: tuple[float, ...] = PrivateAttr(default=())

    @model_validator(mode="after")
    def _compile(self, info: ValidationInfo) -> ExpressionProfile:
        if "$" in self.value:
            raise slip("is an expression already: write it without ${ }", at=("value",))
        try:
            self._program = compiled(self.value, reading_of(info).parameters.find)
        except BrokenParameter:
            raise silent() from None
        except ExpressionError as error:
            raise slip(str(error), hint=error.hint, at=("value",)) from None
        return self

    @property
    def program(self) -> tuple[float, ...]:
        """The expression in postfix order, [operation, operand, ...], as `physsim.scene.program` says."""
        return self._program


ProfileSpec = Annotated[
    SineProfile | RampProfile | StepProfile | TableProfile | ExpressionProfile, Field(discriminator="type")
]
