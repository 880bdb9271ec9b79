"""Small worlds from YAML text, stepped directly: the physics of the engine, not the files."""

from __future__ import annotations

from typing import Any

import numpy as np

from physsim.model import compile_scene
from physsim.scene.loader import load_scene_text
from physsim.simulation.world import build

Array = Any
GRAVITY = 9.81
HEAD = """
physsim: 1
simulation: {duration: 100 s, timestep: %r}
world: {gravity: [0, 0, %r]}
mixing: {restitution: minimum, friction: geometric_mean}
materials:
  %s
bodies:
"""


class Lab:
    """A world, its bodies by name. Positions are those of the centres of mass."""

    def __init__(self, text: str) -> None:
        self.model = compile_scene(load_scene_text(text))
        simulated = build(self.model)
        self.world, self._answer = simulated.world, simulated.answer
        self.timestep = float(self.model.spec.simulation.timestep)

    def index(self, name: str) -> int:
        return self.model.body_names.index(name)

    def run(self, seconds: float) -> Lab:
        """On by so many seconds, a whole number of steps."""
        steps = round(seconds / self.timestep)
        assert abs(steps * self.timestep - seconds) < 1e-9 * seconds
        return self.step(steps)

    def step(self, steps: int = 1) -> Lab:
        self.world.advance(steps, self._answer)
        return self

    def get(self, what: str, name: str) -> Array:
        """`position`, `velocity`, `angular_velocity` or `orientation` of a body."""
        return np.array(self.world.state()[what][self.index(name)])

    def all(self, what: str) -> Array:
        """The same of all bodies that move, in scene order."""
        return np.array(self.world.state()[what])[~self.model.fixed]

    def events(self) -> dict[str, Array]:
        return dict(self.world.events())

    def energy(self) -> float:
        """Kinetic and potential [J]."""
        e = self.world.energies()
        return float(e["kinetic_translational"] + e["kinetic_rotational"] + e["gravitational"])

    def momentum(self) -> tuple[Array, Array]:
        """Linear [kg m/s], and angular about the world's origin [kg m2/s], of the bodies that move."""
        moving = ~self.model.fixed
        mass, inertia = self.model.mass[moving], self.model.inertia[moving]
        x, v, w = (self.all(what) for what in ("position", "velocity", "angular_velocity"))
        turn = np.array([rotation(q) for q in self.all("orientation")])
        spin = np.einsum("nij,njk,nlk,nl->ni", turn, inertia, turn, w)
        p = mass[:, None] * v
        return p.sum(axis=0), (np.cross(x, p) + spin).sum(axis=0)


def rotation(q: Array) -> Array:
    """R of a unit quaternion (w, x, y, z), written out: independent of the package."""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


FLOOR = "  floor: {fixed: true, shape: {type: halfspace}, material: stuff}\n"


def lab(
    bodies: str,
    *,
    timestep: float = 1e-3,
    gravity: float = GRAVITY,
    e: float = 0.0,
    mu: float = 0.0,
    mu_k: float | None = None,
) -> Lab:
    """A scene of one material `stuff` (1000 kg/m^3, e, mu static, mu_k kinetic); `bodies` is YAML, gravity
    points down.
    """
    kinetic = mu if mu_k is None else mu_k
    friction = f"static_friction: {mu!r}, kinetic_friction: {kinetic!r}"
    stuff = f"stuff: {{density: 1000, restitution: {e!r}, {friction}}}"
    return Lab(HEAD % (timestep, -gravity, stuff) + bodies)


def body(name: str, shape: str, **fields: Any) -> str:
    """One entry of `bodies`: `body("ball", "type: sphere, radius: 0.1", position=(0, 0, 1))`."""
    parts = [f"shape: {{{shape}}}", "material: stuff"]
    parts += [f"{key}: {yaml_of(value)}" for key, value in fields.items()]
    return f"  {name}: {{{', '.join(parts)}}}\n"


def yaml_of(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {yaml_of(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, str):
        return value
    if np.ndim(value):
        return "[" + ", ".join(yaml_of(inner) for inner in value) + "]"
    return str(value).lower() if isinstance(value, bool) else repr(float(value))
