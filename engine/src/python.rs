//! The border to Python: plain arrays in, plain arrays out, and nothing else.

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::{DMat3, DQuat, DVec3};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

use crate::body::{MassProperties, State};
use crate::collide::{Answer, Detector, Job, Oracle, Query};
use crate::contact::Contact;
use crate::model::{Coefficients, Geom, Model, PairTable, Settings, Stabilization};
use crate::shape::{Hull, Pose, Shape, TriangleMesh};
use crate::world::{Failure, World};

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

/// Reads values of the border dictionary by name.
struct Input<'py>(&'py Bound<'py, PyDict>);

impl<'py> Input<'py> {
    fn item(&self, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.0
            .get_item(name)?
            .ok_or_else(|| PyValueError::new_err(format!("{name} is missing")))
    }

    fn float(&self, name: &str) -> PyResult<f64> {
        let value: f64 = self.item(name)?.extract()?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(PyValueError::new_err(format!(
                "{name} must be finite, got {value}"
            )))
        }
    }

    fn text(&self, name: &str) -> PyResult<String> {
        self.item(name)?.extract()
    }

    /// A float64 array whose shape, after the first axis, multiplies to `width`.
    fn floats(&self, name: &str, width: usize) -> PyResult<Vec<f64>> {
        floats(&self.item(name)?, name, width)
    }

    fn vectors(&self, name: &str) -> PyResult<Vec<DVec3>> {
        Ok(self
            .floats(name, 3)?
            .chunks_exact(3)
            .map(DVec3::from_slice)
            .collect())
    }

    fn rotations(&self, name: &str) -> PyResult<Vec<DQuat>> {
        Ok(self
            .floats(name, 4)?
            .chunks_exact(4)
            .map(quaternion)
            .collect())
    }

    fn integers(&self, name: &str, width: usize) -> PyResult<Vec<i32>> {
        integers(&self.item(name)?, name, width)
    }

    fn list(&self, name: &str) -> PyResult<Bound<'py, PyList>> {
        Ok(self.item(name)?.cast_into::<PyList>()?)
    }
}

fn floats(value: &Bound<'_, PyAny>, name: &str, width: usize) -> PyResult<Vec<f64>> {
    let array: PyReadonlyArrayDyn<'_, f64> = value
        .extract()
        .map_err(|_| PyValueError::new_err(format!("{name} must be a float64 array")))?;
    check_width(name, array.shape(), width)?;
    Ok(array.as_array().iter().copied().collect())
}

fn integers(value: &Bound<'_, PyAny>, name: &str, width: usize) -> PyResult<Vec<i32>> {
    let array: PyReadonlyArrayDyn<'_, i32> = value
        .extract()
        .map_err(|_| PyValueError::new_err(format!("{name} must be an int32 array")))?;
    check_width(name, array.shape(), width)?;
    Ok(array.as_array().iter().copied().collect())
}

fn check_width(name: &str, shape: &[usize], width: usize) -> PyResult<()> {
    let inner: usize = shape.iter().skip(1).product();
    if shape.is_empty() || inner != width {
        return Err(PyValueError::new_err(format!(
            "{name} has the wrong shape {shape:?}"
        )));
    }
    Ok(())
}

fn quaternion(wxyz: &[f64]) -> DQuat {
    let q = DQuat::from_xyzw(wxyz[1], wxyz[2], wxyz[3], wxyz[0]);
    if q.length_squared() > 0.0 {
        q.normalize()
    } else {
        DQuat::IDENTITY
    }
}

fn wxyz(q: DQuat) -> [f64; 4] {
    [q.w, q.x, q.y, q.z]
}

/// An index of the dictionary, checked against the length of what it points into.
fn index(value: i32, length: usize, name: &str) -> PyResult<usize> {
    usize::try_from(value)
        .ok()
        .filter(|&k| k < length)
        .ok_or_else(|| {
            PyValueError::new_err(format!(
                "{name} has the index {value}, allowed are 0 to {length} - 1"
            ))
        })
}

fn same_length<T>(name: &str, list: &[T], length: usize) -> PyResult<()> {
    if list.len() == length {
        return Ok(());
    }
    Err(PyValueError::new_err(format!(
        "{name} has {} entries, {length} expected",
        list.len()
    )))
}

