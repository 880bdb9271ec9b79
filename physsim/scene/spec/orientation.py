"""Orientations: one of four ways to write a rotation, and the unit quaternion that each of them means."""

from __future__ import annotations

import math
from typing import Any

from pydantic import ConfigDict, Field, model_validator

from physsim.scene.spec.base import Spec
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Angle, PlainNumber, UnitVector, normalized

Quaternion = tuple[float, float, float, float]
_FORMS = ("quaternion", "axis", "euler_xyz", "rotation_vector")


class OrientationSpec(Spec):
    """A rotation body -> world: exactly one of quaternion, axis with angle, euler_xyz and rotation_vector."""

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {"required": ["quaternion"]},
                {"required": ["axis", "angle"]},
                {"required": ["euler_xyz"]},
                {"required": ["rotation_vector"]},
            ]
        }
    )
    quaternion: tuple[PlainNumber, PlainNumber, PlainNumber, PlainNumber] | None = Field(
        default=None, description="Quaternion [w, x, y, z], not zero; brought to length 1."
    )
    axis: UnitVector | None = Field(default=None, description="Axis of rotation, not zero; with angle.")
    angle: Angle | None = Field(
        default=None, description="Angle about axis [rad], right-handed.", examples=["30 deg"]
    )
    euler_xyz: tuple[Angle, Angle, Angle] | None = Field(
        default=None,
        description="Angles [rad] about the body's x, then its new y, then its new z: R = Rx Ry Rz.",
    )
    rotation_vector: tuple[Angle, Angle, Angle] | None = Field(
        default=None, description="Axis times angle [rad], right-handed; zero is no rotation."
    )

    @model_validator(mode="after")
    def _one_form(self) -> OrientationSpec:
        given = [form for form in _FORMS if getattr(self, form) is not None]
        if self.angle is not None and self.axis is None:
            raise slip("needs axis beside it", at=("angle",), points_at_key=True)
        if self.axis is not None and self.angle is None:
            raise slip("needs angle beside it", at=("axis",), points_at_key=True)
        if len(given) != 1:
            what = f"not {' and '.join(given)} together" if given else "none is given"
            allowed = "quaternion, axis with angle, euler_xyz, rotation_vector"
            raise slip(
                f"needs exactly one way to write the rotation, {what}", allowed=allowed, points_at_key=True
            )
        if self.quaternion is not None:
            self._set_unit_quaternion(self.quaternion)
        return self

    def _set_unit_quaternion(self, given: Quaternion) -> None:
        if not any(given):
            raise slip("must not be the zero quaternion", at=("quaternion",))
        object.__setattr__(self, "quaternion", normalized(given))

    @classmethod
    def identity(cls) -> OrientationSpec:
        """No rotation."""
        return cls(quaternion=(1.0, 0.0, 0.0, 0.0))

    def as_quaternion(self) -> Quaternion:
        """The unit quaternion (w, x, y, z) of the rotation body -> world."""
        if self.quaternion is not None:
            return self.quaternion
        if self.axis is not None and self.angle is not None:
            return _about(self.axis, self.angle)
        if self.euler_xyz is not None:
            x, y, z = self.euler_xyz
            return _product(_product(_about((1, 0, 0), x), _about((0, 1, 0), y)), _about((0, 0, 1), z))
        vector: Any = self.rotation_vector
        angle = math.hypot(*vector)
        return _about([v / angle for v in vector], angle) if angle > 0 else (1.0, 0.0, 0.0, 0.0)


def _about(axis: Any, angle: float) -> Quaternion:
    """(cos a/2, sin a/2 u) for the rotation by a about the unit vector u."""
    c, s = math.cos(angle / 2), math.sin(angle / 2)
    return (c, s * axis[0], s * axis[1], s * axis[2])


def _product(p: Quaternion, q: Quaternion) -> Quaternion:
    """Hamilton's product: the rotation p after q, or, read in body axes, p followed by q."""
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )
