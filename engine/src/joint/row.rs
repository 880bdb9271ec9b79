//! One scalar constraint equation C(x) = 0 between bodies.

use glam::DVec3;

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
    /// The part of the Jacobian that is in use.
    #[must_use]
    pub fn ends(&self) -> &[End] {
        &self.ends[..self.count]
    }
}
