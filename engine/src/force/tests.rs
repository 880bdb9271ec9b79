use std::sync::Arc;

use super::testing::{
    at, balance_error, company, evaluate, gradient_error, linear, of_springs, torsional, total,
    world, Numbers,
};
use super::*;
use crate::math::rotation_from_vector;
use crate::profile::{Profile, Schedule};

const G: f64 = 9.81;

fn gravity() -> ForceModel {
    ForceModel {
        gravity: DVec3::new(0.0, 0.0, -G),
        ..ForceModel::default()
    }
}

fn attraction() -> ForceModel {
    ForceModel {
        gravitation: 0.8,
        attracting_mass: vec![1.7, 1.7, 1.7, 3.0],
        ..ForceModel::default()
    }
}

/// Elastic springs of every sort: straight, preloaded, one-sided on either side of rest, with a curve; between moving
/// bodies and to the world; torsional.
fn elastic_springs(seed: u64) -> Vec<(String, Forces, Vec<Body>)> {
    let mut bodies = company(seed);
    let mut numbers = Numbers::new(seed + 99);
    let anchors = [numbers.vector(), numbers.vector()];
    let curve = vec![(-1.0, -2.0), (0.1, 0.3), (0.6, 0.4), (2.0, 5.0)];
    let mut models = Vec::new();
    for pair in [[0, 1], [2, 3], [3, 1]] {
        for (rest, preload) in [(0.3, 0.0), (9.0, 0.0), (0.3, 1.4), (0.3, -0.9)] {
            for acts in [Acts::Always, Acts::Tension, Acts::Compression] {
                let base = SpringModel {
                    rest,
                    preload,
                    acts,
                    stiffness: 2.5,
                    ..linear(pair, anchors)
                };
                let bent = SpringModel {
                    force_curve: curve.clone(),
                    ..base.clone()
                };
                models.extend([base, bent]);
            }
        }
        let twist = SpringModel {
            rest: 0.2,
            stiffness: 1.3,
            preload: 0.4,
            ..torsional(&bodies, pair, numbers.vector())
        };
        let bent = SpringModel {
            force_curve: curve.clone(),
            ..twist.clone()
        };
        models.extend([twist, bent]);
    }
    let springs: Vec<_> = models
        .into_iter()
        .map(|m| (format!("{seed} {m:?}"), of_springs(vec![m], &bodies)))
        .collect();
    // Away from the start, so that the axes of torsional springs come apart.
    for body in bodies.iter_mut().filter(|b| !b.is_fixed()) {
        body.displace(0.3 * numbers.vector(), 0.6 * numbers.vector());
    }
    springs
        .into_iter()
        .map(|(name, forces)| (name, forces, bodies.clone()))
        .collect()
}

#[test]
fn potentials_pull_down_their_gradient() {
    for seed in 0..6 {
        for (name, forces, bodies) in elastic_springs(seed) {
            let error = gradient_error(&forces, &bodies);
            assert!(error < 1e-8, "{name}: {error}"); // measured 2e-9
        }
        let bodies = company(seed);
        for model in [gravity(), attraction()] {
            let error = gradient_error(&Forces::new(model, &bodies), &bodies);
            assert!(error < 1e-7, "{error}"); // measured 1.4e-8
        }
    }
}

#[test]
fn between_bodies_action_is_reaction() {
    for seed in 0..6 {
        let bodies = company(seed);
        let anchors = [DVec3::X, DVec3::new(0.2, -0.4, 0.1)];
        let damped = |model| SpringModel {
            stiffness: 3.0,
            damping: 0.7,
            preload: 0.2,
            ..model
        };
        let springs = vec![
            damped(linear([0, 1], anchors)),
            damped(torsional(&bodies, [1, 2], DVec3::new(0.3, 0.4, 1.0))),
        ];
        let model = ForceModel {
            springs,
            gravitation: 0.8,
            attracting_mass: vec![1.7; 3],
            ..ForceModel::default()
        };
        let forces = Forces::new(model, &bodies);
        let mut turned = bodies.clone();
        turned[1].displace(DVec3::X, DVec3::new(0.5, -0.3, 0.2));
        let (force, torque) = total(&turned, &evaluate(&forces, &turned, 0.0).0);
        assert!(force.length() < 1e-14, "{force}"); // measured 2e-15
        assert!(torque.length() < 1e-13, "{torque}"); // measured 8e-15
    }
}

