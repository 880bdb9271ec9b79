//! One scalar constraint equation C(x) = 0 between bodies.

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
    /// Jacobian, those of body A first; `count` of them are in use.
    pub ends: [End; 4],
    /// Number of bodies; 0 for a row that constrains nothing (its joint broke).
    pub count: usize,
    /// C [m or rad].
    pub value: f64,
    /// d2C/dt2 with all linear and angular accelerations zero [m/s^2 or rad/s^2].
    pub bias: f64,
    /// C is an angle.
    pub angular: bool,
}

impl Row {
    /// A row between two bodies.
    #[must_use]
    pub fn between(a: End, b: End, value: f64, bias: f64, angular: bool) -> Self {
        let unused = End::default();
        Self {
            ends: [a, b, unused, unused],
            count: 2,
            value,
            bias,
            angular,
        }
    }

    /// The part of the Jacobian that is in use.
    #[must_use]
    pub fn ends(&self) -> &[End] {
        &self.ends[..self.count]
    }

    /// dC/dt [m/s or rad/s].
    #[must_use]
    pub fn rate(&self, moving: &[impl Moving]) -> f64 {
        self.ends().iter().map(|end| end.rate(moving)).sum()
    }

    /// Add J^T f to the wrenches of the bodies.
    pub fn add_to(&self, f: f64, wrenches: &mut [Wrench]) {
        for end in self.ends() {
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
        self.ends().iter().map(of).sum()
    }

    /// The row of `factor` times C.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        for end in &mut self.ends[..self.count] {
            end.linear *= factor;
            end.angular *= factor;
        }
        self.value *= factor;
        self.bias *= factor;
        self
    }

    /// The row of the sum of both C; ends on the same body become one. Four bodies at most.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        self.value += other.value;
        self.bias += other.bias;
        for end in other.ends() {
            self.add_end(end);
        }
        self
    }

    fn add_end(&mut self, end: &End) {
        let known = self.ends[..self.count]
            .iter_mut()
            .find(|e| e.body == end.body);
        if let Some(known) = known {
            known.linear += end.linear;
            known.angular += end.angular;
        } else {
            self.ends[self.count] = *end;
            self.count += 1;
        }
    }
}
