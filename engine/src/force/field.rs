//! Uniform fields of acceleration, everywhere or in a region.

use glam::DVec3;

use super::sum::Sum;
use crate::profile::{Moment, Schedule};

/// Accelerates a body while its centre of mass is in the region. It does work: a field that ends somewhere, or changes
/// with time, has no potential.
#[derive(Clone, Debug)]
pub struct Field {
    /// Index of the body.
    pub body: usize,
    /// [m/s^2]
    pub acceleration: DVec3,
    /// Lowest and highest corner [m], part of the region; may be infinite.
    pub region: [DVec3; 2],
    /// Multiplies the acceleration.
    pub schedule: Schedule,
}

impl Field {
    /// F = m a; its power is F . v.
    pub(super) fn add(&self, sum: &mut Sum<'_>, moment: Moment) {
        let body = &sum.bodies[self.body];
        let factor = self.schedule.factor(moment);
        if factor == 0.0 || body.is_fixed() || !self.covers(body.state.position) {
            return;
        }
        let force = self.acceleration * (factor * body.mass.mass);
        sum.powers.forces += force.dot(body.state.velocity);
        sum.push(self.body, force, DVec3::ZERO);
    }

    fn covers(&self, point: DVec3) -> bool {
        point.cmpge(self.region[0]).all() && point.cmple(self.region[1]).all()
    }
}
