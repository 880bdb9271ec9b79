//! What the engine hands out, as arrays.

use glam::DVec3;
use numpy::{Element, IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::contact::Contact;
use crate::impact::Event;
use crate::ledger::Energies;
use crate::world::frames::{BodyRows, ContactRows, JointRows};
use crate::world::World;

/// Rows to an (n, K) array.
pub(super) fn table<'py, const K: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; K]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    flat(py, rows.collect())
}

/// The same, of rows that are handed over as they are.
fn flat<const K: usize>(py: Python<'_>, rows: Vec<[f64; K]>) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len();
    PyArray1::from_vec(py, rows.into_flattened()).reshape([count, K])
}

/// The same to (frames, n, K).
fn cube<const K: usize>(
    py: Python<'_>,
    rows: Vec<[f64; K]>,
    frames: usize,
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let each = rows.len() / frames.max(1);
    PyArray1::from_vec(py, rows.into_flattened()).reshape([frames, each, K])
}

/// Numbers to a (frames, n) array.
fn sheet<T: Element>(
    py: Python<'_>,
    numbers: Vec<T>,
    frames: usize,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let each = numbers.len() / frames.max(1);
    PyArray1::from_vec(py, numbers).reshape([frames, each])
}

/// The only row of each column.
pub(super) fn first_row(columns: Bound<'_, PyDict>) -> PyResult<Bound<'_, PyDict>> {
    for (name, rows) in columns.iter() {
        columns.set_item(name, rows.get_item(0)?)?;
    }
    Ok(columns)
}

/// States of bodies over frames.
pub(super) fn body_columns(
    py: Python<'_>,
    rows: BodyRows,
    frames: usize,
) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("position", cube(py, rows.position, frames)?)?;
    out.set_item("orientation", cube(py, rows.orientation, frames)?)?;
    out.set_item("velocity", cube(py, rows.velocity, frames)?)?;
    out.set_item("angular_velocity", cube(py, rows.angular_velocity, frames)?)?;
    Ok(out)
}

/// Contact points, one after the other.
pub(super) fn contact_columns(py: Python<'_>, rows: ContactRows) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("body_a", rows.body_a.into_pyarray(py))?;
    out.set_item("body_b", rows.body_b.into_pyarray(py))?;
    out.set_item("position", flat(py, rows.position)?)?;
    out.set_item("normal", flat(py, rows.normal)?)?;
    out.set_item("depth", rows.depth.into_pyarray(py))?;
    out.set_item("impulse", flat(py, rows.impulse)?)?;
    out.set_item("normal_impulse", rows.normal_impulse.into_pyarray(py))?;
    out.set_item("tangential_impulse", flat(py, rows.tangential_impulse)?)?;
    out.set_item("force", flat(py, rows.force)?)?;
    out.set_item("velocity_before", flat(py, rows.velocity_before)?)?;
    out.set_item("velocity_after", flat(py, rows.velocity_after)?)?;
    out.set_item("pair", rows.pair.into_pyarray(py))?;
    out.set_item("sliding", rows.sliding.into_pyarray(py))?;
    Ok(out)
}

/// The contact points of one step, and which geoms and materials meet in them.
pub(super) fn contact_table<'py>(
    py: Python<'py>,
    contacts: &[Contact],
    world: &World,
) -> PyResult<Bound<'py, PyDict>> {
    let mut rows = ContactRows::default();
    rows.extend(contacts, world);
    let out = contact_columns(py, rows)?;
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
    let ids = |f: &dyn Fn(&Contact) -> usize| {
        let numbers = contacts.iter().map(|c| f(c) as i32);
        numbers.collect::<Vec<i32>>().into_pyarray(py)
    };
    out.set_item("geom_a", ids(&|c| c.geoms.0 as usize))?;
    out.set_item("geom_b", ids(&|c| c.geoms.1 as usize))?;
    out.set_item("material_a", ids(&|c| world.materials_of(c).0))?;
    out.set_item("material_b", ids(&|c| world.materials_of(c).1))?;
    Ok(out)
}

/// Impacts, one after the other.
pub(super) fn event_columns<'py>(
    py: Python<'py>,
    events: &[Event],
) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    let column = |f: fn(&Event) -> f64| events.iter().map(f).collect::<Vec<f64>>().into_pyarray(py);
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
    let ids = |f: fn(&Event) -> usize| {
        let numbers = events.iter().map(|e| f(e) as i32);
        numbers.collect::<Vec<i32>>().into_pyarray(py)
    };
    let position = events.iter().map(|e| e.position.to_array());
    let normal = events.iter().map(|e| e.normal.to_array());
    out.set_item("time", column(|e| e.time))?;
    out.set_item("body_a", ids(|e| e.bodies.0))?;
    out.set_item("body_b", ids(|e| e.bodies.1))?;
    out.set_item("position", table(py, position)?)?;
    out.set_item("normal", table(py, normal)?)?;
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

type Pick = fn(&Energies) -> f64;

/// Energies over frames.
pub(super) fn energy_columns<'py>(
    py: Python<'py>,
    energies: &[Energies],
) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    let picks: [(&str, Pick); 12] = [
        ("kinetic_translational", |e| e.kinetic_translational),
        ("kinetic_rotational", |e| e.kinetic_rotational),
        ("gravitational", |e| e.potential.gravitational),
        ("gravitation", |e| e.potential.gravitation),
        ("spring", |e| e.potential.spring),
        ("work_forces", |e| e.ledger.work_forces),
        ("work_motors", |e| e.ledger.work_motors),
        ("lost_damping", |e| e.ledger.lost_damping),
        ("lost_friction", |e| e.ledger.lost_friction),
        ("lost_impact", |e| e.ledger.lost_impact),
        ("stabilization", |e| e.ledger.stabilization),
        ("residual", Energies::residual),
    ];
    for (name, pick) in picks {
        let values = energies.iter().map(|e| pick(e) + 0.0); // the sum of nothing is -0
        out.set_item(name, values.collect::<Vec<f64>>().into_pyarray(py))?;
    }
    Ok(out)
}

/// Linear and angular momenta over frames.
pub(super) fn momentum_columns<'py>(
    py: Python<'py>,
    momenta: &[(DVec3, DVec3)],
) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    let linear = momenta.iter().map(|m| m.0.to_array());
    let angular = momenta.iter().map(|m| m.1.to_array());
    out.set_item("linear", table(py, linear)?)?;
    out.set_item("angular", table(py, angular)?)?;
    Ok(out)
}

/// Springs over frames.
pub(super) fn spring_columns<'py>(
    py: Python<'py>,
    readings: &[(f64, f64)],
    frames: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    let (lengths, forces) = readings.iter().copied().unzip();
    out.set_item("length", sheet::<f64>(py, lengths, frames)?)?;
    out.set_item("force", sheet::<f64>(py, forces, frames)?)?;
    Ok(out)
}

/// Joints over frames.
pub(super) fn joint_columns(
    py: Python<'_>,
    rows: JointRows,
    frames: usize,
) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("force", cube(py, rows.force, frames)?)?;
    out.set_item("torque", cube(py, rows.torque, frames)?)?;
    for (name, values) in ["coordinate", "coordinate_2", "coordinate_3"]
        .into_iter()
        .zip(rows.coordinates)
    {
        out.set_item(name, sheet(py, values, frames)?)?;
    }
    out.set_item("violation", sheet(py, rows.violation, frames)?)?;
    out.set_item(
        "angular_violation",
        sheet(py, rows.angular_violation, frames)?,
    )?;
    out.set_item("broken", sheet(py, rows.broken, frames)?)?;
    Ok(out)
}
