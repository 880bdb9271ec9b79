"""Joints: from what was written to the numbers that the engine takes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from math import inf, pi
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.model import drives, rotation
from physsim.model.arrays import floats, wholes
from physsim.model.drives import Drive
from physsim.model.findings import Findings
from physsim.model.placement import Placed, Placement
from physsim.model.profiles import Profiles
from physsim.model.rotation import FloatArray
from physsim.model.springs import COINCIDING
from physsim.model.tied import TiedTable

if TYPE_CHECKING:
    from physsim.scene.spec.joints import DistanceJoint, GearJoint, JointSpec
    from physsim.scene.spec.springs import SpringSpec

NO_ARM: FloatArray = np.zeros(3)
NO_AXIS: FloatArray = np.full(3, np.nan)
WORLD_AXES: FloatArray = np.array(rotation.IDENTITY)


class JointKind(IntEnum):
    """Numbers of the border."""

    DISTANCE = 0
    BALL = 1
    HINGE = 2
    SLIDER = 3
    FIXED = 4
    CONE = 5
    UNIVERSAL = 6
    CYLINDRICAL = 7
    PLANAR = 8
    SCREW = 9
    GEAR = 10
    STOPS = 11
    """Limits of the distance between two points, and nothing else."""


COORDINATE_UNITS: Mapping[JointKind, tuple[str, ...]] = MappingProxyType(
    {
        JointKind.DISTANCE: ("m",),
        JointKind.HINGE: ("rad",),
        JointKind.SLIDER: ("m",),
        JointKind.UNIVERSAL: ("rad", "rad"),
        JointKind.CYLINDRICAL: ("m", "rad"),
        JointKind.PLANAR: ("m", "m", "rad"),
        JointKind.SCREW: ("rad",),
        JointKind.STOPS: ("m",),
    }
)
"""Units of the coordinates that a kind has; the others have none."""

DEGREES_REMOVED: Mapping[JointKind, int] = MappingProxyType(
    {
        JointKind.DISTANCE: 1,
        JointKind.BALL: 3,
        JointKind.HINGE: 5,
        JointKind.SLIDER: 5,
        JointKind.FIXED: 6,
        JointKind.CONE: 3,
        JointKind.UNIVERSAL: 4,
        JointKind.CYLINDRICAL: 4,
        JointKind.PLANAR: 3,
        JointKind.SCREW: 5,
        JointKind.GEAR: 1,
        JointKind.STOPS: 0,
    }
)
"""Degrees of freedom that a joint takes from the motion of B relative to A (formula sheet, section 8)."""


@dataclass(frozen=True)
class Joint:
    """One joint.

    ends: the bodies A and B (of a gear: the second bodies of the joints that it couples); anchors: two arms
    from the centres of mass, body axes [m]; frame: quaternion, joint -> world at the start, its z the axis or
    normal (universal: z the first axis, x the second; planar: x the direction of x); parameters: length [m]
    of a distance, [largest angle, restitution] of a cone, pitch [m/rad] of a screw, [ratio, joint, joint] of
    a gear; damping [N m s/rad]; breaking: force [N] and torque [N m].
    """

    kind: JointKind
    ends: tuple[Placed, Placed]
    anchors: tuple[FloatArray, FloatArray]
    frame: FloatArray
    parameters: tuple[float, ...] = ()
    damping: float = 0.0
    breaking: tuple[float, float] = (inf, inf)

    @property
    def placed(self) -> float:
        """Distance of the two anchors at the start [m]."""
        (a, b), (arm_a, arm_b) = self.ends, self.anchors
        return float(np.linalg.norm(b.place(arm_b) - a.place(arm_a)))


@dataclass(frozen=True)
class JointTable(TiedTable):
    """The joints of a scene, in its order, and after them the stops of its springs, which have no name."""

    names: tuple[str, ...]
    types: tuple[str, ...]
    rows: tuple[Joint, ...]
    drives: tuple[Drive, ...]

    @property
    def axes(self) -> FloatArray:
        """(J, 3) unit vectors in A's own axes; NaN for kinds without an axis."""
        return floats([_axis_of(row) for row in self.rows], 3)

    def engine_input(self) -> dict[str, object]:
        """The joints and their drives as plain arrays; anchors from the centres of mass."""
        rows = self.rows
        frames = [[end.frame_of_world(row.frame) for end in row.ends] for row in rows]
        return {
            "joint_kind": wholes([row.kind for row in rows]),
            "joint_bodies": self.bodies,
            "joint_anchors": floats([row.anchors for row in rows], 2, 3),
            "joint_frames": floats(frames, 2, 4),
            "joint_parameters": floats([_padded(row.parameters) for row in rows], 4),
            "joint_damping": floats([row.damping for row in rows]),
            "joint_break": floats([row.breaking for row in rows], 2),
            **drives.engine_input(self.drives),
        }


def joint_table(
    joints: Mapping[str, JointSpec],
    springs: Mapping[str, SpringSpec],
    placement: Placement,
    profiles: Profiles,
    findings: Findings,
) -> JointTable:
    """Every joint of the scene, and the stops of its springs.

    Distance joints without a direction, because their anchors coincide, are errors in `findings`.
    """
    maker = _JointMaker(joints, placement, profiles, findings)
    for name, spec in joints.items():
        maker.add(name, spec)
    for spring in springs.values():
        if spring.type == "linear" and spring.limits is not None:
            maker.add_stops(spring, spring.limits)
    types = tuple(spec.type for spec in joints.values())
    return JointTable(tuple(joints), types, tuple(maker.rows), tuple(maker.drives))


