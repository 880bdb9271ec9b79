"""What is kept of every run as one number."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, PrivateAttr, ValidationInfo, model_validator

from physsim.scene.quantity import Quantity, parse_quantity
from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.expect import OfQuantity, QuantityText
from physsim.scene.spec.names import WORLD, Name
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Number, Speed, Text, Time

BodyPattern = Annotated[str, Name(reserved=(WORLD,), pattern=True)]
Reduction = Literal[
    "initial", "final", "min", "max", "mean", "rms", "deviation", "range", "time_of_min", "time_of_max"
]


class _OfQuantity(Spec):
    quantity: Annotated[str, QuantityText(300)] = Field(
        description="What is looked at: one number per frame, as in `expect`.",
        examples=["bodies.crate.position.z", "energy.total"],
    )
    _parsed: Quantity = PrivateAttr()

    @model_validator(mode="after")
    def _read(self, info: ValidationInfo) -> Any:
        self._parsed = parse_quantity(self.quantity, reading_of(info).joint_types)
        return self

    @property
    def parsed(self) -> Quantity:
        """The quantity, read."""
        return self._parsed


class ReducedMetric(_OfQuantity):
    """The frames of a time span reduced to one number."""

    type: Reduction
    since: Annotated[float, Number(kinds.TIME, at_least=0)] = Field(
        default=0.0, alias="from", description="Frames from this time on [s]."
    )
    until: Time | None = Field(default=None, description="Frames up to this time [s]; all when left out.")

    @model_validator(mode="after")
    def _in_order(self) -> Any:
        if self.until is not None and self.until < self.since:
            raise slip("must not be before from", at=("until",))
        return self


class AtMetric(_OfQuantity):
    """The value at a time, on a straight line between two frames; the last one after the end."""

    type: Literal["at"]
    time: Time = Field(description="When [s].", examples=["1.5 s"])


class CrossingMetric(_OfQuantity):
    """The first time at which the quantity passes a level, on a straight line between two frames."""

    type: Literal["crossing"]
    level: Annotated[float, OfQuantity()] = Field(description="The level, in the unit of the quantity.")
    direction: Literal["up", "down", "either"] = Field(default="either", description="Which way it passes.")


class _Between(Spec):
    between: tuple[BodyPattern, BodyPattern] = Field(
        default=("*", "*"),
        description="The two bodies; `*` stands for any characters.",
        examples=[["ball", "floor"], ["brick*", "*"]],
    )


class FirstContactMetric(_Between):
    """Time of the first touch [s], not a number when there is none: an impact, or a contact in a frame."""

    type: Literal["first_contact"]


class ImpactsMetric(_Between):
    """Number of impacts."""

    type: Literal["impacts"]


class HardestImpactMetric(_Between):
    """The largest impulse of all impacts [N s]; 0 without one."""

    type: Literal["hardest_impact"]


class RestTimeMetric(Spec):
    """Time from which on the bodies stay at rest to the end [s], not a number when one moves at the end."""

    type: Literal["rest_time"]
    bodies: BodyPattern = Field(default="*", description="Which bodies; `*` stands for any characters.")
    speed: Speed = Field(default=1e-3, description="At rest a body is at most this fast [m/s].")
    angular_speed: Annotated[float, Number(kinds.ANGULAR_SPEED)] = Field(
        default=1e-2, description="At rest a body turns at most this fast [rad/s]."
    )


class EnergyLostMetric(Spec):
    """Energy taken out by friction, impacts and dampers up to the end [J]."""

    type: Literal["energy_lost"]


class ValueMetric(Spec):
    """Arithmetic of other metrics and of the scene's parameters, in SI, by their names."""

    type: Literal["expression"]
    value: Annotated[str, Text(500)] = Field(
        description="An expression as in ${...}; names are metrics above it and parameters of the scene.",
        examples=["bounce / drop", "sqrt(landing_x^2 + landing_y^2)"],
    )


MetricSpec = Annotated[
    ReducedMetric
    | AtMetric
    | CrossingMetric
    | FirstContactMetric
    | ImpactsMetric
    | HardestImpactMetric
    | RestTimeMetric
    | EnergyLostMetric
    | ValueMetric,
    Field(discriminator="type"),
]
