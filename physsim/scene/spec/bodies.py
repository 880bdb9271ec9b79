"""Bodies, their inertia and their repetition."""

from __future__ import annotations

from typing import Annotated

from pydantic import ConfigDict, Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.materials import Density
from physsim.scene.spec.motion import MotionSpec
from physsim.scene.spec.names import ItemName
from physsim.scene.spec.orientation import OrientationSpec
from physsim.scene.spec.schema_rules import Schema
from physsim.scene.spec.shapes import ShapeSpec
from physsim.scene.spec.values import AngularSpeed, Number, Position, Speed, Switch, Whole

MAX_COUNT = 100_000
Mass = Annotated[float, Number(kinds.MASS, above=0)]
Moment = Annotated[float, Number(kinds.INERTIA, above=0)]
ProductOfInertia = Annotated[float, Number(kinds.INERTIA)]
Count = Annotated[int, Whole(1, MAX_COUNT)]
_ZERO = (0.0, 0.0, 0.0)
_IS_FIXED: Schema = {"properties": {"fixed": {"const": True}}, "required": ["fixed"]}


class InertiaSpec(Spec):
    """The inertia tensor about the centre of mass in body axes [kg m^2], in place of what the shape gives.

    Off-diagonal values are elements of the tensor: xy = - integral of x y dm.
    """

    xx: Moment = Field(description="Moment about x [kg m^2], greater than 0.")
    yy: Moment = Field(description="Moment about y [kg m^2], greater than 0.")
    zz: Moment = Field(description="Moment about z [kg m^2], greater than 0.")
    xy: ProductOfInertia = Field(default=0.0, description="Element xy of the tensor [kg m^2].")
    xz: ProductOfInertia = Field(default=0.0, description="Element xz of the tensor [kg m^2].")
    yz: ProductOfInertia = Field(default=0.0, description="Element yz of the tensor [kg m^2].")


class RepeatSpec(Spec):
    """The body is set up several times on a lattice; the copies are called name[i,j,k], counted from 0."""

    count: tuple[Count, Count, Count] = Field(
        description="How many along x, y and z, each at least 1.", examples=[[10, 1, 5]]
    )
    spacing: Position = Field(
        description="Step from one copy to the next along x, y and z, in world axes [m].",
        examples=[["21 cm", 0, "7 cm"]],
    )


class BodySpec(Spec):
    """A rigid body as it stands at the start."""

    model_config = ConfigDict(json_schema_extra={"dependentSchemas": {"motion": _IS_FIXED}})
    shape: ShapeSpec = Field(description="What it looks like, collides as, and where its mass is.")
    fixed: Switch = Field(default=False, description="Whether it never moves.")
    material: ItemName | None = Field(
        default=None,
        description="Name of its material, of the scene or built in. Bodies that collide need one.",
    )
    mass: Mass | None = Field(
        default=None,
        description="Mass [kg], greater than 0; density times volume when left out.",
        examples=["250 g"],
    )
    density: Density | None = Field(
        default=None, description="Density of this body [kg/m^3], greater than 0, in place of its material's."
    )
    inertia: InertiaSpec | None = Field(
        default=None, description="Inertia tensor, when the shape's is not wanted."
    )
    position: Position = Field(
        default=_ZERO, description="Of the body's own origin in the world [m].", examples=[[0, 0, "5 cm"]]
    )
    orientation: OrientationSpec = Field(
        default_factory=OrientationSpec.identity, description="Rotation body -> world; none by default."
    )
    velocity: tuple[Speed, Speed, Speed] = Field(default=_ZERO, description="Of the centre of mass [m/s].")
    angular_velocity: tuple[AngularSpeed, AngularSpeed, AngularSpeed] = Field(
        default=_ZERO, description="In world axes [rad/s].", examples=[[0, 0, "60 rpm"]]
    )
    collides: Switch = Field(default=True, description="Whether it collides with other bodies at all.")
    motion: MotionSpec | None = Field(
        default=None, description="How a fixed body is moved, whatever acts on it: a shaking table, a crank."
    )
    surface_velocity: tuple[Speed, Speed, Speed] = Field(
        default=_ZERO,
        description="Velocity of its surface against the body [m/s], in body axes: a conveyor belt.",
        examples=[["1 m/s", 0, 0]],
    )
    repeat: RepeatSpec | None = Field(default=None, description="Set up a lattice of copies of this body.")
