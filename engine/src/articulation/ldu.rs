//! Sparse A = L D U of a matrix of 3 x 3 blocks whose pattern is symmetric and stays, and whose numbers change.
//!
//! Everything that follows from the pattern is found once: the elimination tree and where every block of the factors
//! goes (Davis 2005, "Algorithm 849: A concise sparse Cholesky factorization package", ACM TOMS 31). Row k of L and column
//! k of U then take from the columns of their reach, the ones on the tree paths from the entries of A(:, k) to k:
//!
//! ```text
//! y_i = A_ik - sum_j<i L_ij y_j,  z_i = A_ki - sum_j<i z_j U_ji,  U_ik = D_i^-1 y_i,  L_ki = z_i D_i^-1,
//! D_k = A_kk - sum_i L_ki y_i
//! ```
//!
//! Joints of a chain have neighbours only, so a chain costs as much as its length. Nothing is pivoted: A is J M^-1 J^T, or
//! near to it.

use pulp::{Simd, WithSimd};

use super::square::{Column, Square};
use crate::lanes::vectorised;

/// A pivot that is this part of the diagonal, or less, belongs to a redundant row.
const REDUNDANT: f64 = 1e-9;

/// What is factored.
pub(crate) trait Matrix {
    /// A_ik and A_ki of the pattern, i < k.
    fn entries(&self, i: usize, k: usize) -> [Square; 2];
    /// A_kk
    fn diagonal(&self, k: usize) -> Square;
}

/// A block of the factors that row k of L and column k of U share.
#[derive(Clone, Copy, Debug)]
struct Link {
    /// The column of L that it is in.
    column: usize,
    /// Its place among all blocks; those of its column before it are in rows before k.
    place: usize,
}

/// Pattern and factors. Column i of L and row i of U: blocks `starts[i]..starts[i + 1]`, in `rows` of A.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ldu {
    starts: Vec<usize>,
    rows: Vec<usize>,
    /// Reach of row k: `links[reaches[k]..reaches[k + 1]]`, ascending.
    reaches: Vec<usize>,
    links: Vec<Link>,
    /// Entries of A in column k above the diagonal: `pattern[columns[k]..columns[k + 1]]`.
    columns: Vec<usize>,
    pattern: Vec<usize>,
    /// A_ik of the pattern, column by column, and the A_kk.
    matrix: Vec<Square>,
    diagonal: Vec<Square>,
    lower: Vec<Square>,
    upper: Vec<Square>,
    pivots: Vec<Pivot>,
    /// D^-1
    inverses: Vec<Square>,
    above: Vec<Square>,
    left: Vec<Square>,
}

impl Ldu {
    /// Analyse a pattern: `columns[k]` holds the block rows i < k with A_ik or A_ki not zero, ascending.
    pub(crate) fn new(columns: &[Vec<usize>]) -> Self {
        let n = columns.len();
        let reaches = reaches(columns);
        let mut below = vec![Vec::new(); n];
        for (k, reach) in reaches.iter().enumerate() {
            reach.iter().for_each(|&i| below[i].push(k));
        }
        let starts = offsets(&below);
        let mut used = starts.clone();
        let mut link = |&i: &usize| {
            used[i] += 1;
            Link {
                column: i,
                place: used[i] - 1,
            }
        };
        Self {
            links: reaches.iter().flatten().map(&mut link).collect(),
            reaches: offsets(&reaches),
            columns: offsets(columns),
            matrix: vec![Square::ZERO; columns.iter().map(Vec::len).sum()],
            diagonal: vec![Square::ZERO; n],
            pattern: columns.concat(),
            lower: vec![Square::ZERO; starts[n]],
            upper: vec![Square::ZERO; starts[n]],
            pivots: vec![Pivot::default(); n],
            inverses: vec![Square::ZERO; n],
            above: vec![Square::ZERO; n],
            left: vec![Square::ZERO; n],
            rows: below.concat(),
            starts,
        }
    }

    /// Factor, with a share `more` added to the diagonal. Returns whether every pivot is more
    /// than the part `REDUNDANT` of the diagonal.
    pub(crate) fn factor(&mut self, more: f64, matrix: &impl Matrix) -> bool {
        vectorised(Factor(self, more, matrix))
    }

