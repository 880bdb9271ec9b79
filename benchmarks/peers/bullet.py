"""Bullet, through pybullet: every body a multibody, as its guide has it, a chain one multibody."""

from __future__ import annotations

from importlib.metadata import version as version_of
from typing import Any

import numpy as np
import pybullet as bullet

from benchmarks.bodies import conjugate, mass_and_inertia, rotated
from benchmarks.peers import State, Unable
from benchmarks.scene import Ball, Body, Floats, Quaternion, Scene

SETTINGS: dict[str, dict[str, Any]] = {"default": {}, "ten": {"iterations": 10}}
# Bullet multiplies the frictions of both bodies.
FREE: dict[str, float] = {"linearDamping": 0.0, "angularDamping": 0.0, "restitution": 0.0}


def version() -> str:
    return version_of("pybullet")


def _xyzw(q: Any) -> list[float]:
    w, x, y, z = map(float, q)
    return [x, y, z, w]


class World:
    def __init__(
        self, scene: Scene, timestep: float, threads: int = 1, iterations: int | None = None
    ) -> None:
        if threads > 1:
            raise Unable("pybullet steps on one thread")
        self._scene = scene
        self._shapes: dict[Any, int] = {}
        self._here = {"physicsClientId": bullet.connect(bullet.DIRECT)}
        bullet.setGravity(0, 0, -scene.gravity, **self._here)
        bullet.setTimeStep(timestep, **self._here)
        if iterations:
            bullet.setPhysicsEngineParameter(numSolverIterations=iterations, **self._here)
        self._friction = {"lateralFriction": scene.friction**0.5}
        for obstacle in scene.obstacles:
            shape = self._shape(obstacle.kind, obstacle.size)
            made = bullet.createMultiBody(0, shape, basePosition=obstacle.position, **self._here)
            bullet.changeDynamics(made, -1, restitution=0.0, **self._friction, **self._here)
        self._masses: dict[Any, tuple[float, Floats]] = {}
        if scene.joints:
            self._bodies = self._chain()
        else:
            self._bodies = [(self._move(body), -1) for body in scene.bodies]

    def _shape(self, kind: str, size: tuple[float, ...]) -> int:
        key = (kind, size)
        if key not in self._shapes:
            self._shapes[key] = bullet.createCollisionShape(**self._described(kind, size), **self._here)
        return int(self._shapes[key])

    def _described(self, kind: str, size: tuple[float, ...]) -> dict[str, Any]:
        if kind == "sphere":
            return {"shapeType": bullet.GEOM_SPHERE, "radius": size[0]}
        if kind == "box":
            return {"shapeType": bullet.GEOM_BOX, "halfExtents": size}
        if kind == "capsule":
            return {"shapeType": bullet.GEOM_CAPSULE, "radius": size[0], "height": 2 * size[1]}
        if kind == "ground":
            return {"shapeType": bullet.GEOM_PLANE}
        assert self._scene.hull is not None
        return {"shapeType": bullet.GEOM_MESH, "vertices": self._scene.hull.tolist()}

    def _mass(self, body: Body) -> tuple[float, Floats]:
        key = (body.kind, body.size, body.density)
        if key not in self._masses:
            self._masses[key] = mass_and_inertia(body, self._scene.hull)
        return self._masses[key]

    def _move(self, body: Body) -> int:
        mass, moments = self._mass(body)
        shape = self._shape(body.kind, body.size) if self._scene.collides else -1
        place = {"basePosition": body.position, "baseOrientation": _xyzw(body.orientation)}
        made = bullet.createMultiBody(mass, shape, **place, **self._here)
        bullet.changeDynamics(
            made, -1, localInertiaDiagonal=list(moments), **FREE, **self._friction, **self._here
        )
        if any(body.velocity) or any(body.spin):
            bullet.resetBaseVelocity(made, body.velocity, body.spin, **self._here)
        return int(made)

    def _chain(self) -> list[tuple[int, int]]:
        """One multibody: each link's frame is that of its joint, turned like the body."""
        scene, joints = self._scene, self._scene.joints
        if [j.child for j in joints] != list(range(len(scene.bodies))):
            raise Unable("only one chain in the order of its links")
        bodies = [scene.bodies[j.child] for j in joints]
        before: list[Quaternion] = [(1.0, 0.0, 0.0, 0.0), *(b.orientation for b in bodies[:-1])]
        anchors = np.array([j.anchor for j in joints])
        steps = np.diff(anchors, axis=0, prepend=anchors[:1])
        made = bullet.createMultiBody(
            0,
            -1,
            basePosition=anchors[0].tolist(),
            linkMasses=[self._mass(b)[0] for b in bodies],
            linkPositions=rotated(conjugate(np.array(before)), steps).tolist(),
            linkOrientations=[_xyzw(bodies[0].orientation), *[[0.0, 0.0, 0.0, 1.0]] * (len(bodies) - 1)],
            linkInertialFramePositions=[_from_joint(b, j) for b, j in zip(bodies, joints, strict=True)],
            linkInertialFrameOrientations=[[0.0, 0.0, 0.0, 1.0]] * len(bodies),
            linkParentIndices=list(range(len(bodies))),
            linkJointTypes=[bullet.JOINT_SPHERICAL] * len(bodies),
            linkJointAxis=[(0, 0, 1)] * len(bodies),
            linkCollisionShapeIndices=[-1] * len(bodies),
            linkVisualShapeIndices=[-1] * len(bodies),
            **self._here,
        )
        for k, body in enumerate(bodies):
            self._loosen(made, k, body)
        return [(int(made), k) for k in range(len(bodies))]

    def _loosen(self, made: int, link: int, body: Body) -> None:
        """No damping, and no motor, which Bullet puts on every joint."""
        moments = list(self._mass(body)[1])
        bullet.changeDynamics(
            made, link, localInertiaDiagonal=moments, jointDamping=0.0, **FREE, **self._here
        )
        still = {"targetPosition": [0, 0, 0, 1], "positionGain": 0, "velocityGain": 0, "force": [0, 0, 0]}
        bullet.setJointMotorControlMultiDof(made, link, bullet.POSITION_CONTROL, **still, **self._here)

    def step(self, count: int) -> None:
        for _ in range(count):
            bullet.stepSimulation(**self._here)

    def state(self) -> State:
        rows = [self._one(body, link) for body, link in self._bodies]
        x, q, v, w = (np.array(column, float) for column in zip(*rows, strict=True))
        return x, q[:, [3, 0, 1, 2]], v, w

    def _one(self, body: int, link: int) -> tuple[Any, Any, Any, Any]:
        if link < 0:
            x, q = bullet.getBasePositionAndOrientation(body, **self._here)
            return (x, q, *bullet.getBaseVelocity(body, **self._here))
        found = bullet.getLinkState(
            body, link, computeLinkVelocity=1, computeForwardKinematics=1, **self._here
        )
        return found[0], found[1], found[6], found[7]

    def close(self) -> None:
        bullet.disconnect(**self._here)


def _from_joint(body: Body, joint: Ball) -> list[float]:
    back = conjugate(np.array(body.orientation))
    place: list[float] = rotated(back, np.subtract(body.position, joint.anchor)).tolist()
    return place
