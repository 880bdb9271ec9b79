//! The border to Python: plain arrays in, plain arrays out, and nothing else.

mod answers;
mod forces;
mod frames;
mod input;
mod joints;
mod model;
mod picture;
mod shuffle;
mod tables;

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::time::{Duration, Instant};

use glam::{DMat3, DVec3};
use numpy::IntoPyArray;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::collide::{Detector, Job};
use crate::shape::Pose;
use crate::world::frames::{BodyRows, JointRows, Plan};
use crate::world::{Failure, World};
use answers::Callback;
use frames::PyFrames;
use input::quaternion;
use tables::{
    body_columns, contact_table, energy_columns, event_columns, first_row, joint_columns,
    momentum_columns, spring_columns, table,
};

create_exception!(
    _engine,
    Diverged,
    PyException,
    "A body's state blew up: (index of the body, time)."
);
create_exception!(
    _engine,
    EngineError,
    PyRuntimeError,
    "The engine failed; a defect of physsim."
);

/// How often a long `advance` looks for signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);

/// Run engine code so that a panic becomes a Python exception.
fn guarded<T>(f: impl FnOnce() -> T) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(f)).map_err(|cause| {
        let text = cause
            .downcast_ref::<&str>()
            .map(ToString::to_string)
            .or_else(|| cause.downcast_ref::<String>().cloned())
            .unwrap_or_else(|| "unknown cause".into());
        EngineError::new_err(format!("the engine failed: {text}"))
    })
}

fn failure(error: Failure, callback: Callback) -> PyErr {
    match error {
        Failure::Diverged { body, time } => Diverged::new_err((body, time)),
        Failure::Oracle(text) => callback.1.unwrap_or_else(|| PyRuntimeError::new_err(text)),
    }
}

/// The world of a scene; see `World` in `world/mod.rs`.
#[pyclass(name = "World", module = "physsim._engine")]
struct PyWorld {
    world: World,
}

#[pymethods]
impl PyWorld {
    #[new]
    fn new(model: &Bound<'_, PyDict>) -> PyResult<Self> {
        let threads = model::read_threads(model)?;
        let model = model::read_model(model)?;
        let mut world = guarded(|| World::new(model))?;
        world.set_threads(threads);
        Ok(Self { world })
    }

    /// Make `steps` steps. Signals are looked for every 50 ms; a pending one raises between two steps.
    #[pyo3(signature = (steps, answer = None))]
    fn advance(&mut self, py: Python<'_>, steps: u64, answer: Option<Py<PyAny>>) -> PyResult<()> {
        self.go(py, steps, answer, |_| true)
    }

    /// `advance`, but frames that are due are kept in `frames`: at steps that are multiples of `every`, and at step
    /// `last`. Stops after a frame in which everything has rested for `rest_time` [s]. Returns how many steps were made.
    #[pyo3(signature = (frames, steps, every, last, rest_time, answer = None))]
    #[allow(clippy::too_many_arguments)] // a Python signature
    fn record(
        &mut self,
        py: Python<'_>,
        frames: &mut PyFrames,
        steps: u64,
        every: u64,
        last: u64,
        rest_time: f64,
        answer: Option<Py<PyAny>>,
    ) -> PyResult<u64> {
        let plan = Plan {
            every: every.max(1),
            last,
            rest_time,
        };
        let kept = &mut frames.frames;
        let begun = self.world.steps();
        self.go(py, steps, answer, |world| plan.keep(world, kept))?;
        Ok(self.world.steps() - begun)
    }

