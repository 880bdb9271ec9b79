"""What a picture is fitted to: where things are over a whole run, and how large they are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from physsim.recording.orientation import rotated, rotation_matrices
from physsim.view.picture.outlook import Outlook, Screen
from physsim.view.shapes.mesh import Mesh
from physsim.view.shapes.tessellate import Placed
from physsim.view.stage import WORLD, FloatArray, Stage

BACKDROP = 3.0
"""What never moves and is larger than this many times what does is a backdrop: the camera need not see
it whole."""
RARE, STRAY = 0.05, 0.5
STILL = 1e-9
"""Changes of a pose smaller than this [m, and of components of a quaternion] are rounding."""


@dataclass(frozen=True)
class Setting:
    """points (n, 3) [m]: what the camera should see; outlook: what may hide it; size [m]: the diagonal of the
    box around the points.
    """

    points: FloatArray
    outlook: Outlook

    @property
    def low(self) -> FloatArray:
        return np.asarray(self.points.min(axis=0))

    @property
    def high(self) -> FloatArray:
        return np.asarray(self.points.max(axis=0))

    @property
    def middle(self) -> FloatArray:
        return (self.low + self.high) / 2

    @property
    def size(self) -> float:
        return float(np.linalg.norm(self.high - self.low))


def setting_of(stage: Stage, boxes: FloatArray, positions: FloatArray, orientations: FloatArray) -> Setting:
    """Of bodies with `boxes` (N, 2, 3) at poses (T, N, 3) and (T, N, 4): all that moves, what it is tied to,
    and what stands around it unless it is a backdrop. Where nothing moves: all that could. The unit cube when
    there is nothing.
    """
    there = np.isfinite(boxes).all(axis=(1, 2))
    moves = there & np.array([_moves(positions[:, k], orientations[:, k]) for k in range(len(boxes))], bool)
    if not moves.any():
        moves = there & ~np.array([actor.fixed for actor in stage.actors], bool)
    way = corners(boxes[moves], positions[:, moves], orientations[:, moves])
    still = there & ~moves
    around = corners(boxes[still], positions[:1, still], orientations[:1, still])
    points = np.concatenate([without_strays(way), _anchors(stage, positions[0], orientations[0])])
    if len(points) == 0:
        points = around if len(around) else _cube()
    extent = float(np.ptp(points, axis=0).max())
    if extent <= 0:
        points, extent = points[0] + _cube(), 2.0
    near = [one for one in around.reshape(-1, 8, 3) if np.ptp(one, axis=0).max() <= BACKDROP * extent]
    screens = tuple(
        Screen(positions[0, k], rotation_matrices(orientations[0, k : k + 1])[0], *boxes[k])
        for k in np.flatnonzero(still)
    )
    middles = way.reshape(-1, 8, 3).mean(axis=1)
    return Setting(np.concatenate([points, *near]), Outlook(middles, screens))


def without_strays(points: FloatArray) -> FloatArray:
    """The points (n, 3) without those few that are far from all others, as of one ball that rolls away: the
    ones more than STRAY times the extent of the middle 1 - 2 RARE outside of it.
    """
    if len(points) == 0:
        return points
    low, high = np.quantile(points, [RARE, 1 - RARE], axis=0)
    margin = STRAY * float((high - low).max())
    kept: FloatArray = points[((points >= low - margin) & (points <= high + margin)).all(axis=1)]
    return kept


def _cube() -> FloatArray:
    """The corners of a cube of 2 m about the origin."""
    return np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)


def _moves(positions: FloatArray, orientations: FloatArray) -> bool:
    return bool(max(np.ptp(positions, axis=0).max(), np.ptp(orientations, axis=0).max()) > STILL)


def _anchors(stage: Stage, positions: FloatArray, orientations: FloatArray) -> FloatArray:
    """Where joints and springs are tied to the world or to bodies, at one instant (n, 3)."""
    links = [*stage.joints, *stage.springs]
    ends = [at(link.bodies[k], link.anchors[k], positions, orientations) for link in links for k in (0, 1)]
    return np.array(ends, np.float64).reshape(-1, 3)


def at(body: int, point: FloatArray, positions: FloatArray, orientations: FloatArray) -> FloatArray:
    """Where a point (3) of a body's own frame is in the world; of the world itself, there."""
    if body == WORLD:
        return point
    return np.asarray(positions[body] + rotated(orientations[body : body + 1], point)[0])


def boxes_of(stage: Stage, meshes: list[Mesh], placed: list[Placed]) -> FloatArray:
    """Lowest and highest corner (N, 2, 3) [m] of what is drawn of each body, in its own frame; NaN for bodies
    of which nothing is, and for half-spaces.
    """
    boxes = np.tile(np.array([[np.inf], [-np.inf]]), (len(stage.actors), 1, 3))
    for one in placed:
        solid = stage.solids[one.solid]
        points = meshes[one.mesh].vertices * one.scale
        turned = points @ rotation_matrices(solid.orientation[None])[0].T + solid.position
        box = boxes[solid.body]
        box[0], box[1] = np.minimum(box[0], turned.min(axis=0)), np.maximum(box[1], turned.max(axis=0))
    boxes[~np.isfinite(boxes).all(axis=(1, 2))] = np.nan
    return boxes


def corners(boxes: npt.NDArray[np.float64], positions: FloatArray, orientations: FloatArray) -> FloatArray:
    """The corners (T * N * 8, 3) of boxes (N, 2, 3) at poses (T, N, 3) and (T, N, 4), body by body."""
    pick = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    local = np.stack([boxes[:, pick[:, axis], axis] for axis in range(3)], axis=-1)
    frames, bodies = positions.shape[:2]
    matrices = rotation_matrices(orientations.reshape(-1, 4)).reshape(frames, bodies, 3, 3)
    world = np.einsum("tnij,nkj->tnki", matrices, local) + positions[:, :, None]
    return np.asarray(world.reshape(-1, 3))
