//! Bodies that stiff contacts hold to one another, solved directly.
//!
//! With M the masses, J the rows of the contacts and G what each of them resists a relative velocity with, the matrix
//!
//! ```text
//! M + J^T G J
//! ```
//!
//! of the bodies' velocities has a 6 x 6 block for each body and for each pair in contact. A stack is a chain there and
//! a wall a grid: Cholesky's factor of it, bodies of few neighbours first, is hardly larger, and a tower of a hundred
//! boxes is as cheap, box by box, as one of two.

use glam::{DMat3, DVec3};
use pulp::{Simd, WithSimd};

use crate::block::{
    cholesky, divide_rows, solve_lower, solve_upper, subtract_from, subtract_product,
    subtract_transposed, Block,
};
use crate::lanes::vectorised;
use crate::mover::Mover;
use crate::pattern::{Pattern, FIXED};
use crate::point::Point;

/// Velocity and angular velocity of a body that moves, or momentum and angular momentum.
pub(crate) type Six = [f64; 6];

/// Working memory of the matrix and its factor.
#[derive(Clone, Debug, Default)]
pub(crate) struct Direct {
    pattern: Pattern,
    diagonal: Vec<Block>,
    below: Vec<Block>,
    /// Mass and inertia of each body.
    masses: Vec<(f64, DMat3)>,
}

/// What the contacts of a pair add up to: K = sum of k, sum of X_a k and X_b k, of X_a k X_a^T, of X_b k X_b^T, and of
/// X_a k X_b^T, X the cross product with an arm and k what a contact resists with, in world axes.
#[derive(Clone, Copy, Debug)]
struct Bond {
    k: DMat3,
    a: DMat3,
    b: DMat3,
    aa: DMat3,
    bb: DMat3,
    ab: DMat3,
}

/// The factor, in the instructions of this processor.
struct Factor<'a>(&'a mut Direct);

impl WithSimd for Factor<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.0.factor();
    }
}

impl Direct {
    /// How many products of blocks a factorisation for these contacts takes; None for more than `most`. Bodies without
    /// a full share of inertia, such as thin rods, cannot be solved at all.
    pub(crate) fn products(
        &mut self,
        points: &[Point],
        movers: &[Mover],
        most: usize,
    ) -> Option<usize> {
        let suits = self.pattern.load(points, movers, most);
        suits.then_some(self.pattern.products)
    }

    /// Begin a matrix for the contacts whose `products` were asked for, and clear `sums`, one for each body in it.
    pub(crate) fn begin(&mut self, movers: &[Mover], sums: &mut Vec<Six>) {
        let bodies = self.pattern.order.iter().map(|&k| &movers[k as usize]);
        self.masses.clear();
        self.masses
            .extend(bodies.map(|m| (1.0 / m.inverse_mass, m.inverse_inertia.inverse())));
        sums.clear();
        sums.resize(self.masses.len(), [0.0; 6]);
    }

    /// The factor of M + J^T G J; `stiffness` is G of each contact in world axes, None for one that does not resist.
    pub(crate) fn factorise(
        &mut self,
        points: &[Point],
        stiffness: impl Iterator<Item = Option<DMat3>>,
    ) {
        self.diagonal.clear();
        let blocks = self.masses.iter().map(|&(m, i)| {
            let mut block = [0.0; 36];
            put(
                &mut block,
                [DMat3::from_diagonal(DVec3::splat(m)), DMat3::ZERO, i],
                1.0,
            );
            block
        });
        self.diagonal.extend(blocks);
        self.below.clear();
        self.below.resize(self.pattern.rows.len(), [0.0; 36]);
        let mut bond = Bond::NONE;
        let mut pair = (0, 0);
        for (p, k) in points.iter().zip(stiffness) {
            if p.bodies != pair {
                self.add(pair, &bond);
                (pair, bond) = (p.bodies, Bond::NONE);
            }
            if let Some(k) = k {
                bond.add(k, p.arms);
            }
        }
        self.add(pair, &bond);
        vectorised(Factor(self));
    }

    fn add(&mut self, (a, b): (u32, u32), bond: &Bond) {
        if bond.k == DMat3::ZERO {
            return;
        }
        let places = &self.pattern.places;
        let (a, b) = (places[a as usize], places[b as usize]);
        if a != FIXED {
            let block = &mut self.diagonal[a as usize];
            put(block, [bond.k, bond.a, bond.aa], 1.0);
        }
        if b != FIXED {
            let block = &mut self.diagonal[b as usize];
            put(block, [bond.k, bond.b, bond.bb], 1.0);
        }
        if a == FIXED || b == FIXED {
            return;
        }
        let (column, row) = (a.min(b), a.max(b));
        let block = &mut self.below[self.pattern.slot(column as usize, row)];
        // Of the later body's row and the earlier one's column.
        let (lower, right, corner) = if a > b {
            (bond.a, bond.b, bond.ab)
        } else {
            (bond.b, bond.a, bond.ab.transpose())
        };
        put(block, [bond.k, lower, corner], -1.0);
        put_right(block, right.transpose(), -1.0);
    }

