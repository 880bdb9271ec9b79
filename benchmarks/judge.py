"""How good a motion is, from poses and velocities alone; the same for all engines.

Overlaps are measured by physsim's closed forms, which `tests/collision` holds against FCL, in 64 bits,
whatever engine it was. Everything in SI.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from benchmarks.bodies import conjugate, local_anchor, mass_and_inertia, rotated
from benchmarks.peers import State
from benchmarks.scene import Ball, Floats, Scene

MARGIN = 1e-3


@dataclass(frozen=True)
class Sample:
    """A state and when it was, s."""

    time: float
    state: State


class Judge:
    """Measures of one scene."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        known: dict[Any, tuple[float, Floats]] = {}
        for body in scene.bodies:
            key = (body.kind, body.size, body.density)
            if key not in known:
                known[key] = mass_and_inertia(body, scene.hull)
        both = [known[body.kind, body.size, body.density] for body in scene.bodies]
        self._mass = np.array([mass for mass, _ in both])
        self._moments = np.array([moments for _, moments in both])
        self._overlaps: Overlaps | None = None

    def verdict(self, samples: list[Sample]) -> dict[str, float]:
        """All measures that the scene has."""
        if not all(np.isfinite(part).all() for sample in samples for part in sample.state):
            return {"blew_up": 1.0}
        if self._scene.joints:
            return self._of_joints(samples)
        return self._of_contacts(samples) if self._scene.collides else self._of_flight(samples)

    def kinetic(self, state: State) -> float:
        """[J]"""
        _, q, v, w = state
        own = rotated(conjugate(q), w)
        return 0.5 * float((self._mass * (v * v).sum(axis=1)).sum() + (self._moments * own * own).sum())

    def energy(self, state: State) -> float:
        """[J], gravity included."""
        return self.kinetic(state) + self._scene.gravity * float(self._mass @ state[0][:, 2])

    def spin(self, state: State) -> Floats:
        """Angular momenta (N, 3) about the centres of mass."""
        _, q, _, w = state
        return rotated(q, self._moments * rotated(conjugate(q), w))

    def deepest(self, state: State) -> float:
        """Deepest overlap of any two bodies, or body and obstacle [m]."""
        self._overlaps = self._overlaps or Overlaps(self._scene)
        return self._overlaps.deepest(state)

    def joint_gap(self, state: State) -> float:
        """Widest distance between the two points of a joint [m]."""
        return max(
            float(np.linalg.norm(self._end(j, j.parent, state) - self._end(j, j.child, state)))
            for j in self._scene.joints
        )

    def _end(self, joint: Ball, body: int, state: State) -> Floats:
        anchor = local_anchor(self._scene, joint, body)
        return anchor if body < 0 else state[0][body] + rotated(state[1][body], anchor)

    def _of_contacts(self, samples: list[Sample]) -> dict[str, float]:
        resting = [s for s in samples if s.time >= self._scene.rest[0]] or samples[-1:]
        moved = samples[-1].state[0] - self._scene.column("position")
        speeds = [(2 * self.kinetic(s.state) / self._mass.sum()) ** 0.5 for s in resting]
        found = {
            "depth_peak": max(self.deepest(s.state) for s in samples),
            "depth_rest": float(np.median([self.deepest(s.state) for s in resting])),
            "speed_rest": float(np.median(speeds)),
            "escaped": float((samples[-1].state[0][:, 2] < -0.05).sum()),
        }
        if self._scene.name.startswith(("pyramid", "columns")):
            found["drift"] = float(np.linalg.norm(moved, axis=1).max())
        return found

    def _of_joints(self, samples: list[Sample]) -> dict[str, float]:
        begin = self.energy(self._start())
        scale = max(self.kinetic(s.state) for s in samples) or 1.0
        return {
            "joint_error": max(self.joint_gap(s.state) for s in samples),
            "energy_error": max(abs(self.energy(s.state) - begin) for s in samples) / scale,
        }

    def _of_flight(self, samples: list[Sample]) -> dict[str, float]:
        start, end = self._start(), samples[-1].state
        before, after = self.spin(start), self.spin(end)
        error = np.linalg.norm(after - before, axis=1) / np.linalg.norm(before, axis=1)
        return {
            "energy_error": abs(self.kinetic(end) / self.kinetic(start) - 1),
            "spin_error": float(np.median(error)),
        }

    def _start(self) -> State:
        x, q, v, w = (self._scene.column(name) for name in ("position", "orientation", "velocity", "spin"))
        return x, q, v, w


class Overlaps:
    """Depths of near pairs: one world of one body per distinct shape answers for all."""

    def __init__(self, scene: Scene) -> None:
        from benchmarks.peers.physsim import described  # noqa: PLC0415
        from physsim._engine import World  # noqa: PLC0415
        from physsim.model import compile_scene  # noqa: PLC0415
        from physsim.scene.loader import load_scene_text  # noqa: PLC0415

        shapes = list(dict.fromkeys((body.kind, body.size) for body in scene.bodies))
        kinds = [next(b for b in scene.bodies if (b.kind, b.size) == shape) for shape in shapes]
        sample = replace(scene, bodies=tuple(kinds), joints=())
        text = described(sample, {"timestep": 1e-3})
        self._world = World(compile_scene(load_scene_text(text)).engine_input())
        self._geom = [shapes.index((body.kind, body.size)) for body in scene.bodies]
        self._walls = [(len(shapes) + k, o) for k, o in enumerate(scene.obstacles)]
        self._reach = np.array([_reach(body.kind, body.size, scene) for body in scene.bodies])

    def deepest(self, state: State) -> float:
        from scipy.spatial import cKDTree  # noqa: PLC0415

        x, q = state[0], state[1] / np.linalg.norm(state[1], axis=1, keepdims=True)
        poses = np.concatenate([x, q], axis=1)
        pairs = cKDTree(x).query_pairs(2 * self._reach.max() + MARGIN, output_type="ndarray")
        apart = np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1)
        near = pairs[apart < self._reach[pairs].sum(axis=1)]
        among = (self._depth(self._geom[i], poses[i], self._geom[j], poses[j]) for i, j in near)
        return max([0.0, *among, *self._against_walls(poses)])

    def _against_walls(self, poses: Floats) -> list[float]:
        found = []
        for geom, wall in self._walls:
            place = np.array([*wall.position, 1.0, 0.0, 0.0, 0.0])
            near = np.flatnonzero(self._clearance(poses[:, :3], wall) < self._reach)
            found += [self._depth(self._geom[i], poses[i], geom, place) for i in near]
        return found

    @staticmethod
    def _clearance(x: Floats, wall: Any) -> Floats:
        """No more than the distance of points from an obstacle."""
        if wall.kind == "ground":
            return x[:, 2]
        away: Floats = (np.abs(x - wall.position) - wall.size).max(axis=1)
        return away

    def _depth(self, geom_a: int, pose_a: Floats, geom_b: int, pose_b: Floats) -> float:
        found = self._world.collide_pair(geom_a, pose_a, geom_b, pose_b, MARGIN)["depth"]
        return float(found.max()) if len(found) else 0.0


def _reach(kind: str, size: tuple[float, ...], scene: Scene) -> float:
    """Largest distance of a point of the shape from its origin."""
    if kind == "hull":
        assert scene.hull is not None
        return float(np.linalg.norm(scene.hull, axis=1).max())
    return float(np.linalg.norm(size)) if kind == "box" else float(sum(size))
