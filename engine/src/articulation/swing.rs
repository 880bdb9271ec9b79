//! How swiftly joints under tension let their bodies swing.

use glam::{DMat3, DVec3};

use super::Articulation;
use crate::body::Body;
use crate::mover::Twist;

/// Rounds of the power iteration: it comes to within some per cent from below.
const ROUNDS: usize = 6;

impl Articulation {
    /// The greatest omega^2 [1/s^2] of K phi = omega^2 I phi among the motions that joints allow, or a number that asks for as
    /// many `parts` of the step.
    ///
    /// Without joints it would be the greatest eigenvalue of any I^-1 K. Where that asks for more than one, power iteration
    /// with P I^-1 K, P V = V - M^-1 J^T A^-1 J V, begins with bodies that turn to and fro in turn: the swiftest swing of a
    /// chain. It comes from below, and ends where it asks for as many as that bound.
    pub fn swiftest_swing(
        &mut self,
        bodies: &[Body],
        stiffness: &[DMat3],
        parts: impl Fn(f64) -> f64,
    ) -> f64 {
        let loose = |k: usize| greatest_eigenvalue(&(bodies[k].inverse_inertia * stiffness[k]));
        let mut swiftest = 0.0_f64;
        for assembly in 0..self.len() {
            let members = self.bodies(assembly).iter();
            let bound = members.map(|&k| loose(k)).fold(0.0, f64::max);
            swiftest = swiftest.max(if parts(bound) <= 1.0 {
                bound
            } else {
                let enough = |square: f64| parts(square) >= parts(bound);
                self.iterate(assembly, bodies, stiffness, enough)
            });
        }
        swiftest
    }

    fn iterate(
        &mut self,
        assembly: usize,
        bodies: &[Body],
        stiffness: &[DMat3],
        enough: impl Fn(f64) -> bool,
    ) -> f64 {
        let mut motion = std::mem::take(&mut self.trial);
        motion.clear();
        motion.resize(bodies.len(), Twist::default());
        let mut sign = 1.0;
        for &k in self.bodies(assembly) {
            motion[k].angular_velocity = DVec3::splat(sign);
            sign = -sign;
        }
        let mut swing = 0.0;
        for _ in 0..ROUNDS {
            let (mut before, mut after) = (0.0, 0.0);
            for &k in self.bodies(assembly) {
                let turn = motion[k].angular_velocity;
                let torque = stiffness[k] * turn;
                before += torque.dot(turn);
                motion[k] = Twist {
                    velocity: DVec3::ZERO,
                    angular_velocity: bodies[k].inverse_inertia * torque,
                };
            }
            self.respond_roughly(assembly, &mut motion);
            for &k in self.bodies(assembly) {
                let turn = motion[k].angular_velocity;
                after += turn.dot(stiffness[k] * turn);
            }
            // |V'|_K / |V|_K
            swing = (after / before).max(0.0).sqrt();
            if swing == 0.0 || !swing.is_finite() {
                swing = 0.0;
                break;
            }
            if enough(swing) {
                break;
            }
            for &k in self.bodies(assembly) {
                motion[k].angular_velocity /= swing;
            }
        }
        self.trial = motion;
        swing
    }
}

/// Not less than the greatest eigenvalue of a matrix of real eigenvalues, by its trace and that of its square (Wolkowicz and
/// Styan 1980, "Bounds for eigenvalues using traces", theorem 2.1).
fn greatest_eigenvalue(m: &DMat3) -> f64 {
    let trace = m.x_axis.x + m.y_axis.y + m.z_axis.z;
    let square = m.x_axis.dot(m.transpose().x_axis)
        + m.y_axis.dot(m.transpose().y_axis)
        + m.z_axis.dot(m.transpose().z_axis);
    trace / 3.0 + (2.0 / 3.0 * (square - trace * trace / 3.0)).max(0.0).sqrt()
}
