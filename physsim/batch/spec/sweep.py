"""The whole sweep as it is written."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field

from physsim.batch.spec.axes import AxisSpec, Count, DistributionSpec
from physsim.batch.spec.metrics import MetricSpec
from physsim.batch.spec.values import ColumnName, ScenePath, Written
from physsim.scene.spec.base import Spec
from physsim.scene.spec.schema_generator import SchemaGenerator
from physsim.scene.spec.values import Switch, Text, Whole
from physsim.scene.spec.version import Version

LANGUAGE_VERSION = 1
FIXED_COLUMNS = ("run", "replicate", "status", "error", "expectations_failed", "file", "wall_time")
MOST_AXES = 100


class SampleSpec(Spec):
    """A design of so many points, whose coordinates follow distributions."""

    method: Literal["random", "latin_hypercube", "sobol"] = Field(
        default="random",
        description="Independent draws, a Latin hypercube, or scrambled Sobol points "
        "(best when count is a power of 2).",
    )
    count: Count = Field(description="Number of points, at least 1.", examples=[128])
    values: Annotated[dict[ScenePath, DistributionSpec], Field(min_length=1, max_length=MOST_AXES)] = Field(
        description="Distributions by path of the scene.",
        examples=[{"parameters.drop": {"type": "uniform", "from": "10 cm", "to": "1 m"}}],
    )


class SweepSpec(Spec):
    """A sweep of physsim: one scene, what varies in it, and what is kept of every run."""

    model_config = ConfigDict(title="physsim sweep, version 1")

    schema_: Annotated[str, Text(1000)] | None = Field(
        default=None, alias="$schema", description="Where the schema is, for editors; has no effect."
    )
    physsim_sweep: Annotated[int, Version("sweep", LANGUAGE_VERSION)] = Field(
        description="Version of the sweep language: 1."
    )
    title: Annotated[str, Text(200, empty=True)] = Field(
        default="", description="What the sweep is for, on one line."
    )
    scene: Annotated[str, Text(1000)] = Field(
        description="The scene file, relative to this file.", examples=["dice_roll.yaml"]
    )
    set: dict[ScenePath, Written] = Field(
        default_factory=dict,
        description="Changes to the scene that all runs share, by path.",
        examples=[{"simulation.duration": "2 s"}],
    )
    grid: Annotated[dict[ScenePath, AxisSpec], Field(max_length=MOST_AXES)] = Field(
        default_factory=dict,
        description="Every combination of these; the last one varies fastest.",
        examples=[{"parameters.e": [0.2, 0.4], "bodies.ball.mass": ["1 kg", "2 kg"]}],
    )
    zip: Annotated[dict[ScenePath, AxisSpec], Field(max_length=MOST_AXES)] = Field(
        default_factory=dict,
        description="Paired: the first values together, then the second ones, ...; all of one length.",
    )
    sample: SampleSpec | None = Field(default=None, description="Values that follow distributions.")
    replicates: Count = Field(
        default=1,
        description="How often everything is repeated, each time with a new draw of sample "
        "and with simulation.seed one higher.",
    )
    seed: Annotated[int, Whole(0, 2**53)] = Field(default=0, description="Seed of everything random.")
    metrics: dict[Annotated[str, ColumnName(200, taken=FIXED_COLUMNS)], MetricSpec] = Field(
        default_factory=dict, description="What is kept of every run as one number, by name."
    )
    keep: Literal["none", "failed", "all"] = Field(
        default="none",
        description="Which trajectories are kept; failed are also those whose expectations did not hold.",
    )
    gather: Switch = Field(
        default=False, description="One HDF5 file over all kept trajectories, by virtual datasets."
    )

    @classmethod
    def model_json_schema(cls, *arguments: Any, **options: Any) -> dict[str, Any]:
        """The schema of sweeps (JSON Schema, draft 2020-12); arguments are those of pydantic."""
        if len(arguments) < 3:
            options.setdefault("schema_generator", SchemaGenerator)
        return super().model_json_schema(*arguments, **options)
