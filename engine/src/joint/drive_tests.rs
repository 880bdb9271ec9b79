//! Limits, rims, springs, dampers and servos on joints that are placed by hand.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::testing::{at, body, join, world, Numbers};
use super::tests::all_rows;
use super::{Ahead, Cause, Course, DriveModel, DriveRow, Joints, Kind, Motor, Row};
use crate::body::Body;
use crate::force::{Powers, Wrench};
use crate::math::rotation_from_vector;
use crate::profile::Profile;

const STEP: f64 = 0.01;

/// A hinge about z through the origin between the world and a body, with this drive.
fn hinge(drive: DriveModel) -> Joints {
    let bodies = vec![world(), at(DVec3::new(0.3, 0.0, 0.0), DQuat::IDENTITY)];
    let model = join(Kind::Hinge, [0, 1], DVec3::ZERO, DQuat::IDENTITY, &bodies);
    Joints::new(vec![model], vec![drive], &bodies)
}

/// World and body at this angle and rate.
fn turned(angle: f64, rate: f64) -> Vec<Body> {
    let turn = rotation_from_vector(angle * DVec3::Z);
    let arm = turn * DVec3::new(0.3, 0.0, 0.0);
    let omega = rate * DVec3::Z;
    vec![world(), body(arm, turn, omega.cross(arm), omega)]
}

fn rows(joints: &Joints, bodies: &[Body], time: f64) -> Vec<DriveRow> {
    let mut out = Vec::new();
    let ahead = Ahead {
        time,
        timestep: STEP,
        lead: 1.0,
    };
    joints.drive_rows(bodies, ahead, &mut out);
    out
}

fn limited(restitution: f64) -> Joints {
    hinge(DriveModel {
        limits: [-0.5, 1.0],
        restitution,
        ..DriveModel::free(0, 0)
    })
}

#[test]
fn a_free_drive_has_two_idle_rows() {
    let rows = rows(&hinge(DriveModel::free(0, 0)), &turned(0.2, 1.0), 0.0);
    assert_eq!(rows.len(), 2);
    assert!(rows
        .iter()
        .all(|row| row.is_idle() && row.row == Row::default()));
}

#[test]
fn the_limit_ahead_is_the_one_that_counts() {
    let joints = limited(0.0);
    for (angle, rate, gap, row_rate) in [
        (0.9, 0.0, 0.1, 0.0),
        (-0.4, 0.0, 0.1, 0.0),
        (0.9, 2.0, 0.1, -2.0),
        (-0.4, -2.0, 0.1, -2.0),
        // Nearer to the lower one, and yet at the upper one within the step.
        (-0.4, 200.0, 1.4, -200.0),
    ] {
        let bodies = turned(angle, rate);
        let limit = rows(&joints, &bodies, 0.0)[1];
        assert_eq!(limit.cause, Cause::Limit);
        assert_eq!((limit.lower, limit.upper), (0.0, f64::INFINITY));
        assert!((limit.row.value - gap).abs() < 1e-14, "{angle} {rate}");
        assert!((limit.row.rate(&bodies) - row_rate).abs() < 1e-12);
        // It comes to the limit and no further; where it gets there of itself it is stopped and held there.
        let arrives = rate * STEP > gap;
        let target = if arrives { 0.0 } else { -gap / STEP };
        assert!((limit.target - target).abs() < 1e-12);
        assert_eq!(limit.lock.map(|lock| lock.place), arrives.then_some(1.0));
    }
}

#[test]
fn beyond_a_limit_the_way_back_is_left_to_stabilisation() {
    let limit = rows(&limited(0.0), &turned(1.2, 0.0), 0.0)[1];
    assert!((limit.row.value + 0.2).abs() < 1e-14);
    assert!(limit.target.abs() < 1e-15);
    let held = limit.lock.unwrap();
    assert!(held.by_limit && !held.arrives && held.place == 1.0);
}

/// Held, the coordinate is a row of its joint; free again, the row holds nothing.
#[test]
fn a_locked_coordinate_is_a_row_of_its_joint() {
    let mut joints = limited(0.0);
    let bodies = turned(0.999, 3.0);
    let lock = rows(&joints, &bodies, 0.0)[1].lock.unwrap();
    assert_eq!(joints.rows_of(0), 0..6);
    joints.lock(1, lock);
    assert!(joints.is_locked(1) && !joints.is_locked(0));
    let found = all_rows(&joints, &bodies);
    assert!((found[5][0].value + 0.001).abs() < 1e-14);
    let course = |row: &Vec<Row>| Course {
        rate: row[0].rate(&bodies),
        ..Course::default()
    };
    let courses: Vec<Course> = found.iter().map(course).collect();
    let mut missing = Vec::new();
    joints.arrest(&courses, true, &mut missing);
    assert!(missing[..5].iter().all(|m| *m == 0.0) && (missing[5] + 3.0).abs() < 1e-14);
    let mut values = vec![0.1; 6];
    joints.take_back(0.5, &mut values);
    assert_eq!(values, [0.05, 0.05, 0.05, 0.05, 0.05, 0.0]);
    joints.release();
    let found = all_rows(&joints, &bodies);
    assert_eq!((found.len(), found[5].len()), (6, 0));
}

