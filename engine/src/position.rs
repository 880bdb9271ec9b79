//! Taking overlaps back by moving bodies, with their velocities as they are (split impulse).
//!
//! For every contact whose gap g at the end of the step is negative a displacement d is sought with n . d >= -beta g,
//! for the others one that does not close them: n . d >= -g. Pseudo-impulses act through the same effective masses as
//! real ones, so that the lighter body gives way; the displacements never enter a velocity.

use glam::DVec3;

use crate::body::Body;
use crate::contact::Contact;
use crate::mover::Twist;

/// Overlaps and gaps up to this are left as they are: what the solver's tolerance leaves in a step. All four corners
/// of a resting box then ask for the same, and the solver need not choose among them [m].
pub const SLOP: f64 = 1e-8;
/// A sweep that moves nothing by more than this is the last, and a body that moved by less has not moved [m].
const STILL: f64 = 0.01 * SLOP;
const SWEEPS: usize = 30;

/// Working memory of the correction.
#[derive(Clone, Debug, Default)]
pub struct Correction {
    /// Displacement and rotation vector of each body.
    shifts: Vec<Twist>,
    /// The last sweep in which each body moved.
    moved_in: Vec<u32>,
    rows: Vec<Row>,
}

/// A contact as the sweeps see it: n . d = normal . (shift_A - shift_B) + turns . (turn_A, turn_B).
#[derive(Clone, Copy, Debug)]
struct Row {
    bodies: (u32, u32),
    normal: DVec3,
    /// r x n on A and -(r x n) on B.
    turns: (DVec3, DVec3),
    /// What a unit push does: inverse masses (negative on B) and rotations.
    given: ((f64, f64), (DVec3, DVec3)),
    stiffness: f64,
    /// 1 / stiffness
    yielding: f64,
    wanted: f64,
    push: f64,
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
        self.rows.clear();
        let rows = contacts.iter().zip(gaps);
        self.rows
            .extend(rows.map(|(c, &gap)| Row::new(c, bodies, wanted(gap, beta))));
        self.shifts.clear();
        self.shifts.resize(bodies.len(), Twist::default());
        self.moved_in.clear();
        self.moved_in.resize(bodies.len(), 0);
        for sweep in 1..=SWEEPS as u32 {
            if self.sweep(sweep) < STILL {
                break;
            }
        }
        for (body, shift) in bodies.iter_mut().zip(&self.shifts) {
            if *shift != Twist::default() {
                body.displace(shift.velocity, shift.angular_velocity);
            }
        }
        true
    }

    /// One Gauss-Seidel sweep over the contacts of bodies that moved since the sweep before, over all in the first;
    /// returns the greatest displacement made [m].
    fn sweep(&mut self, sweep: u32) -> f64 {
        let mut worst = 0.0_f64;
        for row in &mut self.rows {
            let (a, b) = (row.bodies.0 as usize, row.bodies.1 as usize);
            if self.moved_in[a].max(self.moved_in[b]) + 1 < sweep {
                continue;
            }
            let missing = row.wanted - row.made(&self.shifts[a], &self.shifts[b]);
            let push = (row.push + missing * row.yielding).max(0.0);
            let more = push - row.push;
            if more == 0.0 {
                continue;
            }
            row.push = push;
            row.give(more, &mut self.shifts);
            let made = more.abs() * row.stiffness;
            if made >= STILL {
                self.moved_in[a] = sweep;
                self.moved_in[b] = sweep;
            }
            worst = worst.max(made);
        }
        worst
    }
}

/// The displacement that a gap asks for [m].
fn wanted(gap: f64, beta: f64) -> f64 {
    if gap < 0.0 {
        -beta * (gap + SLOP).min(0.0)
    } else {
        -gap
    }
}

impl Row {
    fn new(c: &Contact, bodies: &[Body], wanted: f64) -> Self {
        let (a, b) = (&bodies[c.bodies.0], &bodies[c.bodies.1]);
        let turns = (c.arms.0.cross(c.normal), -c.arms.1.cross(c.normal));
        #[allow(clippy::cast_possible_truncation)]
        let index = |k: usize| k as u32;
        Self {
            bodies: (index(c.bodies.0), index(c.bodies.1)),
            normal: c.normal,
            turns,
            given: (
                (a.mass.inverse_mass, -b.mass.inverse_mass),
                (a.inverse_inertia * turns.0, b.inverse_inertia * turns.1),
            ),
            stiffness: c.k_normal,
            yielding: 1.0 / c.k_normal,
            wanted,
            push: 0.0,
        }
    }

    fn made(&self, a: &Twist, b: &Twist) -> f64 {
        self.normal.dot(a.velocity - b.velocity)
            + self.turns.0.dot(a.angular_velocity)
            + self.turns.1.dot(b.angular_velocity)
    }

    fn give(&self, push: f64, shifts: &mut [Twist]) {
        let ((mass_a, mass_b), (turn_a, turn_b)) = self.given;
        for (k, mass, turn) in [
            (self.bodies.0, mass_a, turn_a),
            (self.bodies.1, mass_b, turn_b),
        ] {
            let shift = &mut shifts[k as usize];
            shift.velocity += self.normal * (push * mass);
            shift.angular_velocity += turn * push;
        }
    }
}