    #[inline(always)]
    fn find_factors(&mut self, more: f64, matrix: &impl Matrix) -> bool {
        let mut regular = true;
        for k in 0..self.inverses.len() {
            for p in self.columns[k]..self.columns[k + 1] {
                let i = self.pattern[p];
                [self.above[i], self.left[i]] = matrix.entries(i, k);
                self.matrix[p] = self.above[i];
            }
            let mut pivot = matrix.diagonal(k);
            self.diagonal[k] = pivot;
            (0..3).for_each(|row| pivot.0[row][row] *= 1.0 + more);
            for link in self.reaches[k]..self.reaches[k + 1] {
                pivot -= self.eliminate(self.links[link]);
            }
            self.pivots[k] = Pivot::new(&pivot);
            self.inverses[k] = self.pivots[k].inverse();
            regular &= self.pivots[k].is_regular(&self.diagonal[k]);
        }
        regular
    }

    /// rest -= A x of a symmetric A, without what was added to its diagonal.
    pub(crate) fn subtract_product(&self, x: &[Column], rest: &mut [Column]) {
        for k in 0..x.len() {
            let mut product = self.diagonal[k] * x[k];
            for p in self.columns[k]..self.columns[k + 1] {
                let i = self.pattern[p];
                rest[i] -= self.matrix[p] * x[k];
                product += self.matrix[p].transposed() * x[i];
            }
            rest[k] -= product;
        }
    }

    /// The block of L and that of U at a link, and what they take from the pivot.
    #[inline(always)]
    fn eliminate(&mut self, link: Link) -> Square {
        let i = link.column;
        let y = std::mem::replace(&mut self.above[i], Square::ZERO);
        let z = std::mem::replace(&mut self.left[i], Square::ZERO);
        for p in self.starts[i]..link.place {
            let row = self.rows[p];
            self.above[row] -= self.lower[p] * y;
            self.left[row] -= z * self.upper[p];
        }
        let upper = self.inverses[i] * y;
        self.lower[link.place] = z * self.inverses[i];
        self.upper[link.place] = upper;
        z * upper
    }

    /// x := A^-1 x.
    pub(crate) fn solve(&self, x: &mut [Column]) {
        vectorised(Solve(self, x));
    }

    #[inline(always)]
    fn substitute(&self, x: &mut [Column]) {
        for k in 0..x.len() {
            let y = x[k];
            for p in self.starts[k]..self.starts[k + 1] {
                x[self.rows[p]] -= self.lower[p] * y;
            }
        }
        for k in (0..x.len()).rev() {
            let mut y = self.pivots[k].solve(x[k]);
            for p in self.starts[k]..self.starts[k + 1] {
                y -= self.upper[p] * x[self.rows[p]];
            }
            x[k] = y;
        }
    }
}

struct Factor<'a, M>(&'a mut Ldu, f64, &'a M);

impl<M: Matrix> WithSimd for Factor<'_, M> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        self.0.find_factors(self.1, self.2)
    }
}

struct Solve<'a>(&'a Ldu, &'a mut [Column]);

impl WithSimd for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.0.substitute(self.1);
    }
}

/// Where each of the lists would start, were they one.
fn offsets(lists: &[Vec<usize>]) -> Vec<usize> {
    let mut starts = vec![0];
    starts.extend(lists.iter().scan(0, |total, list| {
        *total += list.len();
        Some(*total)
    }));
    starts
}

/// For each k the columns that take part in it, ascending: all on the tree paths from the entries of A(:, k) to k.
fn reaches(columns: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let n = columns.len();
    let mut parents: Vec<usize> = (0..n).collect();
    let mut mark = vec![usize::MAX; n];
    let mut out = Vec::with_capacity(n);
    for (k, rows) in columns.iter().enumerate() {
        mark[k] = k;
        let mut reach = Vec::new();
        for &row in rows {
            let mut i = row;
            while mark[i] != k {
                mark[i] = k;
                reach.push(i);
                if parents[i] == i {
                    parents[i] = k;
                }
                i = parents[i];
            }
        }
        reach.sort_unstable();
        out.push(reach);
    }
    out
}

/// A block on the diagonal, factored in the order of its rows. Cofactors would lose a pivot that is 1e-10 of the others.
#[derive(Clone, Copy, Debug, Default)]
struct Pivot {
    /// Below the diagonal: (1, 0), (2, 0), (2, 1).
    lower: [f64; 3],
    /// Inverse of the diagonal.
    inverse: [f64; 3],
    /// Above it, divided by the diagonal: (0, 1), (0, 2), (1, 2).
    upper: [f64; 3],
}

