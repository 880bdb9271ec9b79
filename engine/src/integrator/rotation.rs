//! Torque-free rotation by splitting.
//!
//! H = L1^2/(2 I1) + L2^2/(2 I2) + L3^2/(2 I3) in principal axes is the sum of three parts, each of which is solved
//! exactly by a rotation about its axis with the angle t L_k / I_k. One after the other they are of first order
//! (Lie-Trotter); forth and back with half the time, of second (NO_SQUISH: Miller et al. 2002, J. Chem. Phys. 116,
//! 8649). Both are symplectic and leave the angular momentum in world axes as it is, to the last bit.

use glam::{DQuat, DVec3};

use crate::body::Body;
use crate::math::rotation_from_vector;

/// Axes and shares of the time, in order.
type Splitting = &'static [(usize, f64)];

/// First order.
pub const LIE_TROTTER: Splitting = &[(0, 1.0), (1, 1.0), (2, 1.0)];
/// Second order, the same backwards in time.
pub const NO_SQUISH: Splitting = &[(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)];

/// Turn a body for the time `t` [s], without torque.
pub fn rotate_free(body: &mut Body, t: f64, splitting: Splitting) {
    let moments = body.mass.moments;
    let spread = moments.max_element() - moments.min_element();
    if spread <= 1e-12 * moments.max_element() {
        // All moments equal: the axis does not move, one rotation is exact.
        let turn = rotation_from_vector(body.angular_velocity * t);
        body.state.orientation = turn * body.state.orientation;
        return;
    }
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
