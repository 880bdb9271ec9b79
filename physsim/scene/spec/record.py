"""What is written to the trajectory file, and how often."""

from __future__ import annotations

from pydantic import Field

from physsim.scene.spec.base import Spec
from physsim.scene.spec.simulation import PositiveTime
from physsim.scene.spec.values import Switch


class RecordSpec(Spec):
    """The contents of the trajectory file."""

    every: PositiveTime = Field(
        default=0.01,
        description="Time between frames [s], a whole number of timesteps; about 10 ms when left out.",
        examples=["10 ms"],
    )
    contacts: Switch = Field(default=True, description="Whether contacts are written; impacts always are.")
    joints: Switch = Field(
        default=True, description="Whether forces and coordinates of joints and springs are written."
    )
    energy: Switch = Field(default=True, description="Whether the energy ledger is written.")
