//! Rows against finite differences, coordinates against constructed poses, reactions against hand calculation.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DQuat, DVec3};

use super::testing::{at, body, join, world, Numbers, KINDS};
use super::{Joints, Kind, Row};
use crate::body::Body;
use crate::math::rotation_from_vector;

/// The bodies after the time t at constant velocities.
pub(super) fn moved(bodies: &[Body], t: f64) -> Vec<Body> {
    let later = |b: &Body| {
        body(
            b.state.position + t * b.state.velocity,
            rotation_from_vector(t * b.angular_velocity) * b.state.orientation,
            b.state.velocity,
            b.angular_velocity,
        )
    };
    bodies.iter().map(later).collect()
}

/// First and second derivative of `f` at 0, fourth order.
fn derivatives(f: impl Fn(f64) -> Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let h = 2e-3;
    let f: Vec<Vec<f64>> = [-2.0, -1.0, 0.0, 1.0, 2.0]
        .iter()
        .map(|k| f(k * h))
        .collect();
    let each = |weights: [f64; 5], scale: f64| {
        let sum = |r: usize| (0..5).map(|k| weights[k] * f[k][r]).sum::<f64>() / scale;
        (0..f[0].len()).map(sum).collect()
    };
    (
        each([1.0, -8.0, 0.0, 8.0, -1.0], 12.0 * h),
        each([-1.0, 16.0, -30.0, 16.0, -1.0], 12.0 * h * h),
    )
}

/// Each a sum.
pub(super) fn all_rows(joints: &Joints, bodies: &[Body]) -> Vec<Vec<Row>> {
    let mut rows = Vec::new();
    joints.rows(bodies, true, |_, sum| rows.push(sum.to_vec()));
    rows
}

/// All values that `rows`, then all coordinates would have.
fn all_values(joints: &Joints, bodies: &[Body]) -> Vec<f64> {
    let mut values = Vec::new();
    joints.values(bodies, &mut values);
    for j in 0..joints.len() {
        values.extend((0..3).filter_map(|k| joints.coordinate(j, k, bodies)));
    }
    values
}

/// The rows, then those of all coordinates.
fn rows_and_coordinates(joints: &Joints, bodies: &[Body]) -> Vec<Vec<Row>> {
    let mut rows = all_rows(joints, bodies);
    for j in 0..joints.len() {
        let count = joints.model(j).kind.layout().coordinates.len();
        rows.extend((0..count).map(|k| vec![joints.coordinate_row(j, k, bodies)]));
    }
    rows
}

/// Value, rate and bias of every row against the values along the motion. The differences
/// are good to 3e-10 in the rates and 8e-10 in the biases (measured).
fn assert_derivatives(joints: &Joints, bodies: &[Body], story: &str) {
    let rows = rows_and_coordinates(joints, bodies);
    let values = all_values(joints, bodies);
    let (rates, biases) = derivatives(|t| all_values(joints, &moved(bodies, t)));
    for (r, row) in rows.iter().enumerate() {
        let sum = |of: &dyn Fn(&Row) -> f64| row.iter().map(of).sum::<f64>();
        let rate = sum(&|row| row.rate(bodies));
        assert!(
            (sum(&|row| row.value) - values[r]).abs() < 1e-15,
            "{story}, value of row {r}"
        );
        assert!(
            (rate - rates[r]).abs() < 1e-9,
            "{story}, row {r}: rate {rate}, found {}",
            rates[r]
        );
        let bias = sum(&|row| row.bias);
        assert!(
            (bias - biases[r]).abs() < 1e-8,
            "{story}, row {r}: bias {bias}, found {}",
            biases[r]
        );
    }
}

/// Two bodies near a pose where joints of frames that differ by `shift` and `tilt` hold.
fn random_pair(n: &mut Numbers) -> Vec<Body> {
    let mut one = || body(n.vector(), n.rotation(2.0), n.vector(), n.vector());
    vec![one(), one()]
}

/// What keeps a distance or a tilt off zero, where their derivatives grow beyond all bounds: shift and turn.
fn apart(kind: Kind, frame: DQuat) -> (DVec3, DVec3) {
    match kind {
        Kind::Distance { .. } | Kind::Stops => (DVec3::splat(1.5), DVec3::ZERO),
        Kind::Cone { .. } => (DVec3::ZERO, frame * DVec3::new(1.2, 1.2, 0.0)),
        _ => (DVec3::ZERO, DVec3::ZERO),
    }
}

