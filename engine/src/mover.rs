//! What the contact solve reads and writes: bodies as they move while impulses are still being found.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::contact::Contact;

/// What is solved for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Normal impulses, with friction held.
    Normals,
    /// Normal impulses and friction.
    All,
}

/// What the sweeps read and write of a body, close together in memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mover {
    pub(crate) velocity: DVec3,
    pub(crate) angular_velocity: DVec3,
    pub(crate) inverse_mass: f64,
    pub(crate) inverse_inertia: DMat3,
}

impl Mover {
    /// As the body moves now.
    pub(crate) fn of(body: &Body) -> Self {
        Self {
            velocity: body.state.velocity,
            angular_velocity: body.angular_velocity,
            inverse_mass: body.mass.inverse_mass,
            inverse_inertia: body.inverse_inertia,
        }
    }

    /// Impulse `p` at the arm `r`.
    pub(crate) fn push(&mut self, p: DVec3, r: DVec3) {
        self.velocity += p * self.inverse_mass;
        self.angular_velocity += self.inverse_inertia * r.cross(p);
    }

    /// v + omega x r
    pub(crate) fn velocity_at(&self, r: DVec3) -> DVec3 {
        self.velocity + self.angular_velocity.cross(r)
    }
}

/// Relative velocity of a contact along normal and tangents [m/s].
pub(crate) fn velocity_of(movers: &[Mover], c: &Contact) -> DVec3 {
    let (a, b) = (&movers[c.bodies.0], &movers[c.bodies.1]);
    c.to_local(a.velocity_at(c.arms.0) - b.velocity_at(c.arms.1))
}
