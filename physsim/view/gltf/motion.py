"""What moves in a glTF file: key frames of its nodes, as few as the tolerance allows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from hashlib import blake2b
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.view.clip import Clip
from physsim.view.gltf import axes as gltf_axes
from physsim.view.gltf.glb_file import Binary
from physsim.view.gltf.keyframes import Thinner, in_one_hemisphere, shift, turn
from physsim.view.gltf.spool import Spool
from physsim.view.stage import FloatArray

STRAIGHT_ERROR = 0.004
"""A program that goes from one quaternion to the next along the straight line, as Blender does, and not along
the arc, is off by no more than 0.004 a^3 for a turn of a [rad]: 2 (a/2)^3 max|t (1-t) (1-2t)| / 6."""

Rows = npt.NDArray[np.intp]


@dataclass(frozen=True)
class Track:
    """One property of R nodes over time: path `translation`, `rotation` or `scale`.

    tolerance (R): by how much linear interpolation may be off, in the unit of `difference`, and how far a
    value may stray from the first without being a motion. reach (R): as `Thinner` has it. encoded: values of
    a scene in the axes of glTF. width: numbers of a value.
    """

    path: str
    nodes: Rows
    tolerance: FloatArray
    reach: FloatArray
    difference: Callable[[FloatArray, FloatArray], FloatArray]
    encoded: Callable[[FloatArray], FloatArray]
    width: int


def translations(nodes: Rows, tolerance: FloatArray) -> Track:
    """Where nodes are; tolerance (R) in m."""
    return Track(
        "translation", nodes, tolerance, np.full(len(nodes), np.inf), shift, gltf_axes.turned, width=3
    )


def rotations(nodes: Rows, tolerance: FloatArray) -> Track:
    """How nodes are turned; tolerance (R) in rad, which players that go straight keep as well."""
    reach = np.cbrt(tolerance / STRAIGHT_ERROR)
    return Track("rotation", nodes, tolerance, reach, turn, gltf_axes.quaternions, width=4)


class Mover(Protocol):
    """Some nodes whose motion follows from the poses of all bodies."""

    @property
    def tracks(self) -> Sequence[Track]:
        """What moves of them."""

    def values(
        self, times: FloatArray, positions: FloatArray, orientations: FloatArray
    ) -> Sequence[FloatArray]:
        """Of each track (m, R, width), at times (m) [s] and poses (m, N, 3) [m] and (m, N, 4), later than
        those before.
        """


class BodyMover:
    """Bodies (R), whose nodes have their numbers. tolerance [m]: how far any point of them may be off, and
    radii (R) [m]: how far such points are from the origin of a body.

    A quarter of it each is for positions and turns on the way, and for positions and turns that are left out;
    a turn by an angle moves a point by no more than the radius times the angle.
    """

    def __init__(self, bodies: Rows, radii: FloatArray, tolerance: float) -> None:
        share = np.full(len(bodies), tolerance / 4)
        angle = np.divide(share, radii, out=share.copy(), where=radii > 0)
        self.tracks = [translations(bodies, share), rotations(bodies, angle)]
        self._bodies = bodies
        self._before: FloatArray | None = None

    def values(self, _: FloatArray, positions: FloatArray, orientations: FloatArray) -> Sequence[FloatArray]:
        signed = in_one_hemisphere(orientations[:, self._bodies], self._before)
        self._before = signed[-1]
        return [positions[:, self._bodies], signed]


@dataclass
class Animation:
    """The one animation of a document. clock (n): the time of each sample [s]; kept: how many key frames the
    channels have.
    """

    clock: FloatArray
    binary: Binary
    samplers: list[dict[str, int]] = field(default_factory=list)
    channels: list[dict[str, Any]] = field(default_factory=list)
    kept: int = 0
    _known: dict[bytes, int] = field(default_factory=dict)

    def add(self, node: int, path: str, samples: Rows, values: FloatArray) -> None:
        """Key frames of one property of a node, at these samples of the clock."""
        times = self._times(samples)
        self.samplers.append({"input": times, "output": self.binary.add(values.astype(np.float32))})
        self.channels.append({"sampler": len(self.samplers) - 1, "target": {"node": node, "path": path}})
        self.kept += len(samples)

    @property
    def samples(self) -> int:
        """How many key frames the channels would have without thinning."""
        return len(self.channels) * len(self.clock)

    def document(self) -> dict[str, Any]:
        """The key of the document that holds it; none when nothing moves."""
        if not self.channels:
            return {}
        return {"animations": [{"name": "motion", "samplers": self.samplers, "channels": self.channels}]}

    def _times(self, samples: Rows) -> int:
        """Channels with key frames at the same instants share their times."""
        key = blake2b(samples.tobytes()).digest()
        if key not in self._known:
            self._known[key] = self.binary.add(self.clock[samples].astype(np.float32), bounds=True)
        return self._known[key]


def clock(times: FloatArray, speed: float) -> FloatArray:
    """Seconds since the first at which they are shown. Raises FileTrouble when 32 bits, all that glTF has,
    cannot tell two apart.
    """
    since: FloatArray = (times - times[0]) / speed
    if (np.diff(since.astype(np.float32)) <= 0).any():
        raise FileTrouble(
            "the frames are too close together for the 32-bit times of glTF; --fps, --from or --until helps"
        )
    return since


def animate(clip: Clip, movers: Sequence[Mover], speed: float, binary: Binary, folder: Path) -> Animation:
    """Adds the motion of the movers at a speed; a node that does not do something has no channel for it.

    folder: where samples wait that do not fit into memory.
    """
    animation = Animation(clock(clip.times, speed), binary)
    with ExitStack() as stack:
        spools = [
            [
                Spool(stack.enter_context(TemporaryFile(dir=folder)), len(track.nodes), track.width)
                for track in mover.tracks
            ]
            for mover in movers
        ]
        _thin(clip, movers, spools)
        binary.begin_view()
        for mover, own in zip(movers, spools, strict=True):
            for track, spool in zip(mover.tracks, own, strict=True):
                _add(animation, track, spool)
    return animation


def _thin(clip: Clip, movers: Sequence[Mover], spools: Sequence[Sequence[Spool]]) -> None:
    """Reads the clip once and keeps the samples that are needed."""
    thinners = [
        [Thinner(track.difference, track.tolerance, track.reach) for track in mover.tracks]
        for mover in movers
    ]
    for part, *poses in clip.blocks():
        for mover, own, kept in zip(movers, thinners, spools, strict=True):
            for thinner, spool, values in zip(own, kept, mover.values(clip.times[part], *poses), strict=True):
                for keys in thinner.add(clip.times[part], values):
                    spool.add(keys)
    for own, kept in zip(thinners, spools, strict=True):
        for thinner, spool in zip(own, kept, strict=True):
            for keys in thinner.last():
                spool.add(keys)


def _add(animation: Animation, track: Track, spool: Spool) -> None:
    """A channel for each node that moves."""
    for node, tolerance, (samples, values) in zip(track.nodes, track.tolerance, spool.motions(), strict=True):
        stray = track.difference(np.broadcast_to(values[0], values.shape), values)
        if np.linalg.norm(stray, axis=1).max() > tolerance:
            animation.add(int(node), track.path, samples, track.encoded(values))
