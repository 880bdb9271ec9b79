//! Threads take no memory either once lists have grown to what the scene needs: counted in the whole process.

#[path = "common/counting.rs"]
mod counting;

mod common;

use _engine::body::MassProperties;
use _engine::collide::NoOracle;
use _engine::shape::Shape;
use _engine::world::World;
use common::{add, empty_model};
use counting::of_all_threads;
use glam::{DMat3, DVec3};

/// Eighty stacks of four cubes on a floor.
fn stacks() -> World {
    let mut model = empty_model(1.0 / 240.0, 0.0, 0.5);
    let cube = Shape::Box {
        half: DVec3::splat(0.1),
    };
    let still = MassProperties::fixed();
    add(&mut model, Shape::HalfSpace, DVec3::ZERO, still);
    for k in 0..320 {
        let (stack, row) = (f64::from(k / 4), f64::from(k % 4));
        let place = DVec3::new(0.5 * stack, 0.0, 0.1 + 0.2 * row);
        let inertia = DMat3::from_diagonal(DVec3::splat(4e-3));
        add(
            &mut model,
            cube.clone(),
            place,
            MassProperties::new(1.0, inertia),
        );
    }
    World::new(model)
}

fn advance(world: &mut World, steps: usize) {
    world.together(|world| {
        for _ in 0..steps {
            world.step(&mut NoOracle).expect("no step fails");
        }
    });
}

/// Entering the pool takes a place in a queue, which grows by a block now and then; steps take nothing.
#[test]
fn what_rests_takes_no_memory_on_threads() {
    let mut world = stacks();
    world.set_threads(2);
    advance(&mut world, 480);
    let before = of_all_threads();
    advance(&mut world, 240);
    let taken = of_all_threads() - before;
    assert!(taken <= 2, "{taken} allocations in 240 steps");
}
