"""A trajectory as pictures at any of its times: what stands there, from where, with which signs and words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from physsim.recording import Trajectory
from physsim.recording.orientation import rotated
from physsim.view.clip import Clip
from physsim.view.picture.camera import Camera, View, placed
from physsim.view.picture.caption import Caption, Mark, captioned
from physsim.view.picture.light import linear, of_speeds, told_apart
from physsim.view.picture.painter import Painter, grid_spacing
from physsim.view.picture.setting import Setting, setting_of
from physsim.view.picture.signs import Signs
from physsim.view.picture.things import Extra
from physsim.view.stage import FloatArray, Stage, stage_of

USUAL_SIGNS = ("springs",)
USUAL_WORDS = ("time", "scale")
LOOKED_AT = 120
"""The camera is placed by the poses at so many instants, evenly chosen."""
FOLLOWED = 6.0
"""Who follows a body sees so many of its sizes around it."""
MOST_TRAILS, TRAIL_POINTS, MOST_ARROWS = 60, 600, 300


@dataclass(frozen=True)
class Look:
    """What a user may say of a picture. size: pixels across and down; signs and words: of `--show` and of
    `--caption`; follow: a body that the camera keeps up with; by_speed: bodies have the colour of
    their speed, not of their material.
    """

    size: tuple[int, int] = (1280, 720)
    view: View = field(default_factory=View)
    signs: tuple[str, ...] = USUAL_SIGNS
    words: tuple[str, ...] = USUAL_WORDS
    follow: str | None = None
    by_speed: bool = False


class Show:
    """Pictures of one trajectory between two times [s], all from one camera unless it follows a body.

    Raises FileTrouble when the file keeps no shapes, NotInFile for a body or contacts that it has not.
    """

    def __init__(self, trajectory: Trajectory, look: Look, span: tuple[float, float]) -> None:
        self.trajectory, self.look = trajectory, look
        self.stage = stage_of(trajectory)
        self._known = trajectory.time
        self._painter = Painter(self.stage)
        self._followed = None if look.follow is None else trajectory.index_of(look.follow)
        positions, orientations = self._poses(
            np.linspace(*span, LOOKED_AT) if span[1] > span[0] else np.array(span[:1])
        )
        self._start = positions[0]
        self.setting = self._setting(positions, orientations)
        self.camera = placed(self._view(), self.setting, look.size)
        self._signs = Signs(self.stage, self.setting, self._painter.boxes, positions[0], orientations[0])
        self._largest = self._largest_force(span) if "contacts" in look.signs else 0.0
        self._fastest = self._fastest_of(span) if look.by_speed else 0.0
        self._way = self._ways(span) if "trails" in look.signs else None

    def pictures(self, times: FloatArray, fine: bool = True) -> Iterator[Any]:
        """A Pillow image for each time [s], in order."""
        clip = Clip(self.trajectory, times)
        for part, positions, orientations in clip.blocks():
            for time, position, orientation in zip(times[part], positions, orientations, strict=True):
                yield self._picture(float(time), position, orientation, fine)

    def _picture(self, time: float, positions: FloatArray, orientations: FloatArray, fine: bool) -> Any:
        camera, setting = self._moved(positions)
        extras = list(self._extras(time, positions, orientations))
        pixels = self._painter.draw(
            camera,
            setting,
            positions,
            orientations,
            extras=extras,
            fine=fine,
            colours=of_speeds(self._speeds(time), self._fastest) if self.look.by_speed else None,
        )
        return captioned(pixels, camera, self._caption(time, positions, orientations))

    def _poses(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        blocks = list(Clip(self.trajectory, times).blocks())
        return np.concatenate([p for _, p, _ in blocks]), np.concatenate([q for _, _, q in blocks])

    def _setting(self, positions: FloatArray, orientations: FloatArray) -> Setting:
        found = setting_of(self.stage, self._painter.boxes, positions, orientations)
        if self._followed is None:
            return found
        box = self._painter.boxes[self._followed]
        reach = (
            FOLLOWED / 2 * float(np.linalg.norm(box[1] - box[0])) if np.isfinite(box).all() else found.size
        )
        around = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-0.6, 0.6)])
        return replace(found, points=self._start[self._followed] + reach / 2 * around)

    def _view(self) -> View:
        """A camera that follows a body looks at it."""
        view = self.look.view
        if self._followed is None or view.target is not None:
            return view
        x, y, z = self._start[self._followed]
        return replace(view, target=(float(x), float(y), float(z)))

    def _moved(self, positions: FloatArray) -> tuple[Camera, Setting]:
        if self._followed is None:
            return self.camera, self.setting
        by = positions[self._followed] - self._start[self._followed]
        return self.camera.moved(by), replace(self.setting, points=self.setting.points + by)

    def _extras(self, time: float, positions: FloatArray, orientations: FloatArray) -> Iterator[Extra]:
        signs, broken = self.look.signs, self._broken(time)
        if "springs" in signs:
            yield from self._signs.springs(positions, orientations, broken)
        if "joints" in signs:
            yield from self._signs.joints(positions, orientations, broken)
        if "frames" in signs:
            yield from self._signs.frames(positions, orientations)
        if "contacts" in signs:
            points, forces = self._contacts(time)
            yield from self._signs.contacts(points, forces, self._largest)
        if "trails" in signs:
            yield from self._trails(time, positions, orientations)

    def _frame(self, time: float) -> int:
        """The frame nearest to a time."""
        return int(np.argmin(np.abs(self._known - time)))

    def _speeds(self, time: float) -> FloatArray:
        """Of the centres of mass (N) [m/s], at the frame nearest to a time."""
        velocities = self.trajectory.velocity[self._frame(time)]
        return np.asarray(np.linalg.norm(velocities, axis=1))

    def _fastest_of(self, span: tuple[float, float]) -> float:
        """The largest speed [m/s] of those looked at."""
        return max(float(self._speeds(time).max(initial=0)) for time in np.linspace(*span, LOOKED_AT))

    def _broken(self, time: float) -> frozenset[int]:
        """Numbers of the joints that have broken by then."""
        if not self.trajectory.has("joints/broken"):
            return frozenset()
        frame = int(np.searchsorted(self._known, time, side="right")) - 1
        return frozenset(np.flatnonzero(self.trajectory.series("joints/broken")[frame]).tolist())

    def _contacts(self, time: float) -> tuple[FloatArray, FloatArray]:
        """Points (n, 3) and forces (n, 3) of the frame nearest to a time, the strongest of them; on
        the body that moves, of two that move on the one that is pushed up.
        """
        frame = self._frame(time)
        table = self.trajectory.contact_rows(
            frame, frame + 1, ("position", "force", "body_a", "body_b"), by_name=False
        )
        fixed = np.array([actor.fixed for actor in self.stage.actors])
        a, b = fixed[table["body_a"]], fixed[table["body_b"]]
        on_other = a | (~b & (table["force"][:, 2] < 0))
        forces = np.where(on_other[:, None], -table["force"], table["force"])
        strongest = np.argsort(-np.linalg.norm(forces, axis=1), kind="stable")[:MOST_ARROWS]
        return table["position"][strongest], forces[strongest]

    def _largest_force(self, span: tuple[float, float]) -> float:
        """What most contact forces stay below: of the largest of each frame looked at the upper decile."""
        frames = [self._contacts(time)[1] for time in np.linspace(*span, LOOKED_AT)]
        largest = [float(np.linalg.norm(forces, axis=1).max()) for forces in frames if len(forces)]
        return float(np.quantile(largest, 0.9)) if largest else 1.0

    def _ways(self, span: tuple[float, float]) -> tuple[FloatArray, FloatArray]:
        """Times (n) and places (n, N, 3) of the centres of mass on their way."""
        times = np.linspace(*span, TRAIL_POINTS) if span[1] > span[0] else np.array(span[:1])
        positions, orientations = self._poses(times)
        return times, np.array([self._centers(*pose) for pose in zip(positions, orientations, strict=True)])

    def _centers(self, positions: FloatArray, orientations: FloatArray) -> FloatArray:
        """Centres of mass (N, 3)."""
        return positions + rotated(orientations, np.array([actor.center for actor in self.stage.actors]))

    def _trails(self, time: float, positions: FloatArray, orientations: FloatArray) -> Iterator[Extra]:
        """Of the bodies that move, where their centres of mass have been up to a time."""
        if self._way is None:
            return
        times, places = self._way
        now = self._centers(positions, orientations)
        moving = [k for k, actor in enumerate(self.stage.actors) if not actor.fixed][:MOST_TRAILS]
        for body in moving:
            yield from self._signs.trail(
                np.vstack([places[times < time, body], now[body]]), self._colour(body)
            )

    def _colour(self, body: int) -> FloatArray:
        for solid in self.stage.solids:
            if solid.body == body:
                return told_apart(linear(solid.colour), body)
        return np.ones(3) / 2

    def _scale(self) -> str:
        """What lengths on the ground and colours mean."""
        found = []
        if self.look.by_speed:
            found.append(f"dark 0, light {self._fastest:.3g} m/s")
        if self._painter.grounded:
            found.append(f"grid {grid_spacing(self.setting):g} m")
        return ", ".join(found)

    def _caption(self, time: float, positions: FloatArray, orientations: FloatArray) -> Caption:
        words = self.look.words
        named = "labels" in self.look.signs
        return Caption(
            time=f"t = {time:.{decimals(self.trajectory)}f} s" if "time" in words else "",
            scale=self._scale() if "scale" in words else "",
            title=self.stage.title if "title" in words else "",
            marks=tuple(labels(self.stage, positions, orientations)) if named else (),
        )


def labels(
    stage: Stage, positions: FloatArray, orientations: FloatArray, massive: bool = False
) -> Iterator[Mark]:
    """The names of bodies at their centres of mass, half-spaces left out; of copies (`brick[0,0,1]`) the
    first alone. massive: with the signs of centres of mass, for bodies whose mass is known.
    """
    told = {stage.actors[solid.body].name for solid in stage.solids if solid.kind == "halfspace"}
    for body, actor in enumerate(stage.actors):
        name = actor.name.partition("[")[0]
        if name not in told:
            told.add(name)
            place = positions[body] + rotated(orientations[body : body + 1], actor.center)[0]
            yield Mark(place, actor.name, massive and bool(np.isfinite(actor.mass)))


def decimals(trajectory: Trajectory) -> int:
    """Of times in seconds: as many as tell frames apart, from 2 to 6."""
    steps = np.diff(trajectory.time[:2])
    return int(np.clip(np.ceil(-np.log10(steps[0])), 2, 6)) if steps.size and steps[0] > 0 else 2
