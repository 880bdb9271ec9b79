//! The model of a scene from the border dictionary.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::forces::{read_forces, read_motions, Profiles};
use super::input::{floats, index, integers, same_length, Input};
use super::joints::read_joints;
use crate::body::{MassProperties, State};
use crate::integrator::Integrator;
use crate::model::{Coefficients, Geom, Model, PairTable, Settings, Stabilization};
use crate::shape::{Hull, Shape, TriangleMesh};

/// How many threads the world is to step on.
pub(super) fn read_threads(model: &Bound<'_, PyDict>) -> PyResult<usize> {
    let threads: usize = Input(model).item("threads")?.extract()?;
    if threads == 0 {
        return Err(PyValueError::new_err("threads must be at least 1"));
    }
    Ok(threads)
}

fn read_settings(input: &Input<'_>) -> PyResult<Settings> {
    let integrator = match input.text("integrator")?.as_str() {
        "explicit_euler" => Integrator::ExplicitEuler,
        "semi_implicit_euler" => Integrator::SemiImplicitEuler,
        "verlet" => Integrator::Verlet,
        "velocity_verlet" => Integrator::VelocityVerlet,
        "leapfrog" => Integrator::Leapfrog,
        "rk4" => Integrator::Rk4,
        other => return Err(PyValueError::new_err(format!("unknown integrator {other}"))),
    };
    let located = match input.text("impacts")?.as_str() {
        "stepped" => false,
        "located" => true,
        other => return Err(PyValueError::new_err(format!("unknown impacts {other}"))),
    };
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
        timestep,
        integrator,
        located,
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
    let rolling_friction = input.floats("rolling_friction", count)?;
    let spinning_friction = input.floats("spinning_friction", count)?;
    same_length("rolling_friction", &rolling_friction, count * count)?;
    same_length("spinning_friction", &spinning_friction, count * count)?;
    let entries = (0..count * count)
        .map(|k| Coefficients {
            restitution: restitution[k],
            static_friction: static_friction[k],
            kinetic_friction: kinetic_friction[k],
            rolling_friction: rolling_friction[k],
            spinning_friction: spinning_friction[k],
        })
        .collect();
    Ok(PairTable::new(count, entries))
}

pub(super) fn read_model(dictionary: &Bound<'_, PyDict>) -> PyResult<Model> {
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
    let profiles = Profiles::read(&input)?;
    let (joints, drives) = read_joints(&input, bodies.len(), &profiles)?;
    Ok(Model {
        settings: read_settings(&input)?,
        geoms: read_geoms(&input, bodies.len(), pairs.len())?,
        forces: read_forces(&input, bodies.len(), &profiles)?,
        motions: read_motions(&input, bodies.len(), &profiles)?,
        surface_velocities: input.vectors("surface_velocity")?,
        joints,
        drives,
        bodies,
        pairs,
        no_contact,
    })
}
