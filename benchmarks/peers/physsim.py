"""physsim, through the scene language: what `physsim run` steps."""

from __future__ import annotations

import json
from importlib.metadata import version as version_of
from typing import Any

import numpy as np

from benchmarks.peers import State
from benchmarks.scene import Body, Obstacle, Scene
from physsim.model import Model, compile_scene
from physsim.scene.loader import load_scene_text
from physsim.simulation.world import build

SETTINGS: dict[str, dict[str, Any]] = {
    "default": {},
    "sweeps10": {"iterations": 10},
    "sweeps4": {"iterations": 4},
    "verlet": {"integrator": "velocity_verlet"},
    "rk4": {"integrator": "rk4"},
}
# Of most bodies [kg/m^3].
DENSITY = 1000.0


def version() -> str:
    return version_of("physsim")


class World:
    def __init__(self, scene: Scene, timestep: float, threads: int = 1, **setting: Any) -> None:
        told = tuple({"timestep": timestep, "threads": threads, **setting}.items())
        simulated = build(_compiled(scene, told))
        self._world, self._answer = simulated.world, simulated.answer
        self._moving = len(scene.bodies)

    def step(self, count: int) -> None:
        self._world.advance(count, self._answer)

    def state(self) -> State:
        state = self._world.state()
        names = ("position", "orientation", "velocity", "angular_velocity")
        x, q, v, w = (np.asarray(state[name])[: self._moving] for name in names)
        return x, q, v, w


_MODELS: dict[Any, Model] = {}


def _compiled(scene: Scene, told: tuple[tuple[str, Any], ...]) -> Model:
    """The model, compiled once for all worlds of a batch. JSON is YAML."""
    key = (scene.name, told)
    if key not in _MODELS:
        _MODELS[key] = compile_scene(load_scene_text(described(scene, dict(told))))
    return _MODELS[key]


def described(scene: Scene, simulation: dict[str, Any]) -> str:
    """The scene in physsim's language, as JSON."""
    stuff = {"between": ["stuff", "stuff"], "restitution": 0.0}
    friction = {"static_friction": scene.friction, "kinetic_friction": scene.friction}
    bodies = {f"b{k}": _moving(body, scene) for k, body in enumerate(scene.bodies)}
    bodies |= {f"o{k}": _standing(obstacle) for k, obstacle in enumerate(scene.obstacles)}
    return json.dumps(
        {
            "physsim": 1,
            "world": {"gravity": [0.0, 0.0, -scene.gravity]},
            "simulation": {"duration": scene.duration, **simulation},
            "materials": {"stuff": {"density": DENSITY}},
            "pairs": [stuff | friction],
            "bodies": bodies,
            "joints": {
                f"j{k}": {
                    "type": "ball",
                    "between": ["world" if j.parent < 0 else f"b{j.parent}", f"b{j.child}"],
                    "anchor": list(j.anchor),
                }
                for k, j in enumerate(scene.joints)
            },
        }
    )


def _moving(body: Body, scene: Scene) -> dict[str, Any]:
    """With what is not as it is anyway."""
    shape = _shape(body.kind, body.size, scene)
    told: dict[str, Any] = {"shape": shape, "material": "stuff", "position": list(body.position)}
    if body.density != DENSITY:
        told["density"] = body.density
    if body.orientation != (1.0, 0.0, 0.0, 0.0):
        told["orientation"] = {"quaternion": list(body.orientation)}
    if any(body.velocity) or any(body.spin):
        told |= {"velocity": list(body.velocity), "angular_velocity": list(body.spin)}
    return told if scene.collides else told | {"collides": False}


def _standing(obstacle: Obstacle) -> dict[str, Any]:
    if obstacle.kind == "ground":
        shape: dict[str, Any] = {"type": "halfspace", "normal": [0, 0, 1]}
    else:
        shape = {"type": "box", "size": [2 * s for s in obstacle.size]}
    return {"fixed": True, "shape": shape, "material": "stuff", "position": list(obstacle.position)}


def _shape(kind: str, size: tuple[float, ...], scene: Scene) -> dict[str, Any]:
    if kind == "sphere":
        return {"type": "sphere", "radius": size[0]}
    if kind == "box":
        return {"type": "box", "size": [2 * s for s in size]}
    if kind == "capsule":
        return {"type": "capsule", "radius": size[0], "height": 2 * size[1]}
    assert scene.hull is not None
    return {"type": "convex", "points": scene.hull.tolist()}
