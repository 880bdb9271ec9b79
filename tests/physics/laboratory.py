"""Small worlds from YAML text, stepped directly: the physics of the engine, not the files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from physsim.model import compile_scene
from physsim.scene.loader import load_scene_text
from physsim.simulation.world import build

Array = Any
GRAVITY = 9.81
ENERGIES = ("kinetic_translational", "kinetic_rotational", "gravitational", "gravitation", "spring")
VERLET = ("verlet", "velocity_verlet", "leapfrog")
ORDERS = {"explicit_euler": 1, "semi_implicit_euler": 1, **dict.fromkeys(VERLET, 2), "rk4": 4}
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

    def joint(self, name: str) -> dict[str, Array]:
        """`coordinate`, `force`, `torque`, `violation` and what else is known of a joint."""
        row = list(self.model.spec.joints).index(name)
        return {key: np.array(values)[row] for key, values in self.world.joints().items()}

    def spring(self, name: str) -> tuple[float, float]:
        """Length [m] and tension [N], or angle [rad] and torque [N m]."""
        found, row = self.world.springs(), list(self.model.spec.springs).index(name)
        return float(found["length"][row]), float(found["force"][row])

    def events(self) -> dict[str, Array]:
        return dict(self.world.events())

    def energy(self) -> float:
        """Kinetic and potential [J]."""
        return sum(self.book(key) for key in ENERGIES)

    def book(self, name: str) -> float:
        """One number of the energy ledger [J]."""
        return float(self.world.energies()[name])

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


SCENE = """
physsim: 1
simulation: {duration: 1000 s, timestep: %r, integrator: %s}
world: {gravity: %s, gravitation: %r}
bodies:
"""
Entries = Mapping[str, Mapping[str, Any]]


def mechanics(
    bodies: Entries,
    *,
    springs: Entries | None = None,
    joints: Entries | None = None,
    forces: Entries | None = None,
    timestep: float = 1e-3,
    integrator: str = "rk4",
    gravity: Sequence[float] = (0, 0, 0),
    gravitation: float = 0.0,
) -> Lab:
    """Bodies that do not collide, each `name: {field: value}`; balls of 1 kg unless they say otherwise."""
    ball = {"shape": {"type": "sphere", "radius": 0.1}, "mass": 1.0, "collides": False}
    text = SCENE % (float(timestep), integrator, yaml_of(gravity), gravitation)
    text += lines({name: ball | dict(fields) for name, fields in bodies.items()})
    parts = {"springs": springs, "joints": joints, "forces": forces}
    return Lab(text + "".join(f"{key}:\n{lines(part)}" for key, part in parts.items() if part))


def lines(entries: Entries) -> str:
    return "".join(f"  {name}: {yaml_of(fields)}\n" for name, fields in entries.items())


def samples(scene: Lab, times: Array, read: Callable[[Lab], Any]) -> Array:
    """(T, n): what `read` gives at the times [s], each a whole number of steps."""
    found, before = [], 0.0
    for time in times:
        if time > before:
            scene.run(time - before)
        found.append(np.ravel(read(scene)))
        before = time
    return np.array(found)


def measured(
    make: Callable[[float], Lab],
    read: Callable[[Lab], Any],
    truth: Array,
    times: Array,
    steps: Sequence[float],
) -> tuple[Array, Array]:
    """The greatest deviation of `read` from `truth` (T, n) at each timestep, and the order with which it
    falls from each to the next, which is half as long.
    """
    found = np.array([np.abs(samples(make(step), times, read) - truth).max() for step in steps])
    return found, np.log2(found[:-1] / found[1:])
