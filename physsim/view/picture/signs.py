"""What is drawn beside the bodies: springs, strings, joints, frames, contact forces, trails."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from physsim.view.picture import wires
from physsim.view.picture.light import linear
from physsim.view.picture.setting import Setting, at
from physsim.view.picture.things import Extra, Finish
from physsim.view.stage import WORLD, FloatArray, Link, Stage

SPRING, STRING, JOINT, FORCE = linear("#3c4650"), linear("#6b5a45"), linear("#aa3377"), linear("#e8590c")
AXES = (linear("#d62728"), linear("#2ca02c"), linear("#1f77b4"))
COIL, WIRE, ROPE, PIN, SHAFT, TRAIL = 0.016, 0.0024, 0.0026, 0.006, 0.0042, 0.0014
"""Radii of coils, their wire, strings, pins, arrows and trails, over the size of the setting."""
LONGEST_FORCE = 0.22
"""The largest contact force is drawn with this length, over the size of the setting."""
THIN_COIL = 0.15
"""A coil is no thicker than this part of its length at the start."""
HELD = ("hinge", "ball", "cone", "universal", "fixed")
"""Joints that hold a point of a body: where that lies outside of it, an arm is drawn to it."""
OUTSIDE = 0.03
"""An anchor farther from the body than this, over the size of the setting, needs an arm."""
TURNING = ("hinge", "universal", "gear", "screw", "cylindrical", "slider")
LONG = ("slider", "cylindrical", "screw")


class Signs:
    """Signs of one stage, sized to its setting. boxes (N, 2, 3) of the bodies; poses at the start."""

    def __init__(
        self,
        stage: Stage,
        setting: Setting,
        boxes: FloatArray,
        positions: FloatArray,
        orientations: FloatArray,
    ) -> None:
        self.stage, self.size, self._boxes = stage, setting.size, boxes
        ends = [self._ends(link, positions, orientations) for link in stage.springs]
        self._coil = [
            min(COIL * self.size, THIN_COIL * float(np.linalg.norm(one[1] - one[0]))) for one in ends
        ]

    def springs(
        self, positions: FloatArray, orientations: FloatArray, broken: frozenset[int]
    ) -> Iterator[Extra]:
        """Coils that stretch, spirals for torsional springs, strings for distance joints, and arms.

        broken: the numbers of joints that are not drawn any more.
        """
        for link, radius in zip(self.stage.springs, self._coil, strict=True):
            ends = self._ends(link, positions, orientations)
            if link.kind == "linear":
                wire = min(WIRE * self.size, radius / 3)
                yield Extra(wires.coil(ends, radius, wire), SPRING)
            else:
                axis = self._axis(link, orientations)
                yield Extra(wires.spiral(ends[0], axis, 2 * COIL * self.size, WIRE * self.size), SPRING)
        for link in self._whole_joints(broken):
            if link.kind == "distance":
                ends = self._ends(link, positions, orientations)
                yield Extra(wires.tube(ends, ROPE * self.size), STRING)
            elif link.kind in HELD:
                yield from self._arms(link, positions, orientations)

    def joints(
        self, positions: FloatArray, orientations: FloatArray, broken: frozenset[int]
    ) -> Iterator[Extra]:
        """Pins along axes, long ones where bodies slide; balls where there is no axis."""
        for link in self._whole_joints(broken):
            ends = self._ends(link, positions, orientations)
            radius = PIN * self.size
            if link.kind in TURNING and np.isfinite(link.axis).all():
                length = (0.3 if link.kind in LONG else 0.09) * self.size
                axis = self._axis(link, orientations)
                yield Extra(wires.pin(ends[0], axis, length, radius), JOINT, Finish.SIGN)
            for end in ends if link.kind == "distance" else ends[:1]:
                yield Extra(wires.ball(end, 1.6 * radius), JOINT, Finish.SIGN)

    def frames(self, positions: FloatArray, orientations: FloatArray) -> Iterator[Extra]:
        """The axes x, y, z of each body at its origin: red, green, blue, each shorter than the last."""
        for body, box in enumerate(self._boxes):
            if np.isfinite(box).all():
                length = float(
                    np.clip(0.7 * np.linalg.norm(box[1] - box[0]), 0.06 * self.size, 0.16 * self.size)
                )
                for axis, colour in enumerate(AXES):
                    tip = at(body, (1 - 0.2 * axis) * length * np.eye(3)[axis], positions, orientations)
                    arrow = wires.arrow(positions[body], tip - positions[body], 0.0022 * self.size)
                    yield Extra(arrow, colour, Finish.SIGN)

    def contacts(self, points: FloatArray, forces: FloatArray, largest: float) -> Iterator[Extra]:
        """Contact forces (n, 3) [N] on the one body at points (n, 3) [m]; `largest` [N] is drawn longest."""
        scale = LONGEST_FORCE * self.size / max(largest, 1e-300)
        for point, force in zip(points, forces, strict=True):
            length = float(np.linalg.norm(force)) * scale
            if length > 0.004 * self.size:
                vector = force * scale * min(1.0, 2 * LONGEST_FORCE * self.size / length)
                yield Extra(wires.arrow(point, vector, SHAFT * self.size), FORCE, Finish.SIGN)

    def trail(self, points: FloatArray, colour: FloatArray) -> Iterator[Extra]:
        """Where a body has been: points (n, 3) [m]."""
        still = np.r_[False, np.linalg.norm(np.diff(points, axis=0), axis=1) < 1e-3 * self.size]
        there = points[~still]
        if len(there) > 1:
            yield Extra(wires.tube(there, TRAIL * self.size, sides=5), colour)

    def _whole_joints(self, broken: frozenset[int]) -> Iterator[Link]:
        return (link for number, link in enumerate(self.stage.joints) if number not in broken)

    def _arms(self, link: Link, positions: FloatArray, orientations: FloatArray) -> Iterator[Extra]:
        """From a body's middle to an anchor that lies outside of it."""
        for body, anchor in zip(link.bodies, link.anchors, strict=True):
            if body == WORLD or not np.isfinite(self._boxes[body]).all():
                continue
            low, high = self._boxes[body]
            if np.linalg.norm(anchor - np.clip(anchor, low, high)) > OUTSIDE * self.size:
                ends = [at(body, point, positions, orientations) for point in ((low + high) / 2, anchor)]
                yield Extra(wires.tube(np.array(ends), ROPE * self.size), STRING)

    @staticmethod
    def _ends(link: Link, positions: FloatArray, orientations: FloatArray) -> FloatArray:
        """Both anchors in the world, (2, 3) [m]."""
        return np.array(
            [at(link.bodies[k], link.anchors[k], positions, orientations) for k in (0, 1)], np.float64
        )

    @staticmethod
    def _axis(link: Link, orientations: FloatArray) -> FloatArray:
        """In world axes (3); z where the link has none."""
        axis = link.axis if np.isfinite(link.axis).all() else np.array([0.0, 0.0, 1.0])
        return at(link.bodies[0], axis, np.zeros((len(orientations), 3)), orientations)
