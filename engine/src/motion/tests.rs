use std::sync::Arc;

use super::*;
use crate::curve::Curve;
use crate::profile::{Profile, Program};

const LINEAR: DVec3 = DVec3::new(0.3, -0.2, 0.7);
const ANGULAR: DVec3 = DVec3::new(0.4, 1.1, -0.6);
const CENTER: DVec3 = DVec3::new(1.0, 2.0, -0.5);

fn start() -> State {
    State {
        position: DVec3::new(1.4, 1.5, 0.1),
        orientation: rotation_from_vector(DVec3::new(0.2, 0.5, -0.9)),
        velocity: DVec3::ZERO,
        angular_momentum: DVec3::ZERO,
    }
}

fn motion(kind: MotionKind, profile: Option<Profile>, from: f64, until: f64) -> Motion {
    let schedule = Schedule {
        profile: profile.map(Arc::new),
        from,
        until,
    };
    Motion::new(3, kind, (LINEAR, ANGULAR), CENTER, schedule)
}

fn profiles() -> Vec<Profile> {
    // sin(t * t)
    let chirp = Program::new(&[1.0, 0.0, 1.0, 0.0, 4.0, 0.0, 20.0, 0.0]).unwrap();
    vec![
        Profile::Constant,
        Profile::Sine {
            frequency: 0.8,
            phase: 0.3,
        },
        Profile::Ramp { over: 1.3 },
        Profile::Table(Curve::held(&[(0.0, 0.0), (0.5, 2.0), (1.2, -1.0)])),
        Profile::Expression(chirp),
    ]
}

/// Rotation vector of the small rotation from `a` to `b`.
fn turn_between(a: DQuat, b: DQuat) -> DVec3 {
    let q = b * a.conjugate();
    2.0 * DVec3::new(q.x, q.y, q.z) * q.w.signum()
}

#[test]
fn velocity_and_acceleration_are_rates_of_the_pose() {
    let (h, start) = (1e-5, start());
    for kind in [MotionKind::Position, MotionKind::Velocity] {
        for profile in profiles() {
            let motion = motion(kind, Some(profile), 0.2, 3.0);
            for t in [0.1, 0.4, 0.9, 1.7, 2.4, 3.5] {
                let (before, after) = (motion.pose(&start, t - h), motion.pose(&start, t + h));
                let (v, omega) = motion.velocity(&start, t);
                let error = (after.0 - before.0) / (2.0 * h) - v;
                assert!(error.length() < 1e-8, "{motion:?} {t} {error}"); // measured 6e-9
                let error = turn_between(before.1, after.1) / (2.0 * h) - omega;
                assert!(error.length() < 1e-8, "{motion:?} {t} {error}"); // measured 6e-9
                let (a, alpha) = motion.acceleration(&start, t);
                let (before, after) = (
                    motion.velocity(&start, t - h),
                    motion.velocity(&start, t + h),
                );
                let error = (after.0 - before.0) / (2.0 * h) - a;
                assert!(error.length() < 1e-7, "{motion:?} {t} {error}"); // measured 5e-8
                let error = (after.1 - before.1) / (2.0 * h) - alpha;
                assert!(error.length() < 1e-7, "{motion:?} {t} {error}"); // measured 1.4e-8
            }
        }
    }
}

#[test]
fn a_shaking_table_follows_its_sine() {
    let sine = Profile::Sine {
        frequency: 2.0,
        phase: 0.0,
    };
    let motion = Motion::new(
        0,
        MotionKind::Position,
        (DVec3::X * 0.05, DVec3::ZERO),
        CENTER,
        Schedule {
            profile: Some(Arc::new(sine)),
            ..Schedule::default()
        },
    );
    let (start, t) = (start(), 0.37);
    let w = std::f64::consts::TAU * 2.0;
    let (position, orientation) = motion.pose(&start, t);
    let exact = start.position + DVec3::X * 0.05 * (w * t).sin();
    assert!((position - exact).length() < 1e-15);
    assert_eq!(orientation, start.orientation.normalize());
    let (v, omega) = motion.velocity(&start, t);
    assert!((v - DVec3::X * 0.05 * w * (w * t).cos()).length() < 1e-14);
    assert_eq!(omega, DVec3::ZERO);
}

/// A constant angular speed turns by omega t about the centre, on a circle around it.
#[test]
fn a_drum_turns_about_its_own_origin() {
    let omega = DVec3::Z * 3.0;
    let motion = Motion::new(
        0,
        MotionKind::Velocity,
        (DVec3::ZERO, omega),
        CENTER,
        Schedule::default(),
    );
    let (start, t) = (start(), 10.0);
    let (position, orientation) = motion.pose(&start, t);
    let exact = DQuat::from_rotation_z(3.0 * t);
    let arm = exact * (start.position - CENTER);
    assert!((position - CENTER - arm).length() < 1e-14);
    assert!(turn_between(exact * start.orientation, orientation).length() < 1e-14);
    let (v, spin) = motion.velocity(&start, t);
    assert!((v - omega.cross(arm)).length() < 1e-13);
    assert_eq!(spin, omega);
}

#[test]
fn outside_its_window_a_body_stands_still() {
    let start = start();
    for kind in [MotionKind::Position, MotionKind::Velocity] {
        for profile in profiles() {
            let motion = motion(kind, Some(profile), 1.0, 2.0);
            let (before, after) = (motion.pose(&start, 0.5), motion.pose(&start, 7.0));
            assert!((before.0 - start.position).length() < 1e-15);
            assert_eq!(after, motion.pose(&start, 2.0));
            assert!((motion.pose(&start, 2.0 - 1e-9).0 - after.0).length() < 1e-8);
            for t in [0.5, 2.0, 7.0] {
                assert_eq!(motion.velocity(&start, t), (DVec3::ZERO, DVec3::ZERO));
            }
        }
    }
}
