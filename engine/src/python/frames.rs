//! Frames that the engine keeps while it steps, and hands out many at a time.

use numpy::{Element, IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::tables::{
    body_columns, contact_columns, energy_columns, event_columns, joint_columns, momentum_columns,
    spring_columns,
};
use crate::world::frames::{Choice, Frames, Summary};

/// Readings of frames that follow each other; `World.record` adds to them. `bodies`: indices, all when None;
/// `joints`: so many from the first on.
#[pyclass(name = "Frames", module = "physsim._engine")]
pub(super) struct PyFrames {
    pub(super) frames: Frames,
}

#[pymethods]
impl PyFrames {
    #[new]
    #[pyo3(signature = (*, bodies = None, momentum = false, energy = false, contacts = false, joints = 0, springs = false))]
    fn new(
        bodies: Option<Vec<usize>>,
        momentum: bool,
        energy: bool,
        contacts: bool,
        joints: usize,
        springs: bool,
    ) -> Self {
        let choice = Choice {
            bodies,
            momentum,
            energy,
            contacts,
            joints,
            springs,
        };
        Self {
            frames: Frames::new(choice),
        }
    }

    fn __len__(&self) -> usize {
        self.frames.summaries.len()
    }

    #[allow(clippy::cast_possible_wrap)] // steps are few
    /// Everything so far, in groups of arrays, time first; then there are no frames in here.
    fn take<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let choice = self.frames.choice().clone();
        let frames = self.frames.take();
        let all = frames.summaries.as_slice();
        let count = all.len();
        let out = PyDict::new(py);
        out.set_item("step", column(py, all, |s| s.step as i64))?;
        out.set_item("solver", solver(py, all)?)?;
        out.set_item("bodies", body_columns(py, frames.bodies, count)?)?;
        out.set_item("events", event_columns(py, &frames.events)?)?;
        if choice.momentum {
            let momenta = all.iter().filter_map(|s| s.momentum).collect::<Vec<_>>();
            out.set_item("momentum", momentum_columns(py, &momenta)?)?;
        }
        if choice.energy {
            let energies = all.iter().filter_map(|s| s.energies).collect::<Vec<_>>();
            out.set_item("energy", energy_columns(py, &energies)?)?;
        }
        if choice.contacts {
            out.set_item("contacts", contact_columns(py, frames.contacts)?)?;
        }
        if choice.joints > 0 {
            out.set_item("joints", joint_columns(py, frames.joints, count)?)?;
        }
        if choice.springs {
            out.set_item("springs", spring_columns(py, &frames.springs, count)?)?;
        }
        Ok(out)
    }
}

/// One number of each frame.
fn column<'py, T: Element>(
    py: Python<'py>,
    all: &[Summary],
    pick: fn(&Summary) -> T,
) -> Bound<'py, PyArray1<T>> {
    all.iter().map(pick).collect::<Vec<T>>().into_pyarray(py)
}

#[allow(clippy::cast_possible_wrap)] // counts are small
fn solver<'py>(py: Python<'py>, all: &[Summary]) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("residual", column(py, all, |s| s.residual))?;
    out.set_item("iterations", column(py, all, |s| s.iterations as i64))?;
    out.set_item("contact_count", column(py, all, |s| s.contacts as i64))?;
    out.set_item("fallbacks", column(py, all, |s| s.fallbacks as i64))?;
    Ok(out)
}