class _JointMaker:
    """Collects rows and drives; a joint's row is its place in `joints`."""

    def __init__(
        self,
        joints: Mapping[str, JointSpec],
        placement: Placement,
        profiles: Profiles,
        findings: Findings,
    ) -> None:
        self.rows: list[Joint] = []
        self.drives: list[Drive] = []
        self._joints = joints
        self._numbers = {name: number for number, name in enumerate(joints)}
        self._placement = placement
        self._profiles = profiles
        self._findings = findings

    def add(self, name: str, spec: JointSpec) -> None:
        """One declared joint."""
        if spec.type == "distance":
            self._add_distance(name, spec)
        elif spec.type == "gear":
            self._add_gear(spec)
        else:
            self._add_anchored(spec)

    def add_stops(self, spec: Any, limits: tuple[float, float]) -> None:
        """Hard stops for the distance between two anchors, each in its body's own frame."""
        self.drives.append(Drive(len(self.rows), 0, limits, spec.restitution))
        self._append(Joint(JointKind.STOPS, *self._tied(spec), WORLD_AXES), spec)

    def _add_distance(self, name: str, spec: DistanceJoint) -> None:
        if spec.limits is not None:
            self.add_stops(spec, spec.limits)
            return
        joint = Joint(JointKind.DISTANCE, *self._tied(spec), WORLD_AXES)
        if joint.placed < COINCIDING:
            hint = "move one of them, or use type: ball to hold two points together"
            message = "has no direction: its anchors coincide at the start"
            self._findings.error(("joints", name, "anchors"), message, hint=hint)
        length = joint.placed if spec.length is None else spec.length
        self._append(replace(joint, parameters=(length,)), spec)

    def _add_gear(self, spec: GearJoint) -> None:
        """Its bodies are the ones that turn: the second of each joint that it couples."""
        ends = (self._second(spec.joints[0]), self._second(spec.joints[1]))
        parameters = (spec.ratio, *(float(self._numbers[name]) for name in spec.joints))
        self._append(Joint(JointKind.GEAR, ends, (NO_ARM, NO_ARM), WORLD_AXES, parameters), spec)

    def _add_anchored(self, spec: Any) -> None:
        from physsim.scene.spec.joints import drives_of  # noqa: PLC0415, pydantic is slow to import

        a, b = (self._placement[name] for name in spec.between)
        for coordinate, _, driven in drives_of(spec):
            found = drives.drive(driven, len(self.rows), coordinate, self._profiles)
            if found.does_something:
                self.drives.append(found)
        anchors = (a.arm_of_world(spec.anchor), b.arm_of_world(spec.anchor))
        frame = _FRAMES[spec.type](spec) if spec.type in _FRAMES else WORLD_AXES
        parameters = _PARAMETERS[spec.type](spec) if spec.type in _PARAMETERS else ()
        self._append(Joint(JointKind[spec.type.upper()], (a, b), anchors, frame, parameters), spec)

    def _append(self, joint: Joint, spec: Any) -> None:
        """The joint with what its kind may have besides."""
        damping = spec.damping if joint.kind in (JointKind.BALL, JointKind.CONE) else 0.0
        breaking = (_or_never(spec, "break_force"), _or_never(spec, "break_torque"))
        self.rows.append(replace(joint, damping=damping, breaking=breaking))

    def _second(self, name: str) -> Placed:
        joint = self._joints[name]
        assert joint.type != "gear"  # the scene room refuses gears of gears
        return self._placement[joint.between[1]]

    def _tied(self, spec: Any) -> tuple[tuple[Placed, Placed], tuple[FloatArray, FloatArray]]:
        """Ends and arms of what has anchors in the frames of its bodies."""
        a, b = (self._placement[name] for name in spec.between)
        return (a, b), (a.arm_of_own(spec.anchors[0]), b.arm_of_own(spec.anchors[1]))


def _axis_of(row: Joint) -> FloatArray:
    """The z axis of its frame, seen from A."""
    if row.kind.name.lower() not in _FRAMES:
        return NO_AXIS
    return row.ends[0].axis_of_world(rotation.matrix(row.frame)[:, 2])


def _or_never(spec: Any, name: str) -> float:
    limit = getattr(spec, name, None)
    return inf if limit is None else float(limit)


def _padded(parameters: Sequence[float]) -> tuple[float, ...]:
    return (*parameters, *[0.0] * (4 - len(parameters)))


def _planar_frame(spec: Any) -> FloatArray:
    if spec.axis is None:
        return rotation.from_z_to(spec.normal)
    return rotation.from_axes(spec.normal, spec.axis)


def _along_axis(spec: Any) -> FloatArray:
    return rotation.from_z_to(spec.axis)


_FRAMES: Mapping[str, Callable[[Any], FloatArray]] = MappingProxyType(
    {
        **dict.fromkeys(("hinge", "slider", "screw", "cylindrical", "cone"), _along_axis),
        "universal": lambda spec: rotation.from_axes(*spec.axes),
        "planar": _planar_frame,
    }
)
"""Joint -> world at the start, of the joints that have an axis."""

_PARAMETERS: Mapping[str, Callable[[Any], tuple[float, ...]]] = MappingProxyType(
    {
        "cone": lambda spec: (spec.max_angle, spec.restitution),
        "screw": lambda spec: (spec.pitch / (2 * pi),),
    }
)