/// Joins the bodies, then moves the second one off: by `shift` [m], turned by up to `tilt` [rad] about each axis.
fn disturbed(kind: Kind, n: &mut Numbers, shift: f64, tilt: f64) -> (Joints, Vec<Body>) {
    let mut bodies = random_pair(n);
    let frame = n.rotation(2.0);
    let model = join(kind, [0, 1], n.vector(), frame, &bodies);
    let joints = Joints::new(vec![model], Vec::new(), &bodies);
    let (away, turn) = apart(kind, frame);
    bodies[1].displace(away, turn);
    bodies[1].displace(shift * n.vector(), tilt * n.vector());
    // The displacement leaves the velocity of the centre, not that of the axes, as it was.
    let omega = n.vector();
    bodies[1].set_angular_velocity(omega);
    (joints, bodies)
}

#[test]
fn rows_are_derivatives_of_their_values_near_the_joint() {
    let mut n = Numbers(11);
    for kind in KINDS {
        for _ in 0..20 {
            let (joints, bodies) = disturbed(kind, &mut n, 0.5, 0.2);
            assert_derivatives(&joints, &bodies, &format!("{kind:?}"));
        }
    }
}

#[test]
fn rows_are_derivatives_of_their_values_far_from_the_joint() {
    let mut n = Numbers(12);
    for kind in KINDS {
        for _ in 0..20 {
            let (joints, bodies) = disturbed(kind, &mut n, 1.0, 0.6);
            assert_derivatives(&joints, &bodies, &format!("{kind:?}"));
        }
    }
}

/// Wheels on separate bodies, on one carrier, and one on the other (B of the first joint is A of the second).
#[test]
fn gears_share_bodies_in_every_way() {
    let mut n = Numbers(13);
    for ends in [
        [[0, 1], [2, 3]],
        [[0, 1], [0, 2]],
        [[0, 1], [1, 2]],
        [[1, 0], [2, 0]],
    ] {
        let mut bodies: Vec<Body> = random_pair(&mut n);
        bodies.extend(random_pair(&mut n));
        let mut models: Vec<_> = ends
            .iter()
            .map(|&e| join(Kind::Hinge, e, n.vector(), n.rotation(2.0), &bodies))
            .collect();
        let gear = Kind::Gear {
            ratio: -2.5,
            joints: [0, 1],
        };
        models.push(join(
            gear,
            [ends[0][1], ends[1][1]],
            DVec3::ZERO,
            DQuat::IDENTITY,
            &bodies,
        ));
        let joints = Joints::new(models, Vec::new(), &bodies);
        for body in &mut bodies {
            let omega = n.vector();
            body.displace(DVec3::ZERO, 0.2 * n.vector());
            body.set_angular_velocity(omega);
        }
        assert_derivatives(&joints, &bodies, &format!("{ends:?}"));
        let rows = &all_rows(&joints, &bodies)[10];
        let mut touched: Vec<usize> = rows
            .iter()
            .flat_map(|row| row.ends.map(|e| e.body))
            .collect();
        touched.sort_unstable();
        let mut wheels: Vec<usize> = ends.concat();
        wheels.sort_unstable();
        assert_eq!(touched, wheels);
    }
}

/// World -> body about z through the origin.
fn on_axis(kind: Kind) -> (Joints, Vec<Body>) {
    let bodies = vec![world(), at(DVec3::new(0.3, 0.0, 0.0), DQuat::IDENTITY)];
    let model = join(kind, [0, 1], DVec3::ZERO, DQuat::IDENTITY, &bodies);
    (Joints::new(vec![model], Vec::new(), &bodies), bodies)
}

/// The body of `on_axis` turned about z by `angle` and moved along it by `travel`.
fn twisted(angle: f64, travel: f64) -> Vec<Body> {
    let turn = rotation_from_vector(angle * DVec3::Z);
    vec![
        world(),
        at(turn * DVec3::new(0.3, 0.0, 0.0) + travel * DVec3::Z, turn),
    ]
}

#[test]
fn hinge_angle_counts_turns_both_ways() {
    let (mut joints, _) = on_axis(Kind::Hinge);
    for step in (0..=400).chain((-400..400).rev()) {
        let angle = 0.1 * f64::from(step);
        let bodies = twisted(angle, 0.0);
        // Before it is observed the nearest branch is taken already; measured error 1e-14.
        let found = joints.coordinate(0, 0, &bodies).unwrap();
        assert!((found - angle).abs() < 1e-13, "{angle}: {found}");
        joints.observe(&bodies);
        let (gap, lean) = joints.violation(0, &bodies);
        assert!(gap < 1e-15 && lean < 1e-15);
    }
    assert_eq!(joints.coordinate(0, 1, &twisted(0.0, 0.0)), None);
}

