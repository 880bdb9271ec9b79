//! The linear system of the contacts that carry, solved directly.
//!
//! Open contacts stay open, those that stick ask for u = (target, 0, 0), those that slide for u_n = target while their
//! friction stands. With J the rows that are asked for, A = J M^-1 J^T and a little compliance C = eps diag(A) that makes
//! redundant rows harmless (four corners of a box hold more than it needs), the impulses z solve (A + C) z = r. In the
//! bodies' velocities w = M^-1 J^T z that is
//!
//! ```text
//! (M + J^T C^-1 J) w = J^T C^-1 r,        z = C^-1 (r - J w)
//! ```
//!
//! whose matrix has a 6 x 6 block for each body and for each pair in contact. A stack is a chain there and a wall a
//! grid: Cholesky's factor of it, bodies of few neighbours first, is hardly larger, and a tower of a hundred boxes is
//! as cheap, box by box, as one of two.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use crate::islands::index;
use crate::math::length;
use crate::mover::{Mover, Part};
use crate::point::Point;

/// eps, see above. What a solve leaves of an error in a motion whose eigenvalue of diag(A)^-1 A is e: eps / (eps + e).
const COMPLIANCE: f64 = 1e-5;
/// A bound of friction is reached when less than this part of it is left.
const RIM: f64 = 1e-9;

/// A block of the matrix, row by row.
type Block = [f64; 36];

/// Which bodies meet, and what Cholesky's factor of their matrix looks like.
#[derive(Clone, Debug, Default)]
struct Pattern {
    /// Pairs of bodies in contact, as they came: the pattern is good as long as they are the same.
    pairs: Vec<(u32, u32)>,
    /// Bodies that move, in the order of elimination.
    order: Vec<u32>,
    /// Place of each body in that order, or `FIXED`.
    places: Vec<u32>,
    /// Products of blocks in a factorisation; more than were allowed where it was given up.
    products: usize,
    /// It was not given up.
    complete: bool,
    /// Rows below the diagonal, column by column.
    starts: Vec<usize>,
    rows: Vec<u32>,
}

const FIXED: u32 = u32::MAX;

/// Working memory of the solve, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Direct {
    pattern: Pattern,
    diagonal: Vec<Block>,
    below: Vec<Block>,
    twists: Vec<[f64; 6]>,
    /// Ones where the relative velocity is asked for.
    asked: Vec<DVec3>,
    /// What the impulses gain.
    steps: Vec<DVec3>,
}

impl Direct {
    /// How many products of blocks a solve of these contacts takes; None for more than `most`. Bodies without a full
    /// share of inertia, such as thin rods, cannot be solved at all.
    pub(crate) fn products(
        &mut self,
        points: &[Point],
        movers: &[Mover],
        most: usize,
    ) -> Option<usize> {
        let suits = self.pattern.load(points, movers, most);
        suits.then_some(self.pattern.products)
    }

    /// Push the contacts to where the ones that carry now all reach their targets; impulses may leave their cones.
    /// Only where `products` are known.
    pub(crate) fn solve(&mut self, points: &mut [Point], movers: &mut [Mover], part: Part) {
        self.asked.clear();
        self.asked.extend(points.iter().map(|p| asked_of(p, part)));
        self.assemble(points, movers);
        self.factor();
        self.load(points, movers);
        self.divide();
        self.give(points, movers);
    }

    /// `twists` := J^T C^-1 r
    fn load(&mut self, points: &[Point], movers: &[Mover]) {
        let places = &self.pattern.places;
        self.twists.clear();
        self.twists.resize(self.pattern.order.len(), [0.0; 6]);
        for (p, &asked) in points.iter().zip(&self.asked) {
            if asked == DVec3::ZERO {
                continue;
            }
            let wrenches = p.wrenches(stiffness(p, asked) * missing(p, movers));
            for (body, wrench) in [p.a(), p.b()].into_iter().zip(wrenches) {
                if places[body] != FIXED {
                    let sum = &mut self.twists[places[body] as usize];
                    sum.iter_mut().zip(wrench).for_each(|(s, w)| *s += w);
                }
            }
        }
    }

    /// z = C^-1 (r - J w), to the contacts and their bodies.
    fn give(&mut self, points: &mut [Point], movers: &mut [Mover]) {
        self.steps.clear();
        for (p, &asked) in points.iter().zip(&self.asked) {
            let twist = |body: usize| match self.pattern.places[body] {
                FIXED => [0.0; 6],
                place => self.twists[place as usize],
            };
            let gained = p.relative_of(&twist(p.a()), &twist(p.b()));
            self.steps
                .push(stiffness(p, asked) * (missing(p, movers) - gained));
        }
        for (p, &step) in points.iter_mut().zip(&self.steps) {
            p.impulse += step;
            p.push(movers, step);
        }
    }

