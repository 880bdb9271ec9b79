"""Springs and dampers between two bodies, or a body and the world."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import BodyPair
from physsim.scene.spec.values import Angle, Number, Position, UnitVector

DampingRatio = Annotated[float, Number(at_least=0, at_most=1000)]
_BETWEEN = "Names of the two bodies; `world` is one, and is fixed."
_RATIO = "Damping over critical damping, at least 0; in place of damping."


class LinearSpring(Spec):
    """A spring and damper along the line between two points.

    Force along the line: -k (length - rest length) - c d(length)/dt.
    """

    type: Literal["linear"]
    between: BodyPair = Field(description=_BETWEEN)
    anchors: tuple[Position, Position] = Field(
        default=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        description="Where it is tied, each in its body's own frame [m].",
    )
    rest_length: Annotated[float, Number(kinds.LENGTH, at_least=0)] | None = Field(
        default=None, description="Length without force [m], at least 0; the length as placed when left out."
    )
    stiffness: Annotated[float, Number(kinds.STIFFNESS, at_least=0)] = Field(
        description="Stiffness k [N/m], at least 0; 0 for a damper alone.", examples=["100 N/m"]
    )
    damping: Annotated[float, Number(kinds.DAMPING, at_least=0)] | None = Field(
        default=None,
        description="Damping coefficient c [N s/m], at least 0; 0 when left out.",
        examples=["5 N*s/m"],
    )
    damping_ratio: DampingRatio | None = Field(default=None, description=_RATIO)


class TorsionalSpring(Spec):
    """A spring and damper about an axis.

    Torque about the axis: -k (angle - rest angle) - c d(angle)/dt; the angle is 0 as placed.
    """

    type: Literal["torsional"]
    between: BodyPair = Field(description=_BETWEEN)
    axis: UnitVector = Field(
        description="Axis in world axes at the start, not zero; moves with the first body."
    )
    rest_angle: Angle = Field(
        default=0.0, description="Angle without torque [rad], counted from the angle as placed."
    )
    stiffness: Annotated[float, Number(kinds.TURNING_STIFFNESS, at_least=0)] = Field(
        description="Stiffness k [N m/rad], at least 0.", examples=["3 N*m/rad"]
    )
    damping: Annotated[float, Number(kinds.TURNING_DAMPING, at_least=0)] | None = Field(
        default=None, description="Damping coefficient c [N m s/rad], at least 0; 0 when left out."
    )
    damping_ratio: DampingRatio | None = Field(default=None, description=_RATIO)


SpringSpec = Annotated[LinearSpring | TorsionalSpring, Field(discriminator="type")]
