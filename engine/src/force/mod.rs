//! Forces that depend on position, velocity and time.

mod wrench;

pub use wrench::{Potential, Powers, Wrench};
