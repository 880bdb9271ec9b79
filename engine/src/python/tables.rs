//! What the engine hands out, as arrays.

use glam::DVec3;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::contact::Contact;
use crate::world::World;

/// Rows to an (n, K) array.
pub(super) fn table<'py, const K: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; K]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat = rows.collect::<Vec<_>>().into_flattened();
    let count = flat.len() / K;
    PyArray1::from_vec(py, flat).reshape([count, K])
}

pub(super) fn contact_table<'py>(
    py: Python<'py>,
    contacts: &[Contact],
) -> PyResult<Bound<'py, PyDict>> {
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

pub(super) fn joint_table<'py>(
    py: Python<'py>,
    world: &World,
    loads: &[(DVec3, DVec3)],
) -> PyResult<Bound<'py, PyDict>> {
    let (joints, bodies) = (world.joints(), world.all_bodies());
    let all = 0..loads.len();
    let numbers =
        |f: &dyn Fn(usize) -> f64| all.clone().map(f).collect::<Vec<f64>>().into_pyarray(py);
    let out = PyDict::new(py);
    out.set_item("force", table(py, loads.iter().map(|l| l.0.to_array()))?)?;
    out.set_item("torque", table(py, loads.iter().map(|l| l.1.to_array()))?)?;
    for (k, name) in ["coordinate", "coordinate_2", "coordinate_3"]
        .into_iter()
        .enumerate()
    {
        let value = |j: usize| joints.coordinate(j, k, bodies).unwrap_or(f64::NAN);
        out.set_item(name, numbers(&value))?;
    }
    out.set_item("violation", numbers(&|j| joints.violation(j, bodies).0))?;
    out.set_item(
        "angular_violation",
        numbers(&|j| joints.violation(j, bodies).1),
    )?;
    let broken = all
        .map(|j| i32::from(joints.is_broken(j)))
        .collect::<Vec<i32>>();
    out.set_item("broken", broken.into_pyarray(py))?;
    Ok(out)
}
