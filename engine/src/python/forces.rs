//! Forces, springs, profiles and prescribed motion from the border dictionary.

use std::sync::Arc;

use glam::DVec3;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::input::{floats, index, same_length, Input};
use crate::curve::Curve;
use crate::force::{Acts, AppliedForce, Axes, Drag, Field, ForceModel, SpringKind, SpringModel};
use crate::motion::{Motion, MotionKind};
use crate::profile::{Profile, Program, Schedule};

/// The profiles that forces, drives and motions name by number.
pub(super) struct Profiles(Vec<Arc<Profile>>);

impl Profiles {
    pub(super) fn read(input: &Input<'_>) -> PyResult<Self> {
        let kinds = input.integers("profile_kind", 1)?;
        let data = lists(input, "profile_data", 1, kinds.len())?;
        let profiles = kinds.iter().zip(&data);
        profiles
            .map(|(&kind, numbers)| read_profile(kind, numbers).map(Arc::new))
            .collect::<PyResult<_>>()
            .map(Self)
    }

    /// The profile `number`; -1 is the constant 1.
    pub(super) fn get(&self, number: i32, name: &str) -> PyResult<Option<Arc<Profile>>> {
        if number == -1 {
            return Ok(None);
        }
        Ok(Some(self.0[index(number, self.0.len(), name)?].clone()))
    }
}

fn read_profile(kind: i32, numbers: &[f64]) -> PyResult<Profile> {
    Ok(match (kind, numbers) {
        (0, []) => Profile::Constant,
        (1, &[frequency, phase]) => Profile::Sine { frequency, phase },
        (2, &[over]) if over > 0.0 => Profile::Ramp { over },
        (3, &[at]) => Profile::Step { at },
        (4, &[_, _, ..]) if numbers.len() % 2 == 0 => Profile::Table(Curve::held(&pairs(numbers))),
        (5, program) => Profile::Expression(Program::new(program).map_err(PyValueError::new_err)?),
        _ => {
            return Err(PyValueError::new_err(format!(
                "profile_data {numbers:?} does not fit profile_kind {kind}"
            )))
        }
    })
}

/// Everything that acts on `bodies` bodies but contacts and joints; the number `bodies` itself is the world.
pub(super) fn read_forces(
    input: &Input<'_>,
    bodies: usize,
    profiles: &Profiles,
) -> PyResult<ForceModel> {
    let gravity = input.floats("gravity", 1)?;
    same_length("gravity", &gravity, 3)?;
    Ok(ForceModel {
        gravity: DVec3::from_slice(&gravity),
        gravitation: input.float("gravitation")?,
        attracting_mass: input.floats("attracting_mass", 1)?,
        springs: read_springs(input, bodies)?,
        applied: read_applied(input, bodies, profiles)?,
        drags: read_drags(input, bodies)?,
        fields: read_fields(input, bodies, profiles)?,
    })
}

fn read_springs(input: &Input<'_>, bodies: usize) -> PyResult<Vec<SpringModel>> {
    let kind = input.integers("spring_kind", 1)?;
    let count = kind.len();
    let ends = input.integers("spring_bodies", 2)?;
    let anchors = pairs_of_vectors(input, "spring_anchors", count)?;
    let axes = pairs_of_vectors(input, "spring_axis", count)?;
    let parameters = input.floats("spring_parameters", 5)?;
    let force_curves = lists(input, "spring_force_curve", 2, count)?;
    let damping_curves = lists(input, "spring_damping_curve", 2, count)?;
    same_length("spring_bodies", &ends, 2 * count)?;
    same_length("spring_parameters", &parameters, 5 * count)?;
    (0..count)
        .map(|k| {
            let p = &parameters[5 * k..5 * k + 5];
            Ok(SpringModel {
                kind: match kind[k] {
                    0 => SpringKind::Linear,
                    1 => SpringKind::Torsional,
                    other => return Err(unknown("spring_kind", other)),
                },
                bodies: [
                    body_or_world(ends[2 * k], bodies, "spring_bodies")?,
                    body_or_world(ends[2 * k + 1], bodies, "spring_bodies")?,
                ],
                anchors: anchors[k],
                axes: axes[k],
                rest: p[0],
                stiffness: p[1],
                damping: p[2],
                preload: p[3],
                acts: read_acts(p[4])?,
                force_curve: pairs(&force_curves[k]),
                damping_curve: pairs(&damping_curves[k]),
            })
        })
        .collect()
}

fn read_acts(number: f64) -> PyResult<Acts> {
    let known = [Acts::Always, Acts::Tension, Acts::Compression];
    let found = (0_u8..).zip(known).find(|&(k, _)| f64::from(k) == number);
    found
        .map(|(_, acts)| acts)
        .ok_or_else(|| unknown("acts of spring_parameters", number))
}

