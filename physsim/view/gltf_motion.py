"""What moves in a glTF file: key frames of the bodies, as few as the tolerance allows."""

from __future__ import annotations

from dataclasses import dataclass, field
from hashlib import blake2b
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble
from physsim.view import gltf_axes
from physsim.view.clip import Clip
from physsim.view.glb_file import Binary
from physsim.view.keyframes import Thinner, in_one_hemisphere, shift, turn
from physsim.view.spool import Spool
from physsim.view.stage import FloatArray

STRAIGHT_ERROR = 0.004
"""A program that goes from one quaternion to the next along the straight line, as Blender does, and not along
the arc, is off by no more than 0.004 a^3 for a turn of a [rad]: 2 (a/2)^3 max|t (1-t) (1-2t)| / 6."""


@dataclass(frozen=True)
class Precision:
    """How far a channel of each body may be off: positions (R) [m] and turns (R) [rad]."""

    shift: FloatArray
    turn: FloatArray


def precision(tolerance: float, radii: FloatArray) -> Precision:
    """A quarter of the `tolerance` [m] each for positions and turns on the way, and as much again for motions
    that are left out; a turn moves the points of a body by no more than its radius (R) [m] times the angle.
    """
    share = tolerance / 4
    return Precision(
        np.full(len(radii), share), np.divide(share, radii, out=np.full(len(radii), share), where=radii > 0)
    )


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

    def add(self, node: int, path: str, samples: npt.NDArray[np.intp], values: FloatArray) -> None:
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

    def _times(self, samples: npt.NDArray[np.intp]) -> int:
        """Channels with key frames at the same instants share their times."""
        key = blake2b(samples.tobytes()).digest()
        if key not in self._known:
            self._known[key] = self.binary.add(self.clock[samples].astype(np.float32), bounds=True)
        return self._known[key]


def clock(times: FloatArray) -> FloatArray:
    """Seconds since the first. Raises FileTrouble when 32 bits, all that glTF has, cannot tell two apart."""
    since: FloatArray = times - times[0]
    if (np.diff(since.astype(np.float32)) <= 0).any():
        raise FileTrouble(
            "the frames are too close together for the 32-bit times of glTF; --fps, --from or --until helps"
        )
    return since


def animate(
    clip: Clip, bodies: npt.NDArray[np.intp], fine: Precision, binary: Binary, folder: Path
) -> Animation:
    """Adds the motion of `bodies` (R), whose nodes have their numbers; what one does not do has no channel.

    folder: where samples wait that do not fit into memory.
    """
    animation = Animation(clock(clip.times), binary)
    with TemporaryFile(dir=folder) as one, TemporaryFile(dir=folder) as other:
        positions, orientations = Spool(one, len(bodies), 3), Spool(other, len(bodies), 4)
        thin(clip, bodies, fine, positions, orientations)
        binary.begin_view()
        for row, (samples, values) in enumerate(positions.motions()):
            if np.linalg.norm(values - values[0], axis=1).max() > fine.shift[row]:
                animation.add(int(bodies[row]), "translation", samples, gltf_axes.turned(values))
        for row, (samples, values) in enumerate(orientations.motions()):
            first = np.broadcast_to(values[0], values.shape)
            if np.linalg.norm(turn(first, values), axis=1).max() > fine.turn[row]:
                animation.add(int(bodies[row]), "rotation", samples, gltf_axes.quaternions(values))
    return animation


def thin(
    clip: Clip, bodies: npt.NDArray[np.intp], fine: Precision, positions: Spool, orientations: Spool
) -> None:
    """Reads the clip once and keeps the samples that are needed."""
    anywhere = np.full(len(bodies), np.inf)
    ways = Thinner(shift, fine.shift, anywhere)
    turns = Thinner(turn, fine.turn, np.cbrt(fine.turn / STRAIGHT_ERROR))
    before = None
    for part, position, orientation in clip.blocks(bodies):
        signed = in_one_hemisphere(orientation, before)
        before = signed[-1]
        for keys in ways.add(clip.times[part], position):
            positions.add(keys)
        for keys in turns.add(clip.times[part], signed):
            orientations.add(keys)
    for keys in ways.last():
        positions.add(keys)
    for keys in turns.last():
        orientations.add(keys)
