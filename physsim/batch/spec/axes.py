"""How one value of a scene varies: over a list, over a range, or at random."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, model_validator
from pydantic_core import core_schema

from physsim.batch.spec.values import Given, Written, common
from physsim.scene.spec.base import Spec
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Number, Whole

MOST_RUNS = 1_000_000
Count = Annotated[int, Whole(1, MOST_RUNS)]


class _Measured(Spec):
    """Values of one dimension each; a plain number is SI. `ALIKE` names those that must agree."""

    ALIKE: ClassVar[tuple[str, ...]] = ()

    @model_validator(mode="after")
    def _one_dimension(self) -> Any:
        given = [value for name in self.ALIKE if (value := getattr(self, name)) is not None]
        if common(given) is None:
            raise slip(f"{' and '.join(self.ALIKE)} must be of one dimension", points_at_key=True)
        return self


class ListAxis(Spec):
    """The values that are listed; written as the list alone."""

    type: Literal["list"] = "list"
    values: Annotated[tuple[Written, ...], Field(min_length=1)] = Field(
        description="Values as they would stand in the scene.", examples=[["1 cm", "2 cm"]]
    )


class RangeAxis(_Measured):
    """Evenly spaced values, both ends included."""

    ALIKE = ("start", "stop")
    type: Literal["range"]
    start: Given = Field(alias="from", description="First value, with its unit.", examples=["10 cm"])
    stop: Given = Field(alias="to", description="Last value, with its unit.", examples=["1 m"])
    count: Count = Field(description="Number of values, at least 1.", examples=[10])


class LogRangeAxis(RangeAxis):
    """Values whose logarithms are evenly spaced, both ends included."""

    type: Literal["log_range"]  # type: ignore[assignment]

    @model_validator(mode="after")
    def _one_sign(self) -> Any:
        if self.start.value * self.stop.value <= 0:
            raise slip("both ends of a log_range must be of one sign and not 0", points_at_key=True)
        return self


class _OrList:
    """A list stands for `{type: list, values: [...]}`."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(self.read, handler(source))

    def __get_pydantic_json_schema__(
        self, core: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [{"type": "array", "minItems": 1}, handler(core)]}

    @staticmethod
    def read(value: object) -> object:
        """The list in a mapping; anything else as it is."""
        return {"type": "list", "values": value} if isinstance(value, list) else value


AxisSpec = Annotated[Annotated[ListAxis | RangeAxis | LogRangeAxis, Field(discriminator="type")], _OrList()]


class Uniform(_Measured):
    """Every value between the ends is as likely as any other."""

    ALIKE = ("start", "stop")
    type: Literal["uniform"]
    start: Given = Field(alias="from", description="Least value, with its unit.")
    stop: Given = Field(alias="to", description="Greatest value, with its unit.")


class LogUniform(Uniform):
    """The logarithm is uniform: every decade is as likely as any other."""

    type: Literal["log_uniform"]  # type: ignore[assignment]

    @model_validator(mode="after")
    def _one_sign(self) -> Any:
        if self.start.value * self.stop.value <= 0:
            raise slip("both ends of a log_uniform must be of one sign and not 0", points_at_key=True)
        return self


class Normal(_Measured):
    """Gaussian; cut off at `from` and `to` where these are given, and scaled to be a distribution again."""

    ALIKE = ("mean", "deviation", "start", "stop")
    type: Literal["normal"]
    mean: Given = Field(description="Mean of the distribution before it is cut off.")
    deviation: Given = Field(description="Standard deviation before it is cut off, greater than 0.")
    start: Given | None = Field(default=None, alias="from", description="Nothing below this value.")
    stop: Given | None = Field(default=None, alias="to", description="Nothing above this value.")

    @model_validator(mode="after")
    def _in_order(self) -> Any:
        if self.deviation.value <= 0:
            raise slip("must be greater than 0", at=("deviation",))
        if self.start is not None and self.stop is not None and self.start.value >= self.stop.value:
            raise slip("must be less than to", at=("from",))
        return self


class LogNormal(_Measured):
    """The logarithm is Gaussian; cut off at `from` and `to` where these are given."""

    ALIKE = ("median", "start", "stop")
    type: Literal["log_normal"]
    median: Given = Field(description="Half of all values are below, greater than 0.", examples=["1 kg"])
    factor: Annotated[float, Number(above=1)] = Field(
        description="68 % of all values are between median/factor and median*factor; greater than 1."
    )
    start: Given | None = Field(default=None, alias="from", description="Nothing below this value.")
    stop: Given | None = Field(default=None, alias="to", description="Nothing above this value.")

    @model_validator(mode="after")
    def _in_order(self) -> Any:
        if self.median.value <= 0:
            raise slip("must be greater than 0", at=("median",))
        for name, end in (("from", self.start), ("to", self.stop)):
            if end is not None and end.value <= 0:
                raise slip("must be greater than 0", at=(name,))
        if self.start is not None and self.stop is not None and self.start.value >= self.stop.value:
            raise slip("must be less than to", at=("from",))
        return self


DistributionSpec = Annotated[Uniform | LogUniform | Normal | LogNormal, Field(discriminator="type")]
