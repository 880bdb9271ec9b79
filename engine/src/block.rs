//! Arithmetic of 6 x 6 blocks, column by column in memory: a column is a few vector registers. What factors are made with
//! is inlined, to be compiled for the vector instructions around it.

/// Element (i, k) at 6 k + i.
pub(crate) type Block = [f64; 36];

/// out -= upper left^T
#[inline(always)]
pub(crate) fn subtract_product(out: &mut Block, upper: &Block, left: &Block) {
    for (k, column) in out.chunks_exact_mut(6).enumerate() {
        let mut sum: [f64; 6] = std::array::from_fn(|i| column[i]);
        for (m, upper) in upper.chunks_exact(6).enumerate() {
            let factor = left[6 * m + k];
            for i in 0..6 {
                sum[i] -= upper[i] * factor;
            }
        }
        column.copy_from_slice(&sum);
    }
}

/// The lower factor in place of a symmetric matrix, of which the lower half is read; its diagonal is kept inverted.
#[inline(always)]
pub(crate) fn cholesky(a: &mut Block) {
    for k in 0..6 {
        let inverse = 1.0 / a[7 * k].sqrt();
        a[7 * k] = inverse;
        for i in k + 1..6 {
            a[6 * k + i] *= inverse;
        }
        for m in k + 1..6 {
            let factor = a[6 * k + m];
            for i in m..6 {
                a[6 * m + i] -= a[6 * k + i] * factor;
            }
        }
    }
}

/// block := block L^-T
#[inline(always)]
pub(crate) fn divide_rows(block: &mut Block, l: &Block) {
    for k in 0..6 {
        let (known, rest) = block.split_at_mut(6 * k);
        let column = &mut rest[..6];
        for (m, known) in known.chunks_exact(6).enumerate() {
            let factor = l[6 * m + k];
            for i in 0..6 {
                column[i] -= known[i] * factor;
            }
        }
        column.iter_mut().for_each(|x| *x *= l[7 * k]);
    }
}

/// x := L^-1 x
pub(crate) fn solve_lower(l: &Block, x: &mut [f64; 6]) {
    for k in 0..6 {
        x[k] *= l[7 * k];
        for i in k + 1..6 {
            x[i] -= l[6 * k + i] * x[k];
        }
    }
}

/// x := L^-T x
pub(crate) fn solve_upper(l: &Block, x: &mut [f64; 6]) {
    for k in (0..6).rev() {
        for i in k + 1..6 {
            x[k] -= l[6 * k + i] * x[i];
        }
        x[k] *= l[7 * k];
    }
}

/// y -= block x
pub(crate) fn subtract_from(y: &mut [f64; 6], block: &Block, x: &[f64; 6]) {
    for (column, x) in block.chunks_exact(6).zip(x) {
        for i in 0..6 {
            y[i] -= column[i] * x;
        }
    }
}

/// x -= block^T y
pub(crate) fn subtract_transposed(x: &mut [f64; 6], block: &Block, y: &[f64; 6]) {
    for (x, column) in x.iter_mut().zip(block.chunks_exact(6)) {
        *x -= column.iter().zip(y).map(|(b, y)| b * y).sum::<f64>();
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

    #[test]
    fn a_block_and_its_transpose_multiply() {
        let mut block = [0.0; 36];
        block[6 * 2 + 1] = 3.0; // row 1, column 2
        let (mut y, mut x) = ([0.0; 6], [0.0; 6]);
        subtract_from(&mut y, &block, &[0.0, 0.0, 2.0, 0.0, 0.0, 0.0]);
        subtract_transposed(&mut x, &block, &[0.0, 5.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!((y[1], x[2]), (-6.0, -15.0));
    }
}
