"""How the scene is stepped through time."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.values import Number, Whole

PositiveTime = Annotated[float, Number(kinds.TIME, above=0)]
SlowSpeed = Annotated[float, Number(kinds.SPEED, at_least=0)]
Integrator = Literal["explicit_euler", "semi_implicit_euler", "verlet", "velocity_verlet", "leapfrog", "rk4"]
# A step count this close to a whole number is that number: durations and timesteps are rounded to doubles.
ROUNDING = 1e-9


class SimulationSpec(Spec):
    """Duration, timestep, and the choices of method."""

    duration: PositiveTime = Field(
        description="Simulated time [s], greater than 0; the run ends with the first step that reaches it.",
        examples=["5 s"],
    )
    timestep: PositiveTime = Field(
        description="Time step [s], greater than 0, at most duration.", examples=["1 ms"]
    )
    integrator: Integrator = Field(default="semi_implicit_euler", description="Integration scheme.")
    impacts: Literal["stepped", "located"] = Field(
        default="stepped",
        description="Impacts at the end of the step, or located to the instant of touching.",
    )
    collision: Literal["auto", "fcl"] = Field(
        default="auto",
        description="The engine's own answers, or FCL for every pair.",
    )
    iterations: Annotated[int, Whole(1, 1_000_000)] = Field(
        default=50, description="Most sweeps of the contact solver per step, at least 1."
    )
    tolerance: Annotated[float, Number(kinds.SPEED, at_least=0)] = Field(
        default=1e-6,
        description="The solver stops when its residual is below this [m/s]; 0 uses every sweep.",
    )
    stabilization: Literal["split_impulse", "baumgarte"] = Field(
        default="split_impulse", description="How overlaps and joint errors are corrected."
    )
    baumgarte: Annotated[float, Number(at_least=0, at_most=1)] = Field(
        default=0.2, description="Share beta of an error that is corrected per step, 0 to 1."
    )
    slip_speed: SlowSpeed = Field(
        default=0.01, description="Relative speed [m/s] below which static friction holds, at least 0."
    )
    bounce_speed: SlowSpeed = Field(
        default=0.0, description="Approach speed [m/s] below which restitution counts as 0, at least 0."
    )
    until: Literal["at_rest"] | None = Field(
        default=None, description="End early once nothing moves any more; runs for duration when left out."
    )
    seed: Annotated[int, Whole(0, 2**63 - 1)] = Field(
        default=0, description="Seed of everything random, at least 0; kept in the trajectory file."
    )
    threads: Annotated[int, Whole(1, 1024)] = Field(
        default=1, description="Threads of the engine, at least 1; results are the same for every number."
    )

    @property
    def steps(self) -> int:
        """Number of steps of a run through the whole duration: the first that reaches it is the last."""
        exact = self.duration / self.timestep
        return max(1, math.ceil(exact - ROUNDING * max(1.0, exact)))
