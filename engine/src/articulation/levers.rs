//! Jacobians of the rows of an assembly, block by block, and what they make of the masses.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::joint::Row;
use crate::mover::{Twist, Yielding};

/// A column for each row of a block: its part of J^T, or of M^-1 J^T, that belongs to one body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lever {
    pub(crate) linear: DMat3,
    pub(crate) angular: DMat3,
}

impl Lever {
    const ZERO: Self = Self {
        linear: DMat3::ZERO,
        angular: DMat3::ZERO,
    };

    /// J M^-1 J^T of two of them.
    fn times(&self, other: &Self) -> DMat3 {
        self.linear.transpose() * other.linear + self.angular.transpose() * other.angular
    }
}

/// Levers of all blocks on the moving bodies that each touches: those of block k are `starts[k]..starts[k + 1]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Levers {
    starts: Vec<usize>,
    bodies: Vec<usize>,
    /// J^T
    plain: Vec<Lever>,
    /// M^-1 J^T
    weighted: Vec<Lever>,
    /// J^T where a step leads to.
    ahead: Vec<Lever>,
    /// How the end of that step answers to impulses at its start.
    answers: Vec<Lever>,
}

impl Levers {
    /// For blocks that touch these moving bodies.
    pub(crate) fn new(touched: &[Vec<usize>]) -> Self {
        let mut levers = Self {
            starts: vec![0],
            ..Self::default()
        };
        for bodies in touched {
            levers.bodies.extend(bodies);
            levers.starts.push(levers.bodies.len());
        }
        let blank = vec![Lever::ZERO; levers.bodies.len()];
        (levers.plain, levers.weighted) = (blank.clone(), blank.clone());
        (levers.ahead, levers.answers) = (blank.clone(), blank);
        levers
    }

    /// Rows at the places (block, column) that they have, with the masses of the bodies.
    pub(crate) fn load<'a>(
        &mut self,
        rows: impl Iterator<Item = (&'a Row, (usize, usize))>,
        bodies: &[Body],
    ) {
        fill(&mut self.plain, (&self.starts, &self.bodies), rows);
        for (k, &body) in self.bodies.iter().enumerate() {
            let body = &bodies[body];
            self.weighted[k] = Lever {
                linear: self.plain[k].linear * body.mass.inverse_mass,
                angular: body.inverse_inertia * self.plain[k].angular,
            };
        }
    }

    /// Rows where the step leads to. `answer` gives of a body how far it gets by an impulse of the step's start, and how it
    /// turns by an angular one.
    pub(crate) fn look_ahead<'a>(
        &mut self,
        rows: impl Iterator<Item = (&'a Row, (usize, usize))>,
        answer: impl Fn(usize) -> (f64, DMat3),
    ) {
        fill(&mut self.ahead, (&self.starts, &self.bodies), rows);
        for (k, &body) in self.bodies.iter().enumerate() {
            let (shift, turn) = answer(body);
            self.answers[k] = Lever {
                linear: self.plain[k].linear * shift,
                angular: turn * self.plain[k].angular,
            };
        }
    }

    /// Block (i, k) of J M^-1 J^T.
    pub(crate) fn entry(&self, i: usize, k: usize) -> DMat3 {
        self.product(&self.plain, &self.weighted, (i, k))
    }

    /// Of the derivative of the rows' values at the end of the step by impulses at its start: block (i, k), and block
    /// (k, i) transposed. On the diagonal the first alone counts.
    pub(crate) fn entries_ahead(&self, i: usize, k: usize) -> [DMat3; 2] {
        let entry = self.product(&self.ahead, &self.answers, (i, k));
        if i == k {
            return [entry; 2];
        }
        [entry, self.product(&self.answers, &self.ahead, (i, k))]
    }

    fn product(&self, a: &[Lever], b: &[Lever], (i, k): (usize, usize)) -> DMat3 {
        let (i, k) = (
            self.starts[i]..self.starts[i + 1],
            self.starts[k]..self.starts[k + 1],
        );
        let mut sum = DMat3::ZERO;
        for (one, body) in a[i.clone()].iter().zip(&self.bodies[i]) {
            for (other, touched) in b[k.clone()].iter().zip(&self.bodies[k.clone()]) {
                if body == touched {
                    sum += one.times(other);
                }
            }
        }
        sum
    }

    /// Impulses `x` of a block's rows act: M^-1 J^T x.
    pub(crate) fn push(&self, block: usize, x: DVec3, moving: &mut [impl Yielding]) {
        for k in self.starts[block]..self.starts[block + 1] {
            let change = Twist {
                velocity: self.weighted[k].linear * x,
                angular_velocity: self.weighted[k].angular * x,
            };
            moving[self.bodies[k]].twist_mut().add_scaled(&change, 1.0);
        }
    }

    /// The same of bodies, whose momenta change: J^T x.
    pub(crate) fn kick(&self, block: usize, x: DVec3, bodies: &mut [Body]) {
        for k in self.starts[block]..self.starts[block + 1] {
            let plain = &self.plain[k];
            bodies[self.bodies[k]].apply_wrench(plain.linear * x, plain.angular * x);
        }
    }
}

/// Every row fills its column in the levers of its block; the columns of no row stay as they are.
fn fill<'a>(
    levers: &mut [Lever],
    (starts, bodies): (&[usize], &[usize]),
    rows: impl Iterator<Item = (&'a Row, (usize, usize))>,
) {
    for (row, (block, column)) in rows {
        for k in starts[block]..starts[block + 1] {
            let end = row.ends().iter().find(|end| end.body == bodies[k]);
            let (linear, angular) = end.map_or_else(Default::default, |e| (e.linear, e.angular));
            *levers[k].linear.col_mut(column) = linear;
            *levers[k].angular.col_mut(column) = angular;
        }
    }
}