    /// M + J^T C^-1 J
    fn assemble(&mut self, points: &[Point], movers: &[Mover]) {
        let pattern = &self.pattern;
        self.diagonal.clear();
        self.diagonal.extend(
            pattern
                .order
                .iter()
                .map(|&k| mass_block(&movers[k as usize])),
        );
        self.below.clear();
        self.below.resize(pattern.rows.len(), [0.0; 36]);
        for (p, &asked) in points.iter().zip(&self.asked) {
            if asked == DVec3::ZERO {
                continue;
            }
            let weights = stiffness(p, asked);
            let rows = p.rows();
            let (a, b) = (pattern.places[p.a()], pattern.places[p.b()]);
            if a != FIXED {
                add_product(&mut self.diagonal[a as usize], &rows.0, &rows.0, weights);
            }
            if b != FIXED {
                add_product(&mut self.diagonal[b as usize], &rows.1, &rows.1, weights);
            }
            if a != FIXED && b != FIXED {
                // The block of the later row and the earlier column.
                let (column, row, upper, left) = if a < b {
                    (a, b, &rows.1, &rows.0)
                } else {
                    (b, a, &rows.0, &rows.1)
                };
                let slot = pattern.slot(column as usize, row);
                add_product(&mut self.below[slot], upper, left, weights);
            }
        }
    }

    /// Cholesky's factor in place of the matrix, column by column; what a column does to later ones is done at once.
    fn factor(&mut self) {
        for column in 0..self.pattern.order.len() {
            let (start, end) = (self.pattern.starts[column], self.pattern.starts[column + 1]);
            let diagonal = &mut self.diagonal[column];
            cholesky(diagonal);
            let diagonal = *diagonal;
            for block in &mut self.below[start..end] {
                divide_rows(block, &diagonal);
            }
            for at in start..end {
                let target = self.pattern.rows[at] as usize;
                let left = self.below[at];
                subtract_square(&mut self.diagonal[target], &left);
                let mut slot = self.pattern.starts[target];
                for other in at + 1..end {
                    while self.pattern.rows[slot] != self.pattern.rows[other] {
                        slot += 1;
                    }
                    let upper = self.below[other];
                    subtract_product(&mut self.below[slot], &upper, &left);
                }
            }
        }
    }

    /// `twists` := matrix^-1 `twists`
    fn divide(&mut self) {
        let columns = self.pattern.order.len();
        for column in 0..columns {
            solve_lower(&self.diagonal[column], &mut self.twists[column]);
            let x = self.twists[column];
            for at in self.pattern.starts[column]..self.pattern.starts[column + 1] {
                let y = &mut self.twists[self.pattern.rows[at] as usize];
                let block = &self.below[at];
                for (row, y) in y.iter_mut().enumerate() {
                    *y -= (0..6).map(|k| block[6 * row + k] * x[k]).sum::<f64>();
                }
            }
        }
        for column in (0..columns).rev() {
            let mut x = self.twists[column];
            for at in self.pattern.starts[column]..self.pattern.starts[column + 1] {
                let y = self.twists[self.pattern.rows[at] as usize];
                let block = &self.below[at];
                for (row, y) in y.iter().enumerate() {
                    for k in 0..6 {
                        x[k] -= block[6 * row + k] * y;
                    }
                }
            }
            solve_upper(&self.diagonal[column], &mut x);
            self.twists[column] = x;
        }
    }
}

impl Pattern {
    /// Of these contacts; false where a factorisation would take more than so many products of blocks.
    fn load(&mut self, points: &[Point], movers: &[Mover], products: usize) -> bool {
        let same = self.places.len() == movers.len()
            && self.pairs.len() == points.len()
            && self
                .pairs
                .iter()
                .zip(points)
                .all(|(&pair, p)| pair == p.bodies);
        let known = self.complete || self.products > products;
        if !(same && known) {
            self.pairs.clear();
            self.pairs.extend(points.iter().map(|p| p.bodies));
            let mut neighbours = self.graph(movers);
            self.eliminate(&mut neighbours, products);
        }
        let whole = |&k: &u32| has_inertia(&movers[k as usize]);
        self.products <= products && self.order.iter().all(whole)
    }

