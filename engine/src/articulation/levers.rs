//! Jacobians of the rows of an assembly, block by block, and what they make of the masses.

use glam::{DMat3, DVec3};

use super::ldu::Matrix;
use super::square::{Column, Square};
use crate::body::Body;
use crate::joint::{End, Row};
use crate::mover::{Moving, Twist, Yielding};

/// What the rows of a block, abreast, make of the velocity of one body, coordinate by coordinate: J, or J M^-1.
#[derive(Clone, Copy, Debug)]
struct Lever {
    linear: [Column; 3],
    angular: [Column; 3],
}

impl Lever {
    const ZERO: Self = Self {
        linear: [Column::ZERO; 3],
        angular: [Column::ZERO; 3],
    };

    /// J M^-1, where M^-1 is this much for the velocity and this for the angular velocity.
    #[inline(always)]
    fn weighted(&self, linear: f64, angular: &DMat3) -> Self {
        let [x, y, z] = self.linear;
        let turned = |row| combined(&self.angular, row);
        Self {
            linear: [x * linear, y * linear, z * linear],
            // M^-1 is symmetric, or its transpose is given.
            angular: [
                turned(angular.x_axis),
                turned(angular.y_axis),
                turned(angular.z_axis),
            ],
        }
    }

    /// J J'^T of two of them.
    #[inline(always)]
    fn times(&self, other: &Self) -> Square {
        let row = |k: usize| {
            let ([a, b, c], [d, e, f]) = (other.linear, other.angular);
            combined(&self.linear, DVec3::new(a[k], b[k], c[k]))
                + combined(&self.angular, DVec3::new(d[k], e[k], f[k]))
        };
        Square([row(0), row(1), row(2)])
    }

    /// J^T x
    #[inline(always)]
    fn pull(&self, x: Column) -> Twist {
        let x = DVec3::from_array(x.to_array());
        Twist {
            velocity: dots(&self.linear, x),
            angular_velocity: dots(&self.angular, x),
        }
    }
}

/// The sum of columns, each times its coordinate.
#[inline(always)]
fn combined(columns: &[Column; 3], v: DVec3) -> Column {
    columns[0] * v.x + columns[1] * v.y + columns[2] * v.z
}

/// Columns times x.
#[inline(always)]
fn dots(columns: &[Column; 3], x: DVec3) -> DVec3 {
    DVec3::new(columns[0].dot(x), columns[1].dot(x), columns[2].dot(x))
}

/// Place of a row: its block, and its column there.
pub(crate) type Place = (usize, usize);

/// Levers of all blocks on the bodies that each touches: those of block k are `starts[k]..starts[k + 1]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Levers {
    starts: Vec<usize>,
    bodies: Vec<usize>,
    /// J
    plain: Vec<Lever>,
    /// J M^-1
    weighted: Vec<Lever>,
    /// J where a step leads to.
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
            self.weighted[k] =
                self.plain[k].weighted(body.mass.inverse_mass, &body.inverse_inertia);
        }
    }

    /// How the end of a step answers to impulses at its start: of each body how far an impulse brings it, and how an
    /// angular one turns it, transposed.
    pub(crate) fn answer(&mut self, answers: &[(f64, DMat3)]) {
        for (k, &body) in self.bodies.iter().enumerate() {
            let (shift, turn) = &answers[body];
            self.answers[k] = self.plain[k].weighted(*shift, turn);
        }
    }

    /// The Jacobian of the row at a place.
    pub(crate) fn ends(&self, (block, column): Place) -> impl Iterator<Item = End> + '_ {
        (self.starts[block]..self.starts[block + 1]).map(move |k| End {
            body: self.bodies[k],
            linear: self.plain[k].linear.map(|c| c[column]).into(),
            angular: self.plain[k].angular.map(|c| c[column]).into(),
        })
    }

    /// J V of a block's rows.
    #[inline(always)]
    pub(crate) fn rate(&self, block: usize, moving: &[impl Moving]) -> Column {
        let mut rate = Column::ZERO;
        for k in self.starts[block]..self.starts[block + 1] {
            let (lever, twist) = (&self.plain[k], moving[self.bodies[k]].twist());
            rate += combined(&lever.linear, twist.velocity)
                + combined(&lever.angular, twist.angular_velocity);
        }
        rate
    }

    /// J M^-1 J^T
    pub(crate) fn matrix(&self) -> impl Matrix + '_ {
        Response(self)
    }

    /// The derivative of the rows' values at the end of the step by impulses at its start.
    pub(crate) fn matrix_ahead(&self) -> impl Matrix + '_ {
        ResponseAhead(self)
    }

    #[inline(always)]
    fn product(&self, a: &[Lever], b: &[Lever], (i, k): (usize, usize)) -> Square {
        let of = |block: usize| self.starts[block]..self.starts[block + 1];
        let mut sum = Square::ZERO;
        for (one, body) in a[of(i)].iter().zip(&self.bodies[of(i)]) {
            for (other, touched) in b[of(k)].iter().zip(&self.bodies[of(k)]) {
                if body == touched {
                    sum += one.times(other);
                }
            }
        }
        sum
    }

    /// Impulses `x` of a block's rows act: M^-1 J^T x.
    pub(crate) fn push(&self, block: usize, x: Column, moving: &mut [impl Yielding]) {
        for k in self.starts[block]..self.starts[block + 1] {
            let change = self.weighted[k].pull(x);
            moving[self.bodies[k]].twist_mut().add_scaled(&change, 1.0);
        }
    }

    /// The same of bodies, whose momenta change: J^T x.
    pub(crate) fn kick(&self, block: usize, x: Column, bodies: &mut [Body]) {
        for k in self.starts[block]..self.starts[block + 1] {
            let impulse = self.plain[k].pull(x);
            bodies[self.bodies[k]].apply_wrench(impulse.velocity, impulse.angular_velocity);
        }
    }
}