fn read_settings(input: &Input<'_>) -> PyResult<Settings> {
    let gravity = input.floats("gravity", 1)?;
    same_length("gravity", &gravity, 3)?;
    for (name, known) in [
        ("integrator", "semi_implicit_euler"),
        ("impacts", "stepped"),
    ] {
        let given = input.text(name)?;
        if given != known {
            return Err(PyValueError::new_err(format!(
                "{name} {given} is not supported yet"
            )));
        }
    }
    let stabilization = match input.text("stabilization")?.as_str() {
        "split_impulse" => Stabilization::SplitImpulse,
        "baumgarte" => Stabilization::Baumgarte,
        other => {
            return Err(PyValueError::new_err(format!(
                "unknown stabilization {other}"
            )))
        }
    };
    let fcl_only = match input.text("collision")?.as_str() {
        "auto" => false,
        "fcl" => true,
        other => return Err(PyValueError::new_err(format!("unknown collision {other}"))),
    };
    let timestep = input.float("timestep")?;
    if timestep <= 0.0 {
        return Err(PyValueError::new_err("timestep must be greater than 0"));
    }
    Ok(Settings {
        gravity: DVec3::from_slice(&gravity),
        timestep,
        iterations: input.item("iterations")?.extract()?,
        tolerance: input.float("tolerance")?,
        stabilization,
        baumgarte: input.float("baumgarte")?,
        slip_speed: input.float("slip_speed")?,
        bounce_speed: input.float("bounce_speed")?,
        fcl_only,
    })
}

fn read_bodies(input: &Input<'_>) -> PyResult<Vec<(MassProperties, State, DVec3)>> {
    let fixed = input.integers("fixed", 1)?;
    let mass = input.floats("mass", 1)?;
    let inertia = input.floats("inertia", 9)?;
    let position = input.vectors("position")?;
    let orientation = input.rotations("orientation")?;
    let velocity = input.vectors("velocity")?;
    let omega = input.vectors("angular_velocity")?;
    let count = fixed.len();
    same_length("mass", &mass, count)?;
    same_length("inertia", &inertia, 9 * count)?;
    same_length("orientation", &orientation, count)?;
    for (name, list) in [
        ("position", &position),
        ("velocity", &velocity),
        ("angular_velocity", &omega),
    ] {
        same_length(name, list, count)?;
    }
    (0..count)
        .map(|k| {
            let properties = if fixed[k] != 0 {
                MassProperties::fixed()
            } else if mass[k] > 0.0 && mass[k].is_finite() {
                // Symmetric: rows are columns.
                MassProperties::new(mass[k], DMat3::from_cols_slice(&inertia[9 * k..9 * k + 9]))
            } else {
                return Err(PyValueError::new_err(format!(
                    "mass of body {k} must be positive, got {}",
                    mass[k]
                )));
            };
            let state = State {
                position: position[k],
                orientation: orientation[k],
                velocity: if fixed[k] == 0 {
                    velocity[k]
                } else {
                    DVec3::ZERO
                },
                angular_momentum: DVec3::ZERO,
            };
            Ok((
                properties,
                state,
                if fixed[k] == 0 { omega[k] } else { DVec3::ZERO },
            ))
        })
        .collect()
}

fn read_hulls(input: &Input<'_>) -> PyResult<Vec<Arc<Hull>>> {
    let vertices = input.list("hull_vertices")?;
    let faces = input.list("hull_faces")?;
    same_length("hull_faces", &vec![(); faces.len()], vertices.len())?;
    vertices
        .iter()
        .zip(faces.iter())
        .map(|(v, f)| {
            let points: Vec<DVec3> = floats(&v, "hull_vertices", 3)?
                .chunks_exact(3)
                .map(DVec3::from_slice)
                .collect();
            let polygons: Vec<Vec<u32>> = f.extract()?;
            Hull::new(points, &polygons)
                .map(Arc::new)
                .map_err(PyValueError::new_err)
        })
        .collect()
}

