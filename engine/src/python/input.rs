//! Values of the border dictionary, checked for type and shape.

use glam::{DQuat, DVec3};
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Reads values of the border dictionary by name.
pub(super) struct Input<'py>(pub(super) &'py Bound<'py, PyDict>);

impl<'py> Input<'py> {
    pub(super) fn item(&self, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.0
            .get_item(name)?
            .ok_or_else(|| PyValueError::new_err(format!("{name} is missing")))
    }

    pub(super) fn float(&self, name: &str) -> PyResult<f64> {
        let value: f64 = self.item(name)?.extract()?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(PyValueError::new_err(format!(
                "{name} must be finite, got {value}"
            )))
        }
    }

    pub(super) fn text(&self, name: &str) -> PyResult<String> {
        self.item(name)?.extract()
    }

    /// A float64 array whose shape, after the first axis, multiplies to `width`.
    pub(super) fn floats(&self, name: &str, width: usize) -> PyResult<Vec<f64>> {
        floats(&self.item(name)?, name, width)
    }

    pub(super) fn vectors(&self, name: &str) -> PyResult<Vec<DVec3>> {
        Ok(self
            .floats(name, 3)?
            .chunks_exact(3)
            .map(DVec3::from_slice)
            .collect())
    }

    pub(super) fn rotations(&self, name: &str) -> PyResult<Vec<DQuat>> {
        Ok(self
            .floats(name, 4)?
            .chunks_exact(4)
            .map(quaternion)
            .collect())
    }

    pub(super) fn integers(&self, name: &str, width: usize) -> PyResult<Vec<i32>> {
        integers(&self.item(name)?, name, width)
    }

    pub(super) fn list(&self, name: &str) -> PyResult<Bound<'py, PyList>> {
        Ok(self.item(name)?.cast_into::<PyList>()?)
    }
}

pub(super) fn floats(value: &Bound<'_, PyAny>, name: &str, width: usize) -> PyResult<Vec<f64>> {
    let array: PyReadonlyArrayDyn<'_, f64> = value
        .extract()
        .map_err(|_| PyValueError::new_err(format!("{name} must be a float64 array")))?;
    check_width(name, array.shape(), width)?;
    Ok(array.as_array().iter().copied().collect())
}

pub(super) fn integers(value: &Bound<'_, PyAny>, name: &str, width: usize) -> PyResult<Vec<i32>> {
    let array: PyReadonlyArrayDyn<'_, i32> = value
        .extract()
        .map_err(|_| PyValueError::new_err(format!("{name} must be an int32 array")))?;
    check_width(name, array.shape(), width)?;
    Ok(array.as_array().iter().copied().collect())
}

pub(super) fn check_width(name: &str, shape: &[usize], width: usize) -> PyResult<()> {
    let inner: usize = shape.iter().skip(1).product();
    if shape.is_empty() || inner != width {
        return Err(PyValueError::new_err(format!(
            "{name} has the wrong shape {shape:?}"
        )));
    }
    Ok(())
}

pub(super) fn quaternion(wxyz: &[f64]) -> DQuat {
    let q = DQuat::from_xyzw(wxyz[1], wxyz[2], wxyz[3], wxyz[0]);
    if q.length_squared() > 0.0 {
        q.normalize()
    } else {
        DQuat::IDENTITY
    }
}

/// An index of the dictionary, checked against the length of what it points into.
pub(super) fn index(value: i32, length: usize, name: &str) -> PyResult<usize> {
    usize::try_from(value)
        .ok()
        .filter(|&k| k < length)
        .ok_or_else(|| {
            PyValueError::new_err(format!(
                "{name} has the index {value}, allowed are 0 to {length} - 1"
            ))
        })
}

pub(super) fn same_length<T>(name: &str, list: &[T], length: usize) -> PyResult<()> {
    if list.len() == length {
        return Ok(());
    }
    Err(PyValueError::new_err(format!(
        "{name} has {} entries, {length} expected",
        list.len()
    )))
}
