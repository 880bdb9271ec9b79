"""What acts everywhere."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.values import Acceleration, Number


class WorldSpec(Spec):
    """Gravity and gravitation."""

    gravity: tuple[Acceleration, Acceleration, Acceleration] = Field(
        default=(0.0, 0.0, -9.81), description="Uniform acceleration [m/s^2]."
    )
    gravitation: Annotated[float, Number(kinds.GRAVITATION, at_least=0)] = Field(
        default=0.0,
        description="Constant G of attraction between bodies [m^3/(kg s^2)], at least 0; 0 turns it off.",
    )