fn read_meshes(input: &Input<'_>) -> PyResult<Vec<Arc<TriangleMesh>>> {
    let vertices = input.list("mesh_vertices")?;
    let triangles = input.list("mesh_triangles")?;
    same_length("mesh_triangles", &vec![(); triangles.len()], vertices.len())?;
    vertices
        .iter()
        .zip(triangles.iter())
        .map(|(v, t)| {
            let points: Vec<DVec3> = floats(&v, "mesh_vertices", 3)?
                .chunks_exact(3)
                .map(DVec3::from_slice)
                .collect();
            let corners = integers(&t, "mesh_triangles", 3)?
                .chunks_exact(3)
                .map(|c| {
                    let at =
                        |k: usize| index(c[k], points.len(), "mesh_triangles").map(|i| i as u32);
                    Ok([at(0)?, at(1)?, at(2)?])
                })
                .collect::<PyResult<Vec<[u32; 3]>>>()?;
            TriangleMesh::new(points, corners)
                .map(Arc::new)
                .map_err(PyValueError::new_err)
        })
        .collect()
}

/// Kind numbers of the border; a new shape adds a number here and a variant in `shape.rs`.
fn read_shape(
    kind: i32,
    p: &[f64],
    hulls: &[Arc<Hull>],
    meshes: &[Arc<TriangleMesh>],
) -> PyResult<Shape> {
    #[allow(clippy::cast_possible_truncation)]
    let listed = p[0] as i32;
    Ok(match kind {
        0 => Shape::Sphere { radius: p[0] },
        1 => Shape::Capsule {
            radius: p[0],
            half_height: p[1],
        },
        2 => Shape::Box {
            half: DVec3::new(p[0], p[1], p[2]),
        },
        3 => Shape::Cylinder {
            radius: p[0],
            half_height: p[1],
        },
        4 => Shape::Cone {
            radius: p[0],
            height: p[1],
        },
        5 => Shape::Ellipsoid {
            radii: DVec3::new(p[0], p[1], p[2]),
        },
        6 => Shape::Rod { half_length: p[0] },
        7 => Shape::Hull(hulls[index(listed, hulls.len(), "geom_parameters (hull)")?].clone()),
        8 => Shape::HalfSpace,
        9 => Shape::Mesh(meshes[index(listed, meshes.len(), "geom_parameters (mesh)")?].clone()),
        other => return Err(PyValueError::new_err(format!("unknown geom_kind {other}"))),
    })
}

fn read_geoms(input: &Input<'_>, bodies: usize, materials: usize) -> PyResult<Vec<Geom>> {
    let (hulls, meshes) = (read_hulls(input)?, read_meshes(input)?);
    let body = input.integers("geom_body", 1)?;
    let kind = input.integers("geom_kind", 1)?;
    let parameters = input.floats("geom_parameters", 4)?;
    let position = input.vectors("geom_position")?;
    let orientation = input.rotations("geom_orientation")?;
    let material = input.integers("geom_material", 1)?;
    let count = body.len();
    same_length("geom_kind", &kind, count)?;
    same_length("geom_parameters", &parameters, 4 * count)?;
    same_length("geom_position", &position, count)?;
    same_length("geom_orientation", &orientation, count)?;
    same_length("geom_material", &material, count)?;
    (0..count)
        .map(|k| {
            Ok(Geom {
                body: index(body[k], bodies, "geom_body")?,
                shape: read_shape(kind[k], &parameters[4 * k..4 * k + 4], &hulls, &meshes)?,
                position: position[k],
                rotation: DMat3::from_quat(orientation[k]),
                material: index(material[k], materials, "geom_material")?,
            })
        })
        .collect()
}

fn read_pairs(input: &Input<'_>) -> PyResult<PairTable> {
    let array: PyReadonlyArrayDyn<'_, f64> = input.item("restitution")?.extract()?;
    let count = array.shape().first().copied().unwrap_or(0);
    let restitution = input.floats("restitution", count)?;
    let static_friction = input.floats("static_friction", count)?;
    let kinetic_friction = input.floats("kinetic_friction", count)?;
    same_length("static_friction", &static_friction, count * count)?;
    same_length("kinetic_friction", &kinetic_friction, count * count)?;
    let entries = (0..count * count)
        .map(|k| Coefficients {
            restitution: restitution[k],
            static_friction: static_friction[k],
            kinetic_friction: kinetic_friction[k],
        })
        .collect();
    Ok(PairTable::new(count, entries))
}

