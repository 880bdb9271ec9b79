"""Pictures of trajectories and of tables of runs."""

from physsim.analysis.plot.curves import read_wishes
from physsim.analysis.plot.panels import draw_trajectories
from physsim.analysis.plot.tables import draw_table, read_table, units_beside

__all__ = ["draw_table", "draw_trajectories", "read_table", "read_wishes", "units_beside"]
