//! Sparse A = L D L^T of a symmetric matrix whose pattern stays and whose numbers change.
//!
//! Up-looking factorisation along the elimination tree (Davis 2005, "Algorithm 849: A concise sparse Cholesky
//! factorization package", ACM TOMS 31): row k of L solves L(1..k, 1..k) y = A(1..k, k), and only the columns on the
//! tree paths from the entries of A(:, k) to k take part. Rows of a chain of joints have neighbours only, so a chain
//! costs as much as its length.

/// Pattern of the upper triangle of A by columns, the elimination tree, and the factors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ldl {
    /// Rows of the entries of column k, ascending, the diagonal last: `pattern[starts[k]..starts[k + 1]]`.
    starts: Vec<usize>,
    pattern: Vec<usize>,
    /// The next row that row k passes on to; the row itself at a root.
    parents: Vec<usize>,
    /// Columns of L: `l_rows[l_starts[k]..l_starts[k] + l_counts[k]]`.
    l_starts: Vec<usize>,
    l_counts: Vec<usize>,
    l_rows: Vec<usize>,
    l_values: Vec<f64>,
    diagonal: Vec<f64>,
    work: Vec<f64>,
    reach: Vec<usize>,
    mark: Vec<usize>,
}

impl Ldl {
    /// Analyse a pattern: `columns[k]` holds the rows i < k with A(i, k) != 0, ascending.
    pub(crate) fn new(columns: &[Vec<usize>]) -> Self {
        let n = columns.len();
        let mut ldl = Self {
            starts: vec![0],
            parents: (0..n).collect(),
            l_counts: vec![0; n],
            diagonal: vec![0.0; n],
            work: vec![0.0; n],
            mark: vec![usize::MAX; n],
            ..Self::default()
        };
        for (k, rows) in columns.iter().enumerate() {
            ldl.pattern.extend(rows);
            ldl.pattern.push(k);
            ldl.starts.push(ldl.pattern.len());
            ldl.grow_tree(rows, k);
        }
        let mut total = 0;
        for count in &mut ldl.l_counts {
            ldl.l_starts.push(total);
            total += *count;
            *count = 0;
        }
        ldl.l_rows = vec![0; total];
        ldl.l_values = vec![0.0; total];
        ldl.reach = Vec::with_capacity(n);
        ldl
    }

    /// Every row on the way from an entry of column k up to k gets an entry in row k of L.
    fn grow_tree(&mut self, rows: &[usize], k: usize) {
        self.mark[k] = k;
        for &row in rows {
            let mut i = row;
            while self.mark[i] != k {
                if self.parents[i] == i {
                    self.parents[i] = k;
                }
                self.l_counts[i] += 1;
                self.mark[i] = k;
                i = self.parents[i];
            }
        }
    }

    /// Order of A.
    pub(crate) fn len(&self) -> usize {
        self.diagonal.len()
    }

    /// Factor. `entry(i, k)` gives A(i, k) for the entries of the pattern, i <= k.
    pub(crate) fn factor(&mut self, mut entry: impl FnMut(usize, usize) -> f64) {
        self.l_counts.fill(0);
        self.mark.fill(usize::MAX);
        for k in 0..self.len() {
            self.reach_of(k);
            for p in self.starts[k]..self.starts[k + 1] {
                let i = self.pattern[p];
                self.work[i] = entry(i, k);
            }
            let mut d = std::mem::take(&mut self.work[k]);
            for &i in self.reach.iter().rev() {
                let y = std::mem::take(&mut self.work[i]);
                let (start, count) = (self.l_starts[i], self.l_counts[i]);
                for p in start..start + count {
                    self.work[self.l_rows[p]] -= self.l_values[p] * y;
                }
                let l = y / self.diagonal[i];
                d -= l * y;
                self.l_rows[start + count] = k;
                self.l_values[start + count] = l;
                self.l_counts[i] += 1;
            }
            self.diagonal[k] = d;
        }
    }

    /// The columns that take part in row k: all on the tree paths from the entries of A(:, k) to k, last first. A
    /// column only passes on to later ones, so ascending order is a valid one.
    fn reach_of(&mut self, k: usize) {
        self.reach.clear();
        self.mark[k] = k;
        for p in self.starts[k]..self.starts[k + 1] {
            let mut i = self.pattern[p];
            while self.mark[i] != k {
                self.reach.push(i);
                self.mark[i] = k;
                i = self.parents[i];
            }
        }
        self.reach.sort_unstable_by(|a, b| b.cmp(a));
    }

    /// x := A^-1 x.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        let column = |k: usize| self.l_starts[k]..self.l_starts[k] + self.l_counts[k];
        for k in 0..self.len() {
            let y = x[k];
            for p in column(k) {
                x[self.l_rows[p]] -= self.l_values[p] * y;
            }
        }
        for (value, d) in x.iter_mut().zip(&self.diagonal) {
            *value /= d;
        }
        for k in (0..self.len()).rev() {
            let known: f64 = column(k)
                .map(|p| self.l_values[p] * x[self.l_rows[p]])
                .sum();
            x[k] -= known;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arrow and a band together: fills in.
    fn matrix(n: usize) -> Vec<Vec<f64>> {
        let mut a = vec![vec![0.0; n]; n];
        for i in 0..n {
            a[i][i] = 4.0 + i as f64;
            if i + 1 < n {
                a[i][i + 1] = -1.0;
                a[i + 1][i] = -1.0;
            }
            if i > 1 {
                a[0][i] = 0.5;
                a[i][0] = 0.5;
            }
        }
        a
    }

    #[test]
    fn solves_what_it_factored() {
        let n = 9;
        let a = matrix(n);
        let columns: Vec<Vec<usize>> = (0..n)
            .map(|k| (0..k).filter(|&i| a[i][k] != 0.0).collect())
            .collect();
        let mut ldl = Ldl::new(&columns);
        for _twice in 0..2 {
            ldl.factor(|i, k| a[i][k]);
            let wanted: Vec<f64> = (0..n).map(|i| (i as f64 - 3.0) * 0.7).collect();
            let mut x: Vec<f64> = (0..n)
                .map(|i| (0..n).map(|k| a[i][k] * wanted[k]).sum())
                .collect();
            ldl.solve(&mut x);
            for (got, want) in x.iter().zip(&wanted) {
                assert!((got - want).abs() < 1e-14, "{got} {want}");
            }
        }
    }
}
