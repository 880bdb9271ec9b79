//! Joints and their drives in the border dictionary.

use glam::{DQuat, DVec3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::forces::Profiles;
use super::input::{index, quaternion, same_length, Input};
use crate::joint::{check, DriveModel, JointModel, Kind, Motor};

/// The joints of `joint_*` and the drives of `drive_*`. The world, -1 at the border, is the body after the last of
/// the `body_count` bodies.
pub(super) fn read_joints(
    input: &Input<'_>,
    body_count: usize,
    profiles: &Profiles,
) -> PyResult<(Vec<JointModel>, Vec<DriveModel>)> {
    let joints = read_models(input, body_count)?;
    let drives = read_drives(input, joints.len(), profiles)?;
    check(&joints, &drives).map_err(PyValueError::new_err)?;
    Ok((joints, drives))
}

fn read_models(input: &Input<'_>, body_count: usize) -> PyResult<Vec<JointModel>> {
    let kinds = input.integers("joint_kind", 1)?;
    let count = kinds.len();
    let bodies = input.integers("joint_bodies", 2)?;
    same_length("joint_bodies", &bodies, 2 * count)?;
    let anchors: Vec<DVec3> = rows(input, "joint_anchors", 6, count)?
        .chunks_exact(3)
        .map(DVec3::from_slice)
        .collect();
    let frames: Vec<DQuat> = rows(input, "joint_frames", 8, count)?
        .chunks_exact(4)
        .map(quaternion)
        .collect();
    let parameters = rows(input, "joint_parameters", 4, count)?;
    let damping = rows(input, "joint_damping", 1, count)?;
    let breaking = rows(input, "joint_break", 2, count)?;
    let body = |value: i32| match value {
        -1 => Ok(body_count),
        other => index(other, body_count, "joint_bodies"),
    };
    (0..count)
        .map(|j| {
            Ok(JointModel {
                kind: read_kind(kinds[j], &parameters[4 * j..4 * j + 4], count)?,
                bodies: [body(bodies[2 * j])?, body(bodies[2 * j + 1])?],
                anchors: [anchors[2 * j], anchors[2 * j + 1]],
                frames: [frames[2 * j], frames[2 * j + 1]],
                damping: damping[j],
                break_force: breaking[2 * j],
                break_torque: breaking[2 * j + 1],
            })
        })
        .collect()
}

/// Kind numbers of the border; a new joint adds a number here and a variant in `joint/model.rs`.
fn read_kind(kind: i32, p: &[f64], count: usize) -> PyResult<Kind> {
    #[allow(clippy::cast_possible_truncation)] // whole numbers, and checked as indices
    let joint = |k: usize| index(p[k] as i32, count, "joint_parameters (gear)");
    Ok(match kind {
        0 => Kind::Distance { length: p[0] },
        1 => Kind::Ball,
        2 => Kind::Hinge,
        3 => Kind::Slider,
        4 => Kind::Fixed,
        5 => Kind::Cone {
            max_angle: p[0],
            restitution: p[1],
        },
        6 => Kind::Universal,
        7 => Kind::Cylindrical,
        8 => Kind::Planar,
        9 => Kind::Screw { pitch: p[0] },
        10 => Kind::Gear {
            ratio: p[0],
            joints: [joint(1)?, joint(2)?],
        },
        11 => Kind::Stops,
        other => {
            return Err(PyValueError::new_err(format!(
                "joint_kind {other} is unknown"
            )))
        }
    })
}

fn read_drives(
    input: &Input<'_>,
    joint_count: usize,
    profiles: &Profiles,
) -> PyResult<Vec<DriveModel>> {
    let joints = input.integers("drive_joint", 1)?;
    let count = joints.len();
    let whole = |name: &str| {
        let list = input.integers(name, 1)?;
        same_length(name, &list, count).map(|()| list)
    };
    let (coordinates, kinds) = (whole("drive_coordinate")?, whole("drive_motor_kind")?);
    let limits = rows(input, "drive_limits", 2, count)?;
    let restitution = rows(input, "drive_restitution", 1, count)?;
    let friction = rows(input, "drive_friction", 1, count)?;
    let damping = rows(input, "drive_damping", 1, count)?;
    let spring = rows(input, "drive_spring", 2, count)?;
    let motors = rows(input, "drive_motor", 4, count)?;
    let factors = whole("drive_profile")?;
    (0..count)
        .map(|k| {
            Ok(DriveModel {
                joint: index(joints[k], joint_count, "drive_joint")?,
                coordinate: index(coordinates[k], 3, "drive_coordinate")?,
                limits: [limits[2 * k], limits[2 * k + 1]],
                restitution: restitution[k],
                friction: friction[k],
                damping: damping[k],
                stiffness: spring[2 * k],
                rest: spring[2 * k + 1],
                motor: read_motor(kinds[k], &motors[4 * k..4 * k + 4])?,
                profile: profiles.get(factors[k], "drive_profile")?,
            })
        })
        .collect()
}

fn read_motor(kind: i32, p: &[f64]) -> PyResult<Option<Motor>> {
    Ok(match kind {
        0 => None,
        1 => Some(Motor::Speed {
            speed: p[0],
            max: p[1],
        }),
        2 => Some(Motor::Servo {
            target: p[0],
            stiffness: p[1],
            damping: p[2],
            max: p[3],
        }),
        other => {
            return Err(PyValueError::new_err(format!(
                "drive_motor_kind {other} is unknown"
            )))
        }
    })
}

/// `count` rows of `width` numbers.
fn rows(input: &Input<'_>, name: &str, width: usize, count: usize) -> PyResult<Vec<f64>> {
    let list = input.floats(name, width)?;
    same_length(name, &list, width * count).map(|()| list)
}
