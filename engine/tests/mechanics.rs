//! Joints, integrators and located impacts through the whole step, without Python.

mod common;

use _engine::body::{MassProperties, State};
use _engine::collide::NoOracle;
use _engine::integrator::Integrator;
use _engine::model::{Geom, Model};
use _engine::shape::Shape;
use _engine::world::World;
use common::{empty_model, tie_in_a_row, G};
use glam::{DMat3, DVec3};

/// Elastic and smooth, with located impacts.
fn model(integrator: Integrator, timestep: f64) -> Model {
    let mut model = empty_model(timestep, 1.0, 0.0);
    model.settings.integrator = integrator;
    model.settings.located = true;
    model
}

/// A ball of 1 kg.
fn add_ball(model: &mut Model, radius: f64, position: DVec3) {
    let inertia = DMat3::from_diagonal(DVec3::splat(0.4 * radius * radius));
    let state = State {
        position,
        ..State::default()
    };
    model
        .bodies
        .push((MassProperties::new(1.0, inertia), state, DVec3::ZERO));
}

/// Balls in a row along x, each tied to the one before, the first to the world's origin.
fn chain(links: usize, spacing: f64, integrator: Integrator, timestep: f64) -> World {
    let mut model = model(integrator, timestep);
    let half = DVec3::X * (0.5 * spacing);
    for k in 0..links {
        #[allow(clippy::cast_precision_loss)]
        let place = DVec3::X * (spacing * (k as f64 + 0.5));
        add_ball(&mut model, 0.2 * spacing, place);
    }
    tie_in_a_row(&mut model, half);
    World::new(model)
}

fn run(world: &mut World, steps: usize) {
    for _ in 0..steps {
        world.step(&mut NoOracle).unwrap();
    }
}

fn worst_violation(world: &World) -> f64 {
    let one = |j| world.joints().violation(j, world.all_bodies()).0;
    (0..world.joints().len()).map(one).fold(0.0, f64::max)
}

/// A pendulum let go level passes its lowest point with 3 m g on its joint (plus what its own inertia changes), and its
/// energy stays.
#[test]
fn a_pendulum_keeps_its_energy_and_its_joint() {
    // Measured with velocity Verlet: -2e-5 J, a swing of second order.
    for (integrator, energy) in [(Integrator::VelocityVerlet, 5e-5), (Integrator::Rk4, 1e-11)] {
        let mut world = chain(1, 2.0, integrator, 1e-3);
        let start = world.energies().total();
        let mut pull = 0.0_f64;
        for _ in 0..2000 {
            run(&mut world, 1);
            pull = pull.max(world.joint_loads()[0].0.length());
        }
        let error = world.energies().total() - start;
        assert!(error.abs() < energy, "{integrator:?} {error:e}");
        assert!(worst_violation(&world) < 1e-12);
        // I = m L^2 (1 + k): m v^2 / L = 2 m g / (1 + k) at the bottom.
        let k = 0.4 * 0.4 * 0.4;
        let most = G * (1.0 + 2.0 / (1.0 + k));
        assert!((pull - most).abs() < 1e-4 * most, "{pull} {most}");
    }
}

/// A hundred links fall and crack: they stay together, and the energy stays.
#[test]
fn a_long_chain_stays_together() {
    let mut world = chain(100, 0.1, Integrator::Rk4, 1e-3);
    let start = world.energies().total();
    run(&mut world, 1000);
    assert!(worst_violation(&world) < 1e-11);
    let error = world.energies().total() - start;
    assert!(error.abs() < 1e-3, "{error} of {}", 100.0 * G * 5.0);
}

/// Links that tumble wildly, by half a radian in a step, keep their energy. Measured: within 2.1 %; with steps divided by
/// nothing but what joints ask for, chains of ten to a hundred links gain more than they had within ten seconds.
#[test]
fn a_tumbling_chain_keeps_its_energy() {
    for integrator in [
        Integrator::SemiImplicitEuler,
        Integrator::VelocityVerlet,
        Integrator::Rk4,
    ] {
        let mut world = chain(10, 0.2, integrator, 1.0 / 240.0);
        let start = world.energies().total();
        for _ in 0..100 {
            run(&mut world, 72);
            let error = world.energies().total() - start;

            assert!(error.abs() < 0.05 * 10.0 * G, "{integrator:?} {error}");
            assert!(worst_violation(&world) < 1e-12);
        }
    }
}

/// An elastic ball on a plane keeps its energy, bounce by bounce, to rounding.
#[test]
fn located_impacts_keep_the_energy() {
    for integrator in [Integrator::Verlet, Integrator::Rk4] {
        let mut model = model(integrator, 5e-3);
        model
            .bodies
            .push((MassProperties::fixed(), State::default(), DVec3::ZERO));
        add_ball(&mut model, 0.1, DVec3::Z * 1.1);
        let shapes = [Shape::HalfSpace, Shape::Sphere { radius: 0.1 }];
        model.geoms = shapes
            .into_iter()
            .enumerate()
            .map(|(body, shape)| Geom {
                body,
                shape,
                position: DVec3::ZERO,
                rotation: DMat3::IDENTITY,
                material: 0,
            })
            .collect();
        let mut world = World::new(model);
        let start = world.energies().total();
        for _ in 0..1000 {
            run(&mut world, 1);
            assert!((world.energies().total() - start).abs() < 1e-11);
        }
        assert_eq!(world.take_events().len(), 6);
        assert_eq!(world.fallbacks(), 0);
    }
}