    /// The present state as the next of the `frames`.
    fn keep(&mut self, frames: &mut PyFrames) -> PyResult<()> {
        guarded(|| frames.frames.keep(&mut self.world))
    }

    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut rows = BodyRows::default();
        self.world.bodies().iter().for_each(|b| rows.push(b));
        let out = first_row(body_columns(py, rows, 1)?)?;
        out.set_item("step", self.world.steps())?;
        Ok(out)
    }

    /// Contact points of the last step.
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        contact_table(py, self.world.contacts(), &self.world)
    }

    /// Impacts since the last call.
    fn events<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        event_columns(py, &self.world.take_events())
    }

    fn energies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        first_row(energy_columns(py, &[self.world.energies()])?)
    }

    /// Of all that moves: linear momentum, and angular momentum about the world's origin.
    fn momentum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        first_row(momentum_columns(py, &[self.world.momentum()])?)
    }

    /// Loads, coordinates and errors of joints at this instant.
    fn joints<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut rows = JointRows::default();
        guarded(|| rows.push(&mut self.world, usize::MAX))?;
        first_row(joint_columns(py, rows, 1)?)
    }

    /// Lengths and tensions of springs, angles and torques of torsional ones.
    fn springs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        first_row(spring_columns(
            py,
            &self.world.springs().collect::<Vec<_>>(),
            1,
        )?)
    }

    fn solver<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let report = self.world.report();
        let out = PyDict::new(py);
        out.set_item("residual", report.residual)?;
        out.set_item("iterations", report.iterations)?;
        out.set_item("contact_count", self.world.contacts().len())?;
        out.set_item("rest_time", self.world.rest_time())?;
        out.set_item("fallbacks", self.world.fallbacks())?;
        Ok(out)
    }

    /// Contact points nearer than `margin` in the present state.
    #[pyo3(signature = (margin, answer = None))]
    fn detect<'py>(
        &mut self,
        py: Python<'py>,
        margin: f64,
        answer: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let mut callback = Callback(answer, None);
        match guarded(|| self.world.detect(margin, &mut callback))? {
            Ok(contacts) => contact_table(py, &contacts, &self.world),
            Err(error) => Err(failure(error, callback)),
        }
    }

    /// True when FCL is to answer the pairs of this scene.
    fn needs_answer(&self) -> bool {
        self.world.needs_oracle()
    }

    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.world.save().map_err(PyRuntimeError::new_err)?;
        Ok(PyBytes::new(py, &bytes))
    }

    fn restore(&mut self, bytes: &[u8]) -> PyResult<()> {
        guarded(|| self.world.restore(bytes))?.map_err(PyValueError::new_err)
    }

    /// One pair of geoms at poses (x, y, z, w, x, y, z), apart from the scene.
    #[allow(clippy::too_many_arguments)] // a Python signature
    #[pyo3(signature = (geom_a, pose_a, geom_b, pose_b, margin, answer = None))]
    fn collide_pair<'py>(
        &self,
        py: Python<'py>,
        geom_a: usize,
        pose_a: [f64; 7],
        geom_b: usize,
        pose_b: [f64; 7],
        margin: f64,
        answer: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let geoms = self.world.geoms();
        if geom_a >= geoms.len() || geom_b >= geoms.len() {
            return Err(PyValueError::new_err("no such geom"));
        }
        let pose = |p: [f64; 7]| Pose {
            position: DVec3::from_slice(&p),
            rotation: DMat3::from_quat(quaternion(&p[3..])),
        };
        #[allow(clippy::cast_possible_truncation)]
        let job = Job {
            geoms: (geom_a as u32, geom_b as u32),
            poses: (pose(pose_a), pose(pose_b)),
            margin,
        };
        let fcl_only = answer.is_some();
        let mut callback = Callback(answer, None);
        let mut detector = Detector::default();
        if let Err(text) = guarded(|| detector.run(geoms, &[job], fcl_only, &mut callback))? {
            return Err(failure(Failure::Oracle(text), callback));
        }
        let out = PyDict::new(py);
        let points = || detector.found().map(|f| &f.point);
        out.set_item(
            "position",
            table(py, points().map(|p| p.position.to_array()))?,
        )?;
        out.set_item("normal", table(py, points().map(|p| p.normal.to_array()))?)?;
        out.set_item(
            "depth",
            points()
                .map(|p| p.depth)
                .collect::<Vec<_>>()
                .into_pyarray(py),
        )?;
        Ok(out)
    }
}

impl PyWorld {
    /// Steps until `steps` are made or `after` a step says no. Signals are looked for every 50 ms.
    fn go(
        &mut self,
        py: Python<'_>,
        steps: u64,
        answer: Option<Py<PyAny>>,
        mut after: impl FnMut(&mut World) -> bool + Send,
    ) -> PyResult<()> {
        let mut callback = Callback(answer, None);
        let mut left = steps;
        while left > 0 {
            let (world, oracle, then) = (&mut self.world, &mut callback, &mut after);
            let (made, result) = py.detach(|| {
                guarded(|| world.together(|world| run_for(world, left, oracle, then)))
            })?;
            left = if made.goes_on { left - made.steps } else { 0 };
            if let Err(error) = result {
                return Err(failure(error, callback));
            }
            py.check_signals()?;
        }
        Ok(())
    }
}

/// What `run_for` came to.
struct Made {
    steps: u64,
    goes_on: bool,
}

/// Steps until `left` are made, `after` a step says no, or it is time to look for signals.
fn run_for(
    world: &mut World,
    left: u64,
    oracle: &mut Callback,
    after: &mut impl FnMut(&mut World) -> bool,
) -> (Made, Result<(), Failure>) {
    let start = Instant::now();
    let mut made = Made {
        steps: 0,
        goes_on: true,
    };
    while made.steps < left && made.goes_on && start.elapsed() <= SIGNAL_INTERVAL {
        if let Err(error) = world.step(oracle) {
            return (made, Err(error));
        }
        made.steps += 1;
        made.goes_on = after(world);
    }
    (made, Ok(()))
}

#[pymodule]
fn _engine(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add_class::<PyWorld>()?;
    m.add_class::<PyFrames>()?;
    m.add_function(wrap_pyfunction!(picture::draw, m)?)?;
    m.add_function(wrap_pyfunction!(shuffle::shuffled, m)?)?;
    m.add("Diverged", m.py().get_type::<Diverged>())?;
    m.add("EngineError", m.py().get_type::<EngineError>())?;
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    Ok(())
}
