"""Jolt, through the C library in a PyPI package for Python 3.14; the library itself knows no interpreter.

pip download --no-deps --only-binary=:all: --python-version 3.14 simvx-physics-jolt==0.0.0.dev3104
unzip simvx_physics_jolt-*.whl -d FOLDER; export PHYSSIM_BENCH_JOLT=FOLDER
"""

from __future__ import annotations

import os
import runpy
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.bodies import product
from benchmarks.peers import State
from benchmarks.scene import Body, Obstacle, Scene

SETTINGS: dict[str, dict[str, Any]] = {
    "default": {},
    "tight": {"slop": 0.001},
    "more": {"slop": 0.001, "sweeps": 40},
}
# Jolt's capsules run along y: bodies are turned by this.
Y_TO_Z = np.array([0.5**0.5, 0.5**0.5, 0.0, 0.0])


def _library() -> tuple[Any, Any]:
    import cffi  # noqa: PLC0415, comes with Box3D's package

    folder = os.environ.get("PHYSSIM_BENCH_JOLT")
    if not folder:
        raise ImportError("PHYSSIM_BENCH_JOLT names no folder; see benchmarks/peers/jolt.py")
    home = Path(folder) / "simvx/physics/jolt"
    ffi = cffi.FFI()
    ffi.cdef(runpy.run_path(str(home / "_cdef.py"))["CDEF"])
    library = ffi.dlopen(str(home / "_lib/libsimvx_jolt.so"))
    library.JPH_Init()
    return ffi, library


ffi, lib = _library()


def version() -> str:
    return "5.5.0"


def _vec(p: Any) -> Any:
    return ffi.new("JPH_Vec3*", list(map(float, p)))


