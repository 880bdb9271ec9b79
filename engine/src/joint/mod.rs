//! Joints: what they hold, which coordinates they leave, and what drives these.
//!
//! Geometry and forces only; whoever solves for joint impulses takes `Row`s. Read `layout.rs` first: the table of the
//! kinds. A new kind is a variant in `model.rs` and a line in that table.

mod check;
mod drive;
mod joints;
mod layout;
mod lock;
mod measure;
mod model;
mod placement;
mod pull;
mod row;
mod tension;

pub use check::check;
pub use drive::{Ahead, Cause, DriveRow};
pub use joints::{JointState, Joints};
pub use lock::Lock;
pub use model::{DriveModel, JointModel, Kind, Motor};
pub use row::{Course, End, Row};

#[cfg(test)]
mod drive_tests;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
