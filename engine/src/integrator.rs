//! Semi-implicit (symplectic) Euler for translation and rotation.

use glam::{DQuat, DVec3};

use crate::body::Body;
use crate::math::rotation_from_vector;

/// v += a dt. Forces act on the momentum before anything moves.
pub fn kick(body: &mut Body, acceleration: DVec3, timestep: f64) {
    body.state.velocity += acceleration * timestep;
}

/// x += v dt with the new velocity, and the rotation that goes with the angular momentum.
pub fn drift(body: &mut Body, timestep: f64) {
    body.state.position += body.state.velocity * timestep;
    rotate_free(body, timestep);
    body.refresh();
}

/// Torque-free rotation for a time `t`, to first order and symplectic.
///
/// H = L1^2/(2 I1) + L2^2/(2 I2) + L3^2/(2 I3) in principal axes is the sum of three parts, each of which is solved
/// exactly by a rotation about its axis with the angle t L_k / I_k; here they follow one another (Lie-Trotter
/// splitting; Miller et al. 2002, J. Chem. Phys. 116, 8649, use its symmetric form). The angular momentum in world
/// axes stays as it is, to the last bit.
fn rotate_free(body: &mut Body, t: f64) {
    let moments = body.mass.moments;
    let inverse = body.mass.inverse_moments;
    let spread = moments.max_element() - moments.min_element();
    if spread <= 1e-12 * moments.max_element() {
        // All moments equal: the axis does not move, one rotation is exact.
        let turn = rotation_from_vector(body.angular_velocity * t);
        body.state.orientation = turn * body.state.orientation;
        return;
    }
    let mut principal = body.state.orientation * body.mass.axes;
    let mut momentum = principal.conjugate() * body.state.angular_momentum;
    for (axis, k) in [(DVec3::X, 0), (DVec3::Y, 1), (DVec3::Z, 2)] {
        let turn: DQuat = rotation_from_vector(axis * (t * momentum[k] * inverse[k]));
        principal *= turn;
        momentum = turn.conjugate() * momentum;
    }
    body.state.orientation = principal * body.mass.axes.conjugate();
}
