//! The linear system of the contacts that carry.
//!
//! Open contacts stay open. A sticking contact asks for u = (target, 0, 0) and has three impulses to get it; a sliding
//! one asks for u_n = target and has one, its friction mu p_n s going along in the direction s that it has. So
//! A W z = r with A = J M^-1 J^T, where the columns of W are the impulses that z stands for. Redundant contacts make A
//! singular (four corners of a box hold more than it needs): A + eps diag(A) with a small eps keeps the impulses near
//! those before where A leaves a choice. Sliding makes the system unsymmetric, so it is solved by GMRES (Saad & Schultz
//! 1986), scaled on both sides by diag(A)^-1/2. A is never formed: a product with it is a pass over the contacts that
//! pushes bodies and reads their relative velocities.
//!
//! Rolling and spinning friction stand behind the contacts as further unknowns, in the order of their contacts: within
//! their bounds they ask for no turning, at a bound they go along with the normal impulse.

use glam::DVec3;

use crate::math::length;
use crate::mover::{Part, Twist};
use crate::point::Point;
use crate::roll::Roll;
use crate::system::System;

/// eps. What a leap leaves of an error in a motion whose eigenvalue of diag(A)^-1 A is e: eps / (eps + e). The
/// softest motions of real scenes (many bodies high, 1000 : 1 in mass) have e about 1e-4. Tried from 1e-8 to 1e-5: with
/// less, boxes of 1 g and 1 kg in turn shake themselves apart through what their corners hold against each other.
const DAMPING: f64 = 1e-5;
/// Krylov vectors kept at most.
const VECTORS: usize = 40;

/// A bound is reached when less than this part of it is left.
const RIM: f64 = 1e-9;

/// What a contact may change, of its impulses or of its angular ones.
#[derive(Clone, Copy, Debug)]
struct Freedom {
    /// Ones where the relative velocity is asked for.
    asked: DVec3,
    /// What goes along with a unit of normal impulse.
    along: DVec3,
    /// diag(A)^-1/2
    scale: DVec3,
}

impl Freedom {
    fn of(c: &Point, part: Part) -> Self {
        let limit = c.cone.friction * c.impulse.x;
        let rubbing = length(c.impulse.y, c.impulse.z);
        let (asked, along) = if c.impulse.x <= 0.0 {
            (DVec3::ZERO, DVec3::ZERO)
        } else if part == Part::Normals {
            (DVec3::X, DVec3::ZERO)
        } else if rubbing < limit * (1.0 - RIM) {
            (DVec3::ONE, DVec3::ZERO)
        } else if limit > 0.0 {
            (
                DVec3::X,
                DVec3::new(0.0, c.impulse.y, c.impulse.z) * (limit / rubbing / c.impulse.x),
            )
        } else {
            (DVec3::X, DVec3::ZERO)
        };
        let k = c.k();
        Self {
            asked,
            along,
            scale: DVec3::new(1.0 / k.x.sqrt(), 1.0 / k.y.sqrt(), 1.0 / k.z.sqrt()),
        }
    }

    /// Of the angular impulses of a contact with this normal impulse.
    fn of_roll(roll: &Roll, normal_impulse: f64, part: Part) -> Self {
        let (q, normal) = (roll.impulse, normal_impulse);
        let mut out = Self {
            asked: DVec3::ZERO,
            along: DVec3::ZERO,
            scale: DVec3::new(
                1.0 / roll.k.x.sqrt(),
                1.0 / roll.k.y.sqrt(),
                1.0 / roll.k.z.sqrt(),
            ),
        };
        if normal <= 0.0 || part == Part::Normals {
            return out;
        }
        let held = |q: f64, arm: f64| q < arm * normal * (1.0 - RIM);
        if held(q.x.abs(), roll.spinning) {
            out.asked.x = 1.0;
        } else {
            out.along.x = q.x / normal;
        }
        if held(length(q.y, q.z), roll.rolling) {
            (out.asked.y, out.asked.z) = (1.0, 1.0);
        } else {
            (out.along.y, out.along.z) = (q.y / normal, q.z / normal);
        }
        out
    }

    /// The impulse that scaled unknowns stand for, with so much normal impulse.
    fn impulse(&self, unknown: DVec3, normal: f64) -> DVec3 {
        unknown * self.scale + self.along * normal
    }

