//! Springs and dampers about an axis.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};

use super::law::Law;
use super::spring::SpringModel;
use super::sum::Sum;
use crate::body::Body;

/// 1 + z_A . z_B below which the axes count as opposed: B then stands on its head, and its twist does not exist.
const OPPOSED: f64 = 1e-15;

/// The angle is the twist of B against A about the axis: with Q = (w, v) the rotation of B since the start as seen from
/// A, a the axis in A, and p = v . a, Q is a rotation by
///
///   theta = 2 atan2(p, w)
///
/// about a, and a swing about an axis across a. Its rate: dQ/dt = (0, omega) Q / 2 with omega = omega_B - omega_A in A's
/// axes gives dw/dt = -omega . v / 2 and dp/dt = (w omega . a + omega . (v x a)) / 2, hence
///
///   d theta/dt = 2 (w dp/dt - p dw/dt) / (w^2 + p^2) = g . omega,   g = (w^2 a + w v x a + p v) / (w^2 + p^2).
///
/// The axis of B is b = Q a = (w^2 - v^2) a + 2 p v + 2 w v x a. With w^2 + v^2 = 1 this makes
/// a + b = 2 (w^2 a + w v x a + p v) and 1 + a . b = 2 (w^2 + p^2), so that in world axes
///
///   g = (z_A + z_B) / (1 + z_A . z_B).
///
/// The torque T(theta, d theta/dt) g on A and -T g on B is the gradient of the stored energy, also where the axes have
/// come apart; a torque along z_A would not be one, and would make energy. At right angles |g| is sqrt(2), and it grows
/// without bound towards opposed axes, where the twist jumps.
#[derive(Clone, Debug)]
pub(super) struct TorsionalSpring {
    bodies: [usize; 2],
    axes: [DVec3; 2],
    /// B's axes as seen from A at the start.
    start: DQuat,
    pub(super) law: Law,
    /// The angle when last observed [rad], whole turns included.
    pub(super) observed: f64,
}

/// How far a spring is wound and how it turns.
struct Twist {
    /// theta [rad], unwrapped
    angle: f64,
    /// g, zero where the axes are opposed.
    gradient: DVec3,
    /// d theta/dt [rad/s]
    rate: f64,
}

impl TorsionalSpring {
    pub(super) fn new(model: &SpringModel, bodies: &[Body]) -> Self {
        Self {
            bodies: model.bodies,
            axes: model.axes,
            start: relative(bodies, model.bodies),
            law: Law::new(model),
            observed: 0.0,
        }
    }

    pub(super) fn add(&self, sum: &mut Sum<'_>) {
        let twist = self.twist(sum.bodies);
        let tension = self.law.tension(twist.angle, twist.rate);
        let torque = twist.gradient * tension.total;
        sum.powers.damping -= (tension.total - tension.elastic) * twist.rate;
        sum.interact(self.bodies[0], DVec3::ZERO, torque);
        sum.interact(self.bodies[1], DVec3::ZERO, -torque);
    }

    pub(super) fn energy(&self, bodies: &[Body]) -> f64 {
        self.law.energy(self.angle(bodies))
    }

    /// Angle [rad] and torque [N m].
    pub(super) fn reading(&self, bodies: &[Body]) -> (f64, f64) {
        let twist = self.twist(bodies);
        let tension = self.law.tension(twist.angle, twist.rate);
        (twist.angle, tension.total)
    }

    pub(super) fn observe(&mut self, bodies: &[Body]) {
        self.observed = self.angle(bodies);
    }

    /// theta, with the turns that bring it closest to the angle last observed.
    fn angle(&self, bodies: &[Body]) -> f64 {
        let now = relative(bodies, self.bodies) * self.start.conjugate();
        let sine = DVec3::new(now.x, now.y, now.z).dot(self.axes[0]);
        let angle = 2.0 * libm::atan2(sine, now.w);
        angle + TAU * ((self.observed - angle) / TAU).round()
    }

    fn twist(&self, bodies: &[Body]) -> Twist {
        let (a, b) = (&bodies[self.bodies[0]], &bodies[self.bodies[1]]);
        let (z_a, z_b) = (a.rotation * self.axes[0], b.rotation * self.axes[1]);
        let overlap = 1.0 + z_a.dot(z_b);
        let gradient = if overlap > OPPOSED {
            (z_a + z_b) / overlap
        } else {
            DVec3::ZERO
        };
        Twist {
            angle: self.angle(bodies),
            gradient,
            rate: gradient.dot(b.angular_velocity - a.angular_velocity),
        }
    }
}

/// B's axes as seen from A.
fn relative(bodies: &[Body], [a, b]: [usize; 2]) -> DQuat {
    bodies[a].state.orientation.conjugate() * bodies[b].state.orientation
}
