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

use glam::{DQuat, DVec3};

use crate::body::Body;
use crate::math::rotation_from_vector;

/// Axes and shares of the time, in order.
pub type Splitting = &'static [(usize, f64)];

/// First order.
pub const LIE_TROTTER: Splitting = &[(0, 1.0), (1, 1.0), (2, 1.0)];
/// Second order, the same backwards in time.
pub const NO_SQUISH: Splitting = &[(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)];

/// Moments this near to each other, as a part of the greatest, are equal.
const EQUAL: f64 = 1e-12;

/// Turn a body for the time `t` [s], without torque.
pub fn rotate_free(body: &mut Body, t: f64, splitting: Splitting) {
    let moments = body.mass.moments;
    let near =
        |a: usize, b: usize| (moments[a] - moments[b]).abs() <= EQUAL * moments.max_element();
    match (0..3).find(|&k| near((k + 1) % 3, (k + 2) % 3)) {
        Some(k) if near(k, (k + 1) % 3) => {
            let turn = rotation_from_vector(body.angular_velocity * t);
            body.state.orientation = turn * body.state.orientation;
        }
        Some(k) => rotate_symmetric(body, t, k),
        None => rotate_split(body, t, splitting),
    }
}

/// A body whose moments are equal but for that about its principal axis `k`.
fn rotate_symmetric(body: &mut Body, t: f64, k: usize) {
    let inverse = body.mass.inverse_moments;
    let across = inverse[(k + 1) % 3];
    let principal = body.state.orientation * body.mass.axes;
    let momentum = body.state.angular_momentum;
    let along = momentum.dot(principal * DVec3::AXES[k]);
    let whole = rotation_from_vector(momentum * (across * t));
    let own = rotation_from_vector(DVec3::AXES[k] * (along * (inverse[k] - across) * t));
    body.state.orientation = whole * principal * own * body.mass.axes.conjugate();
}

fn rotate_split(body: &mut Body, t: f64, splitting: Splitting) {
    let inverse = body.mass.inverse_moments;
    let mut principal = body.state.orientation * body.mass.axes;
    let mut momentum = principal.conjugate() * body.state.angular_momentum;
    for &(k, share) in splitting {
        let angle = share * t * momentum[k] * inverse[k];
        let turn: DQuat = rotation_from_vector(DVec3::AXES[k] * angle);
        principal *= turn;
        momentum = turn.conjugate() * momentum;
    }
    body.state.orientation = principal * body.mass.axes.conjugate();
}
