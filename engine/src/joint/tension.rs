//! How fast a mechanism turns about its joints, and how fast it swings under their tension.
//!
//! A joint that pulls with the force f at the arm r of a body resists its turning: a turn phi moves the arm by phi x r, and
//! the torque changes by (phi x r) x f = -K phi, K = (f . r) 1 - (f r^T + r f^T) / 2, f r^T being symmetric for all joints of
//! a body in balance. The swiftest swing is the greatest eigenvalue omega^2 of K phi = omega^2 I phi among the motions that
//! joints allow.

use glam::{DMat3, DVec3};

use super::joints::Joints;
use super::placement::Mount;
use crate::body::Body;

impl Joints {
    /// K of every body [N m/rad]. `pull(j, k)` is the force of joint j on body k.
    pub fn stiffness(
        &self,
        pull: impl Fn(usize, usize) -> DVec3,
        bodies: &[Body],
        out: &mut Vec<DMat3>,
    ) {
        out.clear();
        out.resize(bodies.len(), DMat3::ZERO);
        for (j, joint) in self.joints.iter().enumerate() {
            for mount in &joint.mounts {
                let pull = pull(j, mount.body);
                out[mount.body] += turning_stiffness(pull, mount.arm(bodies));
            }
        }
    }
}

impl Joints {
    /// The greatest rate at which a body turns about a joint [rad/s]: |omega x r| / (r^2 + k^2)^(1/2) with the arm r of the
    /// joint and the radius of gyration k, so that a wheel on its axle does not turn about it.
    #[must_use]
    pub fn fastest_turn(&self, bodies: &[Body]) -> f64 {
        let mounts = self.joints.iter().flat_map(|joint| &joint.mounts);
        let moving = mounts.filter(|mount| !bodies[mount.body].is_fixed());
        let square = |mount: &Mount| {
            let (body, arm) = (&bodies[mount.body], mount.arm(bodies));
            let gyration = body.mass.moments.max_element() * body.mass.inverse_mass;
            body.angular_velocity.cross(arm).length_squared() / (arm.length_squared() + gyration)
        };
        moving.map(square).fold(0.0, f64::max).sqrt()
    }
}

fn turning_stiffness(f: DVec3, r: DVec3) -> DMat3 {
    let dyad = DMat3::from_cols(f * r.x, f * r.y, f * r.z);
    DMat3::from_diagonal(DVec3::splat(f.dot(r))) - 0.5 * (dyad + dyad.transpose())
}