/// Dampers, drag, declared forces, fields and prescribed motion: what they bring is what the energy gains.
#[test]
fn powers_are_what_the_energy_gains() {
    for seed in 0..6 {
        let mut bodies = company(seed);
        let mut numbers = Numbers::new(seed + 7);
        // The world's body as a drive would move it.
        bodies[3].state.velocity = numbers.vector();
        bodies[3].angular_velocity = numbers.vector();
        let mut everything = everything(&mut numbers, &bodies);
        let at_once = Forces::new(everything.clone(), &bodies);
        let mut apart = Vec::new();
        for spring in everything.springs.drain(..) {
            apart.push(of_springs(vec![spring], &bodies));
        }
        apart.extend([at_once, Forces::new(everything, &bodies)]);
        for body in bodies.iter_mut().filter(|b| !b.is_fixed()) {
            body.displace(DVec3::ZERO, 0.6 * numbers.vector());
        }
        for (k, forces) in apart.iter().enumerate() {
            let error = balance_error(forces, &bodies, 0.7);
            assert!(error < 1e-7, "{seed} {k}: {error}"); // measured 1.4e-8
        }
    }
}

fn everything(numbers: &mut Numbers, bodies: &[Body]) -> ForceModel {
    let anchors = [numbers.vector(), numbers.vector()];
    let sine = Schedule {
        profile: Some(Arc::new(Profile::Sine {
            frequency: 0.3,
            phase: 1.0,
        })),
        from: 0.5,
        until: 2.0,
    };
    let mut springs = Vec::new();
    for acts in [Acts::Always, Acts::Tension, Acts::Compression] {
        for rest in [0.1, 8.0] {
            for pair in [[0, 1], [1, 3], [3, 2]] {
                springs.push(SpringModel {
                    rest,
                    stiffness: 2.0,
                    damping: 6.0,
                    preload: 0.3,
                    acts,
                    ..linear(pair, anchors)
                });
            }
        }
    }
    for pair in [[0, 1], [3, 2]] {
        springs.push(SpringModel {
            stiffness: 1.1,
            damping_curve: vec![(-1.0, -2.0), (0.0, 0.0), (1.0, 0.5)],
            ..torsional(bodies, pair, numbers.vector())
        });
    }
    ForceModel {
        springs,
        applied: [Axes::World, Axes::Body]
            .map(|axes| AppliedForce {
                body: 1,
                force: numbers.vector(),
                torque: numbers.vector(),
                at: numbers.vector(),
                axes,
                schedule: sine.clone(),
            })
            .into(),
        drags: vec![Drag {
            body: 2,
            linear: 0.4,
            angular: 0.2,
            quadratic: 0.9,
        }],
        fields: vec![Field {
            body: 0,
            acceleration: numbers.vector(),
            region: [DVec3::NEG_INFINITY, DVec3::INFINITY],
            schedule: sine,
        }],
        ..attraction()
    }
}

