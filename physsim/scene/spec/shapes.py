"""Shapes: `{type: box, size: [2 m, 2 m, 10 cm]}` and their kin. Lengths in metres, axes along z."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import ItemName
from physsim.scene.spec.orientation import OrientationSpec
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Length, Position, Size, Text, UnitVector

MAX_POINTS = 10_000
MAX_PARTS = 1_000


class SphereShape(Spec):
    """A solid ball; the origin is its centre."""

    type: Literal["sphere"]
    radius: Size = Field(description="Radius [m], greater than 0.", examples=["5 cm", 0.05])


class HollowSphereShape(Spec):
    """A thin spherical shell; collides like a ball."""

    type: Literal["hollow_sphere"]
    radius: Size = Field(description="Radius [m], greater than 0.", examples=["12 cm"])


class BoxShape(Spec):
    """A solid box; the origin is its centre."""

    type: Literal["box"]
    size: tuple[Size, Size, Size] = Field(
        description="Whole edge lengths along x, y, z [m], each greater than 0.",
        examples=[["2 m", "2 m", "10 cm"]],
    )


class CylinderShape(Spec):
    """A solid cylinder along z; the origin is its centre."""

    type: Literal["cylinder"]
    radius: Size = Field(description="Radius [m], greater than 0.")
    height: Size = Field(description="Height along z [m], greater than 0.")


class CapsuleShape(Spec):
    """A cylinder along z with half-spheres on its ends; the origin is its centre."""

    type: Literal["capsule"]
    radius: Size = Field(description="Radius of cylinder and ends [m], greater than 0.")
    height: Size = Field(description="Height of the cylindrical part only [m], greater than 0.")


class ConeShape(Spec):
    """A solid cone along z, apex up; the origin is its centre of mass, height / 4 above the base."""

    type: Literal["cone"]
    radius: Size = Field(description="Radius of the base [m], greater than 0.")
    height: Size = Field(description="Height along z [m], greater than 0.")


class RodShape(Spec):
    """A thin straight rod along z without thickness; its mass must be given, since it has no volume."""

    type: Literal["rod"]
    length: Size = Field(description="Length along z [m], greater than 0.")


class EllipsoidShape(Spec):
    """A solid ellipsoid; the origin is its centre."""

    type: Literal["ellipsoid"]
    radii: tuple[Size, Size, Size] = Field(description="Half axes along x, y, z [m], each greater than 0.")


class HalfspaceShape(Spec):
    """Everything on one side of a plane: ground or wall without end. Fixed bodies only."""

    type: Literal["halfspace"]
    normal: UnitVector = Field(
        default=(0.0, 0.0, 1.0), description="Direction out of the material, in body axes; any length but 0."
    )
    offset: Length = Field(
        default=0.0, description="Distance of the surface from the body's origin along normal [m]."
    )


class MeshShape(Spec):
    """A closed triangle mesh from a file (OBJ, STL, PLY, ...); the origin is the file's origin."""

    type: Literal["mesh"]
    file: Annotated[str, Text(1000)] = Field(
        description="Path of the mesh, relative to the scene file.", examples=["meshes/crate.obj"]
    )
    scale: Size = Field(
        default=1.0, description="Length of one file unit [m], greater than 0.", examples=["1 mm"]
    )
    collision: Literal["hull", "pieces", "exact"] = Field(
        default="hull",
        description="What collides: its convex hull, convex pieces, or its triangles (fixed bodies only).",
    )
    inertia: Literal["solid", "shell", "hull"] = Field(
        default="solid", description="Where the mass is: inside, on the surface, or inside the convex hull."
    )


class ConvexShape(Spec):
    """The convex hull of points: exactly one of points and file."""

    type: Literal["convex"]
    points: Annotated[tuple[Position, ...], Field(min_length=4, max_length=MAX_POINTS)] | None = Field(
        default=None, description="Points [m], at least 4 that are not in one plane."
    )
    file: Annotated[str, Text(1000)] | None = Field(
        default=None, description="Path of a mesh whose vertices are taken, relative to the scene file."
    )
    scale: Size | None = Field(
        default=None,
        description="Length of one file unit [m], greater than 0; 1 m when left out. Only with file.",
    )

    @model_validator(mode="after")
    def _one_source(self) -> ConvexShape:
        if (self.points is None) == (self.file is None):
            raise slip("needs exactly one of points and file", points_at_key=True)
        if self.scale is not None and self.file is None:
            raise slip("belongs to file; points carry their own units", at=("scale",), points_at_key=True)
        return self


PrimitiveShape = (
    SphereShape
    | HollowSphereShape
    | BoxShape
    | CylinderShape
    | CapsuleShape
    | ConeShape
    | RodShape
    | EllipsoidShape
    | MeshShape
    | ConvexShape
)
PartShape = Annotated[PrimitiveShape, Field(discriminator="type")]


class PartSpec(Spec):
    """One part of a compound, placed in the body's own frame."""

    shape: PartShape = Field(description="Any shape but halfspace and compound.")
    position: Position = Field(
        default=(0.0, 0.0, 0.0), description="Of the part's origin in the body's frame [m]."
    )
    orientation: OrientationSpec = Field(
        default_factory=OrientationSpec.identity,
        description="Of the part in the body's frame; none by default.",
    )
    material: ItemName | None = Field(
        default=None, description="Material of this part; the body's when left out."
    )


class CompoundShape(Spec):
    """Several shapes that move as one body; the origin is the frame in which the parts are placed."""

    type: Literal["compound"]
    parts: Annotated[tuple[PartSpec, ...], Field(min_length=1, max_length=MAX_PARTS)] = Field(
        description="At least one part; overlapping parts count twice in mass and inertia."
    )


ShapeSpec = Annotated[PrimitiveShape | HalfspaceShape | CompoundShape, Field(discriminator="type")]


def files_of(shape: Any) -> list[tuple[tuple[str | int, ...], str]]:
    """Every mesh file that a shape names, with its path below the shape."""
    if isinstance(shape, CompoundShape):
        return [
            (("parts", i, "shape", *path), file)
            for i, part in enumerate(shape.parts)
            for path, file in files_of(part.shape)
        ]
    file = getattr(shape, "file", None)
    return [(("file",), file)] if file is not None else []
