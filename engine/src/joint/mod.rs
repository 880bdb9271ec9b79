//! Joints: what they hold, what drives them.

mod row;

pub use row::{End, Row};