class World:
    def __init__(
        self, scene: Scene, timestep: float, threads: int = 1, slop: float = 0.02, sweeps: int = 10
    ) -> None:
        self._scene, self._timestep = scene, timestep
        self._shapes: dict[Any, Any] = {}
        count = len(scene.bodies)
        self._memory = lib.JPH_TempAllocator_Create((64 if count < 2000 else 512) << 20)
        self._jobs = lib.JPH_JobSystemThreadPool_Create(
            ffi.new("JobSystemThreadPoolConfig*", [2048, 8, threads - 1])
        )
        room = max(65536, 16 * count)
        self._system = lib.simvx_jolt_create_system(65536, room, room)
        self._bodies = lib.JPH_PhysicsSystem_GetBodyInterface(self._system)
        lib.JPH_PhysicsSystem_SetGravity(self._system, _vec((0, 0, -scene.gravity)))
        lib.simvx_jolt_set_world_settings(self._system, sweeps, 0.5, 0.03, slop)
        for obstacle in scene.obstacles:
            self._stand(obstacle)
        self._capsules = np.array([body.kind == "capsule" for body in scene.bodies])
        self._ids = self._all_moving()

    def _shape(self, kind: str, size: tuple[float, ...]) -> Any:
        key = (kind, tuple(size))
        if key not in self._shapes:
            self._shapes[key] = ffi.cast("JPH_Shape*", self._new_shape(kind, size))
        return self._shapes[key]

    def _new_shape(self, kind: str, size: tuple[float, ...]) -> Any:
        if kind == "sphere":
            return lib.JPH_SphereShape_Create(size[0])
        if kind == "box":
            return lib.JPH_BoxShape_Create(_vec(size), min(0.05, 0.5 * min(size)))
        if kind == "capsule":
            return lib.JPH_CapsuleShape_Create(size[1], size[0])
        assert self._scene.hull is not None
        points = ffi.new("JPH_Vec3[]", self._scene.hull.tolist())
        made = lib.JPH_ConvexHullShapeSettings_Create(points, len(self._scene.hull), 0.05)
        return lib.JPH_ConvexHullShapeSettings_CreateShape(made)

    def _made(self, shape: Any, position: Any, orientation: Any, moves: bool) -> Any:
        w, x, y, z = map(float, orientation)
        motion = lib.JPH_MotionType_Dynamic if moves else lib.JPH_MotionType_Static
        turn = ffi.new("JPH_Quat*", [x, y, z, w])
        layer = lib.simvx_jolt_object_layer()
        made = lib.JPH_BodyCreationSettings_Create3(shape, _vec(position), turn, motion, layer)
        lib.JPH_BodyCreationSettings_SetFriction(made, self._scene.friction)
        lib.JPH_BodyCreationSettings_SetRestitution(made, 0.0)
        # Sensors do not meet sensors.
        lib.JPH_BodyCreationSettings_SetIsSensor(made, not self._scene.collides)
        return made

    def _stand(self, obstacle: Obstacle) -> None:
        place = (0, 0, -obstacle.size[2]) if obstacle.kind == "ground" else obstacle.position
        self._add_still(obstacle.size, place)

    def _add_still(self, size: Any, place: Any) -> int:
        made = self._made(self._shape("box", size), place, (1, 0, 0, 0), moves=False)
        return int(
            lib.JPH_BodyInterface_CreateAndAddBody(self._bodies, made, lib.JPH_Activation_DontActivate)
        )

    def _move(self, body: Body) -> int:
        shape = self._shape(body.kind, body.size)
        turn = product(np.array(body.orientation), Y_TO_Z) if body.kind == "capsule" else body.orientation
        made = self._made(shape, body.position, turn, moves=True)
        lib.JPH_BodyCreationSettings_SetAllowSleeping(made, False)
        lib.JPH_BodyCreationSettings_SetLinearDamping(made, 0.0)
        lib.JPH_BodyCreationSettings_SetAngularDamping(made, 0.0)
        _set_mass(made, shape, body.density)
        number = lib.JPH_BodyInterface_CreateAndAddBody(self._bodies, made, lib.JPH_Activation_Activate)
        lib.JPH_BodyInterface_SetLinearAndAngularVelocity(
            self._bodies, number, _vec(body.velocity), _vec(body.spin)
        )
        return int(number)

    def _all_moving(self) -> Any:
        """All bodies, each joined to its parent as it comes.

        The C layer locks both bodies of a joint one after the other, by mutexes that bodies share; two bodies
        of one mutex lock for ever. The lowest bit of the mutex is `_parity` of the body's number, so that a
        body is put in between where parent and child would be alike.
        """
        joints = {joint.child: joint for joint in self._scene.joints}
        numbers: list[int] = []
        still = [self._spare() for _ in range(3)] if joints else []
        last = still[-1] if still else 0
        for k, body in enumerate(self._scene.bodies):
            parent = numbers[joints[k].parent] if k in joints and joints[k].parent >= 0 else None
            if parent is not None and _parity(last + 1) == _parity(parent):
                self._spare()
            last = self._move(body)
            numbers.append(last)
            if k in joints:
                ground = next((s for s in still if _parity(s) != _parity(last)), 0)
                first = ground if parent is None else parent
                lib.simvx_jolt_create_point(self._system, first, last, *map(float, joints[k].anchor))
        return ffi.new("JPH_BodyID[]", numbers)

    def _spare(self) -> int:
        return self._add_still((0.01, 0.01, 0.01), (0.0, 0.0, 1000.0))

    def step(self, count: int) -> None:
        for _ in range(count):
            error = lib.JPH_PhysicsSystem_Update2(self._system, self._timestep, 1, self._memory, self._jobs)
            if error:
                raise RuntimeError(f"Jolt's update said {error}")

    def state(self) -> State:
        count = len(self._ids)
        poses, rates = np.empty((count, 7), np.float32), np.empty((count, 6), np.float32)
        for read, into in (
            (lib.simvx_jolt_pack_transforms, poses),
            (lib.simvx_jolt_pack_velocities, rates),
        ):
            read(self._bodies, self._ids, count, ffi.cast("float*", ffi.from_buffer(into)))
        q = poses[:, [6, 3, 4, 5]].astype(float)
        back = Y_TO_Z * (1, -1, -1, -1)
        q = np.where(self._capsules[:, None], product(q, back), q)
        r = rates.astype(float)
        return poses[:, :3].astype(float), q, r[:, :3], r[:, 3:]

    def close(self) -> None:
        lib.JPH_PhysicsSystem_Destroy(self._system)
        lib.JPH_JobSystem_Destroy(self._jobs)
        lib.JPH_TempAllocator_Destroy(self._memory)


def _parity(number: int) -> int:
    index = number & 0x7FFFFF
    return (index ^ index >> 8 ^ index >> 16) & 1


def _set_mass(made: Any, shape: Any, density: float) -> None:
    """Jolt's shapes weigh 1000 kg/m^3."""
    mass = ffi.new("JPH_MassProperties*")
    lib.JPH_Shape_GetMassProperties(shape, mass)
    lib.JPH_MassProperties_ScaleToMass(mass, mass.mass * density / 1000.0)
    given = lib.JPH_OverrideMassProperties_MassAndInertiaProvided
    lib.JPH_BodyCreationSettings_SetOverrideMassProperties(made, given)
    lib.JPH_BodyCreationSettings_SetMassPropertiesOverride(made, mass)