impl Pivot {
    #[inline(always)]
    fn new(m: &Square) -> Self {
        let [a, b, c] = m.0;
        let first = 1.0 / a[0];
        let (l1, l2) = (a[1] * first, a[2] * first);
        let (second, beside) = (1.0 / (b[1] - l1 * b[0]), c[1] - l1 * c[0]);
        let l3 = (b[2] - l2 * b[0]) * second;
        let third = c[2] - l2 * c[0] - l3 * beside;
        Self {
            lower: [l1, l2, l3],
            inverse: [first, second, 1.0 / third],
            upper: [b[0] * first, c[0] * first, beside * second],
        }
    }

    /// Its diagonal is more than the part `REDUNDANT` of that of `m`.
    #[inline(always)]
    fn is_regular(&self, m: &Square) -> bool {
        let whole = Column::new(m.diagonal()) * Column::new(self.inverse);
        let small = |part: f64| part.abs() < 1.0 / REDUNDANT;
        small(whole[0]) & small(whole[1]) & small(whole[2])
    }

    #[inline(always)]
    fn solve(&self, x: Column) -> Column {
        let (l, d, u, [x, y, z]) = (self.lower, self.inverse, self.upper, x.to_array());
        let y = y - l[0] * x;
        let z = (z - l[1] * x - l[2] * y) * d[2];
        let y = y * d[1] - u[2] * z;
        Column::new([x * d[0] - u[0] * y - u[1] * z, y, z])
    }

    #[inline(always)]
    fn inverse(&self) -> Square {
        let [x, y, z] = Column::AXES;
        Square([self.solve(x), self.solve(y), self.solve(z)])
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;

    /// An arrow and a band together: fills in. Not symmetric.
    fn block(i: usize, k: usize) -> DMat3 {
        let near = match i.abs_diff(k) {
            0 => return DMat3::from_diagonal(DVec3::new(4.0, 5.0, 6.0 + i as f64)),
            1 => -1.0,
            _ if i.min(k) == 0 => 0.5,
            _ => return DMat3::ZERO,
        };
        let skew = DMat3::from_cols_array(&[1.0, 0.2, 0.0, -0.3, 0.8, 0.1, 0.4, 0.0, 1.1]);
        if i < k {
            near * skew
        } else {
            near * DMat3::IDENTITY
        }
    }

    struct Sample;

    impl Matrix for Sample {
        fn entries(&self, i: usize, k: usize) -> [Square; 2] {
            [square(block(i, k)), square(block(k, i))]
        }

        fn diagonal(&self, k: usize) -> Square {
            square(block(k, k))
        }
    }

    fn square(m: DMat3) -> Square {
        Square([m.x_axis, m.y_axis, m.z_axis].map(|column| Column::new(column.to_array())))
    }

    #[test]
    fn solves_what_it_factored() {
        let n = 9;
        let columns: Vec<Vec<usize>> = (0..n)
            .map(|k| (0..k).filter(|&i| block(i, k) != DMat3::ZERO).collect())
            .collect();
        let mut ldu = Ldu::new(&columns);
        for _twice in 0..2 {
            ldu.factor(0.0, &Sample);
            let wanted: Vec<DVec3> = (0..n)
                .map(|i| DVec3::new(i as f64 - 3.0, 0.7, 1.0 - 0.1 * i as f64))
                .collect();
            let product = |i: usize| (0..n).map(|k| block(i, k) * wanted[k]).sum::<DVec3>();
            let mut x: Vec<Column> = (0..n).map(|i| Column::new(product(i).to_array())).collect();
            ldu.solve(&mut x);
            for (got, want) in x.iter().zip(&wanted) {
                let off = (DVec3::from_array(got.to_array()) - *want).length();
                assert!(off < 1e-13, "{got:?} {want}");
            }
        }
    }

    #[test]
    fn a_block_that_all_but_repeats_a_row_has_an_inverse() {
        let tiny = 1e-10;
        let m =
            DMat3::from_cols_array(&[1.0, 1.0, 1.0, 1.0, 1.0 + tiny, 1.0, 1.0, 1.0, 1.0 + tiny]);
        let inverse = Pivot::new(&square(m)).inverse();
        let columns = inverse.0.map(|column| DVec3::from_array(column.to_array()));
        let one = m * DMat3::from_cols(columns[0], columns[1], columns[2]);
        assert!(
            (one - DMat3::IDENTITY).abs_diff_eq(DMat3::ZERO, 1e-5),
            "{one}"
        );
    }
}