    /// The normal impulse among them.
    fn normal(&self, unknown: DVec3) -> f64 {
        unknown.x * self.scale.x
    }
}

/// Working memory of the linear solve; one entry a contact, and behind them one a contact with a roll.
#[derive(Clone, Debug, Default)]
pub(crate) struct Subspace {
    freedom: Vec<Freedom>,
    /// Slots of the contacts with a roll.
    rolls: Vec<usize>,
    step: Vec<DVec3>,
    basis: Vec<Vec<DVec3>>,
    /// Columns of the triangular factor of the Hessenberg matrix.
    columns: Vec<Vec<f64>>,
    rotations: Vec<(f64, f64)>,
    /// Right-hand side in the Krylov basis; its last entry is the residual that is left.
    rhs: Vec<f64>,
    responses: Vec<Twist>,
}

impl Subspace {
    /// The change of the impulse of the contact in this slot.
    pub(crate) fn step(&self, slot: usize) -> DVec3 {
        self.step[slot]
    }

    /// The changes of the angular impulses, each with the slot of its contact.
    pub(crate) fn turns(&self) -> impl Iterator<Item = (usize, DVec3)> + '_ {
        let contacts = self.step.len() - self.rolls.len();
        let steps = self.step[contacts..].iter().copied();
        self.rolls.iter().copied().zip(steps)
    }

    /// Solve until the residual is `reduction` of what it was, or `budget` passes over the contacts are made, or the
    /// Krylov vectors run out. Returns the passes made.
    pub(crate) fn solve(
        &mut self,
        system: &mut System,
        part: Part,
        (budget, reduction): (usize, f64),
    ) -> usize {
        let start = self.begin(system, part);
        let mut used = 0;
        while start > 0.0 && used < VECTORS.min(budget) {
            self.extend_basis(system, used);
            used += 1;
            if self.rhs[used].abs() <= reduction * start {
                break;
            }
        }
        self.combine(used);
        used
    }

    /// The first Krylov vector, r / |r| with r = target - u scaled. Returns |r|.
    fn begin(&mut self, system: &System, part: Part) -> f64 {
        self.freedom.clear();
        self.columns.clear();
        self.rotations.clear();
        self.rhs.clear();
        self.basis.resize(VECTORS + 1, Vec::new());
        let first = &mut self.basis[0];
        first.clear();
        for c in system.points.iter() {
            let freedom = Freedom::of(c, part);
            first.push(c.missing(system.movers) * freedom.asked * freedom.scale);
            self.freedom.push(freedom);
        }
        self.rolls.clear();
        for (slot, c) in system.points.iter().enumerate() {
            if let Some(roll) = &c.roll {
                let freedom = Freedom::of_roll(roll, c.impulse.x, part);
                let missing = -roll.to_local(c.turning(system.movers));
                first.push(missing * freedom.asked * freedom.scale);
                self.freedom.push(freedom);
                self.rolls.push(slot);
            }
        }
        let norm = dot(first, first).sqrt();
        if norm > 0.0 {
            first.iter_mut().for_each(|v| *v /= norm);
        }
        self.rhs.push(norm);
        norm
    }

    /// One Arnoldi step (modified Gram-Schmidt), and the Givens rotation that keeps the Hessenberg matrix triangular.
    fn extend_basis(&mut self, system: &mut System, last: usize) {
        let mut next = std::mem::take(&mut self.basis[last + 1]);
        self.multiply(system, last, &mut next);
        let mut column = Vec::with_capacity(last + 2);
        for vector in &self.basis[..=last] {
            let h = dot(vector, &next);
            next.iter_mut().zip(vector).for_each(|(n, v)| *n -= *v * h);
            column.push(h);
        }
        let norm = dot(&next, &next).sqrt();
        if norm > 0.0 {
            next.iter_mut().for_each(|v| *v /= norm);
        }
        self.basis[last + 1] = next;
        for (row, &(c, s)) in self.rotations.iter().enumerate() {
            (column[row], column[row + 1]) = (
                c * column[row] + s * column[row + 1],
                c * column[row + 1] - s * column[row],
            );
        }
        let radius = length(column[last], norm);
        let (c, s) = if radius > 0.0 {
            (column[last] / radius, norm / radius)
        } else {
            (1.0, 0.0)
        };
        column[last] = radius;
        self.rotations.push((c, s));
        self.rhs.push(-s * self.rhs[last]);
        self.rhs[last] *= c;
        self.columns.push(column);
    }

    /// Back substitution, and the impulses that the solution stands for.
    fn combine(&mut self, used: usize) {
        let mut weights = vec![0.0; used];
        for row in (0..used).rev() {
            let known: f64 = (row + 1..used)
                .map(|k| self.columns[k][row] * weights[k])
                .sum();
            let pivot = self.columns[row][row];
            weights[row] = if pivot > 0.0 {
                (self.rhs[row] - known) / pivot
            } else {
                0.0
            };
        }
        self.step.clear();
        self.step.resize(self.freedom.len(), DVec3::ZERO);
        for (vector, &weight) in self.basis.iter().zip(&weights) {
            self.step
                .iter_mut()
                .zip(vector)
                .for_each(|(s, v)| *s += *v * weight);
        }
        let (pushes, turns) = self.freedom.split_at(self.freedom.len() - self.rolls.len());
        for (step, freedom) in self.step.iter_mut().zip(pushes) {
            *step = freedom.impulse(*step, freedom.normal(*step));
        }
        for ((n, freedom), &slot) in turns.iter().enumerate().zip(&self.rolls) {
            let normal = self.step[slot].x;
            let step = &mut self.step[pushes.len() + n];
            *step = freedom.impulse(*step, normal);
        }
    }

    /// out = (A W + eps diag(A)) basis[from], scaled.
    fn multiply(&mut self, system: &mut System, from: usize, out: &mut Vec<DVec3>) {
        self.push_bodies(system, from);
        if let Some(joints) = &mut system.joints {
            for &assembly in joints.assemblies {
                let assembly = assembly as usize;
                joints.articulation.respond(assembly, &mut self.responses);
            }
        }
        out.clear();
        let mut unknowns = self.freedom.iter().zip(&self.basis[from]);
        for (c, (freedom, &unknown)) in system.points.iter().zip(&mut unknowns) {
            let given = DVec3::X * (c.cone.give * unknown.x * freedom.scale.x);
            let change = c.relative(&self.responses[c.a()], &self.responses[c.b()]) + given;
            out.push(change * freedom.asked * freedom.scale + unknown * DAMPING);
        }
        for (&slot, (freedom, &unknown)) in self.rolls.iter().zip(unknowns) {
            let c = &system.points[slot];
            let turning = c.turning(&self.responses);
            let change = c
                .roll
                .as_ref()
                .map_or(DVec3::ZERO, |roll| roll.to_local(turning));
            out.push(change * freedom.asked * freedom.scale + unknown * DAMPING);
        }
    }

    /// What the impulses that a vector stands for do to the bodies of the island.
    fn push_bodies(&mut self, system: &System, from: usize) {
        let (points, movers) = (&*system.points, &*system.movers);
        self.responses.resize(movers.len(), Twist::default());
        for c in points.iter() {
            self.responses[c.a()] = Twist::default();
            self.responses[c.b()] = Twist::default();
        }
        for &assembly in system.joints.iter().flat_map(|j| j.assemblies) {
            for &body in system.bodies(assembly) {
                self.responses[body] = Twist::default();
            }
        }
        let mut unknowns = self.freedom.iter().zip(&self.basis[from]);
        for (c, (freedom, &unknown)) in points.iter().zip(&mut unknowns) {
            if unknown == DVec3::ZERO {
                continue;
            }
            let impulse = freedom.impulse(unknown, freedom.normal(unknown));
            let [a, b] = c.responses(movers, impulse);
            self.responses[c.a()].add_scaled(&a, 1.0);
            self.responses[c.b()].add_scaled(&b, 1.0);
        }
        for (&slot, (freedom, &unknown)) in self.rolls.iter().zip(unknowns) {
            let normal = self.freedom[slot].normal(self.basis[from][slot]);
            let c = &points[slot];
            let local = freedom.impulse(unknown, normal);
            let q = c
                .roll
                .as_ref()
                .map_or(DVec3::ZERO, |roll| roll.to_world(local));
            for (body, impulse) in [(c.a(), q), (c.b(), -q)] {
                let turned = movers[body].inverse_inertia * impulse;
                self.responses[body].angular_velocity += turned;
            }
        }
    }
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x.dot(*y)).sum()
}
