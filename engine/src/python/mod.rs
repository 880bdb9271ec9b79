//! The border to Python: plain arrays in, plain arrays out, and nothing else.

mod answers;
mod forces;
mod input;
mod joints;
mod model;
mod picture;
mod tables;

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::time::{Duration, Instant};

use glam::{DMat3, DQuat, DVec3};
use numpy::IntoPyArray;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::collide::{Detector, Job};
use crate::shape::Pose;
use crate::world::{Failure, World};
use answers::Callback;
use input::quaternion;
use tables::{contact_table, table};

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

fn wxyz(q: DQuat) -> [f64; 4] {
    [q.w, q.x, q.y, q.z]
}

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
        let model = model::read_model(model)?;
        Ok(Self {
            world: guarded(|| World::new(model))?,
        })
    }

    /// Make `steps` steps. Signals are looked for every 50 ms; a pending one raises between two steps.
    #[pyo3(signature = (steps, answer = None))]
    fn advance(&mut self, py: Python<'_>, steps: u64, answer: Option<Py<PyAny>>) -> PyResult<()> {
        let mut callback = Callback(answer, None);
        let mut left = steps;
        while left > 0 {
            let (world, oracle) = (&mut self.world, &mut callback);
            let (made, result) =
                py.detach(move || guarded(move || run_for(world, left, oracle)))?;
            left -= made;
            if let Err(error) = result {
                return Err(failure(error, callback));
            }
            py.check_signals()?;
        }
        Ok(())
    }

    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let bodies = self.world.bodies();
        let out = PyDict::new(py);
        out.set_item(
            "position",
            table(py, bodies.iter().map(|b| b.state.position.to_array()))?,
        )?;
        out.set_item(
            "orientation",
            table(py, bodies.iter().map(|b| wxyz(b.state.orientation)))?,
        )?;
        out.set_item(
            "velocity",
            table(py, bodies.iter().map(|b| b.state.velocity.to_array()))?,
        )?;
        out.set_item(
            "angular_velocity",
            table(py, bodies.iter().map(|b| b.angular_velocity.to_array()))?,
        )?;
        out.set_item("step", self.world.steps())?;
        Ok(out)
    }

    /// Contact points of the last step.
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        contact_table(py, self.world.contacts())
    }

    /// Impacts since the last call.
    fn events<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let events = self.world.take_events();
        let out = PyDict::new(py);
        let column = |f: fn(&crate::impact::Event) -> f64| {
            events.iter().map(f).collect::<Vec<f64>>().into_pyarray(py)
        };
        #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
        let ids = |f: fn(&crate::impact::Event) -> usize| {
            events
                .iter()
                .map(|e| f(e) as i32)
                .collect::<Vec<i32>>()
                .into_pyarray(py)
        };
        out.set_item("time", column(|e| e.time))?;
        out.set_item("body_a", ids(|e| e.bodies.0))?;
        out.set_item("body_b", ids(|e| e.bodies.1))?;
        out.set_item(
            "position",
            table(py, events.iter().map(|e| e.position.to_array()))?,
        )?;
        out.set_item(
            "normal",
            table(py, events.iter().map(|e| e.normal.to_array()))?,
        )?;
        out.set_item("speed_before", column(|e| e.speed_before))?;
        out.set_item("speed_after", column(|e| e.speed_after))?;
        out.set_item("impulse", column(|e| e.impulse))?;
        out.set_item("restitution_declared", column(|e| e.restitution))?;
        out.set_item(
            "restitution_measured",
            column(|e| e.speed_after / e.speed_before),
        )?;
        Ok(out)
    }

    fn energies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let e = self.world.energies();
        let out = PyDict::new(py);
        for (name, value) in [
            ("kinetic_translational", e.kinetic_translational),
            ("kinetic_rotational", e.kinetic_rotational),
            ("gravitational", e.potential.gravitational),
            ("gravitation", e.potential.gravitation),
            ("spring", e.potential.spring),
            ("work_forces", e.ledger.work_forces),
            ("work_motors", e.ledger.work_motors),
            ("lost_damping", e.ledger.lost_damping),
            ("lost_friction", e.ledger.lost_friction),
            ("lost_impact", e.ledger.lost_impact),
            ("stabilization", e.ledger.stabilization),
            ("residual", e.residual()),
        ] {
            out.set_item(name, value + 0.0)?; // the sum of nothing is -0
        }
        Ok(out)
    }

    /// Of all that moves: linear momentum, and angular momentum about the world's origin.
    fn momentum<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (linear, angular) = self.world.momentum();
        let out = PyDict::new(py);
        for (name, value) in [("linear", linear), ("angular", angular)] {
            out.set_item(name, value.to_array().to_vec().into_pyarray(py))?;
        }
        Ok(out)
    }

    /// Loads, coordinates and errors of joints at this instant.
    fn joints<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let loads = guarded(|| self.world.joint_loads())?;
        tables::joint_table(py, &self.world, &loads)
    }

    /// Lengths and tensions of springs, angles and torques of torsional ones.
    fn springs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (lengths, forces): (Vec<f64>, Vec<f64>) = self.world.springs().unzip();
        let out = PyDict::new(py);
        out.set_item("length", lengths.into_pyarray(py))?;
        out.set_item("force", forces.into_pyarray(py))?;
        Ok(out)
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
            Ok(contacts) => contact_table(py, &contacts),
            Err(error) => Err(failure(error, callback)),
        }
    }

    /// True when FCL must answer some pair of this scene.
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
        let points = || detector.found.iter().map(|f| &f.point);
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

/// Steps until `left` are made or it is time to look for signals.
fn run_for(world: &mut World, left: u64, oracle: &mut Callback) -> (u64, Result<(), Failure>) {
    let start = Instant::now();
    let mut made = 0;
    while made < left {
        if let Err(error) = world.step(oracle) {
            return (made, Err(error));
        }
        made += 1;
        if start.elapsed() > SIGNAL_INTERVAL {
            break;
        }
    }
    (made, Ok(()))
}

#[pymodule]
fn _engine(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add_class::<PyWorld>()?;
    m.add_function(wrap_pyfunction!(picture::draw, m)?)?;
    m.add("Diverged", m.py().get_type::<Diverged>())?;
    m.add("EngineError", m.py().get_type::<EngineError>())?;
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    Ok(())
}
