"""Rapier, through its own Python package."""

from __future__ import annotations

from importlib.metadata import version as version_of
from typing import Any

import numpy as np
import rapier3d as rapier

from benchmarks.bodies import local_anchor
from benchmarks.peers import State
from benchmarks.scene import Body, Obstacle, Scene

SETTINGS: dict[str, dict[str, Any]] = {"default": {}, "once": {"iterations": 1}, "more": {"iterations": 16}}


def version() -> str:
    return version_of("rapier3d")


class World:
    def __init__(
        self, scene: Scene, timestep: float, threads: int = 1, iterations: int | None = None
    ) -> None:
        self._scene = scene
        world = self._world = rapier.PhysicsWorld(gravity=(0.0, 0.0, -scene.gravity))
        world.set_num_threads(threads)
        world.integration_parameters.dt = timestep
        if iterations:
            world.integration_parameters.num_solver_iterations = iterations
        for obstacle in scene.obstacles:
            world.add_collider(self._surfaced(_standing(obstacle)))
        self._bodies = [self._move(body) for body in scene.bodies]
        self._join()

    def _surfaced(self, collider: Any) -> Any:
        made = collider.friction(self._scene.friction).restitution(0.0)
        return made if self._scene.collides else made.collision_groups(rapier.InteractionGroups.none())

    def _move(self, body: Body) -> Any:
        w, x, y, z = body.orientation
        pose = rapier.Isometry3(body.position, (x, y, z, w))
        made = (
            rapier.RigidBody.dynamic().position(pose).linvel(body.velocity).angvel(body.spin).can_sleep(False)
        )
        collider = self._surfaced(self._collider(body)).density(body.density)
        return self._world.add_body(made, [collider])

    def _collider(self, body: Body) -> Any:
        make = rapier.Collider
        if body.kind == "sphere":
            return make.ball(body.size[0])
        if body.kind == "box":
            return make.cuboid(*body.size)
        if body.kind == "capsule":
            return make.capsule_z(body.size[1], body.size[0])
        assert self._scene.hull is not None
        return make.convex_hull(self._scene.hull.astype(np.float32))

    def _join(self) -> None:
        if not self._scene.joints:
            return
        ground = self._world.add_body(rapier.RigidBody.fixed(), [])
        for joint in self._scene.joints:
            ends = [tuple(local_anchor(self._scene, joint, k)) for k in (joint.parent, joint.child)]
            made = rapier.SphericalJoint.builder().local_anchor1(ends[0]).local_anchor2(ends[1]).build()
            parent = ground if joint.parent < 0 else self._bodies[joint.parent]
            self._world.impulse_joints.insert(parent, self._bodies[joint.child], made)

    def step(self, count: int) -> None:
        for _ in range(count):
            self._world.step()

    def state(self) -> State:
        found = [self._world.rigid_bodies[body] for body in self._bodies]
        turns = [body.rotation for body in found]
        x, v, w = (
            np.array([(p.x, p.y, p.z) for p in (getattr(body, name) for body in found)])
            for name in ("translation", "linvel", "angvel")
        )
        return x, np.array([(q.w, q.i, q.j, q.k) for q in turns]), v, w


def _standing(obstacle: Obstacle) -> Any:
    if obstacle.kind == "ground":
        return rapier.Collider.halfspace((0.0, 0.0, 1.0))
    return rapier.Collider.cuboid(*obstacle.size).translation(tuple(map(float, obstacle.position)))
