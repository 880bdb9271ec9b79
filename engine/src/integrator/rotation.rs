//! Torque-free rotation.
//!
//! A body with two equal moments I, and I_k about its axis e_k, turns as a whole about its angular momentum L at the rate
//! L/I, and by itself about its axis at the rate L_k (1/I_k - 1/I): R(t) = exp(t L/I) R exp(t L_k (1/I_k - 1/I) e_k) is
//! exact (Goldstein, Classical Mechanics, section 5.6).
//!
//! Other bodies turn by splitting: H = L1^2/(2 I1) + L2^2/(2 I2) + L3^2/(2 I3) in principal axes is the sum of three
//! parts, each of which is solved exactly by a rotation about its axis with the angle t L_k / I_k. One after the other
//! they are of first order (Lie-Trotter); forth and back with half the time, of second (NO_SQUISH: Miller et al. 2002,
//! J. Chem. Phys. 116, 8649). All of them are symplectic and leave the angular momentum in world axes as it is, to the
//! last bit.

use glam::{DMat3, DQuat, DVec3};

use crate::body::{MassProperties, State, Symmetry};
use crate::math::rotation_from_vector;

/// Axes and shares of the time, in order.
pub type Splitting = &'static [(usize, f64)];

/// First order.
pub const LIE_TROTTER: Splitting = &[(0, 1.0), (1, 1.0), (2, 1.0)];
/// Second order, the same backwards in time.
pub const NO_SQUISH: Splitting = &[(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)];

/// The orientation after the time `t` [s], without torque.
#[must_use]
pub fn turned(mass: &MassProperties, state: &State, t: f64, splitting: Splitting) -> DQuat {
    match mass.symmetry {
        Symmetry::Sphere => {
            let omega = state.angular_momentum * mass.inverse_moments.x;
            rotation_from_vector(omega * t) * state.orientation
        }
        Symmetry::Axis(k) => turned_about(mass, state, t, k),
        Symmetry::None => turned_split(mass, state, t, splitting),
    }
}

/// A body whose moments are equal but for that about its principal axis `k`.
fn turned_about(mass: &MassProperties, state: &State, t: f64, k: usize) -> DQuat {
    let inverse = mass.inverse_moments;
    let across = inverse[(k + 1) % 3];
    let principal = state.orientation * mass.axes;
    let momentum = state.angular_momentum;
    let along = momentum.dot(principal * DVec3::AXES[k]);
    let whole = rotation_from_vector(momentum * (across * t));
    let own = Spin::new(k, along * (inverse[k] - across) * t);
    whole * own.turn(principal) * mass.axes.conjugate()
}

fn turned_split(mass: &MassProperties, state: &State, t: f64, splitting: Splitting) -> DQuat {
    let mut principal = state.orientation * mass.axes;
    let mut momentum = (principal.conjugate() * state.angular_momentum).to_array();
    for &(k, share) in splitting {
        let spin = Spin::new(k, share * t * momentum[k] * mass.inverse_moments[k]);
        principal = spin.turn(principal);
        spin.follow(&mut momentum);
    }
    principal * mass.axes.conjugate()
}

/// A rotation about a principal axis.
struct Spin {
    axis: usize,
    /// Of half the angle.
    sine: f64,
    cosine: f64,
}

impl Spin {
    fn new(axis: usize, angle: f64) -> Self {
        let (sine, cosine) = libm::sincos(0.5 * angle);
        Self { axis, sine, cosine }
    }

    /// The two axes that turn, the first towards the second.
    fn others(&self) -> (usize, usize) {
        ((self.axis + 1) % 3, (self.axis + 2) % 3)
    }

    /// q (cos + sin e), the spin within the frame `q`.
    fn turn(&self, q: DQuat) -> DQuat {
        let (k, (i, j), q) = (self.axis, self.others(), q.to_array());
        let (s, c) = (self.sine, self.cosine);
        let mut out = [0.0; 4];
        out[k] = q[3] * s + q[k] * c;
        out[i] = q[i] * c + q[j] * s;
        out[j] = q[j] * c - q[i] * s;
        out[3] = q[3] * c - q[k] * s;
        DQuat::from_array(out)
    }

