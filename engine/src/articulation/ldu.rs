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

use glam::{DMat3, DVec3};

/// A pivot that is this part of the diagonal, or less, belongs to a redundant row.
const REDUNDANT: f64 = 1e-9;

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
    matrix: Vec<DMat3>,
    diagonal: Vec<DMat3>,
    lower: Vec<DMat3>,
    upper: Vec<DMat3>,
    pivots: Vec<Pivot>,
    /// D^-1
    inverses: Vec<DMat3>,
    above: Vec<DMat3>,
    left: Vec<DMat3>,
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
            matrix: vec![DMat3::ZERO; columns.iter().map(Vec::len).sum()],
            diagonal: vec![DMat3::ZERO; n],
            pattern: columns.concat(),
            lower: vec![DMat3::ZERO; starts[n]],
            upper: vec![DMat3::ZERO; starts[n]],
            pivots: vec![Pivot::default(); n],
            inverses: vec![DMat3::ZERO; n],
            above: vec![DMat3::ZERO; n],
            left: vec![DMat3::ZERO; n],
            rows: below.concat(),
            starts,
        }
    }

    /// Factor, with a share `more` added to the diagonal. `entries(i, k)` gives A_ik and the transpose of A_ki, for the
    /// entries of the pattern and the diagonal, i <= k. Returns whether every pivot is more
    /// than the part `REDUNDANT` of the diagonal.
    pub(crate) fn factor(
        &mut self,
        more: f64,
        mut entries: impl FnMut(usize, usize) -> [DMat3; 2],
    ) -> bool {
        let mut regular = true;
        for k in 0..self.inverses.len() {
            for p in self.columns[k]..self.columns[k + 1] {
                let i = self.pattern[p];
                [self.above[i], self.left[i]] = entries(i, k);
                self.matrix[p] = self.above[i];
            }
            let mut pivot = entries(k, k)[0];
            self.diagonal[k] = pivot;
            pivot.x_axis.x *= 1.0 + more;
            pivot.y_axis.y *= 1.0 + more;
            pivot.z_axis.z *= 1.0 + more;
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
    pub(crate) fn subtract_product(&self, x: &[DVec3], rest: &mut [DVec3]) {
        for k in 0..x.len() {
            let mut product = self.diagonal[k] * x[k];
            for p in self.columns[k]..self.columns[k + 1] {
                let i = self.pattern[p];
                rest[i] -= self.matrix[p] * x[k];
                product += self.matrix[p].transpose() * x[i];
            }
            rest[k] -= product;
        }
    }

    /// The block of L and that of U at a link, and what they take from the pivot.
    fn eliminate(&mut self, link: Link) -> DMat3 {
        let i = link.column;
        let y = std::mem::replace(&mut self.above[i], DMat3::ZERO);
        let z = std::mem::replace(&mut self.left[i], DMat3::ZERO);
        for p in self.starts[i]..link.place {
            let row = self.rows[p];
            self.above[row] -= self.lower[p] * y;
            self.left[row] -= self.upper[p].transpose() * z;
        }
        let upper = self.inverses[i] * y;
        self.lower[link.place] = (self.inverses[i].transpose() * z).transpose();
        self.upper[link.place] = upper;
        z.transpose() * upper
    }

    /// x := A^-1 x.
    pub(crate) fn solve(&self, x: &mut [DVec3]) {
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
    lower: DVec3,
    /// Inverse of the diagonal.
    inverse: DVec3,
    /// Above it, divided by the diagonal: (0, 1), (0, 2), (1, 2).
    upper: DVec3,
}

impl Pivot {
    fn new(m: &DMat3) -> Self {
        let (a, b, c) = (m.x_axis, m.y_axis, m.z_axis);
        let first = 1.0 / a.x;
        let (l1, l2) = (a.y * first, a.z * first);
        let (second, beside) = (1.0 / (b.y - l1 * b.x), c.y - l1 * c.x);
        let l3 = (b.z - l2 * b.x) * second;
        let third = c.z - l2 * c.x - l3 * beside;
        Self {
            lower: DVec3::new(l1, l2, l3),
            inverse: DVec3::new(first, second, 1.0 / third),
            upper: DVec3::new(b.x * first, c.x * first, beside * second),
        }
    }

    /// Its diagonal is more than the part `REDUNDANT` of that of `m`.
    fn is_regular(&self, m: &DMat3) -> bool {
        let whole = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
        let most = DVec3::splat(1.0 / REDUNDANT);
        (whole * self.inverse).abs().cmplt(most).all()
    }

    fn solve(&self, x: DVec3) -> DVec3 {
        let (l, u) = (self.lower, self.upper);
        let y = x.y - l.x * x.x;
        let down = DVec3::new(x.x, y, x.z - l.y * x.x - l.z * y) * self.inverse;
        let y = down.y - u.z * down.z;
        DVec3::new(down.x - u.x * y - u.y * down.z, y, down.z)
    }

    fn inverse(&self) -> DMat3 {
        DMat3::from_cols(
            self.solve(DVec3::X),
            self.solve(DVec3::Y),
            self.solve(DVec3::Z),
        )
    }
}

#[cfg(test)]
mod tests {
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

    #[test]
    fn solves_what_it_factored() {
        let n = 9;
        let columns: Vec<Vec<usize>> = (0..n)
            .map(|k| (0..k).filter(|&i| block(i, k) != DMat3::ZERO).collect())
            .collect();
        let mut ldu = Ldu::new(&columns);
        for _twice in 0..2 {
            ldu.factor(0.0, |i, k| [block(i, k), block(k, i).transpose()]);
            let wanted: Vec<DVec3> = (0..n)
                .map(|i| DVec3::new(i as f64 - 3.0, 0.7, 1.0 - 0.1 * i as f64))
                .collect();
            let mut x: Vec<DVec3> = (0..n)
                .map(|i| (0..n).map(|k| block(i, k) * wanted[k]).sum())
                .collect();
            ldu.solve(&mut x);
            for (got, want) in x.iter().zip(&wanted) {
                assert!((*got - *want).length() < 1e-13, "{got} {want}");
            }
        }
    }

    #[test]
    fn a_block_that_all_but_repeats_a_row_has_an_inverse() {
        let tiny = 1e-10;
        let m =
            DMat3::from_cols_array(&[1.0, 1.0, 1.0, 1.0, 1.0 + tiny, 1.0, 1.0, 1.0, 1.0 + tiny]);
        let one = m * Pivot::new(&m).inverse();
        assert!(
            (one - DMat3::IDENTITY).abs_diff_eq(DMat3::ZERO, 1e-5),
            "{one}"
        );
    }
}
