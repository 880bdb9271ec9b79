"""Two trajectories held against each other: where they part, how far they go, and what was set
differently.
"""

from physsim.analysis.diff.compare import Comparison, Divergence, Growth, compare
from physsim.analysis.diff.settings import Setting, differing_settings

__all__ = ["Comparison", "Divergence", "Growth", "Setting", "compare", "differing_settings"]