#[test]
fn restitution_throws_back_what_arrives_within_the_step() {
    let joints = limited(0.4);
    let arrives = rows(&joints, &turned(0.99, 3.0), 0.0)[1];
    assert!((arrives.target - 0.4 * 3.0).abs() < 1e-12);
    let not_yet = rows(&joints, &turned(0.9, 3.0), 0.0)[1];
    assert!((not_yet.target + 0.1 / STEP).abs() < 1e-12);
    let rests = rows(&joints, &turned(1.0, 0.0), 0.0)[1];
    assert!(rests.target.abs() < 1e-12);
    let leaves = rows(&joints, &turned(1.0, -3.0), 0.0)[1];
    assert!(leaves.target.abs() < 1e-12);
}

#[test]
fn limits_count_turns() {
    let mut joints = hinge(DriveModel {
        limits: [0.0, 3.0 * TAU],
        ..DriveModel::free(0, 0)
    });
    for step in 0..=180 {
        joints.observe(&turned(0.1 * f64::from(step), 0.0));
    }
    let limit = rows(&joints, &turned(18.0, 0.0), 0.0)[1];
    assert!((limit.row.value - (3.0 * TAU - 18.0)).abs() < 1e-13);
}

/// A profile scales the speed; the row's friction is told apart.
#[test]
fn a_motor_follows_its_profile() {
    let joints = hinge(DriveModel {
        friction: 1.0,
        motor: Some(Motor::Speed {
            speed: 4.0,
            max: 50.0,
        }),
        profile: Some(Arc::new(Profile::Ramp { over: 2.0 })),
        ..DriveModel::free(0, 0)
    });
    // Its target is the speed at the end of the step.
    let motor = rows(&joints, &turned(0.0, 2.0), 1.0 - STEP)[0];
    assert_eq!(motor.cause, Cause::Motor);
    assert_eq!((motor.lower, motor.upper), (-51.0, 49.0));
    assert!((motor.target - 2.0).abs() < 1e-15 && motor.friction == 1.0);
    assert!((motor.row.rate(&turned(0.0, 2.0)) - 2.0).abs() < 1e-14);
}

#[test]
fn a_cone_has_a_rim() {
    let bodies = vec![world(), at(DVec3::ZERO, DQuat::IDENTITY)];
    let kind = Kind::Cone {
        max_angle: 0.5,
        restitution: 0.2,
    };
    let model = join(kind, [0, 1], DVec3::ZERO, DQuat::IDENTITY, &bodies);
    let joints = Joints::new(vec![model], Vec::new(), &bodies);
    let axis = DVec3::new(0.6, -0.8, 0.0);
    let tilt = |angle: f64, rate: f64| {
        let turn = rotation_from_vector(angle * axis);
        vec![world(), body(DVec3::ZERO, turn, DVec3::ZERO, rate * axis)]
    };
    let near = rows(&joints, &tilt(0.45, 1.0), 0.0);
    assert_eq!(near.len(), 2);
    assert!(near[0].is_idle());
    assert!((near[1].row.value - 0.05).abs() < 1e-14);
    assert!((near[1].row.ends[1].angular + axis).length() < 1e-14);
    let hits = rows(&joints, &tilt(0.495, 1.0), 0.0)[1];
    assert!((hits.target - 0.2).abs() < 1e-12);
    // Upright there is no direction, and the rim is far.
    let upright = rows(&joints, &bodies, 0.0)[1];
    assert!((upright.row.value - 0.5).abs() < 1e-15 && upright.row.bias == 0.0);
}

/// A rope from 0 to 2 m is slack however fast its ends pass each other.
#[test]
fn a_distance_of_zero_is_no_limit() {
    let bodies = vec![
        world(),
        body(
            DVec3::X * 0.01,
            DQuat::IDENTITY,
            DVec3::X * -50.0,
            DVec3::ZERO,
        ),
    ];
    let mut model = join(Kind::Stops, [0, 1], DVec3::ZERO, DQuat::IDENTITY, &bodies);
    model.anchors = [DVec3::ZERO; 2];
    let rope = |low: f64| {
        let drive = DriveModel {
            limits: [low, 2.0],
            ..DriveModel::free(0, 0)
        };
        let joints = Joints::new(vec![model.clone()], vec![drive], &bodies);
        rows(&joints, &bodies, 0.0)[1]
    };
    let slack = rope(0.0);
    assert!(
        (slack.row.value - 1.99).abs() < 1e-15 && (slack.row.rate(&bodies) - 50.0).abs() < 1e-12
    );
    let strut = rope(0.005);
    assert!(
        (strut.row.value - 0.005).abs() < 1e-15 && (strut.row.rate(&bodies) + 50.0).abs() < 1e-12
    );
}

fn forces(joints: &Joints, bodies: &[Body], time: f64) -> (Vec<Wrench>, Powers) {
    let mut wrenches = vec![Wrench::default(); bodies.len()];
    let powers = joints.add_forces(bodies, time, &mut wrenches);
    (wrenches, powers)
}

