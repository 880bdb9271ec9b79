"""MuJoCo, with the joints of its minimal coordinates."""

from __future__ import annotations

import sys
from collections import defaultdict
from typing import Any
from xml.etree import ElementTree as Xml

import mujoco
import numpy as np

from benchmarks.bodies import conjugate, product, rotated
from benchmarks.peers import State
from benchmarks.scene import ORIGIN, Ball, Body, Obstacle, Scene

SETTINGS: dict[str, dict[str, Any]] = {"default": {}, "cg": {"solver": "CG"}, "rk4": {"integrator": "RK4"}}


def version() -> str:
    return str(mujoco.__version__)


def _told(values: Any) -> str:
    return " ".join(f"{value:.9g}" for value in np.ravel(values))


class World:
    def __init__(
        self,
        scene: Scene,
        timestep: float,
        threads: int = 1,
        solver: str = "Newton",
        integrator: str = "Euler",
    ) -> None:
        sys.setrecursionlimit(10_000)
        options = {"timestep": repr(timestep), "solver": solver, "integrator": integrator}
        self._model = mujoco.MjModel.from_xml_string(described(scene, options))
        self._data = mujoco.MjData(self._model)
        if threads > 1:
            mujoco.mju_threadpool(self._data, threads)
        self._bodies = [self._model.body(f"b{k}").id for k in range(len(scene.bodies))]
        self._start(scene)

    def _start(self, scene: Scene) -> None:
        """Free bodies have six speeds, velocity in world axes and spin in their own."""
        q, v, w = (scene.column(name) for name in ("orientation", "velocity", "spin"))
        if not scene.joints:
            speeds = self._data.qvel.reshape(-1, 6)
            speeds[:, :3], speeds[:, 3:] = v, rotated(conjugate(q), w)
        elif v.any():
            self._push(v)

    def _push(self, velocity: Any) -> None:
        """Least-squares joint speeds for the pushed bodies' velocities."""
        mujoco.mj_forward(self._model, self._data)
        rows, wanted = [], []
        for body, v in zip(self._bodies, velocity, strict=True):
            jacobian = np.zeros((3, self._model.nv))
            mujoco.mj_jacBodyCom(self._model, self._data, jacobian, None, body)
            rows.append(jacobian)
            wanted.append(v)
        self._data.qvel[:] = np.linalg.lstsq(np.concatenate(rows), np.concatenate(wanted), rcond=None)[0]

    def step(self, count: int) -> None:
        mujoco.mj_step(self._model, self._data, count)

    def state(self) -> State:
        model, data = self._model, self._data
        for refresh in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_comVel):
            refresh(model, data)
        rates = np.empty((len(self._bodies), 6))
        one = np.zeros(6)
        for k, body in enumerate(self._bodies):
            mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY, body, one, 0)
            rates[k] = one
        return data.xpos[self._bodies].copy(), data.xquat[self._bodies].copy(), rates[:, 3:], rates[:, :3]


def described(scene: Scene, options: dict[str, str]) -> str:
    """The scene as MJCF."""
    root = Xml.Element("mujoco")
    Xml.SubElement(root, "option", options, gravity=_told((0, 0, -scene.gravity)))
    Xml.SubElement(root, "size", memory="2G")
    Xml.SubElement(Xml.SubElement(root, "default"), "geom", friction=_told((scene.friction, 0.005, 1e-4)))
    if scene.hull is not None:
        Xml.SubElement(Xml.SubElement(root, "asset"), "mesh", name="hull", vertex=_told(scene.hull))
    world = Xml.SubElement(root, "worldbody")
    for obstacle in scene.obstacles:
        _stand(world, obstacle)
    children = defaultdict(list)
    for joint in scene.joints:
        children[joint.parent].append(joint)
    joined = {joint.child for joint in scene.joints}
    for k in range(len(scene.bodies)):
        if k not in joined:
            _add(world, scene, k, None, children)
    for joint in children[-1]:
        _add(world, scene, joint.child, joint, children)
    return Xml.tostring(root, encoding="unicode")


def _stand(world: Any, obstacle: Obstacle) -> None:
    ground = obstacle.kind == "ground"
    size = (0, 0, 1) if ground else obstacle.size
    Xml.SubElement(
        world, "geom", type="plane" if ground else "box", pos=_told(obstacle.position), size=_told(size)
    )


def _add(parent: Any, scene: Scene, k: int, joint: Ball | None, children: dict[int, list[Ball]]) -> None:
    """A body in its parent's axes, and all that hangs on it."""
    body = scene.bodies[k]
    place, turn = np.array(body.position), np.array(body.orientation)
    if joint is not None and joint.parent >= 0:
        above = scene.bodies[joint.parent]
        back = conjugate(np.array(above.orientation))
        place, turn = rotated(back, place - np.array(above.position)), product(back, turn)
    node = Xml.SubElement(parent, "body", name=f"b{k}", pos=_told(place), quat=_told(turn))
    if joint is None:
        Xml.SubElement(node, "freejoint")
    else:
        anchor = rotated(conjugate(np.array(body.orientation)), np.subtract(joint.anchor, body.position))
        Xml.SubElement(node, "joint", type="ball", pos=_told(anchor))
    Xml.SubElement(node, "geom", _shape(body, scene), density=_told(body.density))
    for below in children.get(k, []):
        _add(node, scene, below.child, below, children)


def _shape(body: Body, scene: Scene) -> dict[str, str]:
    alone = {} if scene.collides else {"contype": "0", "conaffinity": "0"}
    if body.kind == "hull":
        return {"type": "mesh", "mesh": "hull", **alone}
    return {"type": body.kind, "size": _told(body.size or ORIGIN), **alone}
