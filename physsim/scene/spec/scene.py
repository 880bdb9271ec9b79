"""The whole scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import (
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationInfo,
)

from physsim.scene.expressions import FUNCTIONS
from physsim.scene.grammar import ExpressionError
from physsim.scene.parameters import NAME, BrokenParameter
from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.expect import ExpectSpec
from physsim.scene.spec.forces import ForceSpec
from physsim.scene.spec.joints import JointSpec
from physsim.scene.spec.materials import MaterialSpec, MixingSpec, PairSpec
from physsim.scene.spec.names import BodyName, ItemName
from physsim.scene.spec.reader import ContextReader, Reader, Schema
from physsim.scene.spec.reading import reading_of
from physsim.scene.spec.record import RecordSpec
from physsim.scene.spec.schema_generator import SchemaGenerator
from physsim.scene.spec.simulation import SimulationSpec
from physsim.scene.spec.slip import silent, slip
from physsim.scene.spec.springs import SpringSpec
from physsim.scene.spec.values import Bounds, Text, number_schema, within
from physsim.scene.spec.version import Version
from physsim.scene.spec.world import WorldSpec
from physsim.scene.units import UnitError

LANGUAGE_VERSION = 1


@dataclass(frozen=True)
class _Named:
    """A parameter on its way through validation: its value is computed by name, so that circles are seen."""

    name: str


class ParameterName(Reader):
    """A word that can stand in an expression: letters, digits, underscores, no digit first, no function."""

    def schema(self) -> Schema:
        refused = [{"enum": sorted(FUNCTIONS)}, {"pattern": r"^[0-9]|[-\s+*/^()\[\]{},.$]"}]
        return {"type": "string", "minLength": 1, "maxLength": 60, "not": {"anyOf": refused}}

    def read(self, value: str) -> str:
        """The name itself."""
        if not NAME.match(value):
            raise slip("a parameter's name is letters, digits and underscores, at most 60, no digit first")
        if value in FUNCTIONS:
            raise slip(f"the name '{value}' is that of a function")
        return value


class ParameterValue(ContextReader):
    """Any number, with any unit, or an expression of other parameters; in SI after validation."""

    def schema(self) -> Schema:
        return number_schema(kinds.ANYTHING, Bounds())

    def read(self, value: _Named, info: ValidationInfo) -> float:
        """The value of the parameter of that name."""
        try:
            number = reading_of(info).parameters.value(value.name).value
        except BrokenParameter:
            raise silent() from None
        except (UnitError, ExpressionError) as error:
            raise slip(str(error), hint=error.hint) from None
        return within(number, Bounds(), kinds.ANYTHING)


def _by_name(value: object) -> object:
    return {name: _Named(name) for name in value} if isinstance(value, dict) else value


Parameters = Annotated[
    dict[Annotated[str, ParameterName()], Annotated[float, ParameterValue()]], BeforeValidator(_by_name)
]
Pattern = Annotated[str, Text(200)]


class SceneSpec(Spec):
    """A scene of physsim: bodies, what acts on them, how time is stepped, and what is recorded."""

    model_config = ConfigDict(title="physsim scene, version 1")

    schema_: Annotated[str, Text(1000)] | None = Field(
        default=None, alias="$schema", description="Where the schema is, for editors; has no effect."
    )
    physsim: Annotated[int, Version("scene", LANGUAGE_VERSION)] = Field(
        description="Version of the scene language: 1."
    )
    title: Annotated[str, Text(200, empty=True)] = Field(
        default="", description="What the scene shows, on one line."
    )
    parameters: Parameters = Field(
        default_factory=dict,
        description="Named numbers for expressions: ${drop} or ${2*drop}, anywhere a number may stand.",
        examples=[{"drop": "0.5 m", "e": 0.4}],
    )
    world: WorldSpec = Field(default_factory=WorldSpec, description="What acts everywhere.")
    simulation: SimulationSpec = Field(description="How the scene is stepped through time.")
    materials: dict[ItemName, MaterialSpec] = Field(
        default_factory=dict,
        description="Materials by name; they add to the built-in library or override it.",
    )
    pairs: tuple[PairSpec, ...] = Field(
        default=(), description="Coefficients of pairs of materials, looked up first."
    )
    mixing: MixingSpec = Field(default_factory=MixingSpec, description="Rule for pairs that no table has.")
    bodies: Annotated[dict[BodyName, BodySpec], Field(min_length=1)] = Field(
        description="Bodies by name, at least one."
    )
    springs: dict[ItemName, SpringSpec] = Field(
        default_factory=dict, description="Springs and dampers by name."
    )
    joints: dict[ItemName, JointSpec] = Field(default_factory=dict, description="Joints by name.")
    forces: dict[ItemName, ForceSpec] = Field(default_factory=dict, description="Forces and torques by name.")
    no_contact: tuple[tuple[Pattern, Pattern], ...] = Field(
        default=(),
        description="Pairs of bodies that do not collide; `*` stands for any characters.",
        examples=[[["brick*", "plate"]]],
    )
    record: RecordSpec = Field(default_factory=RecordSpec, description="What is recorded.")
    expect: tuple[ExpectSpec, ...] = Field(default=(), description="What must hold after the run.")

    @classmethod
    def model_json_schema(cls, *arguments: Any, **options: Any) -> dict[str, Any]:
        """The schema of scenes (JSON Schema, draft 2020-12); arguments are those of pydantic."""
        if len(arguments) < 3:
            options.setdefault("schema_generator", SchemaGenerator)
        return super().model_json_schema(*arguments, **options)

    @property
    def steps_per_frame(self) -> int:
        """Number of timesteps from one recorded frame to the next."""
        return max(1, round(self.record.every / self.simulation.timestep))
