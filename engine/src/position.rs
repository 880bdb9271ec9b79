//! Taking overlaps back by moving bodies, with their velocities as they are (split impulse).
//!
//! For every contact whose gap g at the end of the step is negative a displacement d is sought with n . d >= -beta g,
//! for the others one that does not close them: n . d >= -g. Pseudo-impulses act through the same effective masses as
//! real ones, so that the lighter body gives way; the displacements never enter a velocity.

use glam::DVec3;

use crate::body::Body;
use crate::contact::Contact;

/// Overlaps and gaps up to this are left as they are: what the solver's tolerance leaves in a step. All four corners
/// of a resting box then ask for the same, and the solver need not choose among them [m].
pub const SLOP: f64 = 1e-8;
const SWEEPS: usize = 30;

/// Working memory of the correction.
#[derive(Clone, Debug, Default)]
pub struct Correction {
    shift: Vec<DVec3>,
    turn: Vec<DVec3>,
    pushes: Vec<f64>,
}

impl Correction {
    /// Move bodies apart. `gaps` are those at the end of the step, one a contact [m]. Returns false when there was
    /// nothing to do.
    pub fn apply(
        &mut self,
        bodies: &mut [Body],
        contacts: &[Contact],
        gaps: &[f64],
        beta: f64,
    ) -> bool {
        if gaps.iter().all(|&g| g >= -SLOP) {
            return false;
        }
        for list in [&mut self.shift, &mut self.turn] {
            list.clear();
            list.resize(bodies.len(), DVec3::ZERO);
        }
        self.pushes.clear();
        self.pushes.resize(contacts.len(), 0.0);
        for _ in 0..SWEEPS {
            if self.sweep(bodies, contacts, gaps, beta) < 0.01 * SLOP {
                break;
            }
        }
        for ((body, &shift), &turn) in bodies.iter_mut().zip(&self.shift).zip(&self.turn) {
            if shift != DVec3::ZERO || turn != DVec3::ZERO {
                body.displace(shift, turn);
            }
        }
        true
    }

    /// One Gauss-Seidel sweep; returns the greatest displacement made [m].
    fn sweep(&mut self, bodies: &[Body], contacts: &[Contact], gaps: &[f64], beta: f64) -> f64 {
        let mut worst = 0.0_f64;
        for ((c, &gap), push) in contacts.iter().zip(gaps).zip(&mut self.pushes) {
            let wanted = if gap < 0.0 {
                -beta * (gap + SLOP).min(0.0)
            } else {
                -gap
            };
            let (a, b) = c.bodies;
            let made = self.shift[a] + self.turn[a].cross(c.arms.0)
                - self.shift[b]
                - self.turn[b].cross(c.arms.1);
            let new = (*push + (wanted - made.dot(c.normal)) / c.k_normal).max(0.0);
            let p = c.normal * (new - *push);
            if *push == new {
                continue;
            }
            worst = worst.max((new - *push).abs() * c.k_normal);
            *push = new;
            for (k, impulse, arm) in [(a, p, c.arms.0), (b, -p, c.arms.1)] {
                self.shift[k] += impulse * bodies[k].mass.inverse_mass;
                self.turn[k] += bodies[k].inverse_inertia * arm.cross(impulse);
            }
        }
        worst
    }
}
