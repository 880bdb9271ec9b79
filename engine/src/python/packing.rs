//! Bytes in the order in which they pack well.

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// So many items are taken at a time: they stay in the nearest cache while their bytes are picked.
const ITEMS: usize = 512;

/// The bytes of items of `size` bytes each: all first bytes, then all second ones, and so on; what HDF5's filter
/// "shuffle" makes of them.
#[pyfunction]
pub(super) fn shuffled<'py>(
    py: Python<'py>,
    items: PyReadonlyArray1<'py, u8>,
    size: usize,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let bytes = items.as_slice()?;
    if size == 0 || bytes.len() % size != 0 {
        return Err(PyValueError::new_err("these are no whole items"));
    }
    Ok(py.detach(|| planes(bytes, size)).into_pyarray(py))
}

fn planes(bytes: &[u8], size: usize) -> Vec<u8> {
    let count = bytes.len() / size;
    let mut out = vec![0; bytes.len()];
    for (block, items) in bytes.chunks(ITEMS * size).enumerate() {
        let (start, length) = (block * ITEMS, items.len() / size);
        for plane in 0..size {
            let to = &mut out[plane * count + start..][..length];
            match size {
                8 => pick::<8>(items, plane, to),
                4 => pick::<4>(items, plane, to),
                _ => to
                    .iter_mut()
                    .zip(items.chunks_exact(size))
                    .for_each(|(byte, item)| *byte = item[plane]),
            }
        }
    }
    out
}

/// One byte of each item. Items go through a register each, which makes this loop one of wide instructions.
fn pick<const SIZE: usize>(items: &[u8], plane: usize, to: &mut [u8]) {
    for (byte, item) in to.iter_mut().zip(items.chunks_exact(SIZE)) {
        let mut word = [0; 8];
        word[..SIZE].copy_from_slice(item);
        #[allow(clippy::cast_possible_truncation)] // the lowest byte is what is wanted
        let picked = (u64::from_le_bytes(word) >> (8 * plane)) as u8;
        *byte = picked;
    }
}

#[cfg(test)]
mod tests {
    use super::{planes, ITEMS};

    #[test]
    fn bytes_of_equal_rank_stand_together() {
        for size in [1, 2, 4, 8] {
            let count = 2 * ITEMS + 3;
            let bytes: Vec<u8> = (0..count * size).map(|k| (k * k / 7) as u8).collect();
            let found = planes(&bytes, size);
            for (k, &byte) in bytes.iter().enumerate() {
                assert_eq!(found[k % size * count + k / size], byte);
            }
        }
    }
}
