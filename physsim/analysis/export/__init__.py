"""Trajectories as tables for other programs: CSV and Parquet, wide and long, block by block."""

from physsim.analysis.export.rows import Batch, contact_rows, impact_rows, long_rows, wide_rows
from physsim.analysis.export.writers import WRITERS, check_writer, write

__all__ = [
    "WRITERS",
    "Batch",
    "check_writer",
    "contact_rows",
    "impact_rows",
    "long_rows",
    "wide_rows",
    "write",
]