    /// A vector that stays in the world, in axes that spin.
    fn follow(&self, v: &mut [f64; 3]) {
        let (i, j) = self.others();
        let (s, c) = (self.sine, self.cosine);
        let (sine, cosine) = (2.0 * s * c, (c - s) * (c + s));
        (v[i], v[j]) = (v[i] * cosine + v[j] * sine, v[j] * cosine - v[i] * sine);
    }
}

/// The derivative of [`turned`] by the angular momentum: a change dL of it turns the end by the small rotation vector
/// F dL [rad], both in world axes.
///
/// A body that turns as a whole by the vector a = t L/I ends with F = t/I E(a), E(a) = 1 + (1 - cos|a|)/|a|^2 [a] +
/// (|a| - sin|a|)/|a|^3 [a]^2, where [a] b = a x b. Where it also turns about its own axis, from e to e', by t (1/I_k -
/// 1/I) e . L, that adds t (1/I_k - 1/I) e' e^T.
#[must_use]
pub fn turn_by_momentum(
    mass: &MassProperties,
    state: &State,
    t: f64,
    splitting: Splitting,
) -> DMat3 {
    let inverse = mass.inverse_moments;
    let momentum = state.angular_momentum;
    match mass.symmetry {
        Symmetry::Sphere => whole_turn(momentum, inverse.x * t),
        Symmetry::Axis(k) => {
            let across = inverse[(k + 1) % 3];
            let axis = state.orientation * (mass.axes * DVec3::AXES[k]);
            let end = rotation_from_vector(momentum * (across * t)) * axis;
            whole_turn(momentum, across * t) + outer(end, axis * (t * (inverse[k] - across)))
        }
        Symmetry::None => split_turn(mass, state, t, splitting),
    }
}

/// s E(s L)
fn whole_turn(momentum: DVec3, s: f64) -> DMat3 {
    let a = momentum * s;
    let square = a.length_squared();
    // Series of (1 - cos x)/x^2 and (x - sin x)/x^3, good to 1e-3 at x = 2.
    let once = 0.5 - square * (1.0 / 24.0 - square / 720.0);
    let twice = 1.0 / 6.0 - square * (1.0 / 120.0 - square / 5040.0);
    let cross = cross_matrix(a);
    s * (DMat3::IDENTITY + once * cross + twice * (cross * cross))
}

/// Each part turns by the angle share t/I_k p . L about the principal axis p as it then is, and p follows what the parts
/// before have been turned by: F' = F + share t/I_k p p^T (1 + [L] F).
fn split_turn(mass: &MassProperties, state: &State, t: f64, splitting: Splitting) -> DMat3 {
    let mut principal = state.orientation * mass.axes;
    let cross = cross_matrix(state.angular_momentum);
    let mut turn = DMat3::ZERO;
    for &(k, share) in splitting {
        let axis = principal * DVec3::AXES[k];
        let rate = share * t * mass.inverse_moments[k];
        let felt = (DMat3::IDENTITY + cross * turn).transpose() * axis;
        turn += outer(axis, felt * rate);
        let angle = rate * axis.dot(state.angular_momentum);
        principal = Spin::new(k, angle).turn(principal);
    }
    turn
}

/// a b^T
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// [a] b = a x b
fn cross_matrix(a: DVec3) -> DMat3 {
    DMat3::from_cols(a.cross(DVec3::X), a.cross(DVec3::Y), a.cross(DVec3::Z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rotation_vector;

    #[test]
    fn turns_follow_the_momentum_as_the_derivative_says() {
        let state = State {
            orientation: DQuat::from_xyzw(0.3, -0.2, 0.5, 0.8).normalize(),
            angular_momentum: DVec3::new(0.7, -1.1, 0.4),
            ..State::default()
        };
        for moments in [[1.0, 1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 2.0, 2.5]] {
            let inertia = DMat3::from_diagonal(DVec3::from_array(moments));
            let mass = MassProperties::new(1.0, inertia);
            for splitting in [LIE_TROTTER, NO_SQUISH] {
                let derivative = turn_by_momentum(&mass, &state, 0.3, splitting);
                for axis in DVec3::AXES {
                    let at = |step: f64| {
                        let mut moved = state;
                        moved.angular_momentum += axis * step;
                        turned(&mass, &moved, 0.3, splitting)
                    };
                    let turn = rotation_vector(at(1e-5) * at(-1e-5).conjugate()) / 2e-5;
                    let off = (turn - derivative * axis).length();
                    assert!(off < 1e-7, "{moments:?} {off}");
                }
            }
        }
    }
}
