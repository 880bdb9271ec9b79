//! Bytes in planes, for what packs them.

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::guarded;

/// `bytes` of numbers of `size` bytes each, with all first bytes first, then all second ones.
#[pyfunction]
pub(super) fn shuffled<'py>(
    py: Python<'py>,
    bytes: PyReadonlyArray1<'py, u8>,
    size: usize,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    if size == 0 {
        return Err(PyValueError::new_err("size: is 0"));
    }
    let bytes = bytes.as_slice()?;
    let planes = py.detach(|| guarded(|| crate::shuffle::shuffled(bytes, size)))?;
    Ok(planes.into_pyarray(py))
}