struct Response<'a>(&'a Levers);

impl Matrix for Response<'_> {
    #[inline(always)]
    fn entries(&self, i: usize, k: usize) -> [Square; 2] {
        let entry = self.0.product(&self.0.plain, &self.0.weighted, (i, k));
        [entry, entry.transposed()]
    }

    #[inline(always)]
    fn diagonal(&self, k: usize) -> Square {
        self.0.product(&self.0.plain, &self.0.weighted, (k, k))
    }
}

struct ResponseAhead<'a>(&'a Levers);

impl Matrix for ResponseAhead<'_> {
    #[inline(always)]
    fn entries(&self, i: usize, k: usize) -> [Square; 2] {
        let product = |at| self.0.product(&self.0.ahead, &self.0.answers, at);
        [product((i, k)), product((k, i))]
    }

    #[inline(always)]
    fn diagonal(&self, k: usize) -> Square {
        self.0.product(&self.0.ahead, &self.0.answers, (k, k))
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
        for axis in 0..3 {
            levers[k].linear[axis][column] = linear[axis];
            levers[k].angular[axis][column] = angular[axis];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gear's row is the sum of two, which may share a body.
    #[test]
    fn a_sum_of_rows_pulls_at_a_shared_body_once() {
        let end = |body: usize, size: f64| End {
            body,
            linear: DVec3::X * size,
            angular: DVec3::new(0.5, size, -1.0),
        };
        let rows = [[end(0, 1.0), end(1, -2.0)], [end(1, 3.0), end(2, 0.7)]];
        let rows = rows.map(|ends| Row {
            ends,
            ..Row::default()
        });
        let mut levers = Levers::new(&[vec![0, 1, 2]]);
        levers.place((0, 1), &rows);
        let moving = [0.3, -1.1, 2.0].map(|size| Twist {
            velocity: DVec3::new(size, 1.0, 0.2),
            angular_velocity: DVec3::new(-size, 0.4, size),
        });
        let rate = levers.rate(0, &moving).to_array();
        let sum: f64 = rows.iter().map(|row| row.rate(&moving)).sum();
        assert!((rate[1] - sum).abs() < 1e-14 && rate[0] == 0.0 && rate[2] == 0.0);
        let ends: Vec<End> = levers.ends((0, 1)).collect();
        assert_eq!(
            ends.iter().map(|end| end.body).collect::<Vec<_>>(),
            [0, 1, 2]
        );
        assert_eq!(ends[1].linear, DVec3::X);
        assert_eq!(ends[1].angular, DVec3::new(1.0, 1.0, -2.0));
    }
}