/// k = 50 N/m, l0 = 1 m, c = 3 N s/m, ends 1.5 m apart and parting at 2 m/s: T = 25 + 6 + preload.
#[test]
fn tension_is_elastic_damped_and_preloaded() {
    let mut bodies = vec![at(DVec3::ZERO), at(DVec3::X * 1.5)];
    bodies[1].state.velocity = DVec3::new(2.0, 7.0, 0.0);
    let spring = SpringModel {
        rest: 1.0,
        stiffness: 50.0,
        damping: 3.0,
        preload: 4.0,
        ..linear([0, 1], [DVec3::ZERO; 2])
    };
    let forces = of_springs(vec![spring], &bodies);
    let (wrenches, powers) = evaluate(&forces, &bodies, 0.0);
    assert!((wrenches[0].force - DVec3::X * 35.0).length() < 1e-13);
    assert!((wrenches[1].force + DVec3::X * 35.0).length() < 1e-13);
    assert!((powers.damping + 12.0).abs() < 1e-13); // -c (dl/dt)^2
    assert!((forces.potential(&bodies).spring - (6.25 + 2.0)).abs() < 1e-13); // k x^2 / 2 + preload x
    let readings: Vec<_> = forces.readings(&bodies).collect();
    assert!((readings[0].0 - 1.5).abs() < 1e-15 && (readings[0].1 - 35.0).abs() < 1e-13);
    assert!(forces.depends_on_velocity());
}

/// (acts, length, speed of lengthening, tension) with k = 10 N/m, l0 = 1 m, c = 1 N s/m.
#[test]
fn ropes_never_push_and_bumpers_never_pull() {
    let cases = [
        (Acts::Tension, 1.5, 2.0, 7.0),
        (Acts::Tension, 1.5, -9.0, 0.0),
        (Acts::Tension, 0.8, 2.0, 0.0),
        (Acts::Compression, 0.5, -2.0, -7.0),
        (Acts::Compression, 0.5, 9.0, 0.0),
        (Acts::Compression, 1.2, -2.0, 0.0),
        (Acts::Always, 0.5, 9.0, 4.0),
    ];
    for (acts, length, speed, tension) in cases {
        let mut bodies = vec![at(DVec3::ZERO), at(DVec3::Y * length)];
        bodies[1].state.velocity = DVec3::Y * speed;
        let spring = SpringModel {
            rest: 1.0,
            stiffness: 10.0,
            damping: 1.0,
            acts,
            ..linear([0, 1], [DVec3::ZERO; 2])
        };
        let forces = of_springs(vec![spring], &bodies);
        let found = forces.readings(&bodies).next().unwrap().1;
        assert!(
            (found - tension).abs() < 1e-13,
            "{acts:?} {length} {speed}: {found}"
        );
    }
}

#[test]
fn a_spring_of_no_length_is_without_force() {
    let bodies = vec![at(DVec3::ONE), at(DVec3::ONE)];
    let spring = SpringModel {
        rest: 1.0,
        stiffness: 10.0,
        damping: 1.0,
        ..linear([0, 1], [DVec3::ZERO; 2])
    };
    let model = ForceModel {
        springs: vec![spring],
        gravitation: 1.0,
        attracting_mass: vec![2.0; 2],
        ..ForceModel::default()
    };
    let forces = Forces::new(model, &bodies);
    let (wrenches, powers) = evaluate(&forces, &bodies, 0.0);
    assert_eq!(wrenches, vec![Wrench::default(); 2]);
    assert_eq!(powers, Powers::default());
    assert_eq!(forces.potential(&bodies).gravitation, 0.0);
    assert_eq!(forces.potential(&bodies).spring, 5.0);
}

