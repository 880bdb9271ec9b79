//! Semi-implicit Euler, and the kick-drift-kick form of the Verlet family.

use super::dynamics::Dynamics;
use super::rotation::{LIE_TROTTER, NO_SQUISH};
use crate::body::Body;
use crate::force::Powers;
use crate::mover::Moving;

/// Rounds of the implicit half kick at most, and the relative change at which it has converged. A force -c v asks for
/// c dt / (2 m) < 1; each round then gains that factor.
const ROUNDS: usize = 25;
const CONVERGED: f64 = 1e-15;

/// v += a(x, v) dt, then x += v dt.
pub(super) fn euler(bodies: &mut [Body], d: &mut Dynamics) {
    let h = d.span.1;
    let start = d.evaluate(bodies, 0.0);
    d.kick(bodies, h);
    d.drift(bodies, LIE_TROTTER);
    if !d.baumgarte {
        d.project_velocities(bodies);
        d.note_reactions(1.0);
    }
    let end = d.evaluate(bodies, 1.0);
    d.book((start + end) * 0.5, h);
}

/// v += a(x, v) dt/2, x += v dt, v' = v + a(x', v') dt/2. The first kick takes the velocity before it and the second the
/// one after it, so the map is its own adjoint and of second order with velocity-dependent forces, too.
pub(super) fn kick_drift_kick(bodies: &mut [Body], d: &mut Dynamics) {
    let h = d.span.1;
    let start = d.evaluate(bodies, 0.0);
    d.kick(bodies, 0.5 * h);
    d.drift(bodies, NO_SQUISH);
    let end = closing_kick(bodies, d, 0.5 * h);
    d.note_reactions(1.0);
    d.book((start + end) * 0.5, h);
}

/// The kick over `h` that ends a step, by fixed-point iteration where forces depend on the velocity that it leads to.
/// Returns the powers at the end.
fn closing_kick(bodies: &mut [Body], d: &mut Dynamics, h: f64) -> Powers {
    let rounds = if d.depends_on_velocity() { ROUNDS } else { 1 };
    let mut before = std::mem::take(&mut d.scratch.states);
    before.clear();
    before.extend(bodies.iter().map(|b| b.state));
    let mut powers = Powers::default();
    for _ in 0..rounds {
        powers = d.evaluate(bodies, 1.0);
        d.scratch.twists.clear();
        d.scratch.twists.extend(bodies.iter().map(Body::twist));
        for (body, start) in bodies
            .iter_mut()
            .zip(&before)
            .filter(|(b, _)| !b.is_fixed())
        {
            body.state.velocity = start.velocity;
            body.state.angular_momentum = start.angular_momentum;
            body.derive();
        }
        d.kick(bodies, h);
        d.project_velocities(bodies);
        if converged(bodies, d) {
            break;
        }
    }
    d.scratch.states = before;
    if rounds == 1 {
        powers = d.evaluate(bodies, 1.0);
    }
    powers
}

/// Velocities are those of the round before.
fn converged(bodies: &[Body], d: &Dynamics) -> bool {
    let mut change = 0.0_f64;
    let mut size = 0.0_f64;
    for (now, was) in bodies.iter().map(Body::twist).zip(&d.scratch.twists) {
        change = change
            .max((now.velocity - was.velocity).length())
            .max((now.angular_velocity - was.angular_velocity).length());
        size = size
            .max(now.velocity.length())
            .max(now.angular_velocity.length());
    }
    change <= CONVERGED * size
}
