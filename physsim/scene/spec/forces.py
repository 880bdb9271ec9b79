"""What acts on bodies: forces and torques that follow a profile in time, drag, and uniform fields."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.materials import Density
from physsim.scene.spec.names import BodyPattern
from physsim.scene.spec.profiles import ProfileSpec
from physsim.scene.spec.schema_rules import SOMETHING, any_of, none_of
from physsim.scene.spec.values import Acceleration, Force, Number, Position, Time, Torque

Area = Annotated[float, Number(kinds.AREA, above=0)]


class DragSpec(Spec):
    """Drag of a medium at rest: force -linear v - density area coefficient |v| v / 2, torque -angular omega.

    v is the velocity of the centre of mass; density, area and coefficient are given together or not at all.
    """

    model_config = ConfigDict(
        json_schema_extra={
            **SOMETHING,
            "dependentRequired": {
                "density": ["area", "coefficient"],
                "area": ["density", "coefficient"],
                "coefficient": ["density", "area"],
            },
        }
    )
    linear: Annotated[float, Number(kinds.DAMPING, at_least=0)] = Field(
        default=0.0, description="Force per speed [N s/m], at least 0."
    )
    angular: Annotated[float, Number(kinds.TURNING_DAMPING, at_least=0)] = Field(
        default=0.0, description="Torque per angular speed [N m s/rad], at least 0."
    )
    density: Density | None = Field(
        default=None, description="Density of the medium [kg/m^3], greater than 0.", examples=["1.2 kg/m^3"]
    )
    area: Area | None = Field(
        default=None, description="Area that meets the medium [m^2], greater than 0.", examples=["80 cm^2"]
    )
    coefficient: Annotated[float, Number(at_least=0, at_most=1e6)] | None = Field(
        default=None, description="Drag coefficient, at least 0; 0.47 for a sphere."
    )


class ForceSpec(Spec):
    """One of: a force, a torque, or both, on one body; drag on bodies; a uniform acceleration of bodies."""

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {**any_of("force", "torque"), "properties": {"body": {"not": {"pattern": r"\*"}}}},
                {"required": ["drag"], **none_of("until", "profile")},
                {"required": ["acceleration"]},
            ],
            "dependentRequired": {"at": ["force"], "region": ["acceleration"]},
        }
    )
    body: BodyPattern = Field(
        description="Name of the body; for drag and acceleration `*` may stand for any characters.",
        examples=["crate", "brick*"],
    )
    force: tuple[Force, Force, Force] | None = Field(
        default=None, description="Force [N].", examples=[["150 N", 0, 0]]
    )
    torque: tuple[Torque, Torque, Torque] | None = Field(default=None, description="Torque [N m].")
    drag: DragSpec | None = Field(default=None, description="Drag of a medium at rest.")
    acceleration: tuple[Acceleration, Acceleration, Acceleration] | None = Field(
        default=None,
        description="Acceleration of a uniform field, in world axes [m/s^2].",
        examples=[[0, 0, "2 m/s^2"]],
    )
    at: Position | None = Field(
        default=None,
        description="Point of attack of the force in the body's own frame [m]; the centre of mass when left "
        "out.",
    )
    frame: Literal["world", "body"] = Field(default="world", description="Axes of force and torque.")
    from_: Time = Field(default=0.0, alias="from", description="Start [s], at least 0.")
    until: Time | None = Field(default=None, description="End [s], after the start; never when left out.")
    profile: ProfileSpec | None = Field(
        default=None,
        description="Factor that multiplies force, torque and acceleration over time; 1 when left out.",
    )
    region: tuple[Position, Position] | None = Field(
        default=None,
        description="Lower and upper corner of the box in which the field acts, in the world [m]; everywhere "
        "when left out. A body is inside when its centre of mass is.",
        examples=[[[-1, -1, 0], [1, 1, "2 m"]]],
    )
