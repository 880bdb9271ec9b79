"""Sweeps: what varies, where the runs are done, and how their results are gathered."""

from physsim.batch.load import Sweep, load_sweep
from physsim.batch.sweep import Progress, SweepResult, sweep

__all__ = ["Progress", "Sweep", "SweepResult", "load_sweep", "sweep"]
