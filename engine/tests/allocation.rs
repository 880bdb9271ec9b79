//! A step takes no memory once its lists have grown to what the scene needs: counted by the allocator.

#[path = "common/counting.rs"]
mod counting;

mod common;

use _engine::body::MassProperties;
use _engine::collide::NoOracle;
use _engine::integrator::Integrator;
use _engine::shape::Shape;
use _engine::world::World;
use common::{add, empty_model, tie_in_a_row};
use counting::of_this_thread;
use glam::{DMat3, DVec3};

/// Cubes in pairs, one on the other, with a ball beside each, on a floor.
fn pairs(integrator: Integrator) -> World {
    let mut model = empty_model(1.0 / 240.0, 0.2, 0.5);
    model.settings.integrator = integrator;
    let inertia = DMat3::from_diagonal(DVec3::splat(4e-3));
    let cube = Shape::Box {
        half: DVec3::splat(0.1),
    };
    let still = MassProperties::fixed();
    add(&mut model, Shape::HalfSpace, DVec3::ZERO, still);
    for k in 0..8 {
        let (column, row) = (f64::from(k % 4), f64::from(k / 4));
        let place = DVec3::new(0.5 * column, 0.0, 0.11 + 0.205 * row);
        add(
            &mut model,
            cube.clone(),
            place,
            MassProperties::new(1.0, inertia),
        );
    }
    for k in 0..4 {
        let place = DVec3::new(0.5 * f64::from(k), 0.5, 0.1);
        let ball = Shape::Sphere { radius: 0.1 };
        add(&mut model, ball, place, MassProperties::new(1.0, inertia));
    }
    World::new(model)
}

fn allocations(world: &mut World, steps: usize) -> usize {
    let before = of_this_thread();
    for _ in 0..steps {
        world.step(&mut NoOracle).expect("no step fails");
    }
    of_this_thread() - before
}

#[test]
fn what_rests_takes_no_memory() {
    for integrator in [Integrator::SemiImplicitEuler, Integrator::VelocityVerlet] {
        let mut world = pairs(integrator);
        assert!(allocations(&mut world, 1) > 0, "the counter counts");
        allocations(&mut world, 960);
        world.take_events();
        assert_eq!(allocations(&mut world, 240), 0, "{integrator:?}");
    }
}

#[test]
fn free_flight_takes_no_memory_from_the_second_step_on() {
    let mut model = empty_model(1e-3, 0.0, 0.0);
    let inertia = DMat3::from_diagonal(DVec3::new(1.0, 2.0, 3.0));
    let cube = Shape::Box {
        half: DVec3::splat(0.1),
    };
    for k in 0..10 {
        let place = DVec3::new(f64::from(k), 0.0, 0.0);
        add(
            &mut model,
            cube.clone(),
            place,
            MassProperties::new(1.0, inertia),
        );
    }
    let mut world = World::new(model);
    allocations(&mut world, 2);
    assert_eq!(allocations(&mut world, 1000), 0);
}

#[test]
fn a_chain_that_swings_takes_no_memory() {
    let mut model = empty_model(1.0 / 240.0, 0.0, 0.0);
    let inertia = DMat3::from_diagonal(DVec3::new(0.1, 1.0, 1.2));
    let half = DVec3::new(0.5, 0.1, 0.1);
    for k in 0..10 {
        // Far enough apart that they never touch.
        let place = DVec3::new(3.0 * f64::from(k) + 1.5, 0.0, 0.0);
        let mass = MassProperties::new(1.0, inertia);
        add(&mut model, Shape::Box { half }, place, mass);
    }
    tie_in_a_row(&mut model, DVec3::X * 1.5);
    let mut world = World::new(model);
    allocations(&mut world, 240);
    assert_eq!(allocations(&mut world, 240), 0);
}
