//! Taking overlaps back by moving bodies, with their velocities as they are (split impulse).
//!
//! For every contact whose gap g at the end of the step is negative a displacement d is sought with n . d >= -beta g,
//! for the others one that does not close them: n . d >= -g. Pseudo-impulses act through the same effective masses as
//! real ones, so that the lighter body gives way; the displacements never enter a velocity.

use std::array::from_fn;

use glam::DVec3;
use pulp::{Simd, WithSimd};

use crate::body::Body;
use crate::contact::Contact;
use crate::islands::index;
use crate::lanes::{abreast, vectorised, Four, FourVectors, Lanes, Real, Vectors, WIDTH};
use crate::mover::{Twist, Window};
use crate::schedule::Schedule;
use crate::team::{each_with, fill};
use crate::twists::{Motion, Twists};

/// Overlaps and gaps up to this are left as they are: what the solver's tolerance leaves in a step. All four corners
/// of a resting box then ask for the same, and the solver need not choose among them [m].
pub const SLOP: f64 = 1e-8;
/// A sweep that moves nothing by more than this is the last, and a body that moved by less has not moved [m].
const STILL: f64 = 0.01 * SLOP;
const SWEEPS: u32 = 30;

/// Working memory of the correction.
#[derive(Clone, Debug, Default)]
pub struct Correction {
    /// Displacement and rotation vector of each body.
    shifts: Vec<Motion>,
    /// The last sweep in which each body moved.
    moved_in: Vec<u32>,
    /// Which contacts are answered at once.
    schedule: Schedule,
    packs: Vec<Pack>,
}

impl Correction {
    /// Is there an overlap to be taken back? `gaps` are those at the end of the step [m].
    #[must_use]
    pub fn is_due(gaps: &[f64]) -> bool {
        gaps.iter().any(|&gap| gap < -SLOP)
    }

    /// Move bodies apart. `gaps` are those at the end of the step, one a contact [m].
    pub fn apply(&mut self, bodies: &mut [Body], contacts: &[Contact], gaps: &[f64], beta: f64) {
        self.schedule.begin(bodies.len());
        for (slot, c) in (0..).zip(contacts) {
            let both = [c.bodies.0, c.bodies.1].into_iter();
            let moved = both.filter(|&body| !bodies[body].is_fixed());
            self.schedule.put(slot, moved.map(index));
        }
        let row = |k: usize| Row::new(&contacts[k], bodies, wanted(gaps[k], beta));
        let bunches = &self.schedule.bunches;
        fill(&mut self.packs, (bunches.len(), Pack::default()), &|k| {
            Pack::of(bunches[k].filled().map(row), bunches[k].held())
        });
        self.shifts.clear();
        self.shifts.resize(bodies.len(), Motion::default());
        self.moved_in.clear();
        self.moved_in.resize(bodies.len(), 0);
        vectorised(Sweeps(self));
        each_with(bodies, &self.shifts, &|body, shift| {
            let shift = shift.twist();
            if shift != Twist::default() {
                body.displace(shift.velocity, shift.angular_velocity);
            }
        });
    }
}

/// Gauss-Seidel sweeps until nothing moves any more.
struct Sweeps<'a>(&'a mut Correction);

impl WithSimd for Sweeps<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Correction {
            shifts,
            moved_in,
            packs,
            ..
        } = self.0;
        let mut shifts = Window::new(shifts);
        for sweep in 1..=SWEEPS {
            let mut worst = 0.0_f64;
            for pack in &mut *packs {
                if pack.stirs(moved_in, sweep) {
                    let made = pack.solve(simd, &mut shifts);
                    pack.note(moved_in, sweep, made);
                    worst = made.into_iter().fold(worst, f64::max);
                }
            }
            if worst < STILL {
                break;
            }
        }
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

/// A contact as the sweeps see it: n . d = normal . (shift_A - shift_B) + turns . (turn_A, turn_B).
#[derive(Clone, Copy, Debug)]
struct Row {
    bodies: [u32; 2],
    normal: DVec3,
    /// r x n on A and -(r x n) on B.
    turns: [DVec3; 2],
    /// What a unit push does: inverse masses (negative on B) and rotations.
    masses: [f64; 2],
    turned: [DVec3; 2],
    stiffness: f64,
    wanted: f64,
}

