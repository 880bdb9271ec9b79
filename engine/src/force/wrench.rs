//! What forces come to on a body: force, torque, power, potential energy.

use std::ops::{Add, Mul};

use glam::DVec3;

/// Force [N] and torque [N m] on a body at its centre of mass, world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// [N]
    pub force: DVec3,
    /// About the centre of mass [N m].
    pub torque: DVec3,
}

/// Power [W] that flows into the bodies, by where it comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Powers {
    /// Of declared forces and torques.
    pub forces: f64,
    /// Of dampers and drag; negative while they take energy.
    pub damping: f64,
    /// Of motors that act as springs (servos).
    pub motors: f64,
}

/// Potential energies [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Potential {
    /// In uniform gravity, zero at the origin.
    pub gravitational: f64,
    /// Of pairwise attraction, zero far apart.
    pub gravitation: f64,
    /// Stored in springs.
    pub spring: f64,
}

impl Add for Powers {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            forces: self.forces + other.forces,
            damping: self.damping + other.damping,
            motors: self.motors + other.motors,
        }
    }
}

impl Mul<f64> for Powers {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self {
            forces: self.forces * factor,
            damping: self.damping * factor,
            motors: self.motors * factor,
        }
    }
}

impl Potential {
    /// All of them.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.gravitational + self.gravitation + self.spring
    }
}
