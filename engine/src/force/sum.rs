//! Where forces are added up.

use glam::DVec3;

use super::wrench::{Powers, Wrench};
use crate::body::Body;

/// The bodies and what has come together on them so far.
pub(super) struct Sum<'a> {
    pub(super) bodies: &'a [Body],
    pub(super) powers: Powers,
    wrenches: &'a mut [Wrench],
}

impl<'a> Sum<'a> {
    pub(super) fn new(bodies: &'a [Body], wrenches: &'a mut [Wrench]) -> Self {
        Self {
            bodies,
            powers: Powers::default(),
            wrenches,
        }
    }

    /// Force and torque of a potential or a damper between bodies.
    ///
    /// Of a spring between a moving body B and a fixed body A that is moved as prescribed, d(kinetic + stored)/dt is
    /// F_B . v_B + T n . (v_B - v_A) with F_B = -T n, which leaves -F_A . v_A, F_A = T n: what the drive of A spends.
    pub(super) fn interact(&mut self, body: usize, force: DVec3, torque: DVec3) {
        let b = &self.bodies[body];
        if b.is_fixed() {
            self.powers.motors -= force.dot(b.state.velocity) + torque.dot(b.angular_velocity);
        } else {
            self.push(body, force, torque);
        }
    }

    /// Force and torque on a moving body.
    pub(super) fn push(&mut self, body: usize, force: DVec3, torque: DVec3) {
        let wrench = &mut self.wrenches[body];
        wrench.force += force;
        wrench.torque += torque;
    }
}