impl Row {
    fn new(c: &Contact, bodies: &[Body], wanted: f64) -> Self {
        let (a, b) = (&bodies[c.bodies.0], &bodies[c.bodies.1]);
        let turns = [c.arms.0.cross(c.normal), -c.arms.1.cross(c.normal)];
        Self {
            bodies: [index(c.bodies.0), index(c.bodies.1)],
            normal: c.normal,
            turns,
            masses: [a.mass.inverse_mass, -b.mass.inverse_mass],
            turned: [a.inverse_inertia * turns[0], b.inverse_inertia * turns[1]],
            stiffness: c.k_normal,
            wanted,
        }
    }
}

/// Four contacts, no two of which have a moving body in common.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
struct Pack {
    bodies: [[u32; WIDTH]; 2],
    normal: FourVectors,
    turns: [FourVectors; 2],
    masses: [Four; 2],
    turned: [FourVectors; 2],
    stiffness: Four,
    /// 1 / stiffness; 0 in lanes that only repeat the first.
    yielding: Four,
    wanted: Four,
    push: Four,
}

impl Pack {
    fn of(rows: [Row; WIDTH], held: [bool; WIDTH]) -> Self {
        Self {
            bodies: from_fn(|side| rows.map(|row| row.bodies[side])),
            normal: abreast(rows.map(|row| row.normal)),
            turns: from_fn(|side| abreast(rows.map(|row| row.turns[side]))),
            masses: from_fn(|side| rows.map(|row| row.masses[side])),
            turned: from_fn(|side| abreast(rows.map(|row| row.turned[side]))),
            stiffness: rows.map(|row| row.stiffness),
            yielding: from_fn(|lane| f64::from(u8::from(held[lane])) / rows[lane].stiffness),
            wanted: rows.map(|row| row.wanted),
            push: [0.0; WIDTH],
        }
    }

    /// Has one of the bodies moved since the sweep before? At first all are looked at.
    #[inline(always)]
    fn stirs(&self, moved_in: &[u32], sweep: u32) -> bool {
        let mut bodies = self.bodies.iter().flatten();
        bodies.any(|&body| moved_in[body as usize] + 1 >= sweep)
    }

    /// The exact push of each contact, all others held; returns the displacements made [m].
    #[inline(always)]
    fn solve<S: Simd>(&mut self, simd: S, shifts: &mut Window<Motion>) -> Four {
        let number = |numbers| Lanes::load(simd, numbers);
        let vectors = |vectors| Vectors::load(simd, vectors);
        let (normal, turns) = (vectors(self.normal), self.turns.map(vectors));
        let [a, b] = self.bodies.map(|four| Twists::load(simd, shifts, four));
        let made = normal.dot(a.velocity - b.velocity)
            + turns[0].dot(a.angular_velocity)
            + turns[1].dot(b.angular_velocity);
        let missing = number(self.wanted) - made;
        let old = number(self.push);
        let push = (old + missing * number(self.yielding)).max(old.constant(0.0));
        let more = push - old;
        self.push = push.store();
        for (side, shift) in [a, b].into_iter().enumerate() {
            let shifted = Twists {
                velocity: shift.velocity + normal * (more * number(self.masses[side])),
                angular_velocity: shift.angular_velocity + vectors(self.turned[side]) * more,
            };
            shifted.store(shifts, self.bodies[side]);
        }
        (more.abs() * number(self.stiffness)).store()
    }

    /// Who moved.
    #[inline(always)]
    fn note(&self, moved_in: &mut [u32], sweep: u32, made: Four) {
        for (lane, made) in made.into_iter().enumerate() {
            if made >= STILL {
                for (bodies, masses) in self.bodies.iter().zip(&self.masses) {
                    if masses[lane] != 0.0 {
                        moved_in[bodies[lane] as usize] = sweep;
                    }
                }
            }
        }
    }
}
