"""PhysX 5 on the processor, through SAPIEN, with its settings: TGS, 10 position and 1 velocity iterations."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from benchmarks.bodies import local_anchor
from benchmarks.peers import State
from benchmarks.scene import LEVEL, Obstacle, Scene

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import sapien
    from sapien import physx

SETTINGS: dict[str, dict[str, Any]] = {"default": {}, "four": {"iterations": 4}, "more": {"iterations": 40}}
# SAPIEN's capsules and planes run along x.
X_TO_Z = [0.5**0.5, 0.0, -(0.5**0.5), 0.0]


def version() -> str:
    return f"5, sapien {sapien.__version__}"


class World:
    def __init__(self, scene: Scene, timestep: float, threads: int = 1, iterations: int = 10) -> None:
        self._scene = scene
        gravity = np.array([0, 0, -scene.gravity], np.float32)
        physx.set_scene_config(gravity=gravity, enable_tgs=True, cpu_workers=0 if threads == 1 else threads)
        physx.set_body_config(
            solver_position_iterations=iterations, solver_velocity_iterations=1, sleep_threshold=0.0
        )
        self._system = physx.PhysxCpuSystem()
        self._system.timestep = timestep
        self._stage = sapien.Scene([self._system])
        self._stuff = physx.PhysxMaterial(scene.friction, scene.friction, 0.0)
        for obstacle in scene.obstacles:
            self._stand(obstacle)
        self._bodies = [self._move(body) for body in scene.bodies]
        for joint in scene.joints:
            self._join(joint)

    def _shape(self, kind: str, size: Any) -> Any:
        stuff = self._stuff
        if kind == "sphere":
            shape = physx.PhysxCollisionShapeSphere(size[0], stuff)
        elif kind == "box":
            shape = physx.PhysxCollisionShapeBox(np.array(size, np.float32), stuff)
        elif kind == "capsule":
            shape = physx.PhysxCollisionShapeCapsule(size[0], size[1], stuff)
        elif kind == "ground":
            shape = physx.PhysxCollisionShapePlane(stuff)
        else:
            assert self._scene.hull is not None
            points = self._scene.hull.astype(np.float32)
            shape = physx.PhysxCollisionShapeConvexMesh(points, np.ones(3, np.float32), stuff)
        if kind in ("capsule", "ground"):
            shape.local_pose = sapien.Pose([0, 0, 0], X_TO_Z)
        if not self._scene.collides:
            shape.set_collision_groups([0, 0, 0, 0])
        return shape

    def _place(self, component: Any, position: Any, orientation: Any = LEVEL) -> None:
        entity = sapien.Entity()
        entity.add_component(component)
        entity.set_pose(sapien.Pose(list(position), list(orientation)))
        self._stage.add_entity(entity)

    def _stand(self, obstacle: Obstacle) -> None:
        component = physx.PhysxRigidStaticComponent()
        component.attach(self._shape(obstacle.kind, obstacle.size))
        self._place(component, obstacle.position)

    def _move(self, body: Any) -> Any:
        component, shape = physx.PhysxRigidDynamicComponent(), self._shape(body.kind, body.size)
        shape.set_density(body.density)
        component.attach(shape)
        component.set_linear_damping(0.0)
        component.set_angular_damping(0.0)
        self._place(component, body.position, body.orientation)
        if any(body.velocity) or any(body.spin):
            component.set_linear_velocity(list(body.velocity))
            component.set_angular_velocity(list(body.spin))
        return component

    def _join(self, joint: Any) -> None:
        """A drive without drives whose three lengths are locked."""
        child = self._bodies[joint.child]
        drive = physx.PhysxDriveComponent(child)
        if joint.parent >= 0:
            drive.set_parent(self._bodies[joint.parent])
        drive.set_pose_in_parent(sapien.Pose(list(local_anchor(self._scene, joint, joint.parent))))
        drive.set_pose_in_child(sapien.Pose(list(local_anchor(self._scene, joint, joint.child))))
        for lock in (drive.set_limit_x, drive.set_limit_y, drive.set_limit_z):
            lock(0.0, 0.0)
        child.entity.add_component(drive)

    def step(self, count: int) -> None:
        for _ in range(count):
            self._system.step()

    def state(self) -> State:
        poses = [body.entity_pose for body in self._bodies]
        return (
            np.array([pose.p for pose in poses], float),
            np.array([pose.q for pose in poses], float),
            np.array([body.linear_velocity for body in self._bodies], float),
            np.array([body.angular_velocity for body in self._bodies], float),
        )
