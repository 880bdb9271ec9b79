"""The page that plays a trajectory: its data, as exact as fits, and its HTML."""