fn read_model(dictionary: &Bound<'_, PyDict>) -> PyResult<Model> {
    let input = Input(dictionary);
    let bodies = read_bodies(&input)?;
    let pairs = read_pairs(&input)?;
    let no_contact = input
        .integers("no_contact", 2)?
        .chunks_exact(2)
        .map(|p| {
            Ok((
                index(p[0], bodies.len(), "no_contact")?,
                index(p[1], bodies.len(), "no_contact")?,
            ))
        })
        .collect::<PyResult<_>>()?;
    Ok(Model {
        settings: read_settings(&input)?,
        geoms: read_geoms(&input, bodies.len(), pairs.len())?,
        bodies,
        pairs,
        no_contact,
    })
}

/// FCL behind a Python callable.
struct Callback(Option<Py<PyAny>>, Option<PyErr>);

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

/// Rows to an (n, K) array.
fn table<'py, const K: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; K]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat: Vec<f64> = rows.flatten().collect();
    let count = flat.len() / K;
    PyArray1::from_vec(py, flat).reshape([count, K])
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

/// The world of a scene; see `World` in `world.rs`.
#[pyclass(name = "World", module = "physsim._engine")]
struct PyWorld {
    world: World,
}

#[pymethods]
impl PyWorld {
    #[new]
    fn new(model: &Bound<'_, PyDict>) -> PyResult<Self> {
        let model = read_model(model)?;
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
            ("gravitational", e.gravitational),
            ("spring", 0.0),
            ("work_forces", 0.0),
            ("work_motors", 0.0),
            ("lost_damping", 0.0),
            ("lost_friction", e.ledger.lost_friction),
            ("lost_impact", e.ledger.lost_impact),
            ("stabilization", e.ledger.stabilization),
            ("residual", e.residual()),
        ] {
            out.set_item(name, value)?;
        }
        Ok(out)
    }

    fn solver<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let report = self.world.report();
        let out = PyDict::new(py);
        out.set_item("residual", report.residual)?;
        out.set_item("iterations", report.iterations)?;
        out.set_item("contact_count", self.world.contacts().len())?;
        out.set_item("rest_time", self.world.rest_time())?;
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

fn contact_table<'py>(py: Python<'py>, contacts: &[Contact]) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    let vectors =
        |f: fn(&Contact) -> DVec3| table(py, contacts.iter().map(move |c| f(c).to_array()));
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
    let ids = |f: fn(&Contact) -> usize| {
        contacts
            .iter()
            .map(|c| f(c) as i32)
            .collect::<Vec<i32>>()
            .into_pyarray(py)
    };
    let numbers = |f: fn(&Contact) -> f64| {
        contacts
            .iter()
            .map(f)
            .collect::<Vec<f64>>()
            .into_pyarray(py)
    };
    out.set_item("body_a", ids(|c| c.bodies.0))?;
    out.set_item("body_b", ids(|c| c.bodies.1))?;
    out.set_item("geom_a", ids(|c| c.geoms.0 as usize))?;
    out.set_item("geom_b", ids(|c| c.geoms.1 as usize))?;
    out.set_item("material_a", ids(|c| c.materials.0))?;
    out.set_item("material_b", ids(|c| c.materials.1))?;
    out.set_item("position", vectors(|c| c.position)?)?;
    out.set_item("normal", vectors(|c| c.normal)?)?;
    out.set_item("depth", numbers(|c| -c.gap))?;
    out.set_item(
        "normal_impulse",
        numbers(|c| c.impulse.x + c.impact_impulse.dot(c.normal)),
    )?;
    out.set_item("tangential_impulse", vectors(Contact::tangential_impulse)?)?;
    out.set_item("velocity_before", vectors(|c| c.velocity_before)?)?;
    out.set_item("velocity_after", vectors(|c| c.velocity_after)?)?;
    out.set_item("sliding", ids(|c| usize::from(c.sliding)))?;
    Ok(out)
}

#[pymodule]
fn _engine(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add_class::<PyWorld>()?;
    m.add("Diverged", m.py().get_type::<Diverged>())?;
    m.add("EngineError", m.py().get_type::<EngineError>())?;
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    Ok(())
}
