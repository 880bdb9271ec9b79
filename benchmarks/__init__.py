"""physsim beside other engines: one set of scenes, one step. See `python -m benchmarks --help`."""
