"""The page of a run while it computes: a process beside the run serves it."""
