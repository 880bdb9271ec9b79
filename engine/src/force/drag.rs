//! Resistance of the medium.

use super::sum::Sum;

/// Force -(linear + quadratic |v|) v at the centre of mass and torque -angular omega.
///
/// Linear is Stokes' law (6 pi mu r for a slow sphere), quadratic Rayleigh's: (1/2) rho C A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// Index of the body.
    pub body: usize,
    /// [N s/m]
    pub linear: f64,
    /// [N m s/rad]
    pub angular: f64,
    /// (1/2) rho C A [kg/m]
    pub quadratic: f64,
}

impl Drag {
    pub(super) fn add(&self, sum: &mut Sum<'_>) {
        let body = &sum.bodies[self.body];
        if body.is_fixed() {
            return;
        }
        let (velocity, omega) = (body.state.velocity, body.angular_velocity);
        let force = -(self.linear + self.quadratic * velocity.length()) * velocity;
        let torque = -self.angular * omega;
        sum.powers.damping += force.dot(velocity) + torque.dot(omega);
        sum.push(self.body, force, torque);
    }
}
