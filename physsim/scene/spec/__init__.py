"""What the user wrote, typed: field names are the keys of the scene language, numbers are floats in SI."""

from physsim.scene.spec.bodies import BodySpec, InertiaSpec, RepeatSpec
from physsim.scene.spec.expect import ExpectSpec
from physsim.scene.spec.materials import MaterialSpec, MixingSpec, PairSpec
from physsim.scene.spec.orientation import OrientationSpec
from physsim.scene.spec.record import RecordSpec
from physsim.scene.spec.scene import SceneSpec
from physsim.scene.spec.shapes import (
    BoxShape,
    CapsuleShape,
    CompoundShape,
    ConeShape,
    ConvexShape,
    CylinderShape,
    EllipsoidShape,
    HalfspaceShape,
    HollowSphereShape,
    MeshShape,
    PartSpec,
    RodShape,
    ShapeSpec,
    SphereShape,
)
from physsim.scene.spec.simulation import SimulationSpec
from physsim.scene.spec.world import WorldSpec

__all__ = [
    "BodySpec",
    "BoxShape",
    "CapsuleShape",
    "CompoundShape",
    "ConeShape",
    "ConvexShape",
    "CylinderShape",
    "EllipsoidShape",
    "ExpectSpec",
    "HalfspaceShape",
    "HollowSphereShape",
    "InertiaSpec",
    "MaterialSpec",
    "MeshShape",
    "MixingSpec",
    "OrientationSpec",
    "PairSpec",
    "PartSpec",
    "RecordSpec",
    "RepeatSpec",
    "RodShape",
    "SceneSpec",
    "ShapeSpec",
    "SimulationSpec",
    "SphereShape",
    "WorldSpec",
]
