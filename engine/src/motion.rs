//! Fixed bodies that move on a prescribed path.
