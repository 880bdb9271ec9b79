//! Declared forces and torques.

use glam::DVec3;

use super::sum::Sum;
use crate::profile::{Moment, Schedule};

/// Axes in which a force is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// They stay.
    World,
    /// They turn with the body.
    Body,
}

/// A force at a point of a body, a torque, or both.
#[derive(Clone, Debug)]
pub struct AppliedForce {
    /// Index of the body.
    pub body: usize,
    /// [N]
    pub force: DVec3,
    /// [N m]
    pub torque: DVec3,
    /// Point of attack from the centre of mass, body axes [m].
    pub at: DVec3,
    /// Of force and torque.
    pub axes: Axes,
    /// Multiplies both.
    pub schedule: Schedule,
}

impl AppliedForce {
    /// F and r x F + M; the power is F . v + (r x F + M) . omega.
    pub(super) fn add(&self, sum: &mut Sum<'_>, moment: Moment) {
        let body = &sum.bodies[self.body];
        let factor = self.schedule.factor(moment);
        if factor == 0.0 || body.is_fixed() {
            return;
        }
        let (force, torque) = match self.axes {
            Axes::World => (self.force, self.torque),
            Axes::Body => (body.rotation * self.force, body.rotation * self.torque),
        };
        let force = force * factor;
        let torque = torque * factor + (body.rotation * self.at).cross(force);
        sum.powers.forces += force.dot(body.state.velocity) + torque.dot(body.angular_velocity);
        sum.push(self.body, force, torque);
    }
}
