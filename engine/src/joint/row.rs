//! One scalar function C(x) of two bodies.

use glam::DVec3;

use crate::body::Body;
use crate::force::Wrench;
use crate::mover::Moving;

/// The part of a row's Jacobian that belongs to one body: dC/dt gains linear . v + angular . omega.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct End {
    /// Index of the body.
    pub body: usize,
    /// Of the velocity of the centre of mass.
    pub linear: DVec3,
    /// Of the angular velocity, world axes.
    pub angular: DVec3,
}

impl End {
    /// linear . v + angular . omega
    #[must_use]
    pub fn rate(&self, moving: &[impl Moving]) -> f64 {
        let twist = moving[self.body].twist();
        self.linear.dot(twist.velocity) + self.angular.dot(twist.angular_velocity)
    }
}

/// C, its Jacobian, and what is left of its second derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// Jacobian, that of body A first.
    pub ends: [End; 2],
    /// C [m or rad].
    pub value: f64,
    /// d2C/dt2 with all linear and angular accelerations zero [m/s^2 or rad/s^2].
    pub bias: f64,
}

impl Row {
    /// dC/dt [m/s or rad/s].
    #[must_use]
    pub fn rate(&self, moving: &[impl Moving]) -> f64 {
        self.ends.iter().map(|end| end.rate(moving)).sum()
    }

    /// Add J^T f to the wrenches of the bodies.
    pub fn add_to(&self, f: f64, wrenches: &mut [Wrench]) {
        for end in &self.ends {
            wrenches[end.body].force += end.linear * f;
            wrenches[end.body].torque += end.angular * f;
        }
    }

    /// Change of dC/dt by a unit impulse along the row on bodies that nothing else holds: J M^-1 J^T.
    #[must_use]
    pub fn mobility(&self, bodies: &[Body]) -> f64 {
        let of = |end: &End| {
            let body = &bodies[end.body];
            body.mass.inverse_mass * end.linear.length_squared()
                + end.angular.dot(body.inverse_inertia * end.angular)
        };
        self.ends.iter().map(of).sum()
    }

    /// The row of `factor` times C.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        for end in &mut self.ends {
            end.linear *= factor;
            end.angular *= factor;
        }
        self.value *= factor;
        self.bias *= factor;
        self
    }

    /// The row of the sum of both C, which are of the same bodies.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        for (end, more) in self.ends.iter_mut().zip(&other.ends) {
            end.linear += more.linear;
            end.angular += more.angular;
        }
        self.value += other.value;
        self.bias += other.bias;
        self
    }
}

/// Where the C of a row is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// C [m or rad].
    pub value: f64,
    /// dC/dt [m/s or rad/s].
    pub rate: f64,
    /// d2C/dt2 with all linear and angular accelerations zero [m/s^2 or rad/s^2].
    pub bias: f64,
    /// The row holds something: its joint is whole, its coordinate held.
    pub holds: bool,
}
