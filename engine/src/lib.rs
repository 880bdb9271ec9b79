//! Everything inside a step of physsim: plain arrays in, plain arrays out.
//!
//! Read `world/mod.rs` first: its `step` names every stage in order.

pub mod approach;
pub mod articulation;
mod block;
pub mod body;
pub mod broadphase;
mod carrying;
pub mod collide;
mod cone;
mod conjugate;
pub mod contact;
pub mod curve;
mod direct;
mod disc;
pub mod force;
pub mod impact;
pub mod integrator;
mod interior;
mod islands;
pub mod joint;
mod lanes;
mod layout;
pub mod ledger;
pub mod loads;
mod lorentz;
pub mod math;
pub mod model;
pub mod motion;
pub mod mover;
pub mod narrowphase;
mod pack;
pub mod paths;
mod pattern;
mod point;
pub mod position;
pub mod profile;
mod response;
pub mod roll;
mod schedule;
pub mod shape;
pub mod shuffle;
pub mod solver;
mod subspace;
mod system;
pub mod team;
mod twists;
mod worker;
pub mod world;

#[cfg(feature = "python")]
mod python;