    /// Cholesky's factor in place of the matrix, column by column; what a column does to later ones is done at once.
    #[inline(always)]
    fn factor(&mut self) {
        for column in 0..self.pattern.order.len() {
            let (start, end) = (self.pattern.starts[column], self.pattern.starts[column + 1]);
            let diagonal = &mut self.diagonal[column];
            cholesky(diagonal);
            for block in &mut self.below[start..end] {
                divide_rows(block, diagonal);
            }
            // Blocks of this column lie before those of the later ones.
            let (known, later) = self.below.split_at_mut(end);
            let (rows, known) = (&self.pattern.rows, &known[start..]);
            for (at, left) in known.iter().enumerate() {
                let target = rows[start + at] as usize;
                subtract_product(&mut self.diagonal[target], left, left);
                let mut slot = self.pattern.starts[target];
                for (other, upper) in known.iter().enumerate().skip(at + 1) {
                    while rows[slot] != rows[start + other] {
                        slot += 1;
                    }
                    subtract_product(&mut later[slot - end], upper, left);
                }
            }
        }
    }

    /// x := matrix^-1 x
    pub(crate) fn divide(&self, x: &mut [Six]) {
        let columns = self.pattern.order.len();
        let entries = |column: usize| {
            let range = self.pattern.starts[column]..self.pattern.starts[column + 1];
            let rows = self.pattern.rows[range.clone()].iter();
            rows.map(|&row| row as usize).zip(&self.below[range])
        };
        for column in 0..columns {
            solve_lower(&self.diagonal[column], &mut x[column]);
            let known = x[column];
            for (row, block) in entries(column) {
                subtract_from(&mut x[row], block, &known);
            }
        }
        for column in (0..columns).rev() {
            let mut sum = x[column];
            for (row, block) in entries(column) {
                subtract_transposed(&mut sum, block, &x[row]);
            }
            solve_upper(&self.diagonal[column], &mut sum);
            x[column] = sum;
        }
    }

    /// `sums` += J^T p of a contact
    pub(crate) fn add_impulse(&self, sums: &mut [Six], p: &Point, impulse: DVec3) {
        if impulse == DVec3::ZERO {
            return;
        }
        for (body, wrench) in [p.a(), p.b()].into_iter().zip(p.wrenches(impulse)) {
            if let Some(sum) = sums.get_mut(self.pattern.places[body] as usize) {
                sum.iter_mut().zip(wrench).for_each(|(s, w)| *s += w);
            }
        }
    }

    /// J x of a contact
    pub(crate) fn relative(&self, p: &Point, x: &[Six]) -> DVec3 {
        let of = |body: usize| x.get(self.pattern.places[body] as usize);
        let still = [0.0; 6];
        p.relative_of(of(p.a()).unwrap_or(&still), of(p.b()).unwrap_or(&still))
    }

    /// `out` := M x
    pub(crate) fn momenta(&self, x: &[Six], out: &mut Vec<Six>) {
        out.clear();
        out.extend(self.masses.iter().zip(x).map(|(&(mass, inertia), x)| {
            let [l, m, n] = (inertia * DVec3::from_slice(&x[3..])).to_array();
            [mass * x[0], mass * x[1], mass * x[2], l, m, n]
        }));
    }
}

impl Bond {
    const NONE: Self = Self {
        k: DMat3::ZERO,
        a: DMat3::ZERO,
        b: DMat3::ZERO,
        aa: DMat3::ZERO,
        bb: DMat3::ZERO,
        ab: DMat3::ZERO,
    };

    fn add(&mut self, k: DMat3, (a, b): (DVec3, DVec3)) {
        let (ak, bk) = (crossed(a, k), crossed(b, k));
        let (ka, kb) = (ak.transpose(), bk.transpose());
        self.k += k;
        self.a += ak;
        self.b += bk;
        self.aa += crossed(a, ka);
        self.bb += crossed(b, kb);
        self.ab += crossed(a, kb);
    }
}

/// r x each column
fn crossed(r: DVec3, m: DMat3) -> DMat3 {
    DMat3::from_cols(r.cross(m.x_axis), r.cross(m.y_axis), r.cross(m.z_axis))
}

/// block += sign (k, lower^T; lower, corner), its upper right part being left out.
fn put(block: &mut Block, [k, lower, corner]: [DMat3; 3], sign: f64) {
    for column in 0..3 {
        for row in 0..3 {
            block[6 * column + row] += sign * k.col(column)[row];
            block[6 * column + 3 + row] += sign * lower.col(column)[row];
            block[6 * (column + 3) + 3 + row] += sign * corner.col(column)[row];
        }
    }
}

/// The upper right part.
fn put_right(block: &mut Block, right: DMat3, sign: f64) {
    for column in 0..3 {
        for row in 0..3 {
            block[6 * (column + 3) + row] += sign * right.col(column)[row];
        }
    }
}
