"""What follows from the motion of one body and its mass: energy, momentum, rest."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from physsim.recording.orientation import Floats, rotated, rotation_matrices

if TYPE_CHECKING:
    from physsim.recording.track import BodyTrack

ALL = slice(None)


def kinetic_energy(body: BodyTrack, frames: slice = ALL) -> Floats:
    """E = (m v·v + ω·L) / 2, (T) J; 0 for a fixed body. Goldstein, 3rd ed., eqs. 1.31 and 5.16."""
    v, w = body.velocity[frames], body.angular_velocity[frames]
    if body.fixed:
        return np.zeros(len(v))
    spin = np.einsum("ti,ti->t", w, angular_momentum(body, frames))
    return np.asarray(0.5 * (body.mass * np.einsum("ti,ti->t", v, v) + spin), np.float64)


def momentum(body: BodyTrack, frames: slice = ALL) -> Floats:
    """p = m v, (T, 3) kg m/s; 0 for a fixed body."""
    v = body.velocity[frames]
    return np.zeros_like(v) if body.fixed else np.asarray(body.mass * v, np.float64)


def angular_momentum(body: BodyTrack, frames: slice = ALL) -> Floats:
    """L = R I Rᵀ ω about the centre of mass, world axes, (T, 3) kg m2/s; 0 for a fixed body.

    Goldstein, 3rd ed., eq. 5.9.
    """
    w = body.angular_velocity[frames]
    if body.fixed:
        return np.zeros_like(w)
    turn = rotation_matrices(body.orientation[frames])
    return np.asarray(np.einsum("tij,jk,tlk,tl->ti", turn, body.inertia, turn, w), np.float64)


def center(body: BodyTrack, frames: slice = ALL) -> Floats:
    """Where the centre of mass is: x + R c, world axes, (T, 3) m."""
    position = body.position[frames]
    if not body.center_of_mass.any():
        return np.asarray(position, np.float64)
    return np.asarray(position + rotated(body.orientation[frames], body.center_of_mass), np.float64)


def rest_frame(body: BodyTrack, speed: float, angular_speed: float) -> int | None:
    """The first frame from which the body is at most this fast [m/s], [rad/s] to the end; None when it moves
    in the last frame.
    """
    moving = np.linalg.norm(body.velocity[:], axis=1) > speed
    moving |= np.linalg.norm(body.angular_velocity[:], axis=1) > angular_speed
    last = np.flatnonzero(moving)
    first = int(last[-1]) + 1 if len(last) else 0
    return first if first < len(moving) else None