#[test]
fn torsional_springs_count_their_turns() {
    let mut bodies = vec![at(DVec3::ZERO), at(DVec3::X), world()];
    let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let spring = SpringModel {
        stiffness: 2.0,
        rest: 0.5,
        ..torsional(&bodies, [0, 1], axis)
    };
    let mut forces = of_springs(vec![spring], &bodies);
    let step = 0.37;
    for k in 1..=60 {
        bodies[1].displace(DVec3::ZERO, axis * step);
        let (angle, torque) = forces.readings(&bodies).next().unwrap();
        let exact = step * f64::from(k);
        assert!((angle - exact).abs() < 1e-12, "{k}"); // measured 4e-15
        assert!((torque - 2.0 * (exact - 0.5)).abs() < 1e-12);
        forces.observe(&bodies);
    }
    let (wrenches, _) = evaluate(&forces, &bodies, 0.0);
    let torque = axis * 2.0 * (60.0 * step - 0.5);
    assert!((wrenches[0].torque - torque).length() < 1e-12);
    assert!((wrenches[1].torque + torque).length() < 1e-12);
    let turns = forces.turns();
    assert!(!forces.set_turns(&[]));
    assert!(forces.set_turns(&[0.0]));
    let lost = forces.readings(&bodies).next().unwrap().0;
    assert!(lost.abs() < std::f64::consts::PI);
    assert!(forces.set_turns(&turns));
    assert!((forces.readings(&bodies).next().unwrap().0 - 60.0 * step).abs() < 1e-12);
}

/// B on its head: no twist, no torque, no NaN.
#[test]
fn opposed_axes_are_without_torque() {
    let mut bodies = vec![at(DVec3::ZERO), world()];
    let spring = SpringModel {
        stiffness: 2.0,
        rest: 0.5,
        damping: 1.0,
        ..torsional(&bodies, [0, 1], DVec3::Z)
    };
    let forces = of_springs(vec![spring], &bodies);
    bodies[0].displace(DVec3::ZERO, DVec3::X * std::f64::consts::PI);
    let (wrenches, powers) = evaluate(&forces, &bodies, 0.0);
    assert_eq!(wrenches[0], Wrench::default());
    assert_eq!(powers, Powers::default());
}

/// At a right angle between the axes the gradient is (z_A + z_B), of length sqrt 2.
#[test]
fn the_gradient_of_the_twist_at_a_right_angle() {
    let mut bodies = vec![at(DVec3::ZERO), at(DVec3::ZERO)];
    let spring = SpringModel {
        preload: 3.0,
        ..torsional(&bodies, [0, 1], DVec3::Z)
    };
    let forces = of_springs(vec![spring], &bodies);
    bodies[1].displace(DVec3::ZERO, DVec3::X * std::f64::consts::FRAC_PI_2);
    let (wrenches, _) = evaluate(&forces, &bodies, 0.0);
    let exact = 3.0 * DVec3::new(0.0, -1.0, 1.0);
    assert!((wrenches[0].torque - exact).length() < 1e-14);
}

#[test]
fn a_force_acts_at_its_point_in_its_axes() {
    let turn = rotation_from_vector(DVec3::Z * std::f64::consts::FRAC_PI_2);
    let mut body = at(DVec3::new(3.0, 0.0, 0.0));
    body.state.orientation = turn;
    body.refresh();
    let bodies = vec![body];
    for (axes, force) in [(Axes::World, DVec3::X), (Axes::Body, DVec3::Y)] {
        let applied = AppliedForce {
            body: 0,
            force: 2.0 * DVec3::X,
            torque: DVec3::Z,
            at: DVec3::X,
            axes,
            schedule: Schedule {
                profile: None,
                from: 1.0,
                until: 2.0,
            },
        };
        let model = ForceModel {
            applied: vec![applied],
            ..ForceModel::default()
        };
        let forces = Forces::new(model, &bodies);
        let wrench = evaluate(&forces, &bodies, 1.5).0[0];
        assert!((wrench.force - 2.0 * force).length() < 1e-15);
        // The point of attack has turned to +y: y x X = -z, y x Y = 0.
        let moment = DVec3::Y.cross(2.0 * force) + DVec3::Z;
        assert!((wrench.torque - moment).length() < 1e-15);
        assert_eq!(evaluate(&forces, &bodies, 2.0).0[0], Wrench::default());
        assert!(!forces.depends_on_velocity());
    }
}

