"""Pages, pictures, films and models of a trajectory. Reads files through `physsim.recording` only."""
