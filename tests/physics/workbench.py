"""Mechanisms from YAML text, stepped directly: a `Lab` that knows joints, and the other side of each test, a
motion integrated in as few coordinates as it has.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from laboratory import Array, Lab, yaml_of

SCHEMES = ["explicit_euler", "semi_implicit_euler", "verlet", "velocity_verlet", "leapfrog", "rk4"]
HEAD = """
physsim: 1
simulation: {duration: 1000 s, timestep: %r%s}
world: {gravity: %s}
mixing: {restitution: minimum, friction: geometric_mean}
materials:
  stuff: {density: 1000, restitution: %r, static_friction: %r, kinetic_friction: %r}
"""


class Bench(Lab):
    """A world with joints by name."""

    def joint(self, name: str) -> dict[str, Array]:
        """Force and torque on its first body, coordinates, violations, broken."""
        row = list(self.model.spec.joints).index(name)
        return {key: np.array(values)[row] for key, values in self.world.joints().items()}

    def angle(self, name: str) -> float:
        """The first coordinate of a joint [rad or m]."""
        return float(self.joint(name)["coordinate"])

    def books(self) -> dict[str, float]:
        """Energies and running sums [J]."""
        return {key: float(value) for key, value in self.world.energies().items()}

    def energy(self) -> float:
        """Kinetic and potential, springs included [J]."""
        e = self.books()
        kinetic = e["kinetic_translational"] + e["kinetic_rotational"]
        return kinetic + e["gravitational"] + e["gravitation"] + e["spring"]

    def worst_violation(self) -> tuple[float, float]:
        """Of all joints, [m] and [rad]."""
        found = self.world.joints()
        return float(np.max(found["violation"])), float(np.max(found["angular_violation"]))


def bench(
    bodies: str,
    joints: Mapping[str, Mapping[str, Any]],
    *,
    timestep: float = 1e-3,
    gravity: Any = (0, 0, -9.81),
    scheme: str = "semi_implicit_euler",
    e: float = 0.0,
    mu: float = 0.0,
    more: str = "",
    **settings: Any,
) -> Bench:
    """A world of `bodies` (YAML lines, as `laboratory.body` makes them) and `joints` by name; `more` is
    YAML that follows, `settings` go into `simulation`.
    """
    given = {"integrator": scheme, **settings}
    extra = "".join(f", {key}: {yaml_of(value)}" for key, value in given.items())
    text = HEAD % (timestep, extra, yaml_of(gravity), e, mu, mu) + "bodies:\n" + bodies
    if joints:
        text += "joints:\n" + "".join(f"  {name}: {flow(joint)}\n" for name, joint in joints.items())
    return Bench(text + more)


def flow(value: Any) -> str:
    """YAML in flow style; tuples and lists may hold names."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key}: {flow(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, (tuple, list)):
        return "[" + ", ".join(flow(inner) for inner in value) + "]"
    return yaml_of(value)


def moved(rates: Callable[[float, Array], Array], start: Array, times: Any) -> Array:
    """(T, n) states of y' = rates(t, y) at the times, by Dormand and Prince's method of order 8."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415

    found = solve_ivp(
        rates,
        (0.0, float(np.max(times))),
        start,
        "DOP853",
        t_eval=np.atleast_1d(times),
        rtol=1e-13,
        atol=1e-13,
    )
    return np.asarray(found.y.T)
