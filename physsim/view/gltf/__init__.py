"""A trajectory as an animated binary glTF file."""
