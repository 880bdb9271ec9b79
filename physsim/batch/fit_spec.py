"""A fit as it is written: which values of a scene are sought, and what was measured."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, PrivateAttr, ValidationInfo, model_validator

from physsim.batch.spec.values import Given, ScenePath, Written, common
from physsim.scene.quantity import Quantity, parse_quantity
from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.expect import QuantityText
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.schema_generator import SchemaGenerator
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Number, Text, Whole
from physsim.scene.spec.version import Version
from physsim.scene.units import Dimension, Unit, UnitError, fits, parse_unit, same

LANGUAGE_VERSION = 1
MOST_FREE = 50
MOST_FILES = 1000


class UnitText(Text):
    """A unit, or nothing for SI."""

    def read(self, value: object) -> str:
        """The unit as written."""
        text = super().read(value)
        if text:
            unit_of(text)
        return text


def unit_of(text: str) -> Unit:
    """The unit; a slip for a text that is none."""
    try:
        return parse_unit(text)
    except UnitError as error:
        raise slip(str(error), hint=error.hint) from None


class FreeSpec(Spec):
    """One value of the scene that is sought."""

    start: Given = Field(description="Where the search begins.", examples=[0.5, "80 N/m"])
    min: Given | None = Field(default=None, description="Least value that is tried.")
    max: Given | None = Field(default=None, description="Greatest value that is tried.")
    scale: Literal["linear", "log"] = Field(
        default="linear", description="log: steps are factors, for values whose magnitude is not known."
    )

    _dimension: Dimension = PrivateAttr()

    @model_validator(mode="after")
    def _in_order(self) -> FreeSpec:
        given = [value for value in (self.start, self.min, self.max) if value is not None]
        found = common(given)
        if found is None:
            raise slip("start, min and max must be of one dimension", points_at_key=True)
        self._dimension = found
        for key, bound, below in (("min", self.min, True), ("max", self.max, False)):
            if bound is not None and (bound.value >= self.start.value) == below:
                raise slip(f"must be {'less' if below else 'greater'} than start", at=(key,))
        if self.scale == "log" and (self.start.value <= 0 or (self.min is not None and self.min.value <= 0)):
            raise slip("log needs values greater than 0", at=("scale",))
        return self

    @property
    def dimension(self) -> Dimension:
        """Powers of kg, m, s and rad."""
        return self._dimension


class MeasuredSpec(Spec):
    """Where the measured values of a quantity stand."""

    column: Annotated[str, Text(300)] | None = Field(
        default=None,
        description="The column of a CSV file, the quantity of a trajectory, or the dataset of any other "
        "HDF5 file; the name of the quantity when not given.",
    )
    unit: Annotated[str, UnitText(80, empty=True)] = Field(
        default="", description="The unit of the column; SI when not given.", examples=["cm"]
    )
    sigma: Given | None = Field(
        default=None, description="Standard deviation of one measured value.", examples=["2 mm"]
    )


class DataSpec(Spec):
    """One file of measured data, and what was different in that experiment."""

    file: Annotated[str, Text(1000)] = Field(description="CSV or HDF5, relative to this file.")
    time: Annotated[str, Text(300)] = Field(default="time", description="The column of the time.")
    time_unit: Annotated[str, UnitText(80, empty=True)] = Field(
        default="", description="Its unit; s when not given."
    )
    start: Annotated[float, Number(kinds.TIME)] = Field(
        default=0.0, description="Time of the data at which the simulation starts."
    )
    set: dict[ScenePath, Written] = Field(
        default_factory=dict, description="Changes to the scene for this experiment, by path."
    )
    quantities: Annotated[
        dict[Annotated[str, QuantityText(300)], MeasuredSpec], Field(min_length=1, max_length=100)
    ] = Field(
        description="What was measured, by the name of the quantity in the simulation.",
        examples=[{"bodies.ball.position.z": {"column": "height", "unit": "cm", "sigma": "2 mm"}}],
    )

    _parsed: list[Quantity] = PrivateAttr()

    @model_validator(mode="after")
    def _units_fit(self, info: ValidationInfo) -> DataSpec:
        types = reading_of(info).joint_types
        self._parsed = [parse_quantity(name, types) for name in self.quantities]
        for quantity, measured in zip(self._parsed, self.quantities.values(), strict=True):
            at = ("quantities", quantity.text)
            if measured.unit and not _may_be(unit_of(measured.unit).dimension, quantity):
                raise slip(f"must be {quantity.kind.wanted()}", at=(*at, "unit"))
            if measured.sigma is not None and not _may_be(measured.sigma.dimension, quantity):
                raise slip(f"must be {quantity.kind.wanted()}", at=(*at, "sigma"))
            if measured.sigma is not None and measured.sigma.value <= 0:
                raise slip("must be greater than 0", at=(*at, "sigma"))
        if self.time_unit and not same(unit_of(self.time_unit).dimension, kinds.TIME.dimension):
            raise slip("must be a unit of time", at=("time_unit",))
        return self

    @property
    def parsed(self) -> list[Quantity]:
        """The quantities, read, in order."""
        return self._parsed


def _may_be(dimension: Dimension, quantity: Quantity) -> bool:
    plain = same(dimension, (0.0, 0.0, 0.0, 0.0))
    return plain or quantity.kind.any_unit or fits(dimension, quantity.kind.dimension)


class FitSpec(Spec):
    """A fit of physsim: values of a scene that make its simulation match measured data."""

    model_config = ConfigDict(title="physsim fit, version 1")

    schema_: Annotated[str, Text(1000)] | None = Field(
        default=None, alias="$schema", description="Where the schema is, for editors; has no effect."
    )
    physsim_fit: Annotated[int, Version("fit", LANGUAGE_VERSION)] = Field(
        description="Version of the fit language: 1."
    )
    title: Annotated[str, Text(200, empty=True)] = Field(
        default="", description="What is fitted, on one line."
    )
    scene: Annotated[str, Text(1000)] = Field(description="The scene file, relative to this file.")
    set: dict[ScenePath, Written] = Field(
        default_factory=dict, description="Changes to the scene in all experiments, by path."
    )
    parameters: Annotated[dict[ScenePath, FreeSpec], Field(min_length=1, max_length=MOST_FREE)] = Field(
        description="The values that are sought, by path of the scene.",
        examples=[{"parameters.e": {"start": 0.5, "min": 0, "max": 1}}],
    )
    data: Annotated[list[DataSpec], Field(min_length=1, max_length=MOST_FILES)] = Field(
        description="What was measured: one entry per experiment."
    )
    method: Literal["least_squares", "nelder_mead", "differential_evolution"] = Field(
        default="least_squares",
        description="least_squares follows derivatives; nelder_mead needs none; differential_evolution "
        "searches all of the bounds, then least_squares goes on from its best.",
    )
    loss: Literal["linear", "soft_l1", "huber", "cauchy"] = Field(
        default="linear", description="How residuals count; all but linear let outliers count less."
    )
    starts: Annotated[int, Whole(1, 1000)] = Field(
        default=1, description="Searches from so many points; the best counts. More than 1 needs min and max."
    )
    step: Annotated[float, Number(kinds.NUMBER, above=0, at_most=0.1)] = Field(
        default=1e-4,
        description="Step of derivatives, as a part of max - min (or of the value without them).",
    )
    evaluations: Annotated[int, Whole(1, 10_000_000)] = Field(
        default=10_000, description="Most simulations of all experiments together."
    )
    seed: Annotated[int, Whole(0, 2**63 - 1)] = Field(
        default=0, description="Seed of starts and of differential_evolution."
    )

    @model_validator(mode="after")
    def _bounded(self) -> FitSpec:
        if self.starts == 1 and self.method != "differential_evolution":
            return self
        key = "starts" if self.starts > 1 else "method"
        for path, free in self.parameters.items():
            if free.min is None or free.max is None:
                raise slip(f"needs min and max, which {path} lacks", at=(key,))
        return self

    @classmethod
    def model_json_schema(cls, *arguments: Any, **options: Any) -> dict[str, Any]:
        """The schema of fits (JSON Schema, draft 2020-12); arguments are those of pydantic."""
        if len(arguments) < 3:
            options.setdefault("schema_generator", SchemaGenerator)
        return super().model_json_schema(*arguments, **options)