#[test]
fn drag_has_a_linear_and_a_quadratic_part() {
    let mut body = at(DVec3::ZERO);
    body.state.velocity = DVec3::new(3.0, 4.0, 0.0);
    body.set_angular_velocity(DVec3::Z * 2.0);
    let drag = Drag {
        body: 0,
        linear: 0.5,
        angular: 0.25,
        quadratic: 0.1,
    };
    let model = ForceModel {
        drags: vec![drag],
        ..ForceModel::default()
    };
    let bodies = vec![body];
    let forces = Forces::new(model, &bodies);
    let (wrenches, powers) = evaluate(&forces, &bodies, 0.0);
    assert!((wrenches[0].force + DVec3::new(3.0, 4.0, 0.0)).length() < 1e-14); // 0.5 + 0.1 * 5 = 1
    assert!((wrenches[0].torque + DVec3::Z * 0.5).length() < 1e-14);
    assert!((powers.damping + 26.0).abs() < 1e-13); // 25 + 0.5 * 2
    assert!(forces.depends_on_velocity());
}

#[test]
fn a_field_ends_with_its_region() {
    let field = Field {
        body: 0,
        acceleration: DVec3::X * 4.0,
        region: [DVec3::ZERO, DVec3::new(1.0, 1.0, f64::INFINITY)],
        schedule: Schedule::default(),
    };
    let model = ForceModel {
        fields: vec![field],
        ..ForceModel::default()
    };
    for (z, y, force) in [(0.5, 0.5, 8.0), (900.0, 1.0, 8.0), (0.5, 1.01, 0.0)] {
        let mut bodies = vec![at(DVec3::new(0.2, y, z))];
        bodies[0].state.velocity = DVec3::X * 3.0;
        let forces = Forces::new(model.clone(), &bodies);
        let (wrenches, powers) = evaluate(&forces, &bodies, 0.0);
        assert!((wrenches[0].force - DVec3::X * force).length() < 1e-15);
        assert!((powers.forces - 3.0 * force).abs() < 1e-14);
        assert_eq!(forces.potential(&bodies), Potential::default());
    }
}

/// Weight m g, energy m g h; and G m1 m2 / r^2 = 6.5e-2 * 2 * 5 / 4, energy -G m1 m2 / r, from a fixed body too.
#[test]
fn weight_and_attraction_have_their_size() {
    let bodies = vec![at(DVec3::Z * 2.0), world()];
    let weight = Forces::new(gravity(), &bodies);
    let wrench = evaluate(&weight, &bodies, 0.0).0;
    assert_eq!(wrench[0].force, DVec3::Z * (-2.0 * G));
    assert_eq!(wrench[1], Wrench::default());
    assert!((weight.potential(&bodies).gravitational - 4.0 * G).abs() < 1e-13);
    let model = ForceModel {
        gravitation: 6.5e-2,
        attracting_mass: vec![2.0, 5.0],
        ..ForceModel::default()
    };
    let attraction = Forces::new(model, &bodies);
    let wrench = evaluate(&attraction, &bodies, 0.0).0;
    assert!((wrench[0].force + DVec3::Z * 0.1625).length() < 1e-16);
    assert_eq!(wrench[1], Wrench::default());
    assert!((attraction.potential(&bodies).gravitation + 0.325).abs() < 1e-16);
}

/// On a fixed body nothing acts, and what acts on it has no power.
#[test]
fn fixed_bodies_take_nothing() {
    let bodies = vec![world(), world()];
    let mut numbers = Numbers::new(3);
    let model = everything(&mut numbers, &company(3));
    let mut model = ForceModel {
        springs: model.springs[..1].to_vec(),
        attracting_mass: vec![1.0, 2.0],
        gravity: DVec3::Z,
        ..model
    };
    model.applied.iter_mut().for_each(|f| f.body = 0);
    model.drags[0].body = 1;
    let forces = Forces::new(model, &bodies);
    let (wrenches, powers) = evaluate(&forces, &bodies, 0.7);
    assert_eq!(wrenches, vec![Wrench::default(); 2]);
    assert_eq!(powers, Powers::default());
}
