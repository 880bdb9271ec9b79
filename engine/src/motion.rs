//! Prescribed motion of fixed bodies: a shaking table, a turning drum, a lift.

#[cfg(test)]
mod tests;

use glam::{DQuat, DVec3};

use crate::body::State;
use crate::math::rotation_from_vector;
use crate::profile::{Integral, Schedule};

/// What the profile multiplies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKind {
    /// A displacement [m] and a rotation vector [rad].
    Position,
    /// A velocity [m/s] and an angular velocity [rad/s].
    Velocity,
}

/// Moves a body along its profile: with the course s(t),
///
///   R = exp(s angular),  center' = center + s linear,
///   position = center' + R (start - center),  orientation = R start,
///   omega = s' angular,  v = s' linear + omega x R (start - center),
///   alpha = s'' angular,  a = s'' linear + alpha x R (start - center) + omega x (omega x R (start - center)).
///
/// The axis stays, so that this is exact. Position: s is the profile; before its window the body stands at its start,
/// after it where it then is. Velocity: s is the integral of the profile over the window.
#[derive(Clone, Debug)]
pub struct Motion {
    body: usize,
    kind: MotionKind,
    linear: DVec3,
    angular: DVec3,
    center: DVec3,
    schedule: Schedule,
    integral: Integral,
}

impl Motion {
    /// linear: [m] or [m/s]; angular: rotation vector [rad] or [rad/s], world axes; center: the point [m] that
    /// `linear` moves and the rotation leaves alone, where it is at the start.
    #[must_use]
    pub fn new(
        body: usize,
        kind: MotionKind,
        (linear, angular): (DVec3, DVec3),
        center: DVec3,
        schedule: Schedule,
    ) -> Self {
        Self {
            body,
            kind,
            linear,
            angular,
            center,
            integral: Integral::new(schedule.profile.clone()),
            schedule,
        }
    }

    /// Index of the body that is moved.
    #[must_use]
    pub fn body(&self) -> usize {
        self.body
    }

    /// Position of the centre of mass [m] and orientation at the time `t` [s] of a body that starts in `start`.
    #[must_use]
    pub fn pose(&self, start: &State, t: f64) -> (DVec3, DQuat) {
        let course = self.course(t);
        let turn = rotation_from_vector(self.angular * course);
        let arm = turn * (start.position - self.center);
        (
            self.center + self.linear * course + arm,
            (turn * start.orientation).normalize(),
        )
    }

    /// Velocity of the centre of mass [m/s] and angular velocity [rad/s], world axes.
    #[must_use]
    pub fn velocity(&self, start: &State, t: f64) -> (DVec3, DVec3) {
        let (rate, _) = self.rates(t);
        let omega = self.angular * rate;
        (self.linear * rate + omega.cross(self.arm(start, t)), omega)
    }

    /// Acceleration of the centre of mass [m/s^2] and angular acceleration [rad/s^2], world axes.
    #[must_use]
    pub fn acceleration(&self, start: &State, t: f64) -> (DVec3, DVec3) {
        let (rate, curvature) = self.rates(t);
        let (omega, alpha) = (self.angular * rate, self.angular * curvature);
        let arm = self.arm(start, t);
        let turning = alpha.cross(arm) + omega.cross(omega.cross(arm));
        (self.linear * curvature + turning, alpha)
    }

    /// Once a step, at its time: keeps what the course to later times builds on. Changes no value.
    pub fn observe(&mut self, t: f64) {
        if self.kind == MotionKind::Velocity {
            self.integral.observe(self.elapsed(t));
        }
    }

    /// s(t)
    fn course(&self, t: f64) -> f64 {
        match self.kind {
            MotionKind::Velocity => self.integral.value(self.elapsed(t)),
            MotionKind::Position if t < self.schedule.from => 0.0,
            MotionKind::Position => self
                .schedule
                .profile
                .as_ref()
                .map_or(1.0, |p| p.value(self.elapsed(t))),
        }
    }

    /// s' and s'', 0 outside the window.
    fn rates(&self, t: f64) -> (f64, f64) {
        let [factor, rate, curvature] = self.schedule.derivatives(t);
        match self.kind {
            MotionKind::Velocity => (factor, rate),
            MotionKind::Position => (rate, curvature),
        }
    }

    /// R (start - center)
    fn arm(&self, start: &State, t: f64) -> DVec3 {
        rotation_from_vector(self.angular * self.course(t)) * (start.position - self.center)
    }

    /// Time spent in the window [s].
    fn elapsed(&self, t: f64) -> f64 {
        (t.min(self.schedule.until) - self.schedule.from).max(0.0)
    }
}
