"""What is read out of trajectories. Nothing here steps a world: files come through `physsim.recording`."""