#[test]
fn screw_holds_over_many_turns() {
    let pitch = 0.01;
    let (mut joints, _) = on_axis(Kind::Screw { pitch });
    for step in 0..500 {
        let angle = 0.2 * f64::from(step);
        let bodies = twisted(angle, pitch * angle);
        let (gap, lean) = joints.violation(0, &bodies);
        // Measured 3e-16.
        assert!(gap < 1e-14 && lean < 1e-14, "{angle}: {gap}");
        joints.observe(&bodies);
    }
}

#[test]
fn turns_survive_a_checkpoint() {
    let (mut joints, start) = on_axis(Kind::Hinge);
    for step in 0..100 {
        joints.observe(&twisted(0.3 * f64::from(step), 0.0));
    }
    let state = joints.state().clone();
    let mut again = Joints::new(vec![joints.model(0).clone()], Vec::new(), &start);
    again.set_state(state).unwrap();
    let last = twisted(29.7, 0.0);
    assert_eq!(
        again.coordinate(0, 0, &last),
        joints.coordinate(0, 0, &last)
    );
    assert!((again.coordinate(0, 0, &last).unwrap() - 29.7).abs() < 1e-13);
    let (other, _) = on_axis(Kind::Ball);
    assert!(again.set_state(other.state().clone()).is_err());
}

#[test]
fn travel_and_angle_of_a_cylindrical_joint() {
    let (joints, _) = on_axis(Kind::Cylindrical);
    let bodies = twisted(1.2, -0.4);
    assert!((joints.coordinate(0, 0, &bodies).unwrap() + 0.4).abs() < 1e-15);
    assert!((joints.coordinate(0, 1, &bodies).unwrap() - 1.2).abs() < 1e-15);
}

#[test]
fn coordinates_of_a_planar_joint() {
    let (joints, _) = on_axis(Kind::Planar);
    let turn = rotation_from_vector(-0.8 * DVec3::Z);
    let shift = DVec3::new(0.2, -0.5, 0.0);
    let bodies = vec![world(), at(shift + turn * DVec3::new(0.3, 0.0, 0.0), turn)];
    for (k, expected) in [0.2, -0.5, -0.8].into_iter().enumerate() {
        assert!((joints.coordinate(0, k, &bodies).unwrap() - expected).abs() < 1e-15);
    }
    assert!(joints.violation(0, &bodies).0 < 1e-15);
}

/// Cardan: first about z of A, then about the x that this has turned.
#[test]
fn angles_of_a_universal_joint() {
    let (joints, _) = on_axis(Kind::Universal);
    let turn = rotation_from_vector(0.7 * DVec3::Z) * rotation_from_vector(-1.1 * DVec3::X);
    let bodies = vec![world(), at(turn * DVec3::new(0.3, 0.0, 0.0), turn)];
    assert!((joints.coordinate(0, 0, &bodies).unwrap() - 0.7).abs() < 1e-15);
    assert!((joints.coordinate(0, 1, &bodies).unwrap() + 1.1).abs() < 1e-15);
    let (gap, square) = joints.violation(0, &bodies);
    assert!(gap < 1e-15 && square < 1e-15);
}

#[test]
fn a_cone_measures_its_tilt() {
    let (joints, _) = on_axis(Kind::Cone {
        max_angle: 0.5,
        restitution: 0.0,
    });
    let turn = rotation_from_vector(0.4 * DVec3::new(0.6, 0.8, 0.0))
        * rotation_from_vector(2.0 * DVec3::Z);
    let bodies = vec![world(), at(turn * DVec3::new(0.3, 0.0, 0.0), turn)];
    assert!((joints.coordinate(0, 0, &bodies).unwrap() - 0.4).abs() < 1e-15);
    assert!(joints.coordinate(0, 0, &twisted(1.0, 0.0)).unwrap() < 1e-15);
}

