//! Jacobians of the rows of an assembly, block by block, and what they make of the masses.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::joint::{End, Row};
use crate::mover::{Moving, Twist, Yielding};

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
        let dots = |linear: DVec3, angular: DVec3| {
            DVec3::new(
                self.linear.x_axis.dot(linear) + self.angular.x_axis.dot(angular),
                self.linear.y_axis.dot(linear) + self.angular.y_axis.dot(angular),
                self.linear.z_axis.dot(linear) + self.angular.z_axis.dot(angular),
            )
        };
        DMat3::from_cols(
            dots(other.linear.x_axis, other.angular.x_axis),
            dots(other.linear.y_axis, other.angular.y_axis),
            dots(other.linear.z_axis, other.angular.z_axis),
        )
    }
}

/// Place of a row: its block, and its column there.
pub(crate) type Place = (usize, usize);

/// Levers of all blocks on the bodies that each touches: those of block k are `starts[k]..starts[k + 1]`.
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
    /// For blocks that touch these bodies.
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

    /// The row at a place is the sum of these.
    pub(crate) fn place(&mut self, at: Place, rows: &[Row]) {
        place(&mut self.plain, (&self.starts, &self.bodies), at, rows);
    }

    /// The same where a step leads to.
    pub(crate) fn place_ahead(&mut self, at: Place, rows: &[Row]) {
        place(&mut self.ahead, (&self.starts, &self.bodies), at, rows);
    }

    /// The masses of the bodies, as they lie now.
    pub(crate) fn weigh(&mut self, bodies: &[Body]) {
        for (k, &body) in self.bodies.iter().enumerate() {
            let body = &bodies[body];
            self.weighted[k] = Lever {
                linear: self.plain[k].linear * body.mass.inverse_mass,
                angular: body.inverse_inertia * self.plain[k].angular,
            };
        }
    }

    /// How the end of a step answers to impulses at its start: of each body how far an impulse brings it, and how an
    /// angular one turns it.
    pub(crate) fn answer(&mut self, answers: &[(f64, DMat3)]) {
        for (k, &body) in self.bodies.iter().enumerate() {
            let (shift, turn) = answers[body];
            self.answers[k] = Lever {
                linear: self.plain[k].linear * shift,
                angular: turn * self.plain[k].angular,
            };
        }
    }

    /// The Jacobian of the row at a place.
    pub(crate) fn ends(&self, (block, column): Place) -> impl Iterator<Item = End> + '_ {
        (self.starts[block]..self.starts[block + 1]).map(move |k| End {
            body: self.bodies[k],
            linear: self.plain[k].linear.col(column),
            angular: self.plain[k].angular.col(column),
        })
    }

    /// J V of a block's rows.
    pub(crate) fn rate(&self, block: usize, moving: &[impl Moving]) -> DVec3 {
        let mut rate = DVec3::ZERO;
        for k in self.starts[block]..self.starts[block + 1] {
            let (lever, twist) = (&self.plain[k], moving[self.bodies[k]].twist());
            rate += lever.linear.transpose() * twist.velocity;
            rate += lever.angular.transpose() * twist.angular_velocity;
        }
        rate
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

fn place(
    levers: &mut [Lever],
    (starts, bodies): (&[usize], &[usize]),
    (block, column): Place,
    rows: &[Row],
) {
    for k in starts[block]..starts[block + 1] {
        let (mut linear, mut angular) = (DVec3::ZERO, DVec3::ZERO);
        for end in rows.iter().flat_map(|row| &row.ends) {
            if end.body == bodies[k] {
                linear += end.linear;
                angular += end.angular;
            }
        }
        *levers[k].linear.col_mut(column) = linear;
        *levers[k].angular.col_mut(column) = angular;
    }
}
