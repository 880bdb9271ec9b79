"""The run loop: engine, recorder, progress, checkpoints, and what is checked before and after a run."""

from physsim.simulation.expectations import ExpectationResult, check_expectations, demand
from physsim.simulation.onlooker import Onlooker
from physsim.simulation.overlaps import Overlap, find_overlaps, overlap_problems
from physsim.simulation.progress import Progress
from physsim.simulation.run import run
from physsim.simulation.stop import Interrupted
from physsim.simulation.watch import Wanted, watch
from physsim.simulation.watched import Watched

__all__ = [
    "ExpectationResult",
    "Interrupted",
    "Onlooker",
    "Overlap",
    "Progress",
    "Wanted",
    "Watched",
    "check_expectations",
    "demand",
    "find_overlaps",
    "overlap_problems",
    "run",
    "watch",
]
