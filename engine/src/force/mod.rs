//! Forces that depend on position, velocity and time.
//!
//! Uniform gravity, springs and pairwise gravitation have potentials; dampers and drag take energy; declared forces and
//! uniform fields do work. `evaluate` gives the wrench on every body that moves and the power of everything that is not
//! a potential, so that d(kinetic + potential)/dt is the sum of the powers.

mod applied;
mod drag;
mod field;
mod gravitation;
mod law;
mod linear;
mod spring;
mod sum;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod torsional;
mod wrench;

use glam::DVec3;

pub use applied::{AppliedForce, Axes};
pub use drag::Drag;
pub use field::Field;
pub use law::Acts;
pub use spring::{SpringKind, SpringModel};
pub use wrench::{Potential, Powers, Wrench};

use crate::body::Body;
use crate::profile::Moment;
use crate::team::each_with;
use gravitation::Gravitation;
use spring::Spring;
use sum::Sum;

/// Everything that acts on bodies but contacts and joints.
#[derive(Clone, Debug, Default)]
pub struct ForceModel {
    /// [m/s^2]
    pub gravity: DVec3,
    /// Constant of pairwise attraction [m^3/(kg s^2)]; 0 switches it off.
    pub gravitation: f64,
    /// By body [kg], also of bodies that are fixed; bodies beyond the end, and those with 0, attract nothing.
    pub attracting_mass: Vec<f64>,
    /// In the order of their readings.
    pub springs: Vec<SpringModel>,
    /// Declared forces and torques.
    pub applied: Vec<AppliedForce>,
    /// Resistance of the medium.
    pub drags: Vec<Drag>,
    /// Uniform fields of acceleration.
    pub fields: Vec<Field>,
}

/// The forces of a world. What they remember is how far torsional springs have been wound.
#[derive(Clone, Debug)]
pub struct Forces {
    gravity: DVec3,
    gravitation: Gravitation,
    springs: Vec<Spring>,
    applied: Vec<AppliedForce>,
    drags: Vec<Drag>,
    fields: Vec<Field>,
}

impl Forces {
    /// `bodies` as they stand at the start: angles of torsional springs count from here.
    #[must_use]
    pub fn new(model: ForceModel, bodies: &[Body]) -> Self {
        let springs = model.springs.into_iter();
        Self {
            gravity: model.gravity,
            gravitation: Gravitation::new(model.gravitation, &model.attracting_mass),
            springs: springs.map(|s| Spring::new(s, bodies)).collect(),
            applied: model.applied,
            drags: model.drags,
            fields: model.fields,
        }
    }

    /// Uniform gravity [m/s^2].
    #[must_use]
    pub fn gravity(&self) -> DVec3 {
        self.gravity
    }

    /// Add what acts on the moving bodies at a moment to `wrenches`, and give the power of all that has no
    /// potential. A fixed body takes nothing; where it is moved as prescribed, the power that its drive spends on
    /// springs and gravitation counts as that of a motor.
    pub fn evaluate(&self, bodies: &[Body], moment: Moment, wrenches: &mut [Wrench]) -> Powers {
        each_with(wrenches, bodies, &|wrench, body| {
            wrench.force += self.gravity * body.mass.mass;
        });
        let mut sum = Sum::new(bodies, wrenches);
        self.gravitation.add(&mut sum);
        for spring in &self.springs {
            spring.add(&mut sum);
        }
        for force in &self.applied {
            force.add(&mut sum, moment);
        }
        for drag in &self.drags {
            drag.add(&mut sum);
        }
        for field in &self.fields {
            field.add(&mut sum, moment);
        }
        sum.powers
    }

    /// Potential energies [J]. They depend on the poses alone.
    #[must_use]
    pub fn potential(&self, bodies: &[Body]) -> Potential {
        let weight = |b: &Body| -b.mass.mass * self.gravity.dot(b.state.position);
        Potential {
            gravitational: bodies.iter().map(weight).sum(),
            gravitation: self.gravitation.energy(bodies),
            spring: self.springs.iter().map(|s| s.energy(bodies)).sum(),
        }
    }

    /// Some force changes with velocities.
    #[must_use]
    pub fn depends_on_velocity(&self) -> bool {
        !self.drags.is_empty() || self.springs.iter().any(Spring::is_damped)
    }

    /// Once a step: counts the turns of torsional springs, which must turn by less than half a turn between two calls.
    pub fn observe(&mut self, bodies: &[Body]) {
        for spring in &mut self.springs {
            spring.observe(bodies);
        }
    }

    /// Angles [rad] of the torsional springs when last observed: what a checkpoint keeps.
    #[must_use]
    pub fn turns(&self) -> Vec<f64> {
        self.springs.iter().filter_map(Spring::observed).collect()
    }

    /// Take back what [`Forces::turns`] gave; `false`, and nothing changed, when it is of another world.
    pub fn set_turns(&mut self, turns: &[f64]) -> bool {
        if turns.len() != self.springs.iter().filter_map(Spring::observed).count() {
            return false;
        }
        let wound = self.springs.iter_mut().filter_map(Spring::observed_mut);
        for (observed, &angle) in wound.zip(turns) {
            *observed = angle;
        }
        true
    }

    /// Of every spring: length [m] and tension [N], positive when it pulls its ends together; or angle [rad] since the
    /// start and torque [N m], positive when it turns the angle back.
    pub fn readings<'a>(&'a self, bodies: &'a [Body]) -> impl Iterator<Item = (f64, f64)> + 'a {
        self.springs.iter().map(|s| s.reading(bodies))
    }
}