    /// Moving bodies that touch each one, by the order in which contacts name them; `order` tells who they are.
    fn graph(&mut self, movers: &[Mover]) -> Vec<Vec<u32>> {
        if self.places.len() == movers.len() {
            for &body in &self.order {
                self.places[body as usize] = FIXED;
            }
        } else {
            self.places.clear();
            self.places.resize(movers.len(), FIXED);
        }
        self.order.clear();
        let mut neighbours: Vec<Vec<u32>> = Vec::new();
        let moves = |k: u32| movers[k as usize].inverse_mass != 0.0;
        for &(a, b) in &self.pairs {
            for k in [a, b] {
                if moves(k) && self.places[k as usize] == FIXED {
                    self.places[k as usize] = index(self.order.len());
                    self.order.push(k);
                    neighbours.push(Vec::new());
                }
            }
            if moves(a) && moves(b) {
                let (a, b) = (self.places[a as usize], self.places[b as usize]);
                neighbours[a as usize].push(b);
                neighbours[b as usize].push(a);
            }
        }
        for list in &mut neighbours {
            list.sort_unstable();
            list.dedup();
        }
        neighbours
    }

    /// Bodies of least degree first (Tinney & Walker 1967); the neighbours that an eliminated body leaves behind then
    /// touch one another. Stops where it takes more than so many products.
    fn eliminate(&mut self, neighbours: &mut [Vec<u32>], products: usize) {
        let mut queue: BinaryHeap<Reverse<(usize, u32)>> = (0..)
            .zip(neighbours.iter())
            .map(|(k, list)| Reverse((list.len(), k)))
            .collect();
        let mut turn = vec![FIXED; neighbours.len()];
        let mut sequence: Vec<u32> = Vec::with_capacity(neighbours.len());
        self.products = 0;
        self.complete = false;
        self.starts.clear();
        self.rows.clear();
        self.starts.push(0);
        while let Some(Reverse((degree, k))) = queue.pop() {
            if turn[k as usize] != FIXED || neighbours[k as usize].len() != degree {
                continue; // an entry from before its degree changed
            }
            self.products += degree * (degree + 3) / 2;
            if self.products > products {
                return;
            }
            turn[k as usize] = index(sequence.len());
            sequence.push(k);
            let clique = std::mem::take(&mut neighbours[k as usize]);
            for &i in &clique {
                let list = &mut neighbours[i as usize];
                *list = merged(list, &clique, (i, k));
                queue.push(Reverse((list.len(), i)));
            }
            self.rows.extend(clique);
            self.starts.push(self.rows.len());
        }
        self.number(&turn, &sequence);
        self.complete = true;
    }

    /// Rows and bodies by their turn in the elimination, instead of as `graph` found them.
    fn number(&mut self, turn: &[u32], sequence: &[u32]) {
        for row in &mut self.rows {
            *row = turn[*row as usize];
        }
        for column in self.starts.windows(2) {
            self.rows[column[0]..column[1]].sort_unstable();
        }
        self.order = sequence.iter().map(|&k| self.order[k as usize]).collect();
        for (place, &body) in (0..).zip(&self.order) {
            self.places[body as usize] = place;
        }
    }

    /// Where the block of a row and an earlier column is.
    fn slot(&self, column: usize, row: u32) -> usize {
        let rows = &self.rows[self.starts[column]..self.starts[column + 1]];
        self.starts[column] + rows.partition_point(|&r| r < row)
    }
}

/// The union of two sorted lists without two members.
fn merged(a: &[u32], b: &[u32], without: (u32, u32)) -> Vec<u32> {
    let mut out = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let next = match (a.get(i), b.get(j)) {
            (Some(&x), Some(&y)) => x.min(y),
            (Some(&x), None) | (None, Some(&x)) => x,
            (None, None) => break,
        };
        i += usize::from(a.get(i) == Some(&next));
        j += usize::from(b.get(j) == Some(&next));
        if next != without.0 && next != without.1 {
            out.push(next);
        }
    }
    out
}

/// Its inertia can be found from the inverse.
fn has_inertia(mover: &Mover) -> bool {
    let i = &mover.inverse_inertia;
    let mean = (i.x_axis.x + i.y_axis.y + i.z_axis.z) / 3.0;
    i.determinant() > 1e-6 * mean * mean * mean
}

fn asked_of(p: &Point, part: Part) -> DVec3 {
    let limit = p.cone.friction * p.impulse.x;
    if p.impulse.x <= 0.0 {
        DVec3::ZERO
    } else if part == Part::All && length(p.impulse.y, p.impulse.z) < limit * (1.0 - RIM) {
        DVec3::ONE
    } else {
        DVec3::X
    }
}

/// C^-1 of the rows that are asked for.
fn stiffness(p: &Point, asked: DVec3) -> DVec3 {
    asked / (p.k() * COMPLIANCE + DVec3::X * p.cone.give)
}

/// r
fn missing(p: &Point, movers: &[Mover]) -> DVec3 {
    -DVec3::X * (p.cone.give * p.impulse.x) - p.velocity(movers)
}