/// No angle but zero looks like zero: the lock of a fixed joint over every rotation, the lean of a hinge up to half a turn.
#[test]
fn locks_have_no_false_zero() {
    let mut n = Numbers(14);
    let (fixed, _) = on_axis(Kind::Fixed);
    let (hinge, _) = on_axis(Kind::Hinge);
    let axes = (0..20).map(|_| n.vector().normalize()).chain(DVec3::AXES);
    for axis in axes {
        let across = axis.cross(DVec3::Z).normalize_or(DVec3::X);
        for angle in [0.01, 0.5, FRAC_PI_2, 2.0, 3.0, PI, 4.0, 5.0] {
            let turned =
                |axis: DVec3| vec![world(), at(DVec3::ZERO, rotation_from_vector(angle * axis))];
            let expected = 2.0 * (0.5 * angle).sin().abs();
            let (_, lock) = fixed.violation(0, &turned(axis));
            assert!((lock - expected).abs() < 1e-14, "{axis} {angle}: {lock}");
            if angle < PI {
                let (_, lean) = hinge.violation(0, &turned(across));
                assert!((lean - expected).abs() < 1e-13, "{across} {angle}: {lean}");
            }
        }
    }
}

/// A weight m on a hinge at the end of an arm L, held level: the hinge takes its weight, m g upwards on the weight, and the
/// torque m g L about the anchor; on A (the world) the opposite force.
#[test]
fn reaction_of_a_cantilever() {
    let bodies = vec![world(), at(DVec3::new(2.0, 0.0, 0.0), DQuat::IDENTITY)];
    let model = join(
        Kind::Fixed,
        [0, 1],
        DVec3::new(0.5, 0.0, 0.0),
        DQuat::IDENTITY,
        &bodies,
    );
    let joints = Joints::new(vec![model], Vec::new(), &bodies);
    let rows = all_rows(&joints, &bodies);
    let (weight, arm) = (10.0, 1.5);
    // On B: force +weight z; torque about its centre must cancel r_B x F = (-arm, 0, 0) x (0, 0, weight) = (0, arm weight, 0).
    let impulses = [0.0, 0.0, weight, 0.0, -arm * weight, 0.0];
    let of_b = |f: fn(&super::End) -> DVec3| -> DVec3 {
        rows.iter()
            .zip(impulses)
            .map(|(row, l)| l * f(&row[0].ends[1]))
            .sum()
    };
    assert_eq!(of_b(|end| end.linear), weight * DVec3::Z);
    assert!(of_b(|end| end.angular).length() < 1e-15);
    let pushes = rows.iter().zip(impulses);
    let pushes = pushes.flat_map(|(row, l)| row[0].ends.map(|end| (end, l)));
    let (force, torque) = joints.reaction(0, pushes, &bodies);
    assert_eq!(force, -weight * DVec3::Z);
    // The weight at +x pulls the world's side over about +y.
    assert!((torque - arm * weight * DVec3::Y).length() < 1e-14);
}

#[test]
fn overload_breaks_a_joint_and_its_gear() {
    let bodies = vec![
        world(),
        at(DVec3::X, DQuat::IDENTITY),
        at(DVec3::Y, DQuat::IDENTITY),
    ];
    let hinge = |b: usize| join(Kind::Hinge, [0, b], DVec3::ZERO, DQuat::IDENTITY, &bodies);
    let gear = Kind::Gear {
        ratio: 2.0,
        joints: [0, 1],
    };
    let mut models = vec![
        hinge(1),
        hinge(2),
        join(gear, [1, 2], DVec3::ZERO, DQuat::IDENTITY, &bodies),
    ];
    models[1].break_torque = 3.0;
    let mut joints = Joints::new(models, Vec::new(), &bodies);
    let load = |torque: f64| {
        [
            (100.0 * DVec3::X, 100.0 * DVec3::Y),
            (DVec3::X, torque * DVec3::Z),
            (DVec3::X, DVec3::Z),
        ]
    };
    joints.break_overloaded(&load(2.9));
    assert!((0..3).all(|j| !joints.is_broken(j)));
    joints.break_overloaded(&load(3.1));
    assert_eq!([false, true, true], [0, 1, 2].map(|j| joints.is_broken(j)));
    let rows = all_rows(&joints, &bodies);
    assert!(rows[joints.rows_of(1)].iter().all(Vec::is_empty));
    assert!(rows[joints.rows_of(0)].iter().all(|row| row.len() == 1));
    assert_eq!(joints.rows_of(2), 10..11);
    let mut values = Vec::new();
    joints.values(&bodies, &mut values);
    assert_eq!(values.len(), rows.len());
    assert!(TAU > values.iter().sum());
}
