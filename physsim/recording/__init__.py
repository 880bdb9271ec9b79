"""The trajectory file: its layout, the recorder that writes it, and the trajectory that reads it."""

from physsim.recording.block import Block
from physsim.recording.connection_track import JointTrack, SpringTrack
from physsim.recording.layout import recorded
from physsim.recording.reader import NotInFile, Trajectory, open_own, open_trajectory
from physsim.recording.recorder import Recorder
from physsim.recording.series import Series, Table
from physsim.recording.target import Target
from physsim.recording.track import BodyTrack

__all__ = [
    "Block",
    "BodyTrack",
    "JointTrack",
    "NotInFile",
    "Recorder",
    "Series",
    "SpringTrack",
    "Table",
    "Target",
    "Trajectory",
    "open_own",
    "open_trajectory",
    "recorded",
]
