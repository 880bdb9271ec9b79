//! Where every joule went.
//!
//! An impulse J on a set of contacts changes the kinetic energy by exactly the sum of J . (u_before + u_after) / 2 over
//! the contacts, with u the relative velocity before and after all impulses of that set: the kinetic energy is a
//! quadratic form, so its difference is the momentum change times the mean velocity. Nothing else in the books needs an
//! approximation; what the integrator itself adds or takes shows as `residual`.

use serde::{Deserialize, Serialize};

use crate::force::Potential;

/// Running sums since the start [J]; losses are positive when energy was lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Done by declared forces and torques.
    pub work_forces: f64,
    /// Done by motors, conveyors and bodies that follow a path.
    pub work_motors: f64,
    /// Into dampers and drag.
    pub lost_damping: f64,
    /// Into friction.
    pub lost_friction: f64,
    /// Into impacts and the normal part of contacts.
    pub lost_impact: f64,
    /// Added by taking overlaps back.
    pub stabilization: f64,
    /// Total energy at the start.
    pub initial: f64,
}

impl Ledger {
    /// Book an impulse: normal and tangential parts times the mean velocities, both as seen in the contact.
    pub fn book(&mut self, normal_work: f64, tangential_work: f64) {
        self.lost_impact -= normal_work;
        self.lost_friction -= tangential_work;
    }

    /// Both books together.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            work_forces: self.work_forces + other.work_forces,
            work_motors: self.work_motors + other.work_motors,
            lost_damping: self.lost_damping + other.lost_damping,
            lost_friction: self.lost_friction + other.lost_friction,
            lost_impact: self.lost_impact + other.lost_impact,
            stabilization: self.stabilization + other.stabilization,
            initial: self.initial + other.initial,
        }
    }
}

/// Energies at one instant and the books up to it [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Sum of m v^2 / 2.
    pub kinetic_translational: f64,
    /// Sum of omega . L / 2.
    pub kinetic_rotational: f64,
    /// Of gravity, gravitation and springs.
    pub potential: Potential,
    /// The books.
    pub ledger: Ledger,
}

impl Energies {
    /// Kinetic and potential energy together.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic_translational + self.kinetic_rotational + self.potential.total()
    }

    /// What the books do not explain.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let l = &self.ledger;
        self.total() - l.initial - l.stabilization - l.work_forces - l.work_motors
            + l.lost_damping
            + l.lost_friction
            + l.lost_impact
    }
}