#[test]
fn spring_and_damper_of_a_hinge() {
    let joints = hinge(DriveModel {
        stiffness: 10.0,
        rest: 0.5,
        damping: 2.0,
        ..DriveModel::free(0, 0)
    });
    let bodies = turned(0.2, 3.0);
    let (wrenches, powers) = forces(&joints, &bodies, 0.0);
    // 10 (0.5 - 0.2) - 2 * 3
    assert!((wrenches[1].torque + 3.0 * DVec3::Z).length() < 1e-14);
    assert_eq!(wrenches[0], Wrench::default());
    assert!((powers.damping + 18.0).abs() < 1e-13);
    assert!((joints.spring_energy(&bodies) - 5.0 * 0.09).abs() < 1e-15);
    assert!(joints.depends_on_velocity());
    let (force, torque) = joints.pull_on(0, &bodies, 0.0);
    assert!(force.length() < 1e-15 && (torque - 3.0 * DVec3::Z).length() < 1e-14);
}

#[test]
fn a_servo_is_cut_off_at_its_strength() {
    let joints = hinge(DriveModel {
        motor: Some(Motor::Servo {
            target: 1.0,
            stiffness: 100.0,
            damping: 5.0,
            max: 30.0,
        }),
        profile: Some(Arc::new(Profile::Ramp { over: 2.0 })),
        ..DriveModel::free(0, 0)
    });
    // Target 0.25 at the rate 0.5: 100 * 0.05 + 5 (0.5 - 1) = 2.5.
    let (wrenches, powers) = forces(&joints, &turned(0.2, 1.0), 0.5);
    assert!((wrenches[1].torque - 2.5 * DVec3::Z).length() < 1e-13);
    assert!((powers.motors - 2.5).abs() < 1e-13);
    let (wrenches, _) = forces(&joints, &turned(-0.2, 1.0), 0.5);
    assert!((wrenches[1].torque - 30.0 * DVec3::Z).length() < 1e-13);
    assert!(rows(&joints, &turned(0.0, 0.0), 0.0)[0].is_idle());
}

#[test]
fn a_ball_joint_is_damped_about_every_axis() {
    let mut n = Numbers(21);
    let bodies = vec![
        body(n.vector(), n.rotation(2.0), n.vector(), n.vector()),
        body(n.vector(), n.rotation(2.0), n.vector(), n.vector()),
    ];
    let mut model = join(Kind::Ball, [0, 1], n.vector(), DQuat::IDENTITY, &bodies);
    model.damping = 0.7;
    let joints = Joints::new(vec![model], Vec::new(), &bodies);
    let slip = bodies[1].angular_velocity - bodies[0].angular_velocity;
    let (wrenches, powers) = forces(&joints, &bodies, 0.0);
    assert!((wrenches[1].torque + 0.7 * slip).length() < 1e-15);
    assert!((wrenches[0].torque - 0.7 * slip).length() < 1e-15);
    assert!((powers.damping + 0.7 * slip.length_squared()).abs() < 1e-14);
    assert!((joints.pull_on(0, &bodies, 0.0).1 - 0.7 * slip).length() < 1e-15);
}

/// Springs on every coordinate of a loose joint: the power of the wrenches is what the springs lose, plus what is booked.
/// The energy is differentiated along the motion (central differences, errors up to 8e-8 measured).
#[test]
fn power_into_the_bodies_balances() {
    let mut n = Numbers(22);
    for kind in [
        Kind::Cylindrical,
        Kind::Planar,
        Kind::Universal,
        Kind::Stops,
    ] {
        for fixed in [false, true] {
            let mut bodies: Vec<Body> = (0..2)
                .map(|_| body(n.vector(), n.rotation(1.0), n.vector(), n.vector()))
                .collect();
            if fixed {
                // In prescribed motion.
                bodies[0].mass = world().mass;
            }
            let model = join(kind, [0, 1], n.vector(), n.rotation(1.0), &bodies);
            let drive = |k| DriveModel {
                stiffness: 7.0,
                rest: 0.3,
                damping: 0.4,
                ..DriveModel::free(0, k)
            };
            let count = kind.layout().coordinates.len();
            let joints = Joints::new(vec![model], (0..count).map(drive).collect(), &bodies);
            bodies[1].state.position += DVec3::splat(0.6);
            let (wrenches, powers) = forces(&joints, &bodies, 0.0);
            let into = |k: usize| {
                wrenches[k].force.dot(bodies[k].state.velocity)
                    + wrenches[k].torque.dot(bodies[k].angular_velocity)
            };
            let h = 1e-4;
            let energy = |t: f64| joints.spring_energy(&super::tests::moved(&bodies, t));
            let stored = (energy(h) - energy(-h)) / (2.0 * h);
            let error = into(0) + into(1) + stored - powers.damping - powers.forces;
            assert!(error.abs() < 1e-6, "{kind:?} {fixed}: {error}");
        }
    }
}
