//! FCL's answers, from Python.

use glam::{DQuat, DVec3};
use numpy::{IntoPyArray, PyArray2, PyReadonlyArrayDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::input::{floats, same_length};
use super::tables::table;
use crate::collide::{Answer, Oracle, Query};
use crate::shape::Pose;

/// FCL behind a Python callable.
pub(super) struct Callback(pub(super) Option<Py<PyAny>>, pub(super) Option<PyErr>);

impl Callback {
    fn call(&self, queries: &[Query], answers: &mut Vec<Option<Answer>>) -> PyResult<()> {
        let Some(function) = &self.0 else {
            return Err(PyValueError::new_err(
                "a pair of shapes needs FCL, but no FCL callback was given",
            ));
        };
        Python::attach(|py| {
            let ids = |pick: fn(&Query) -> i32| -> Vec<i32> { queries.iter().map(pick).collect() };
            #[allow(clippy::cast_possible_wrap)]
            let result = function.call1(
                py,
                (
                    ids(|q| q.geoms.0 as i32).into_pyarray(py),
                    ids(|q| q.geoms.1 as i32).into_pyarray(py),
                    ids(|q| q.triangles.0).into_pyarray(py),
                    ids(|q| q.triangles.1).into_pyarray(py),
                    poses(py, queries.iter().map(|q| &q.poses.0))?,
                    poses(py, queries.iter().map(|q| &q.poses.1))?,
                    queries
                        .iter()
                        .map(|q| q.margin)
                        .collect::<Vec<_>>()
                        .into_pyarray(py),
                ),
            )?;
            read_answers(result.bind(py), queries.len(), answers)
        })
    }
}

fn poses<'py, 'a>(
    py: Python<'py>,
    list: impl Iterator<Item = &'a Pose>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let row = |p: &Pose| -> [f64; 7] {
        let q = DQuat::from_mat3(&p.rotation);
        let x = p.position;
        [x.x, x.y, x.z, q.w, q.x, q.y, q.z]
    };
    table(py, list.map(row))
}

fn read_answers(
    result: &Bound<'_, PyAny>,
    count: usize,
    answers: &mut Vec<Option<Answer>>,
) -> PyResult<()> {
    let (found, normal, depth, position): (
        Bound<'_, PyAny>,
        Bound<'_, PyAny>,
        Bound<'_, PyAny>,
        Bound<'_, PyAny>,
    ) = result.extract()?;
    let found: Vec<bool> = {
        let array: PyReadonlyArrayDyn<'_, bool> = found.extract()?;
        array.as_array().iter().copied().collect()
    };
    let (normal, depth, position) = (
        floats(&normal, "normal", 3)?,
        floats(&depth, "depth", 1)?,
        floats(&position, "position", 3)?,
    );
    same_length("found", &found, count)?;
    same_length("normal", &normal, 3 * count)?;
    same_length("depth", &depth, count)?;
    same_length("position", &position, 3 * count)?;
    answers.extend((0..count).map(|k| {
        found[k].then(|| Answer {
            normal: DVec3::from_slice(&normal[3 * k..]),
            depth: depth[k],
            position: DVec3::from_slice(&position[3 * k..]),
        })
    }));
    Ok(())
}

impl Oracle for Callback {
    fn ask(&mut self, queries: &[Query], answers: &mut Vec<Option<Answer>>) -> Result<(), String> {
        self.call(queries, answers).map_err(|error| {
            let text = error.to_string();
            self.1 = Some(error);
            text
        })
    }
}