fn read_applied(
    input: &Input<'_>,
    bodies: usize,
    profiles: &Profiles,
) -> PyResult<Vec<AppliedForce>> {
    let body = input.integers("force_body", 1)?;
    let count = body.len();
    let force = vectors(input, "force_force", count)?;
    let torque = vectors(input, "force_torque", count)?;
    let at = vectors(input, "force_at", count)?;
    let frame = input.integers("force_frame", 1)?;
    same_length("force_frame", &frame, count)?;
    let schedules = read_schedules(input, "force", count, profiles)?;
    schedules
        .into_iter()
        .enumerate()
        .map(|(k, schedule)| {
            Ok(AppliedForce {
                body: index(body[k], bodies, "force_body")?,
                force: force[k],
                torque: torque[k],
                at: at[k],
                axes: match frame[k] {
                    0 => Axes::World,
                    1 => Axes::Body,
                    other => return Err(unknown("force_frame", other)),
                },
                schedule,
            })
        })
        .collect()
}

fn read_drags(input: &Input<'_>, bodies: usize) -> PyResult<Vec<Drag>> {
    let body = input.integers("drag_body", 1)?;
    let column = |name: &str| {
        let values = input.floats(name, 1)?;
        same_length(name, &values, body.len()).map(|()| values)
    };
    let linear = column("drag_linear")?;
    let angular = column("drag_angular")?;
    let quadratic = column("drag_quadratic")?;
    (0..body.len())
        .map(|k| {
            Ok(Drag {
                body: index(body[k], bodies, "drag_body")?,
                linear: linear[k],
                angular: angular[k],
                quadratic: quadratic[k],
            })
        })
        .collect()
}

fn read_fields(input: &Input<'_>, bodies: usize, profiles: &Profiles) -> PyResult<Vec<Field>> {
    let body = input.integers("field_body", 1)?;
    let acceleration = vectors(input, "field_acceleration", body.len())?;
    let region = pairs_of_vectors(input, "field_region", body.len())?;
    let schedules = read_schedules(input, "field", body.len(), profiles)?;
    schedules
        .into_iter()
        .enumerate()
        .map(|(k, schedule)| {
            Ok(Field {
                body: index(body[k], bodies, "field_body")?,
                acceleration: acceleration[k],
                region: region[k],
                schedule,
            })
        })
        .collect()
}

/// Prescribed motions of fixed bodies.
pub(super) fn read_motions(
    input: &Input<'_>,
    bodies: usize,
    profiles: &Profiles,
) -> PyResult<Vec<Motion>> {
    let body = input.integers("motion_body", 1)?;
    let count = body.len();
    let kind = input.integers("motion_kind", 1)?;
    same_length("motion_kind", &kind, count)?;
    let linear = vectors(input, "motion_linear", count)?;
    let angular = vectors(input, "motion_angular", count)?;
    let center = vectors(input, "motion_center", count)?;
    let schedules = read_schedules(input, "motion", count, profiles)?;
    schedules
        .into_iter()
        .enumerate()
        .map(|(k, schedule)| {
            let kind = match kind[k] {
                0 => MotionKind::Position,
                1 => MotionKind::Velocity,
                other => return Err(unknown("motion_kind", other)),
            };
            let body = index(body[k], bodies, "motion_body")?;
            let amplitude = (linear[k], angular[k]);
            Ok(Motion::new(body, kind, amplitude, center[k], schedule))
        })
        .collect()
}

/// `prefix`_window and `prefix`_profile.
fn read_schedules(
    input: &Input<'_>,
    prefix: &str,
    count: usize,
    profiles: &Profiles,
) -> PyResult<Vec<Schedule>> {
    let (window, profile) = (format!("{prefix}_window"), format!("{prefix}_profile"));
    let windows = input.floats(&window, 2)?;
    let numbers = input.integers(&profile, 1)?;
    same_length(&window, &windows, 2 * count)?;
    same_length(&profile, &numbers, count)?;
    (0..count)
        .map(|k| {
            Ok(Schedule {
                profile: profiles.get(numbers[k], &profile)?,
                from: windows[2 * k],
                until: windows[2 * k + 1],
            })
        })
        .collect()
}

/// Number of a body, -1 for the world.
fn body_or_world(number: i32, bodies: usize, name: &str) -> PyResult<usize> {
    if number == -1 {
        Ok(bodies)
    } else {
        index(number, bodies, name)
    }
}

fn vectors(input: &Input<'_>, name: &str, count: usize) -> PyResult<Vec<DVec3>> {
    let vectors = input.vectors(name)?;
    same_length(name, &vectors, count).map(|()| vectors)
}

/// A (count, 2, 3) array.
fn pairs_of_vectors(input: &Input<'_>, name: &str, count: usize) -> PyResult<Vec<[DVec3; 2]>> {
    let numbers = input.floats(name, 6)?;
    same_length(name, &numbers, 6 * count)?;
    let split = |v: &[f64]| [DVec3::from_slice(&v[..3]), DVec3::from_slice(&v[3..])];
    Ok(numbers.chunks_exact(6).map(split).collect())
}

/// A list of `count` arrays whose rows have `width` numbers, each array flat.
fn lists(input: &Input<'_>, name: &str, width: usize, count: usize) -> PyResult<Vec<Vec<f64>>> {
    let list = input.list(name)?;
    same_length(name, &vec![(); list.len()], count)?;
    list.iter().map(|rows| floats(&rows, name, width)).collect()
}

fn pairs(numbers: &[f64]) -> Vec<(f64, f64)> {
    numbers.chunks_exact(2).map(|p| (p[0], p[1])).collect()
}

fn unknown(name: &str, number: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(format!("unknown {name} {number}"))
}
