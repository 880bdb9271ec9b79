"""Erin Catto's Box3D, through the C interface that robox3d carries."""

from __future__ import annotations

from typing import Any

import numpy as np
from robox3d._ffi import ffi, lib, shim

from benchmarks.bodies import local_anchor
from benchmarks.peers import State
from benchmarks.scene import LEVEL, Body, Obstacle, Scene

SETTINGS: dict[str, dict[str, Any]] = {"default": {}, "once": {"substeps": 1}, "more": {"substeps": 8}}


def version() -> str:
    found = lib.b3GetVersion()
    return f"{found.major}.{found.minor}.{found.revision}"


def _vec(p: Any) -> dict[str, float]:
    return dict(zip("xyz", map(float, p), strict=True))


class World:
    def __init__(self, scene: Scene, timestep: float, threads: int = 1, substeps: int = 4) -> None:
        self._timestep, self._substeps = timestep, substeps
        self._scene = scene
        definition = lib.b3DefaultWorldDef()
        definition.gravity = _vec((0, 0, -scene.gravity))
        definition.workerCount, definition.enableSleep = threads, False
        self._world = lib.b3CreateWorld(ffi.addressof(definition))
        self._hull = _hull(scene)
        for obstacle in scene.obstacles:
            self._stand(obstacle)
        bodies = [self._move(body) for body in scene.bodies]
        self._join(bodies)
        self._bodies = ffi.new("b3BodyId[]", bodies)

    def _body(self, position: Any, body: Body | None) -> Any:
        definition = lib.b3DefaultBodyDef()
        definition.position = _vec(position)
        w, x, y, z = body.orientation if body else LEVEL
        definition.rotation.s, definition.rotation.v = w, _vec((x, y, z))
        definition.type = lib.b3_dynamicBody if body else lib.b3_staticBody
        if body:
            definition.linearVelocity, definition.angularVelocity = _vec(body.velocity), _vec(body.spin)
        return lib.b3CreateBody(self._world, ffi.addressof(definition))

    def _shape(self, body: Any, kind: str, size: Any, density: float) -> None:
        definition = lib.b3DefaultShapeDef()
        definition.density = density
        definition.baseMaterial.friction, definition.baseMaterial.restitution = self._scene.friction, 0.0
        if not self._scene.collides:
            definition.filter.maskBits = 0
        told = ffi.addressof(definition)
        if kind == "sphere":
            lib.b3CreateSphereShape(
                body, told, ffi.new("b3Sphere*", {"center": _vec((0, 0, 0)), "radius": size[0]})
            )
        elif kind == "capsule":
            ends = {"center1": _vec((0, 0, -size[1])), "center2": _vec((0, 0, size[1])), "radius": size[0]}
            lib.b3CreateCapsuleShape(body, told, ffi.new("b3Capsule*", ends))
        elif kind == "box":
            made = ffi.new("b3BoxHull*", lib.b3MakeBoxHull(*map(float, size)))
            lib.b3CreateHullShape(body, told, ffi.addressof(made[0], "base"))
        else:
            lib.b3CreateHullShape(body, told, self._hull)

    def _stand(self, obstacle: Obstacle) -> None:
        below = obstacle.kind == "ground"
        place = (0, 0, -obstacle.size[2]) if below else obstacle.position
        self._shape(self._body(place, None), "box", obstacle.size, 0.0)

    def _move(self, body: Body) -> Any:
        made = self._body(body.position, body)
        self._shape(made, body.kind, body.size, body.density)
        return made

    def _join(self, bodies: list[Any]) -> None:
        if not self._scene.joints:
            return
        ground = self._body((0, 0, 0), None)
        for joint in self._scene.joints:
            definition = lib.b3DefaultSphericalJointDef()
            base = definition.base
            base.bodyIdA = ground if joint.parent < 0 else bodies[joint.parent]
            base.bodyIdB = bodies[joint.child]
            base.localFrameA.p = _vec(local_anchor(self._scene, joint, joint.parent))
            base.localFrameB.p = _vec(local_anchor(self._scene, joint, joint.child))
            lib.b3CreateSphericalJoint(self._world, ffi.addressof(definition))

    def step(self, count: int) -> None:
        shim.rxWorldStepN(self._world, self._timestep, self._substeps, count)

    def state(self) -> State:
        count = len(self._bodies)
        poses, rates = np.empty((count, 7), np.float32), np.empty((count, 6), np.float32)
        shim.rxBodyGetPoses(self._bodies, count, ffi.cast("float*", ffi.from_buffer(poses)))
        shim.rxBodyGetVelocities(self._bodies, count, ffi.cast("float*", ffi.from_buffer(rates)))
        p, r = poses.astype(float), rates.astype(float)
        return p[:, :3], p[:, [6, 3, 4, 5]], r[:, :3], r[:, 3:]

    def close(self) -> None:
        lib.b3DestroyWorld(self._world)


def _hull(scene: Scene) -> Any:
    if scene.hull is None:
        return None
    points = ffi.new("b3Vec3[]", [_vec(p) for p in scene.hull])
    return lib.b3CreateHull(points, len(scene.hull), len(scene.hull))
