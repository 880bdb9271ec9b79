"""Forces and torques on bodies, constant or following a profile in time."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import BodyName
from physsim.scene.spec.values import Angle, Force, Number, PlainNumber, Position, Time, Torque

MAX_SAMPLES = 100_000


class SineProfile(Spec):
    """Factor sin(2 pi frequency t + phase); t counts from the start of the force."""

    type: Literal["sine"]
    frequency: Annotated[float, Number(kinds.FREQUENCY, above=0)] = Field(
        description="Frequency [Hz], greater than 0.", examples=["2 Hz"]
    )
    phase: Angle = Field(default=0.0, description="Phase [rad].")


class RampProfile(Spec):
    """Factor that rises from 0 to 1 over a time and stays there; t counts from the start of the force."""

    type: Literal["ramp"]
    over: Annotated[float, Number(kinds.TIME, above=0)] = Field(
        description="Time of the rise [s], greater than 0."
    )


class TableProfile(Spec):
    """Factor from a table of (time from the start, factor): straight lines between, constant outside."""

    type: Literal["table"]
    samples: Annotated[tuple[tuple[Time, PlainNumber], ...], Field(min_length=1, max_length=MAX_SAMPLES)] = (
        Field(description="Pairs [time in s, factor], times rising.")
    )


ProfileSpec = Annotated[SineProfile | RampProfile | TableProfile, Field(discriminator="type")]


class ForceSpec(Spec):
    """A force, a torque, or both, on one body."""

    body: BodyName = Field(description="Name of the body.")
    force: tuple[Force, Force, Force] | None = Field(
        default=None, description="Force [N].", examples=[["150 N", 0, 0]]
    )
    torque: tuple[Torque, Torque, Torque] | None = Field(default=None, description="Torque [N m].")
    at: Position | None = Field(
        default=None,
        description="Point of attack in the body's own frame [m]; the centre of mass when left out.",
    )
    frame: Literal["world", "body"] = Field(default="world", description="Axes of force and torque.")
    from_: Time = Field(default=0.0, alias="from", description="Start [s], at least 0.")
    until: Time | None = Field(default=None, description="End [s], after the start; never when left out.")
    profile: ProfileSpec | None = Field(
        default=None, description="Factor that multiplies force and torque over time; constant when left out."
    )