/// diag(m 1, I)
fn mass_block(mover: &Mover) -> Block {
    let mut out = [0.0; 36];
    let mass = 1.0 / mover.inverse_mass;
    let inertia = mover.inverse_inertia.inverse();
    for k in 0..3 {
        out[7 * k] = mass;
        for i in 0..3 {
            out[6 * (3 + i) + 3 + k] = inertia.col(k)[i];
        }
    }
    out
}

/// out += upper^T diag(weights) left, for three rows each.
fn add_product(out: &mut Block, upper: &[[f64; 6]; 3], left: &[[f64; 6]; 3], weights: DVec3) {
    for ((u, l), w) in upper.iter().zip(left).zip(weights.to_array()) {
        for i in 0..6 {
            let factor = u[i] * w;
            for k in 0..6 {
                out[6 * i + k] += factor * l[k];
            }
        }
    }
}

/// out -= upper left^T
fn subtract_product(out: &mut Block, upper: &Block, left: &Block) {
    for i in 0..6 {
        for k in 0..6 {
            let mut sum = 0.0;
            for m in 0..6 {
                sum += upper[6 * i + m] * left[6 * k + m];
            }
            out[6 * i + k] -= sum;
        }
    }
}

/// out -= left left^T
fn subtract_square(out: &mut Block, left: &Block) {
    subtract_product(out, left, left);
}

/// The lower factor in place of a symmetric matrix; its diagonal is kept inverted.
fn cholesky(a: &mut Block) {
    for k in 0..6 {
        let mut pivot = a[7 * k];
        for m in 0..k {
            pivot -= a[6 * k + m] * a[6 * k + m];
        }
        let inverse = 1.0 / pivot.sqrt();
        a[7 * k] = inverse;
        for i in k + 1..6 {
            let mut sum = a[6 * i + k];
            for m in 0..k {
                sum -= a[6 * i + m] * a[6 * k + m];
            }
            a[6 * i + k] = sum * inverse;
        }
    }
}

/// block := block L^-T
fn divide_rows(block: &mut Block, l: &Block) {
    for row in block.chunks_exact_mut(6) {
        for k in 0..6 {
            let mut sum = row[k];
            for m in 0..k {
                sum -= row[m] * l[6 * k + m];
            }
            row[k] = sum * l[7 * k];
        }
    }
}

fn solve_lower(l: &Block, x: &mut [f64; 6]) {
    for k in 0..6 {
        for m in 0..k {
            x[k] -= l[6 * k + m] * x[m];
        }
        x[k] *= l[7 * k];
    }
}

fn solve_upper(l: &Block, x: &mut [f64; 6]) {
    for k in (0..6).rev() {
        for m in k + 1..6 {
            x[k] -= l[6 * m + k] * x[m];
        }
        x[k] *= l[7 * k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix() -> Block {
        let mut out = [0.0; 36];
        for i in 0..6 {
            for k in 0..6 {
                let off = 1.0 / (1.0 + (i + 2 * k) as f64) + 1.0 / (1.0 + (k + 2 * i) as f64);
                out[6 * i + k] = if i == k { 5.0 + i as f64 } else { off };
            }
        }
        out
    }

    #[test]
    fn lists_are_merged_without_two_members() {
        assert_eq!(merged(&[1, 4, 7], &[2, 4, 9], (4, 9)), [1, 2, 7]);
        assert_eq!(merged(&[], &[3], (3, 0)), [0; 0]);
    }

    #[test]
    fn a_block_divides_what_it_multiplied() {
        let a = matrix();
        let x = [1.0, -2.0, 0.5, 3.0, -1.0, 0.25];
        let mut y: [f64; 6] = std::array::from_fn(|i| (0..6).map(|k| a[6 * i + k] * x[k]).sum());
        let mut l = a;
        cholesky(&mut l);
        solve_lower(&l, &mut y);
        solve_upper(&l, &mut y);
        for (y, x) in y.iter().zip(x) {
            assert!((y - x).abs() < 1e-14);
        }
    }

    /// A column's block B L^-T, squared, is B A^-1 B^T.
    #[test]
    fn rows_are_divided_by_the_factor() {
        let (a, b) = (matrix(), [0.7; 36]);
        let (mut l, mut divided) = (a, b);
        cholesky(&mut l);
        divide_rows(&mut divided, &l);
        let mut square = [0.0; 36];
        subtract_product(&mut square, &divided, &divided);
        let mut x = [0.7; 6];
        solve_lower(&l, &mut x);
        solve_upper(&l, &mut x);
        let expected = -0.7 * x.iter().sum::<f64>();
        assert!(square.iter().all(|s| (s - expected).abs() < 1e-14));
    }
}
