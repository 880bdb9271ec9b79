"""What the user wrote, typed: field names are the keys of the scene language, numbers are floats in SI."""

from physsim.scene.spec.bodies import BodySpec, InertiaSpec, RepeatSpec
from physsim.scene.spec.drives import AngleDrive, AngleMotor, DriveSpec, TravelDrive, TravelMotor
from physsim.scene.spec.expect import ExpectSpec
from physsim.scene.spec.forces import DragSpec, ForceSpec
from physsim.scene.spec.joints import (
    BallJoint,
    ConeJoint,
    CylindricalJoint,
    DistanceJoint,
    FixedJoint,
    GearJoint,
    HingeJoint,
    JointSpec,
    PlanarJoint,
    ScrewJoint,
    SliderJoint,
    UniversalJoint,
)
from physsim.scene.spec.materials import MaterialSpec, MixingSpec, PairSpec
from physsim.scene.spec.motion import MotionSpec, RotationSpec
from physsim.scene.spec.orientation import OrientationSpec
from physsim.scene.spec.profiles import (
    ExpressionProfile,
    ProfileSpec,
    RampProfile,
    SineProfile,
    StepProfile,
    TableProfile,
)
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
from physsim.scene.spec.springs import LinearSpring, SpringSpec, TorsionalSpring
from physsim.scene.spec.world import WorldSpec

__all__ = [
    "AngleDrive",
    "AngleMotor",
    "BallJoint",
    "BodySpec",
    "BoxShape",
    "CapsuleShape",
    "CompoundShape",
    "ConeJoint",
    "ConeShape",
    "ConvexShape",
    "CylinderShape",
    "CylindricalJoint",
    "DistanceJoint",
    "DragSpec",
    "DriveSpec",
    "EllipsoidShape",
    "ExpectSpec",
    "ExpressionProfile",
    "FixedJoint",
    "ForceSpec",
    "GearJoint",
    "HalfspaceShape",
    "HingeJoint",
    "HollowSphereShape",
    "InertiaSpec",
    "JointSpec",
    "LinearSpring",
    "MaterialSpec",
    "MeshShape",
    "MixingSpec",
    "MotionSpec",
    "OrientationSpec",
    "PairSpec",
    "PartSpec",
    "PlanarJoint",
    "ProfileSpec",
    "RampProfile",
    "RecordSpec",
    "RepeatSpec",
    "RodShape",
    "RotationSpec",
    "SceneSpec",
    "ScrewJoint",
    "ShapeSpec",
    "SimulationSpec",
    "SineProfile",
    "SliderJoint",
    "SphereShape",
    "SpringSpec",
    "StepProfile",
    "TableProfile",
    "TorsionalSpring",
    "TravelDrive",
    "TravelMotor",
    "UniversalJoint",
    "WorldSpec",
]
