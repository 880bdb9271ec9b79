"""Where a picture is taken from: a pinhole camera, and how it is placed so that everything is seen."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from physsim.view.picture.setting import Setting
from physsim.view.stage import FloatArray

FOCUS = 3.2
"""Focal length over half the height of the picture: an angle of view of 35 degrees from top to bottom."""
FILLED = 0.84
"""What is to be seen fills this part of the picture."""
FLAT = 0.12
"""A scene thinner than this part of its size is looked at from its broad side."""
FROM_FRONT, FROM_SIDE, FROM_ABOVE, OVERVIEW = (-72.0, 10.0), (18.0, 10.0), (-78.0, 48.0), (-58.0, 22.0)
"""Azimuth and elevation [degrees]: for scenes in an upright plane (xz, yz), for flat ones, for all others."""
AROUND = ((0.0, 0.0), (-64.0, 0.0), (90.0, 0.0), (0.0, 24.0), (180.0, 0.0), (-64.0, 24.0))
"""What is tried in turn when something hides what moves, added to the usual azimuth and elevation."""
SEEN_WELL = 0.05
"""A direction is good enough when no more than this part of what moves is hidden."""


@dataclass(frozen=True)
class Camera:
    """eye (3) [m]; axes (3, 3): unit vectors to the right of the picture, up in it, and into it; size: pixels
    across and down.
    """

    eye: FloatArray
    axes: FloatArray
    size: tuple[int, int]

    def moved(self, by: FloatArray) -> Camera:
        """The same view from another place: by (3) [m]."""
        return replace(self, eye=self.eye + by)

    def pixels(self, points: FloatArray) -> FloatArray:
        """Columns and rows from the upper left corner, and depths [m], (n, 3), of points (n, 3) [m].

        Square pixels: column = width / 2 + f x / depth, f = FOCUS height / 2. Behind the camera: NaN.
        """
        x, y, depth = ((points - self.eye) @ self.axes.T).T
        scale = FOCUS * self.size[1] / 2 / np.where(depth > 0, depth, np.nan)
        return np.column_stack([self.size[0] / 2 + scale * x, self.size[1] / 2 - scale * y, depth])


@dataclass(frozen=True)
class View:
    """What a user may say of the camera; None: found from the scene. Azimuth and elevation go together.

    azimuth and elevation [degrees] of the camera seen from what it looks at: azimuth 0 is the x axis, 90 the
    y axis; distance [m]; target (3) [m]: what it looks at.
    """

    azimuth: float | None = None
    elevation: float | None = None
    distance: float | None = None
    target: tuple[float, float, float] | None = None


def placed(view: View, setting: Setting, size: tuple[int, int]) -> Camera:
    """A camera as the view says that sees all points of the setting where the view leaves that open."""
    axes = looking(*_direction(view, setting))
    eye, target = fitting(setting.points, axes, size)
    if view.target is not None or view.distance is not None:
        distance = float((target - eye) @ axes[2]) if view.distance is None else view.distance
        target = target if view.target is None else np.asarray(view.target, np.float64)
        eye = target - distance * axes[2]
    return Camera(eye, axes, size)


def looking(azimuth: float, elevation: float) -> FloatArray:
    """Axes (3, 3), right, up, into the picture, of a camera in that direction [degrees]; z is up."""
    a, e = np.radians([azimuth, elevation])
    into = -np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.array([right, np.cross(right, into), into])


def fitting(points: FloatArray, axes: FloatArray, size: tuple[int, int]) -> tuple[FloatArray, FloatArray]:
    """The nearest eye (3) from which all points fill no more than FILLED of the picture, and the middle
    (3) of what it sees.

    |x - eye_x| <= m (z - eye_z), m the tangent of the angle of view: the largest x - m z and -x - m z give
    eye_x and eye_z; likewise for y.
    """
    seen = points @ axes.T
    tangents = FILLED / FOCUS * np.array([size[0] / size[1], 1.0])
    most = (seen[:, :2] - tangents * seen[:, 2:]).max(axis=0)
    least = (-seen[:, :2] - tangents * seen[:, 2:]).max(axis=0)
    across = (most - least) / 2
    back = (-(most + least) / (2 * tangents)).min()
    nearest, farthest = seen[:, 2].min(), seen[:, 2].max()
    back = min(back, nearest - 0.2 * (farthest - nearest) - 1e-9)
    middle = np.array([*across, (nearest + farthest) / 2])
    return np.array([*across, back]) @ axes, middle @ axes


def _direction(view: View, setting: Setting) -> tuple[float, float]:
    """As the view says; else the first of the usual ones from which what moves is seen well."""
    azimuth, elevation = _usual(setting.points)
    if view.azimuth is not None and view.elevation is not None:
        return view.azimuth, view.elevation
    tried = [(azimuth + turn, elevation + lift) for turn, lift in AROUND]
    hidden = [setting.outlook.hidden(-looking(*one)[2]) for one in tried]
    good = [one for one, share in zip(tried, hidden, strict=True) if share <= SEEN_WELL]
    return good[0] if good else tried[int(np.argmin(hidden))]


def _usual(points: FloatArray) -> tuple[float, float]:
    """Upright planes from the front, flat scenes from above."""
    extent = np.ptp(points, axis=0)
    thin = extent < FLAT * max(float(extent.max()), 1e-12)
    if thin[2]:
        return FROM_ABOVE
    if thin[0] == thin[1]:
        return OVERVIEW
    return FROM_SIDE if thin[0] else FROM_FRONT
