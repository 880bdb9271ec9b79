"""How easily the free coordinates of a joint move at the start, the other joints of the bodies left out."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from physsim.model import rotation
from physsim.model.joints import Joint, JointKind
from physsim.model.placement import Placed
from physsim.model.rotation import FloatArray

X, Y, Z, ABOUT_X, ABOUT_Y, ABOUT_Z = np.eye(6)
"""Motions of B relative to A in the joint's frame: three velocities of the anchor, three rates of turning."""

FREE: Mapping[JointKind, tuple[FloatArray, ...]] = MappingProxyType(
    {
        JointKind.HINGE: (ABOUT_Z,),
        JointKind.SLIDER: (Z,),
        JointKind.SCREW: (ABOUT_Z,),
        JointKind.CYLINDRICAL: (Z, ABOUT_Z),
        JointKind.UNIVERSAL: (ABOUT_Z, ABOUT_X),
        JointKind.PLANAR: (X, Y, ABOUT_Z),
        JointKind.BALL: (ABOUT_X, ABOUT_Y, ABOUT_Z),
        JointKind.CONE: (ABOUT_X, ABOUT_Y, ABOUT_Z),
    }
)
"""What each kind leaves free: its coordinates, in their order; of ball and cone, which have none, turning."""


def mobility(joint: Joint, coordinate: int) -> float:
    """Acceleration of the coordinate by a unit force or torque along it [1/kg or 1/(kg m^2)]."""
    free = np.array(FREE[joint.kind])
    return max(float(_mobility(joint, free)[coordinate, coordinate]), 0.0)


def greatest_mobility(joint: Joint) -> float:
    """The same along the direction in which it is greatest, of joints whose motions are all turning."""
    return max(float(np.linalg.eigvalsh(_mobility(joint, np.array(FREE[joint.kind])))[-1]), 0.0)


def _mobility(joint: Joint, free: FloatArray) -> FloatArray:
    """(f, f) accelerations of the free motions by forces along them.

    With K = J M^-1 J^T of the six relative motions, d the free ones and h what the joint holds: the Schur
    complement K_dd - K_dh K_hh^+ K_hd, which is what is left of their own mobility once the forces of the
    joint (those that keep the accelerations of h at zero) are eliminated.
    """
    K = sum(_relative(end, arm, joint) for end, arm in zip(joint.ends, joint.anchors, strict=True))
    held = _held(joint, free)
    across = held @ K @ free.T
    found: FloatArray = free @ K @ free.T - across.T @ np.linalg.pinv(held @ K @ held.T) @ across
    return found


def _held(joint: Joint, free: FloatArray) -> FloatArray:
    """Rows (h, 6) of what the joint holds; a screw holds the travel to the pitch times the angle."""
    others = [row for row in np.eye(6) if not any(row @ other for other in free)]
    if joint.kind is JointKind.SCREW:
        others = [Z - joint.parameters[0] * ABOUT_Z if row @ Z else row for row in others]
    return np.array(others)


def _relative(end: Placed, arm: FloatArray, joint: Joint) -> FloatArray:
    """J M^-1 J^T (6, 6) of one body: v + omega x r and omega in the joint's axes."""
    axes = rotation.matrix(joint.frame).T
    x, y, z = end.turn @ arm
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    linear, turning = np.hstack([axes, -axes @ cross]), np.hstack([np.zeros((3, 3)), axes])
    J = np.vstack([linear, turning])
    inverse = np.zeros((6, 6))
    inverse[:3, :3] = end.inverse_mass * np.eye(3)
    inverse[3:, 3:] = end.inverse_inertia
    found: FloatArray = J @ inverse @ J.T
    return found
